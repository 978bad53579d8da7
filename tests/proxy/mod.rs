//! A proxy on the loopback between the service and PostgreSQL. It reads the statements that pass, and disturbs the
//! connection of a chosen statement: before the statement reaches the server, or after the server ran it and before the
//! answer returns.
//!
//! It understands as much of the protocol as it needs: a statement is a simple query, or the binding of a prepared one.
//! Connections through it are not encrypted.

// Each test binary uses only a part of this module.
#![allow(dead_code)]

use std::collections::{BTreeSet, HashMap};
use std::io::{ErrorKind, Read, Write};
use std::net::{Shutdown, SocketAddr, TcpListener, TcpStream};
use std::os::unix::net::UnixStream;
use std::sync::atomic::{AtomicBool, AtomicU8, Ordering};
use std::sync::{Arc, Mutex};
use std::time::Duration;

/// Disturbance of the connection that carries a statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// The connection closes, and the server never gets the statement.
    CutBefore,
    /// The server runs the statement, and the connection closes instead of carrying the answer.
    CutAfter,
    /// The connection stays open, but the server never gets the statement.
    SilentBefore,
    /// The connection stays open and the server runs the statement, but no answer arrives.
    SilentAfter,
    /// The statement arrives late.
    Delay(Duration),
}

/// A statement and the one before it in the same transaction. The text before the first statement of a transaction, and
/// before a statement outside of one, is empty.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Boundary {
    pub previous: String,
    pub statement: String,
}

/// A fault that waits for its statement.
#[derive(Debug)]
struct Rule {
    /// Parts of the texts. An empty part matches every text.
    boundary: Boundary,
    fault: Fault,
    /// Number of matching statements that still get the fault.
    times: usize,
    fired: Arc<AtomicBool>,
}

/// Tells whether a fault has happened.
#[derive(Clone, Debug)]
pub struct Fired(Arc<AtomicBool>);

impl Fired {
    pub fn yet(&self) -> bool {
        self.0.load(Ordering::SeqCst)
    }
}

#[derive(Debug, Default)]
struct State {
    rules: Mutex<Vec<Rule>>,
    seen: Mutex<BTreeSet<Boundary>>,
    /// True while the network is silent: open connections carry nothing and new ones are accepted without an answer.
    silent: AtomicBool,
    connections: Mutex<Vec<(TcpStream, UnixStream)>>,
}

/// A running proxy. It ends with its process.
#[derive(Debug)]
pub struct Proxy {
    address: SocketAddr,
    database: String,
    state: Arc<State>,
}

const FORWARD: u8 = 0;
/// The next answer is dropped and the connection closes.
const CUT: u8 = 1;
/// No answer arrives any more.
const SILENT: u8 = 2;

impl Proxy {
    /// Starts a proxy to a database of [`crate::postgres::Postgres`].
    pub fn start(url: &str) -> Self {
        let (server, folder) = url.split_once("?host=").expect("the URL of a server's socket");
        let database = server.rsplit_once('/').expect("a database").1.to_owned();
        let socket = format!("{folder}/.s.PGSQL.5432");
        let listener = TcpListener::bind("127.0.0.1:0").expect("a free port");
        let address = listener.local_addr().expect("an address");
        let state = Arc::new(State::default());
        let shared = Arc::clone(&state);
        std::thread::spawn(move || {
            for client in listener.incoming().flatten() {
                // A stopped server refuses connections. Dropping the client's end passes that on.
                let Ok(server) = UnixStream::connect(&socket) else { continue };
                let state = Arc::clone(&shared);
                std::thread::spawn(move || carry(&state, client, server));
            }
        });
        Self { address, database, state }
    }

    /// URL of the database through this proxy.
    pub fn url(&self) -> String {
        format!("postgres://postgres@{}/{}?sslmode=disable", self.address, self.database)
    }

    /// Disturbs the next statement whose text contains `statement`.
    pub fn disturb(&self, statement: &str, fault: Fault) -> Fired {
        self.disturb_at(Boundary { previous: String::new(), statement: statement.into() }, fault, 1)
    }

    /// Disturbs the next COMMIT of a transaction whose last statement contains `last`.
    pub fn disturb_commit(&self, last: &str, fault: Fault) -> Fired {
        self.disturb_at(Boundary { previous: last.into(), statement: "COMMIT".into() }, fault, 1)
    }

    /// Disturbs the next `times` statements that match both texts of the boundary.
    pub fn disturb_at(&self, boundary: Boundary, fault: Fault, times: usize) -> Fired {
        let fired = Arc::new(AtomicBool::new(false));
        self.state.rules.lock().unwrap().push(Rule { boundary, fault, times, fired: fired.clone() });
        Fired(fired)
    }

    /// Forgets every fault that has not happened.
    pub fn calm(&self) {
        self.state.rules.lock().unwrap().clear();
    }

    /// Starts or ends a silence of the whole network.
    pub fn silence(&self, silent: bool) {
        self.state.silent.store(silent, Ordering::SeqCst);
        if !silent {
            // Statements that were sent during the silence are lost, so their connections cannot go on.
            self.cut_all();
        }
    }

    /// Closes every open connection.
    pub fn cut_all(&self) {
        for (client, server) in self.state.connections.lock().unwrap().drain(..) {
            let _ = client.shutdown(Shutdown::Both);
            let _ = server.shutdown(Shutdown::Both);
        }
    }

    /// Forgets the statements that have passed.
    pub fn forget(&self) {
        self.state.seen.lock().unwrap().clear();
    }

    /// Returns every statement that has passed, with the one before it in its transaction.
    pub fn seen(&self) -> BTreeSet<Boundary> {
        self.state.seen.lock().unwrap().clone()
    }
}

impl State {
    /// Returns the fault of this statement.
    fn fault(&self, boundary: &Boundary) -> Option<Fault> {
        let mut rules = self.rules.lock().unwrap();
        let matches = |rule: &Rule| {
            boundary.previous.contains(&rule.boundary.previous) && boundary.statement.contains(&rule.boundary.statement)
        };
        let index = rules.iter().position(matches)?;
        let rule = &mut rules[index];
        let fault = rule.fault;
        rule.fired.store(true, Ordering::SeqCst);
        rule.times -= 1;
        if rule.times == 0 {
            rules.remove(index);
        }
        Some(fault)
    }
}

/// Forwards the bytes of one connection in both directions.
fn carry(state: &Arc<State>, client: TcpStream, server: UnixStream) {
    let _ = client.set_nodelay(true);
    let clones = || Ok::<_, std::io::Error>((client.try_clone()?, server.try_clone()?));
    let (Ok(kept), Ok((to_client, from_server))) = (clones(), clones()) else { return };
    state.connections.lock().unwrap().push(kept);
    let answers = Arc::new(AtomicU8::new(FORWARD));
    let (shared, mode) = (Arc::clone(state), Arc::clone(&answers));
    std::thread::spawn(move || carry_answers(&shared, &mode, from_server, to_client));
    let silent_end = carry_requests(state, &answers, &client, &server).unwrap_or(false);
    if !silent_end {
        let _ = client.shutdown(Shutdown::Both);
        let _ = server.shutdown(Shutdown::Both);
    }
}

/// Reads one message that begins with its type. Returns the type and all bytes of the message.
fn message(from: &mut impl Read) -> std::io::Result<(u8, Vec<u8>)> {
    let mut head = [0; 5];
    from.read_exact(&mut head)?;
    let length = u32::from_be_bytes([head[1], head[2], head[3], head[4]]) as usize;
    let mut bytes = head.to_vec();
    bytes.resize(1 + length, 0);
    from.read_exact(&mut bytes[5..])?;
    Ok((head[0], bytes))
}

/// Returns the texts that end with a zero at the beginning of a message's content.
fn texts(bytes: &[u8]) -> impl Iterator<Item = String> + '_ {
    bytes[5..].split(|byte| *byte == 0).map(|text| String::from_utf8_lossy(text).into_owned())
}

/// Forwards statements to the server. Returns true if the connection became silent, so that the server does not learn
/// of its end.
fn carry_requests(
    state: &State,
    answers: &AtomicU8,
    mut client: &TcpStream,
    mut server: &UnixStream,
) -> std::io::Result<bool> {
    // The first message has no type.
    let mut length = [0; 4];
    client.read_exact(&mut length)?;
    let mut start = length.to_vec();
    start.resize(u32::from_be_bytes(length) as usize, 0);
    client.read_exact(&mut start[4..])?;
    if state.silent.load(Ordering::SeqCst) {
        return swallow(client);
    }
    server.write_all(&start)?;
    let (mut prepared, mut previous, mut in_transaction) = (HashMap::new(), String::new(), false);
    loop {
        let (kind, bytes) = message(&mut client)?;
        if state.silent.load(Ordering::SeqCst) {
            return swallow(client);
        }
        let statement = match kind {
            b'P' => {
                let mut texts = texts(&bytes);
                prepared.insert(texts.next().unwrap_or_default(), texts.next().unwrap_or_default());
                None
            }
            b'B' => texts(&bytes).nth(1).and_then(|name| prepared.get(&name).cloned()),
            b'Q' => texts(&bytes).next(),
            _ => None,
        };
        if let Some(statement) = statement {
            if statement.starts_with("BEGIN") {
                (in_transaction, previous) = (true, String::new());
            }
            let boundary = Boundary { previous: std::mem::take(&mut previous), statement };
            in_transaction &= !["COMMIT", "ROLLBACK"].contains(&boundary.statement.as_str());
            if in_transaction {
                previous.clone_from(&boundary.statement);
            }
            let fault = state.fault(&boundary);
            state.seen.lock().unwrap().insert(boundary);
            match fault {
                None => {}
                Some(Fault::CutBefore) => return Ok(false),
                Some(Fault::CutAfter) => answers.store(CUT, Ordering::SeqCst),
                Some(Fault::SilentBefore) => return swallow(client),
                Some(Fault::SilentAfter) => answers.store(SILENT, Ordering::SeqCst),
                Some(Fault::Delay(time)) => std::thread::sleep(time),
            }
        }
        server.write_all(&bytes)?;
    }
}

/// Reads and drops everything until the client closes.
fn swallow(mut client: &TcpStream) -> std::io::Result<bool> {
    let mut dropped = [0; 4096];
    loop {
        match client.read(&mut dropped) {
            Ok(0) => return Ok(true),
            Err(error) if error.kind() != ErrorKind::Interrupted => return Ok(true),
            _ => {}
        }
    }
}

fn carry_answers(state: &State, mode: &AtomicU8, mut server: UnixStream, mut client: TcpStream) {
    while let Ok((kind, bytes)) = message(&mut server) {
        match mode.load(Ordering::SeqCst) {
            FORWARD if !state.silent.load(Ordering::SeqCst) && client.write_all(&bytes).is_err() => break,
            // The message `Z` (ReadyForQuery) says that the server has run the statement.
            CUT if kind == b'Z' => break,
            _ => {}
        }
    }
    if mode.load(Ordering::SeqCst) != SILENT && !state.silent.load(Ordering::SeqCst) {
        let _ = client.shutdown(Shutdown::Both);
        let _ = server.shutdown(Shutdown::Both);
    }
}
