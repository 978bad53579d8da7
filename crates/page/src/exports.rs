//! The functions that JavaScript calls, and the functions that the module calls in JavaScript.
//!
//! Bytes go in through [`plateau_input`], which returns the address at which JavaScript writes them. They come out as
//! an address and a length. An address is valid until the next call, because memory may move then.

// WebAssembly exports and imports functions by their names, and Rust counts both as unsafe: another item of the program
// could have the same name, and nothing checks what an imported function does.
#![allow(unsafe_code)]

use crate::session::{Ending, Session};
use plateau_engine::report::Progress;
use plateau_engine::solved::Signal;
use std::cell::RefCell;

thread_local! {
    static INPUT: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static SESSION: RefCell<Session> = RefCell::default();
    static FILE: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

#[link(wasm_import_module = "plateau")]
unsafe extern "C" {
    /// Returns 0 to go on, 1 to cancel, 2 to end with the best result so far.
    safe fn signal() -> u32;
    safe fn progress(
        fraction: f64,
        phase: *const u8,
        phase_bytes: usize,
        iteration: f64,
        objective: f64,
        residual: f64,
    );
}

/// Makes room for `bytes` bytes of input and returns their address.
#[unsafe(no_mangle)]
extern "C" fn plateau_input(bytes: usize) -> *mut u8 {
    INPUT.with_borrow_mut(|input| {
        input.clear();
        input.resize(bytes, 0);
        input.as_mut_ptr()
    })
}

/// Solves the request in the input, and returns its [`Ending`](crate::session::Ending) as a number.
#[unsafe(no_mangle)]
extern "C" fn plateau_solve() -> u32 {
    run(Session::solve)
}

/// Moves the last result to the positions that the request in the input gives, or solves that request. Returns its
/// [`Ending`](crate::session::Ending) as a number.
#[unsafe(no_mangle)]
extern "C" fn plateau_drag() -> u32 {
    run(Session::drag)
}

fn run(entry: fn(&mut Session, &[u8], &dyn Fn() -> Signal, &dyn Fn(Progress)) -> Ending) -> u32 {
    let asked = || match signal() {
        0 => Signal::Continue,
        1 => Signal::Cancel,
        _ => Signal::Deadline,
    };
    let report = |Progress { fraction, phase, iteration, objective_value, residual }: Progress| {
        // JavaScript reads NaN as a value that is not known.
        let (objective, residual) = (objective_value.unwrap_or(f64::NAN), residual.unwrap_or(f64::NAN));
        progress(fraction, phase.as_ptr(), phase.len(), iteration as f64, objective, residual);
    };
    let request = INPUT.take();
    FILE.take();
    SESSION.with_borrow_mut(|session| entry(session, &request, &asked, &report) as u32)
}

#[unsafe(no_mangle)]
extern "C" fn plateau_answer() -> *const u8 {
    SESSION.with_borrow(|session| session.answer().as_ptr())
}

#[unsafe(no_mangle)]
extern "C" fn plateau_answer_bytes() -> usize {
    SESSION.with_borrow(|session| session.answer().len())
}

/// Returns the address of the vertices of the last result or of its preview, three f64 each.
#[unsafe(no_mangle)]
extern "C" fn plateau_vertices() -> *const u8 {
    SESSION.with_borrow(|session| session.vertices().as_ptr().cast())
}

#[unsafe(no_mangle)]
extern "C" fn plateau_vertices_count() -> usize {
    SESSION.with_borrow(|session| session.vertices().len())
}

/// Returns the address of the triangles of the last result, three u32 each.
#[unsafe(no_mangle)]
extern "C" fn plateau_triangles() -> *const u8 {
    SESSION.with_borrow(|session| session.triangles().as_ptr().cast())
}

#[unsafe(no_mangle)]
extern "C" fn plateau_triangles_count() -> usize {
    SESSION.with_borrow(|session| session.triangles().len())
}

/// Makes the file whose format is named in the input. Returns its length, or 0 if there is none.
#[unsafe(no_mangle)]
extern "C" fn plateau_file() -> usize {
    let format = INPUT.take();
    let file = std::str::from_utf8(&format).ok().and_then(|format| SESSION.with_borrow(|session| session.file(format)));
    FILE.with_borrow_mut(|last| {
        *last = file.unwrap_or_default();
        last.len()
    })
}

#[unsafe(no_mangle)]
extern "C" fn plateau_file_address() -> *const u8 {
    FILE.with_borrow(|file| file.as_ptr())
}
