//! `server`: a language server on standard input and output.
//!
//! In: framed messages of an editor. Out: framed messages; exit status as the protocol says: 0 after
//! `shutdown` and `exit`, 1 after `exit` alone. One thread reads, and the other answers: while messages are
//! waiting they are taken first, so that a request can be cancelled before it is answered. `files` has the
//! settings and the subprograms, `framing` the frames.

mod files;
mod framing;

use std::io::{self, Write};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread;
use std::time::Duration;

use super::options::{LanguageOptions, ProgramOptions};
use super::system::{self, Stream};
use super::{Status, configuration};
use crate::server::{Options, Pending, Server};
use files::Files;

/// Maximum number of messages that are read and not yet taken.
const MAX_WAITING: usize = 1000;

/// How long diagnostics wait for the next message: a user who types sends another one soon.
const PAUSE: Duration = Duration::from_millis(100);

/// The arguments of `server`.
#[derive(clap::Args)]
pub(super) struct Serve {
    #[command(flatten)]
    with: ProgramOptions,
    #[command(flatten)]
    texts: LanguageOptions,
    /// The address of the rule pages, a folder `rules` of the site: messages then link to the page of each rule.
    #[arg(long, value_name = "ADDRESS", value_parser = configuration::web_address)]
    rules_url: Option<String>,
}

/// A message, or the error that ends the stream.
type Read = io::Result<Vec<u8>>;

/// Runs `server` until the client ends it.
pub(super) fn run(serve: &Serve) -> Result<Status, String> {
    let options = Options { language: serve.texts.given(), rules_url: serve.rules_url.clone() };
    let server = Server::new(Files::new(&serve.with)?, options);
    let (send, receive) = mpsc::sync_channel(MAX_WAITING);
    // The thread ends with the process: it may wait for input forever.
    thread::Builder::new()
        .spawn(move || {
            let mut input = io::stdin().lock();
            while let Some(read) = framing::read(&mut input).transpose() {
                let is_last = read.is_err();
                if send.send(read).is_err() || is_last {
                    return;
                }
            }
        })
        .map_err(|error| system::reason(&error))?;
    serve_client(server, &receive).map_err(|error| format!("standard input: {}", system::reason(&error)))
}

fn serve_client(mut server: Server<Files<'_>>, input: &Receiver<Read>) -> io::Result<Status> {
    let mut output = system::stream(Stream::Output);
    loop {
        let messages = match next(server.pending(), input) {
            Ok(message) => server.handle(&message?),
            // The client has closed the stream.
            Err(RecvTimeoutError::Disconnected) if server.is_idle() => return Ok(Status::Right),
            Err(RecvTimeoutError::Timeout | RecvTimeoutError::Disconnected) => server.work(),
        };
        for message in messages {
            framing::write(&mut output, &message)?;
        }
        output.flush()?;
        if let Some(status) = server.exit_status() {
            return Ok(Status::faulty_if(status != 0));
        }
    }
}

/// The next message. An error if there is none and the server has work to do.
fn next(pending: Pending, input: &Receiver<Read>) -> Result<Read, RecvTimeoutError> {
    match pending {
        Pending::Nothing => input.recv().map_err(|_| RecvTimeoutError::Disconnected),
        Pending::Diagnostics => input.recv_timeout(PAUSE),
        Pending::Answers => input.recv_timeout(Duration::ZERO),
    }
}
