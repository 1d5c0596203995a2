//! Requests about documents: which there are, what each needs, and how it is answered.
//!
//! In: a method and its parameters. Out: a [`Task`], which waits until its document is prepared.

use std::task::Poll;

use gen_lsp_types::{
    CodeAction, CodeActionRequest, CodeLensRequest, CompletionRequest, DefinitionParams,
    DocumentDiagnosticRequest, DocumentFormattingRequest, DocumentHighlightRequest, DocumentLinkRequest,
    DocumentSymbolRequest, FoldingRangeRequest, HoverRequest, InlayHintRequest, LspRequestMethod,
    PrepareRenameRequest, ReferencesRequest, RenameRequest, Request, SemanticTokensRangeRequest,
    SemanticTokensRequest, SignatureHelpRequest, TextDocumentIdentifier, TextDocumentPositionParams, Uri,
    WorkspaceSymbolParams,
};
use serde_json::Value;

use super::context::{Asked, Context};
use super::document::Need;
use super::message::{Failure, Id, Progress, Reason};
use super::{
    actions, completion, diagnostics, formatting, hints, hover, lenses, links, navigation, rename, signature,
    symbols, tokens,
};

/// A request that is not answered yet.
pub struct Task {
    /// The id of the request.
    pub id: Id,
    /// The document that has to be prepared.
    pub subject: Option<Subject>,
    /// Makes the answer.
    pub answer: Answer,
}

/// A document, and the results that a request needs.
#[derive(Clone, Debug, PartialEq)]
pub struct Subject {
    /// The document.
    pub uri: Uri,
    /// What the request needs.
    pub need: Need,
}

/// Makes the answer to a request, in slices; it is not called again once it is ready.
pub type Answer = Box<dyn FnMut(&Context) -> Progress<Value>>;

/// Continues an answer, and keeps its progress in a state.
type Slice<R, S> = fn(&mut Option<S>, &Asked, &<R as Request>::Params) -> Progress<<R as Request>::Result>;

/// The parsed parameters of a request.
type Parsed = Result<(Option<Subject>, Answer), Failure>;

/// The task of a request; `None` if the server does not have the method.
pub fn task(id: Id, method: &str, params: Value) -> Option<Result<Task, Failure>> {
    let parsed = parse(method.into(), params)?;
    Some(parsed.map(|(subject, answer)| Task { id, subject, answer }))
}

fn parse(method: LspRequestMethod, params: Value) -> Option<Parsed> {
    use LspRequestMethod as Method;
    Some(match method {
        Method::TextDocumentDiagnostic => about::<DocumentDiagnosticRequest>(
            params,
            |p| (&p.text_document, Need::Messages),
            diagnostics::pulled,
        ),
        Method::TextDocumentCodeAction => {
            about::<CodeActionRequest>(params, |p| (&p.text_document, Need::Fixes), actions::actions)
        }
        Method::CodeActionResolve => resolve(params),
        Method::TextDocumentCodeLens => {
            about::<CodeLensRequest>(params, |p| (&p.text_document, Need::Messages), lenses::lenses)
        }
        Method::TextDocumentHover => {
            about::<HoverRequest>(params, |p| place(&p.text_document_position_params), hover::hover)
        }
        Method::TextDocumentCompletion => about::<CompletionRequest>(
            params,
            |p| place(&p.text_document_position_params),
            completion::completion,
        ),
        Method::TextDocumentSignatureHelp => about::<SignatureHelpRequest>(
            params,
            |p| place(&p.text_document_position_params),
            signature::signature,
        ),
        Method::TextDocumentDocumentSymbol => {
            about::<DocumentSymbolRequest>(params, |p| (&p.text_document, Need::Text), symbols::symbols)
        }
        Method::TextDocumentFoldingRange => {
            about::<FoldingRangeRequest>(params, |p| (&p.text_document, Need::Text), symbols::folds)
        }
        Method::TextDocumentReferences => about::<ReferencesRequest>(
            params,
            |p| text(&p.text_document_position_params),
            navigation::references,
        ),
        Method::TextDocumentDocumentHighlight => about::<DocumentHighlightRequest>(
            params,
            |p| text(&p.text_document_position_params),
            navigation::highlights,
        ),
        Method::TextDocumentPrepareRename => {
            about::<PrepareRenameRequest>(params, |p| text(&p.text_document_position_params), rename::prepare)
        }
        Method::TextDocumentRename => about_in_slices::<RenameRequest, _>(
            params,
            |p| (&p.text_document_position_params.text_document, Need::Run),
            rename::rename,
        ),
        Method::TextDocumentSemanticTokensFull => {
            about::<SemanticTokensRequest>(params, |p| (&p.text_document, Need::Text), tokens::whole)
        }
        Method::TextDocumentSemanticTokensRange => {
            about::<SemanticTokensRangeRequest>(params, |p| (&p.text_document, Need::Text), tokens::part)
        }
        Method::TextDocumentInlayHint => {
            about::<InlayHintRequest>(params, |p| (&p.text_document, Need::Hints(p.range)), hints::hints)
        }
        Method::TextDocumentDocumentLink => {
            about::<DocumentLinkRequest>(params, |p| (&p.text_document, Need::Text), links::links)
        }
        Method::TextDocumentFormatting => about_in_slices::<DocumentFormattingRequest, _>(
            params,
            |p| (&p.text_document, Need::Run),
            formatting::formatting,
        ),
        Method::TextDocumentDefinition => definition(params),
        Method::WorkspaceSymbol => workspace_symbols(params),
        _ => return None,
    })
}

/// A request about one document. `subject`: the document, and the results that the request needs.
fn about<R: Request>(
    params: Value,
    subject: fn(&R::Params) -> (&TextDocumentIdentifier, Need),
    answer: fn(&Asked, &R::Params) -> Result<R::Result, Failure>,
) -> Parsed {
    let params: R::Params = read(params)?;
    let (document, need) = subject(&params);
    let uri = document.uri.clone();
    let subject = Subject { uri: uri.clone(), need };
    let answer = move |context: &Context| written(&answer(&context.asked(&uri)?, &params)?);
    Ok((Some(subject), at_once(answer)))
}

/// A request about one document whose answer takes several slices. It begins again when the document is run again.
fn about_in_slices<R: Request, S: 'static>(
    params: Value,
    subject: fn(&R::Params) -> (&TextDocumentIdentifier, Need),
    answer: Slice<R, S>,
) -> Parsed {
    let params: R::Params = read(params)?;
    let (document, need) = subject(&params);
    let uri = document.uri.clone();
    let subject = Subject { uri: uri.clone(), need };
    let (mut run, mut state) = (None, None);
    let answer = move |context: &Context| {
        let asked = match context.asked(&uri) {
            Ok(asked) => asked,
            Err(failure) => return Poll::Ready(Err(failure)),
        };
        if run.replace(asked.document.run().id()) != Some(asked.document.run().id()) {
            state = None;
        }
        answer(&mut state, &asked, &params).map(|result| written(&result?))
    };
    Ok((Some(subject), Box::new(answer)))
}

/// An answer that is made in one slice.
fn at_once(mut answer: impl FnMut(&Context) -> Result<Value, Failure> + 'static) -> Answer {
    Box::new(move |context| Poll::Ready(answer(context)))
}

fn definition(params: Value) -> Parsed {
    let params: DefinitionParams = read(params)?;
    let uri = params.text_document_position_params.text_document.uri.clone();
    let subject = Subject { uri: uri.clone(), need: Need::Text };
    let answer = move |context: &Context| written(&navigation::definition(context, &uri, &params)?);
    Ok((Some(subject), at_once(answer)))
}

fn resolve(params: Value) -> Parsed {
    let action: CodeAction = read(params)?;
    let address = action.data.as_ref().and_then(|data| data.get("address")?.as_str());
    let uri = address
        .map(Uri::from)
        .ok_or_else(|| Failure::new(Reason::InvalidParams, "the action has no `data`"))?;
    let subject = Subject { uri: uri.clone(), need: Need::Text };
    let answer = move |context: &Context| written(&actions::resolved(&context.asked(&uri)?, &action)?);
    Ok((Some(subject), at_once(answer)))
}

fn workspace_symbols(params: Value) -> Parsed {
    let params: WorkspaceSymbolParams = read(params)?;
    Ok((None, at_once(move |context| written(&symbols::programs(context, &params)?))))
}

fn place(at: &TextDocumentPositionParams) -> (&TextDocumentIdentifier, Need) {
    (&at.text_document, Need::Place(at.position))
}

fn text(at: &TextDocumentPositionParams) -> (&TextDocumentIdentifier, Need) {
    (&at.text_document, Need::Text)
}

/// Reads parameters.
pub fn read<P: serde::de::DeserializeOwned>(params: Value) -> Result<P, Failure> {
    serde_json::from_value(params).map_err(|error| Failure::new(Reason::InvalidParams, error.to_string()))
}

fn written(result: &impl serde::Serialize) -> Result<Value, Failure> {
    serde_json::to_value(result).map_err(|error| Failure::new(Reason::RequestFailed, error.to_string()))
}
