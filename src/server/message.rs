//! Messages of JSON-RPC 2.0, as the Language Server Protocol uses it.
//!
//! In: the text of a message. Out: a request, a notification or a response; and the texts of answers. Must
//! not know the methods.

use std::task::Poll;

use serde::Serialize;
use serde_json::{Value, json};

/// The id of a request: a number or a text.
#[derive(Clone, Debug, PartialEq)]
pub struct Id(Value);

/// A message from the client.
#[derive(Clone, Debug, PartialEq)]
pub enum Incoming {
    /// A request; it gets one answer.
    Request(Id, String, Value),
    /// A notification; it gets no answer.
    Notification(String, Value),
    /// The answer to a request of the server.
    Response,
}

/// Why a request has no result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum Reason {
    /// The text is not JSON.
    ParseError = -32700,
    /// The JSON is no message, or the message is not allowed now.
    InvalidRequest = -32600,
    /// The server has no such method.
    MethodNotFound = -32601,
    /// The parameters do not fit the method.
    InvalidParams = -32602,
    /// `initialize` comes first.
    ServerNotInitialized = -32002,
    /// The client has cancelled the request.
    RequestCancelled = -32800,
    /// The document has changed since the request.
    ContentModified = -32801,
    /// The request is correct and cannot be fulfilled.
    RequestFailed = -32803,
}

/// Pending, or the result of a request.
pub type Progress<T> = Poll<Result<T, Failure>>;

/// The error of a request.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure {
    /// The reason.
    pub reason: Reason,
    /// A sentence; clients show that of [`Reason::RequestFailed`] to the user.
    pub message: String,
}

impl Failure {
    /// An error with a sentence.
    pub fn new(reason: Reason, message: impl Into<String>) -> Self {
        Self { reason, message: message.into() }
    }
}

/// Reads a message. An error has the id of the request, if it can be read.
pub fn read(text: &[u8]) -> Result<Incoming, (Option<Id>, Failure)> {
    let message = serde_json::from_slice::<Value>(text)
        .map_err(|error| (None, Failure::new(Reason::ParseError, error.to_string())))?;
    let Value::Object(mut message) = message else { return Err((None, invalid("a message is an object"))) };
    let (id, method) = (message.remove("id"), message.remove("method"));
    let id = id.map(read_id);
    let params = message.remove("params").unwrap_or_default();
    match (id, method) {
        (Some(Some(id)), Some(Value::String(method))) => Ok(Incoming::Request(id, method, params)),
        (None, Some(Value::String(method))) => Ok(Incoming::Notification(method, params)),
        (Some(_), None) if message.contains_key("result") || message.contains_key("error") => {
            Ok(Incoming::Response)
        }
        (Some(None), _) => Err((None, invalid("an id is a whole number or a text"))),
        (id, _) => Err((id.flatten(), invalid("a message has a method, which is a text"))),
    }
}

fn read_id(id: Value) -> Option<Id> {
    let may_be = id.is_string() || id.is_i64() || id.is_u64();
    may_be.then_some(Id(id))
}

fn invalid(what: &str) -> Failure {
    Failure::new(Reason::InvalidRequest, what)
}

/// The id in the parameters of `$/cancelRequest`.
pub fn cancelled(mut params: Value) -> Option<Id> {
    read_id(params.get_mut("id")?.take())
}

/// The text of the answer to a request; without an id, to a message that cannot be read.
pub fn answer(id: Option<Id>, result: Result<Value, Failure>) -> String {
    let id = id.map_or(Value::Null, |id| id.0);
    let message = match result {
        Ok(result) => json!({"jsonrpc": "2.0", "id": id, "result": result}),
        Err(Failure { reason, message }) => {
            json!({"jsonrpc": "2.0", "id": id, "error": {"code": reason as i32, "message": message}})
        }
    };
    message.to_string()
}

/// The text of a notification.
pub fn notification(method: &str, params: impl Serialize) -> String {
    json!({"jsonrpc": "2.0", "method": method, "params": params}).to_string()
}

/// The text of a request of the server; parameters that are null are left out.
pub fn request(id: u64, method: &str, params: Value) -> String {
    let mut message = json!({"jsonrpc": "2.0", "id": id, "method": method});
    if !params.is_null() {
        message["params"] = params;
    }
    message.to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_message_is_a_request_a_notification_or_a_response() {
        let request = |id: Value| Incoming::Request(Id(id), "a/b".to_owned(), json!([1]));
        for id in [json!(7), json!(-1), json!("x")] {
            let text = json!({"jsonrpc": "2.0", "id": id, "method": "a/b", "params": [1]}).to_string();
            assert_eq!(read(text.as_bytes()), Ok(request(id)));
        }
        assert_eq!(read(br#"{"method": "a"}"#), Ok(Incoming::Notification("a".to_owned(), Value::Null)));
        assert_eq!(read(br#"{"id": 1, "result": null}"#), Ok(Incoming::Response));
        assert_eq!(read(br#"{"id": "a", "error": {}}"#), Ok(Incoming::Response));
    }

    #[test]
    fn anything_else_is_an_error_with_the_id_if_there_is_one() {
        let reason = |text: &str| read(text.as_bytes()).map_err(|(id, failure)| (id, failure.reason));
        assert_eq!(reason("{"), Err((None, Reason::ParseError)));
        assert_eq!(reason(""), Err((None, Reason::ParseError)));
        assert_eq!(
            read(b"{\"method\": \"\xff\"}").map_err(|(_, failure)| failure.reason),
            Err(Reason::ParseError)
        );
        assert_eq!(reason(&"[".repeat(1000)), Err((None, Reason::ParseError)));
        for text in
            ["[]", "7", "null", "{}", r#"{"id": 1.5, "method": "a"}"#, r#"{"id": null, "method": "a"}"#]
        {
            assert_eq!(reason(text), Err((None, Reason::InvalidRequest)), "{text}");
        }
        assert_eq!(reason(r#"{"id": 3, "method": 4}"#), Err((Some(Id(json!(3))), Reason::InvalidRequest)));
        assert_eq!(reason(r#"{"id": 3}"#), Err((Some(Id(json!(3))), Reason::InvalidRequest)));
    }
}
