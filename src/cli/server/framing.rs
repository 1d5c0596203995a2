//! The frames of messages on a stream: headers with the length, an empty line, the message.
//!
//! In: a stream. Out: the bytes of each message. Must not know the messages.

use std::io::{self, BufRead, ErrorKind, Read, Write};

use crate::limits::TEXT_BUFFER;

/// Longest line of a header, bytes.
const MAX_HEADER: u64 = 1 << 12;

/// Reads the next message; `None` at the end of the stream.
pub(super) fn read(input: &mut impl BufRead) -> io::Result<Option<Vec<u8>>> {
    let mut length = None;
    loop {
        let Some(line) = header(input)? else { return Ok(None) };
        if line.is_empty() {
            break;
        }
        length = content_length(&line)?.or(length);
    }
    let length = length.ok_or_else(|| invalid("a message has no Content-Length"))?;
    let mut message = Vec::new();
    input.take(length as u64).read_to_end(&mut message)?;
    if message.len() < length { Err(ErrorKind::UnexpectedEof.into()) } else { Ok(Some(message)) }
}

/// The next line of a header, without its end; `None` at the end of the stream.
fn header(input: &mut impl BufRead) -> io::Result<Option<String>> {
    let mut line = Vec::new();
    input.take(MAX_HEADER).read_until(b'\n', &mut line)?;
    if line.is_empty() {
        return Ok(None);
    }
    let Some(line) = line.strip_suffix(b"\n") else { return Err(invalid("a header has no end")) };
    Ok(Some(String::from_utf8_lossy(line.strip_suffix(b"\r").unwrap_or(line)).into_owned()))
}

/// The length that a header gives; `None` for another header.
fn content_length(header: &str) -> io::Result<Option<usize>> {
    let (name, value) = header.split_once(':').ok_or_else(|| invalid("a header has no colon"))?;
    if !name.trim().eq_ignore_ascii_case("Content-Length") {
        return Ok(None);
    }
    let length = value.trim().parse().map_err(|_| invalid("Content-Length is not a number"))?;
    if length > TEXT_BUFFER { Err(invalid("a message is too long")) } else { Ok(Some(length)) }
}

fn invalid(what: &str) -> io::Error {
    io::Error::other(what.to_owned())
}

/// Writes a message.
pub(super) fn write(output: &mut impl Write, message: &str) -> io::Result<()> {
    write!(output, "Content-Length: {}\r\n\r\n{message}", message.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_follow_each_other() {
        let mut stream = Vec::new();
        for message in ["{}", "", "\"外\"\r\n\r\n"] {
            write(&mut stream, message).expect("memory takes all");
        }
        let mut input = stream.as_slice();
        for message in ["{}", "", "\"外\"\r\n\r\n"] {
            assert_eq!(read(&mut input).expect("a message").as_deref(), Some(message.as_bytes()));
        }
        assert_eq!(read(&mut input).expect("the end"), None);
    }

    #[test]
    fn other_headers_and_plain_line_ends_are_accepted() {
        let mut input = &b"Content-Type: text\ncontent-length:  2 \n\n{}"[..];
        assert_eq!(read(&mut input).expect("a message").as_deref(), Some(&b"{}"[..]));
    }

    #[test]
    fn what_is_no_frame_is_an_error() {
        for stream in [
            "{}\n",
            "\r\n{}",
            "Content-Length: two\r\n\r\n{}",
            "Content-Length: 3\r\n\r\n{}",
            "Content-Length: 99999999999\r\n\r\n{}",
            &"a".repeat(10_000),
        ] {
            assert!(read(&mut stream.as_bytes()).is_err(), "{stream:.40}");
        }
    }
}
