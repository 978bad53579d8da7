//! The flat pattern as DXF (AC1015, AutoCAD 2000), true to scale in the client's unit. `$INSUNITS` names the unit.
//!
//! The layers `CUT`, `FOLD_MOUNTAIN`, `FOLD_VALLEY`, `FOLD_FLAT` and `LABEL` allow a cutting program to use a different
//! tool for each. AC1015 is used instead of the shorter R12 because R12 cannot name its unit. This module writes the
//! format itself, because a crate for DXF would add an image library. A pattern needs only one closed `LWPOLYLINE` per
//! piece, `LINE` and `TEXT`, and the tables that every file must have.

use std::fmt::{Display, Write as _};

use plateau_mesh::DVec2;

use super::obj::one_line;
use super::svg::{label_height, middle};
use crate::archive::Contents;
use crate::pattern::{FoldKind, Pattern};
use crate::units::Unit;

const LAYERS: [(&str, u8, &str); 6] = [
    ("0", 7, "CONTINUOUS"),
    ("CUT", 7, "CONTINUOUS"),
    ("FOLD_MOUNTAIN", 1, "DASHDOT"),
    ("FOLD_VALLEY", 5, "DASHED"),
    ("FOLD_FLAT", 8, "DASHED"),
    ("LABEL", 3, "CONTINUOUS"),
];

/// Fixed handles that other parts of the file refer to. All other handles are counted from `FIRST_FREE_HANDLE`.
const MODEL_SPACE: u32 = 0x1F;
const PAPER_SPACE: u32 = 0x1B;
const ROOT_DICTIONARY: u32 = 0xC;
const GROUP_DICTIONARY: u32 = 0xD;
const FIRST_FREE_HANDLE: u32 = 0x30;

/// Writes all pieces on one sheet, as [`Pattern::sheet`] lays them out.
#[must_use]
pub fn to_dxf(pattern: &Pattern, contents: &Contents) -> Vec<u8> {
    let sheet = pattern.sheet();
    let mut body = Writer { text: String::new(), next_handle: FIRST_FREE_HANDLE };
    body.section("CLASSES", |_| {});
    body.section("TABLES", |out| out.tables(sheet.size));
    body.section("BLOCKS", Writer::blocks);
    body.section("ENTITIES", |out| {
        for piece in &sheet.pieces {
            out.outline(&piece.outline);
            for fold in &piece.folds {
                let layer = match fold.kind() {
                    FoldKind::Mountain => "FOLD_MOUNTAIN",
                    FoldKind::Valley => "FOLD_VALLEY",
                    FoldKind::Flat => "FOLD_FLAT",
                };
                out.line(fold.ends, layer);
            }
            out.label(middle(piece), label_height(sheet.size), &piece.name);
        }
    });
    body.section("OBJECTS", Writer::objects);
    body.pair(0, "EOF");

    // The header contains the next free handle, so it is written after the body.
    let mut file = Writer { text: String::new(), next_handle: body.next_handle };
    file.pair(999, one_line(&contents.generator));
    file.section("HEADER", |out| {
        out.variable("$ACADVER", 1, "AC1015");
        out.variable("$DWGCODEPAGE", 3, "ANSI_1252");
        out.variable("$INSUNITS", 70, insunits(contents.unit));
        out.variable("$MEASUREMENT", 70, u8::from(!matches!(contents.unit, Unit::Inch | Unit::Foot)));
        out.variable("$HANDSEED", 5, format_args!("{:X}", body.next_handle));
        out.pair(9, "$EXTMIN");
        out.point(10, DVec2::ZERO);
        out.pair(9, "$EXTMAX");
        out.point(10, sheet.size);
    });
    file.text.push_str(&body.text);
    file.text.into_bytes()
}

fn insunits(unit: Unit) -> u8 {
    match unit {
        Unit::Inch => 1,
        Unit::Foot => 2,
        Unit::Millimetre => 4,
        Unit::Centimetre => 5,
        Unit::Metre => 6,
    }
}

struct Writer {
    text: String,
    next_handle: u32,
}

impl Writer {
    fn pair(&mut self, code: u16, value: impl Display) {
        writeln!(self.text, "{code:>3}\n{value}").expect("writing to memory");
    }

    /// Writes the shortest text that reads back as the same f64.
    fn number(&mut self, code: u16, value: f64) {
        self.pair(code, format_args!("{value:?}"));
    }

    /// Writes x under `code`, y under `code + 10` and z = 0 under `code + 20`.
    fn point(&mut self, code: u16, point: DVec2) {
        self.number(code, point.x);
        self.number(code + 10, point.y);
        self.number(code + 20, 0.0);
    }

    fn variable(&mut self, name: &str, code: u16, value: impl Display) {
        self.pair(9, name);
        self.pair(code, value);
    }

    fn section(&mut self, name: &str, fill: impl FnOnce(&mut Self)) {
        self.pair(0, "SECTION");
        self.pair(2, name);
        fill(self);
        self.pair(0, "ENDSEC");
    }

    fn new_handle(&mut self) -> u32 {
        self.next_handle += 1;
        self.next_handle - 1
    }

    fn handle(&mut self, code: u16, handle: u32) {
        self.pair(code, format_args!("{handle:X}"));
    }

    /// Writes a table. `records` writes its records.
    fn table(&mut self, name: &str, count: usize, records: impl FnOnce(&mut Self, u32)) {
        let table = self.new_handle();
        self.pair(0, "TABLE");
        self.pair(2, name);
        self.handle(5, table);
        self.handle(330, 0);
        self.pair(100, "AcDbSymbolTable");
        self.pair(70, count);
        if name == "DIMSTYLE" {
            self.pair(100, "AcDbDimStyleTable");
        }
        records(self, table);
        self.pair(0, "ENDTAB");
    }

    fn record(&mut self, kind: &str, class: &str, table: u32, name: &str) {
        let handle = self.new_handle();
        self.pair(0, kind);
        self.handle(if kind == "DIMSTYLE" { 105 } else { 5 }, handle);
        self.handle(330, table);
        self.pair(100, "AcDbSymbolTableRecord");
        self.pair(100, class);
        self.pair(2, name);
        self.pair(70, 0);
    }

    fn tables(&mut self, sheet: DVec2) {
        self.table("VPORT", 1, |out, table| {
            out.record("VPORT", "AcDbViewportTableRecord", table, "*ACTIVE");
            // The values are the lower left and upper right of the window, and the centre, height and aspect of the
            // view.
            for (code, x, y) in [(10, 0.0, 0.0), (11, 1.0, 1.0), (12, 0.5 * sheet.x, 0.5 * sheet.y)] {
                out.number(code, x);
                out.number(code + 10, y);
            }
            out.number(40, 1.1 * sheet.max_element());
            out.number(41, 1.0);
        });
        let dash = sheet.max_element() / 200.0;
        let patterns: [(&str, &[f64]); 5] = [
            ("ByBlock", &[]),
            ("ByLayer", &[]),
            ("CONTINUOUS", &[]),
            ("DASHED", &[2.0, -1.0]),
            ("DASHDOT", &[2.0, -0.75, 0.0, -0.75]),
        ];
        self.table("LTYPE", patterns.len(), |out, table| {
            for (name, pattern) in patterns {
                out.record("LTYPE", "AcDbLinetypeTableRecord", table, name);
                out.pair(3, "");
                out.pair(72, 65);
                out.pair(73, pattern.len());
                out.number(40, pattern.iter().map(|length| length.abs() * dash).sum());
                for length in pattern {
                    out.number(49, length * dash);
                    out.pair(74, 0);
                }
            }
        });
        self.table("LAYER", LAYERS.len(), |out, table| {
            for (name, color, line_type) in LAYERS {
                out.record("LAYER", "AcDbLayerTableRecord", table, name);
                out.pair(62, color);
                out.pair(6, line_type);
            }
        });
        self.table("STYLE", 1, |out, table| {
            out.record("STYLE", "AcDbTextStyleTableRecord", table, "STANDARD");
            for (code, value) in [(40, 0.0), (41, 1.0), (50, 0.0)] {
                out.number(code, value);
            }
            out.pair(71, 0);
            out.number(42, 1.0);
            out.pair(3, "txt");
            out.pair(4, "");
        });
        self.table("VIEW", 0, |_, _| {});
        self.table("UCS", 0, |_, _| {});
        self.table("APPID", 1, |out, table| out.record("APPID", "AcDbRegAppTableRecord", table, "ACAD"));
        self.table("DIMSTYLE", 1, |out, table| {
            out.record("DIMSTYLE", "AcDbDimStyleTableRecord", table, "STANDARD");
        });
        self.table("BLOCK_RECORD", 2, |out, table| {
            for (name, handle) in [("*MODEL_SPACE", MODEL_SPACE), ("*PAPER_SPACE", PAPER_SPACE)] {
                out.pair(0, "BLOCK_RECORD");
                out.handle(5, handle);
                out.handle(330, table);
                out.pair(100, "AcDbSymbolTableRecord");
                out.pair(100, "AcDbBlockTableRecord");
                out.pair(2, name);
            }
        });
    }

    /// Writes model space and paper space. Both blocks are empty, because the entities have their own section.
    fn blocks(&mut self) {
        for (name, record) in [("*MODEL_SPACE", MODEL_SPACE), ("*PAPER_SPACE", PAPER_SPACE)] {
            self.entity("BLOCK", record, "0", "AcDbBlockBegin");
            self.pair(2, name);
            self.pair(70, 0);
            self.point(10, DVec2::ZERO);
            self.pair(3, name);
            self.pair(1, "");
            self.entity("ENDBLK", record, "0", "AcDbBlockEnd");
        }
    }

    fn entity(&mut self, kind: &str, owner: u32, layer: &str, class: &str) {
        let handle = self.new_handle();
        self.pair(0, kind);
        self.handle(5, handle);
        self.handle(330, owner);
        self.pair(100, "AcDbEntity");
        self.pair(8, layer);
        self.pair(100, class);
    }

    fn outline(&mut self, points: &[DVec2]) {
        self.entity("LWPOLYLINE", MODEL_SPACE, "CUT", "AcDbPolyline");
        self.pair(90, points.len());
        self.pair(70, 1);
        for point in points {
            self.number(10, point.x);
            self.number(20, point.y);
        }
    }

    fn line(&mut self, [start, end]: [DVec2; 2], layer: &str) {
        self.entity("LINE", MODEL_SPACE, layer, "AcDbLine");
        self.point(10, start);
        self.point(11, end);
    }

    fn label(&mut self, at: DVec2, height: f64, text: &str) {
        self.entity("TEXT", MODEL_SPACE, "LABEL", "AcDbText");
        self.point(10, at);
        self.number(40, height);
        self.pair(1, ascii(text));
        self.pair(72, 1);
        self.point(11, at);
        self.pair(100, "AcDbText");
        self.pair(73, 2);
    }

    fn objects(&mut self) {
        for (handle, owner, entry) in [(ROOT_DICTIONARY, 0, true), (GROUP_DICTIONARY, ROOT_DICTIONARY, false)] {
            self.pair(0, "DICTIONARY");
            self.handle(5, handle);
            self.handle(330, owner);
            self.pair(100, "AcDbDictionary");
            self.pair(281, 1);
            if entry {
                self.pair(3, "ACAD_GROUP");
                self.handle(350, GROUP_DICTIONARY);
            }
        }
    }
}

/// Returns `text` in ASCII, because AC1015 is older than UTF-8 in DXF. Other characters become `\U+XXXX`.
fn ascii(text: &str) -> String {
    let mut out = String::new();
    for c in one_line(text).chars() {
        let mut units = [0; 2];
        match c {
            ' '..='~' => out.push(c),
            _ => c.encode_utf16(&mut units).iter().for_each(|unit| out.push_str(&format!("\\U+{unit:04X}"))),
        }
    }
    out
}
