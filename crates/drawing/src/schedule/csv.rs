//! Tables as CSV (RFC 4180) in UTF-8.

use std::fmt::Write as _;

/// A table that is being written.
#[derive(Debug)]
pub struct Table {
    text: String,
    columns: usize,
}

/// A value of a table.
#[derive(Clone, Copy, Debug)]
pub enum Cell<'a> {
    Text(&'a str),
    Count(usize),
    Number(f64),
    Empty,
}

impl From<Option<f64>> for Cell<'_> {
    fn from(number: Option<f64>) -> Self {
        number.map_or(Self::Empty, Self::Number)
    }
}

impl Table {
    /// Begins a table with the names of its columns.
    #[must_use]
    pub fn new<S: AsRef<str>>(columns: &[S]) -> Self {
        let mut table = Self { text: String::new(), columns: columns.len() };
        let cells: Vec<Cell<'_>> = columns.iter().map(|name| Cell::Text(name.as_ref())).collect();
        table.row(&cells);
        table
    }

    /// Adds a row with a cell for each column.
    pub fn row(&mut self, cells: &[Cell<'_>]) {
        debug_assert_eq!(cells.len(), self.columns);
        for (k, cell) in cells.iter().enumerate() {
            if k > 0 {
                self.text.push(',');
            }
            // Writing to a String cannot fail.
            let _ = match cell {
                Cell::Text(text) => {
                    quoted(text, &mut self.text);
                    Ok(())
                }
                Cell::Count(count) => write!(self.text, "{count}"),
                Cell::Number(number) => write!(self.text, "{number:?}"),
                Cell::Empty => Ok(()),
            };
        }
        self.text.push_str("\r\n");
    }

    #[must_use]
    pub fn into_bytes(self) -> Vec<u8> {
        self.text.into_bytes()
    }
}

fn quoted(text: &str, out: &mut String) {
    if text.contains([',', '"', '\n', '\r']) || text.starts_with(' ') || text.ends_with(' ') {
        out.push('"');
        out.push_str(&text.replace('"', "\"\""));
        out.push('"');
    } else {
        out.push_str(text);
    }
}
