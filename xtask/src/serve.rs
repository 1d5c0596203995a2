//! In: a folder of static files and a port. Out: the folder on http://localhost, to this machine only. It
//! does what a page needs that any plain file host can serve, and nothing else. Text and wasm are sent
//! compressed, as such a host sends them: what loads slowly here loads slowly there.

use std::io::{self, BufRead, BufReader, Write};
use std::net::{Ipv4Addr, Ipv6Addr, TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;
use std::{fs, thread};

use flate2::Compression;
use flate2::write::GzEncoder;

/// The longest line of a request that is read.
const LINE_MAX: u64 = 16 * 1024;

/// Answers up to this many bytes fit one packet as they are.
const PLAIN_MAX: usize = 1024;

/// A port of this machine, taken.
pub struct Server {
    listeners: Vec<TcpListener>,
    /// The port.
    pub port: u16,
}

impl Server {
    /// Takes a port of this machine, on both kinds of address that `localhost` may mean.
    pub fn bind(port: u16) -> io::Result<Self> {
        let first = TcpListener::bind((Ipv4Addr::LOCALHOST, port))?;
        let port = first.local_addr()?.port();
        let second = match TcpListener::bind((Ipv6Addr::LOCALHOST, port)) {
            // Someone else's server would answer half of the requests.
            Err(error) if error.kind() == io::ErrorKind::AddrInUse => return Err(error),
            second => second.ok(),
        };
        Ok(Server { listeners: [Some(first), second].into_iter().flatten().collect(), port })
    }

    /// Serves the folder until the program is stopped.
    pub fn serve(self, folder: &Path) {
        let folder: Arc<Path> = folder.into();
        let loops: Vec<_> =
            self.listeners.into_iter().map(|listener| (listener, Arc::clone(&folder))).collect();
        let loops =
            loops.into_iter().map(|(listener, folder)| thread::spawn(move || accept(&listener, &folder)));
        for running in loops.collect::<Vec<_>>() {
            let _ = running.join();
        }
    }
}

fn accept(listener: &TcpListener, folder: &Arc<Path>) {
    for stream in listener.incoming().flatten() {
        let folder = Arc::clone(folder);
        // A browser that goes away in the middle of an answer is no concern of ours.
        thread::spawn(move || answer(&stream, &folder));
    }
}

fn answer(stream: &TcpStream, folder: &Path) -> io::Result<()> {
    stream.set_read_timeout(Some(Duration::from_secs(10)))?;
    let mut reader = io::Read::take(BufReader::new(stream), LINE_MAX);
    let mut request = String::new();
    reader.read_line(&mut request)?;
    // The rest of the head is read, lest the connection be reset before the answer arrives.
    let mut line = String::new();
    let mut gzip = false;
    while reader.read_line(&mut line)? > 2 {
        gzip |= takes_gzip(&line);
        line.clear();
        reader.set_limit(LINE_MAX);
    }
    let mut words = request.split(' ');
    let (method, target) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
    let found = match (method, find(folder, target)) {
        ("GET" | "HEAD", Some(path)) => {
            fs::read(&path).map(|body| ("200 OK", content_type(&path), body)).ok()
        }
        ("GET" | "HEAD", None) => None,
        _ => Some(("405 Method Not Allowed", "text/plain; charset=utf-8", b"only GET and HEAD\n".to_vec())),
    };
    let missing = || ("404 Not Found", "text/plain; charset=utf-8", b"no such file\n".to_vec());
    let (status, kind, mut body) = found.unwrap_or_else(missing);
    let mut encoding = "";
    if gzip && body.len() > PLAIN_MAX && shrinks(kind) {
        let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
        encoder.write_all(&body)?;
        body = encoder.finish()?;
        encoding = "Content-Encoding: gzip\r\n";
    }
    let mut stream = stream;
    write!(
        stream,
        "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {}\r\n{encoding}Vary: Accept-Encoding\r\n\
         Cache-Control: no-cache\r\nConnection: close\r\n\r\n",
        body.len()
    )?;
    if method != "HEAD" {
        stream.write_all(&body)?;
    }
    stream.flush()
}

/// Whether a line of a request's head says that the reader takes gzip.
fn takes_gzip(line: &str) -> bool {
    let Some((name, value)) = line.split_once(':') else { return false };
    let coding = |part: &str| part.split(';').next().is_some_and(|coding| coding.trim() == "gzip");
    name.eq_ignore_ascii_case("accept-encoding") && value.split(',').any(coding)
}

/// Whether gzip makes files of a content type smaller: pictures and fonts are compressed already.
fn shrinks(content_type: &str) -> bool {
    let kind = content_type.split(';').next().unwrap_or_default();
    kind.starts_with("text/") || ["application/json", "application/wasm", "image/svg+xml"].contains(&kind)
}

/// The file that the target of a request names; never one outside the folder.
fn find(folder: &Path, target: &str) -> Option<PathBuf> {
    let path = target.split(['?', '#']).next()?.strip_prefix('/')?;
    let mut file = folder.to_path_buf();
    for part in path.split('/') {
        let part = decoded(part)?;
        let unsafe_part = part.starts_with('.') || part.contains(['/', '\\', ':', '\0']);
        if unsafe_part {
            return None;
        }
        file.push(part);
    }
    let file = if file.is_dir() { file.join("index.html") } else { file };
    file.is_file().then_some(file)
}

fn decoded(part: &str) -> Option<String> {
    let mut bytes = Vec::new();
    let mut rest = part.as_bytes();
    while let [first, tail @ ..] = rest {
        rest = match (first, tail) {
            (b'%', [high, low, tail @ ..]) => {
                let digit =
                    |byte: u8| char::from(byte).to_digit(16).and_then(|digit| u8::try_from(digit).ok());
                bytes.push(digit(*high)? * 16 + digit(*low)?);
                tail
            }
            _ => {
                bytes.push(*first);
                tail
            }
        };
    }
    String::from_utf8(bytes).ok()
}

fn content_type(path: &Path) -> &'static str {
    match path.extension().and_then(|extension| extension.to_str()).unwrap_or_default() {
        "html" => "text/html; charset=utf-8",
        "js" | "mjs" => "text/javascript; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "json" | "map" | "webmanifest" => "application/json",
        "wasm" => "application/wasm",
        "svg" => "image/svg+xml",
        "png" => "image/png",
        "ico" => "image/x-icon",
        "woff2" => "font/woff2",
        "txt" | "md" | "nc" => "text/plain; charset=utf-8",
        _ => "application/octet-stream",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_files_of_the_folder_are_found() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
        let check = |target: &str, file: Option<&str>| {
            assert_eq!(find(folder, target), file.map(|file| folder.join(file)), "{target}");
        };
        check("/Cargo.toml", Some("Cargo.toml"));
        check("/Cargo.toml?v=1", Some("Cargo.toml"));
        check("/src/%6Dain.rs", Some("src/main.rs"));
        check("/src/../Cargo.toml", None);
        check("/../Cargo.toml", None);
        check("/%2e%2e/Cargo.toml", None);
        check("/src%2Fmain.rs", None);
        check("//etc/passwd", None);
        check("/no-such-file", None);
        check("Cargo.toml", None);
        check("/%zz", None);
        check("/%", None);
    }

    #[test]
    fn a_request_is_answered_in_full() -> io::Result<()> {
        let server = Server::bind(0)?;
        let port = server.port;
        thread::spawn(|| server.serve(Path::new(env!("CARGO_MANIFEST_DIR"))));
        let ask = |request: &str| -> io::Result<String> {
            let mut stream = TcpStream::connect((Ipv4Addr::LOCALHOST, port))?;
            stream.write_all(request.as_bytes())?;
            io::read_to_string(stream)
        };
        let answer = ask("GET /Cargo.toml HTTP/1.1\r\nHost: localhost\r\n\r\n")?;
        assert!(answer.starts_with("HTTP/1.1 200 OK\r\n"), "{answer}");
        assert!(answer.contains("name = \"xtask\""), "{answer}");
        assert!(ask("GET /none HTTP/1.1\r\n\r\n")?.starts_with("HTTP/1.1 404 "));
        assert!(ask("POST / HTTP/1.1\r\n\r\n")?.starts_with("HTTP/1.1 405 "));
        Ok(())
    }

    #[test]
    fn text_is_compressed_for_those_who_take_it() -> io::Result<()> {
        let folder = run_folder("compressed")?;
        let text = "G01 X20 Z-30 F0.2\n".repeat(1000);
        fs::write(folder.join("long.nc"), &text)?;
        fs::write(folder.join("short.nc"), "M30\n")?;
        fs::write(folder.join("picture.png"), &text)?;
        let server = Server::bind(0)?;
        let port = server.port;
        thread::spawn(move || server.serve(&folder));
        let ask = |file: &str, accept: &str| -> io::Result<(String, Vec<u8>)> {
            let mut stream = TcpStream::connect((Ipv4Addr::LOCALHOST, port))?;
            write!(stream, "GET /{file} HTTP/1.1\r\naccept-encoding: {accept}\r\n\r\n")?;
            let mut answer = Vec::new();
            io::Read::read_to_end(&mut stream, &mut answer)?;
            let head = answer.windows(4).position(|bytes| bytes == b"\r\n\r\n").expect("a head") + 4;
            let body = answer.split_off(head);
            Ok((String::from_utf8_lossy(&answer).into_owned(), body))
        };
        let (head, body) = ask("long.nc", "br, gzip;q=0.9")?;
        assert!(head.contains("\r\nContent-Encoding: gzip\r\n"), "{head}");
        assert!(head.contains(&format!("\r\nContent-Length: {}\r\n", body.len())), "{head}");
        assert!(body.len() < text.len() / 10);
        assert_eq!(io::read_to_string(flate2::read::GzDecoder::new(&body[..]))?, text);
        for (file, accept) in [("long.nc", "br"), ("short.nc", "gzip"), ("picture.png", "gzip")] {
            let (head, body) = ask(file, accept)?;
            assert!(!head.contains("Content-Encoding"), "{file}, {accept}: {head}");
            assert!(head.contains(&format!("\r\nContent-Length: {}\r\n", body.len())), "{head}");
        }
        Ok(())
    }

    /// A new folder for one test.
    fn run_folder(name: &str) -> io::Result<PathBuf> {
        let folder = std::env::temp_dir().join(format!("gcode-playground-{name}-{}", std::process::id()));
        fs::create_dir_all(&folder)?;
        Ok(folder)
    }

    #[test]
    fn only_an_accepted_coding_counts() {
        assert!(takes_gzip("Accept-Encoding: gzip, deflate, br\r\n"));
        assert!(takes_gzip("accept-encoding:gzip\r\n"));
        assert!(!takes_gzip("Accept-Encoding: br\r\n"));
        assert!(!takes_gzip("User-Agent: gzip\r\n"));
        assert!(shrinks("text/html; charset=utf-8") && shrinks("application/wasm"));
        assert!(!shrinks("image/png") && !shrinks("application/octet-stream"));
    }
}
