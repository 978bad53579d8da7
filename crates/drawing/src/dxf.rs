//! Drawings as DXF (AC1015, AutoCAD 2000), true to scale in millimetres, which `$INSUNITS` names.
//!
//! Every layer of a drawing is a layer of the file, so that a cutting program can use a different tool for each. Fold
//! and bend lines have their angle in degrees as extended data of the application `PLATEAU`. AC1015 is used instead of
//! the shorter R12 because R12 cannot name its unit. This module writes the format itself, because a crate for DXF
//! would add an image library. A drawing needs only closed `LWPOLYLINE`, `LINE` and `TEXT`, and the tables that every
//! file must have.

use crate::drawing::Drawing;
use crate::figure::Shape;
use crate::label::Spot;
use crate::options::{Layer, LayerNames};
use plateau_mesh::{DVec2, DVec3};
use std::fmt::{Display, Write as _};

/// A layer of a file: its name, colour number and line type.
type FileLayer = (String, u8, &'static str);

/// Name of the application whose extended data the lines have.
const APPLICATION: &str = "PLATEAU";

/// Fixed handles that other parts of the file refer to. All other handles are counted from `FIRST_FREE_HANDLE`.
const MODEL_SPACE: u32 = 0x1F;
const PAPER_SPACE: u32 = 0x1B;
/// The blocks that every file has, with the handles of their records.
const SPACES: [(&str, u32); 2] = [("*MODEL_SPACE", MODEL_SPACE), ("*PAPER_SPACE", PAPER_SPACE)];
const ROOT_DICTIONARY: u32 = 0xC;
const GROUP_DICTIONARY: u32 = 0xD;
const FIRST_FREE_HANDLE: u32 = 0x30;

/// Writes a drawing.
#[must_use]
pub fn to_dxf(drawing: &Drawing, layers: &LayerNames) -> Vec<u8> {
    let used: Vec<Layer> = Layer::ALL.into_iter().filter(|layer| is_used(drawing, *layer)).collect();
    let named: Vec<FileLayer> = used
        .iter()
        .map(|&layer| {
            let (color, line_type) = style(layer);
            (layers.of(layer).to_owned(), color, line_type)
        })
        .collect();
    file(&named, [DVec3::ZERO, drawing.size.extend(0.0)], 4, &drawing.generator, |out| {
        for shape in drawing.groups.iter().flat_map(|group| &group.shapes) {
            match shape {
                Shape::Polygon { layer, points } => out.polygon(points, layers.of(*layer)),
                Shape::Line { layer, ends, angle_deg } => {
                    out.line(ends.map(|end| end.extend(0.0)), layers.of(*layer));
                    angle_deg.iter().for_each(|&angle| out.angle(angle));
                }
                Shape::Text { layer, text, spot } => out.text(text, spot, layers.of(*layer)),
            }
        }
    })
}

fn is_used(drawing: &Drawing, layer: Layer) -> bool {
    drawing.groups.iter().flat_map(|group| &group.shapes).any(|shape| match shape {
        Shape::Polygon { layer: own, .. } | Shape::Line { layer: own, .. } | Shape::Text { layer: own, .. } => {
            *own == layer
        }
    })
}

/// Returns the colour number and the line type of a layer.
fn style(layer: Layer) -> (u8, &'static str) {
    match layer {
        Layer::Cut => (7, "CONTINUOUS"),
        Layer::Sew => (6, "DASHED"),
        Layer::BendUp | Layer::FoldValley => (5, "DASHED"),
        Layer::BendDown | Layer::FoldMountain => (1, "DASHDOT"),
        Layer::FoldFlat => (8, "DASHED"),
        Layer::BendZone | Layer::Mark | Layer::Sheet | Layer::Register | Layer::Dimension => (8, "CONTINUOUS"),
        Layer::Notch => (2, "CONTINUOUS"),
        Layer::Grain | Layer::Text | Layer::ScaleBar => (3, "CONTINUOUS"),
    }
}

/// Writes a file of AutoCAD 2000 with these layers besides `0`. `units` is the value of `$INSUNITS`.
pub(crate) fn file(
    layers: &[FileLayer],
    extent: [DVec3; 2],
    units: u8,
    generator: &str,
    entities: impl FnOnce(&mut Writer),
) -> Vec<u8> {
    complete(layers, extent, Some(units), generator, &[], |_, _| {}, entities)
}

/// Writes a file with blocks of these names, which `block` fills by their number. With `units` it is one of AutoCAD
/// 2000, and of R13 without, which cannot name its unit.
pub(crate) fn complete(
    layers: &[FileLayer],
    [low, high]: [DVec3; 2],
    units: Option<u8>,
    generator: &str,
    blocks: &[String],
    block: impl FnMut(&mut Writer, usize),
    entities: impl FnOnce(&mut Writer),
) -> Vec<u8> {
    let mut body = Writer { text: String::new(), next_handle: FIRST_FREE_HANDLE, owner: MODEL_SPACE };
    // Handles of the blocks' records.
    let records: Vec<u32> = blocks.iter().map(|_| body.new_handle()).collect();
    let named: Vec<(&str, u32)> = blocks.iter().map(String::as_str).zip(records).collect();
    body.section("CLASSES", |_| {});
    body.section("TABLES", |out| out.tables(layers, [low, high], &named));
    body.section("BLOCKS", |out| out.blocks(&named, block));
    body.section("ENTITIES", entities);
    body.section("OBJECTS", |out| out.objects(units.is_some()));
    body.pair(0, "EOF");

    // The header contains the next free handle, so it is written after the body.
    let mut file = Writer { text: String::new(), next_handle: body.next_handle, owner: MODEL_SPACE };
    file.pair(999, one_line(generator));
    file.section("HEADER", |out| {
        out.variable("$ACADVER", 1, if units.is_some() { "AC1015" } else { "AC1012" });
        out.variable("$DWGCODEPAGE", 3, "ANSI_1252");
        if let Some(units) = units {
            out.variable("$INSUNITS", 70, units);
            out.variable("$MEASUREMENT", 70, u8::from(!matches!(units, 1 | 2)));
        }
        out.variable("$HANDSEED", 5, format_args!("{:X}", body.next_handle));
        out.pair(9, "$EXTMIN");
        out.point(10, low);
        out.pair(9, "$EXTMAX");
        out.point(10, high);
    });
    file.text.push_str(&body.text);
    file.text.into_bytes()
}

fn one_line(text: &str) -> String {
    text.replace(|c: char| c.is_control(), " ")
}

pub(crate) struct Writer {
    text: String,
    next_handle: u32,
    /// Handle of the block record that entities belong to.
    owner: u32,
}

impl Writer {
    fn pair(&mut self, code: u16, value: impl Display) {
        writeln!(self.text, "{code:>3}\n{value}").expect("writing to memory");
    }

    /// Writes the shortest text that reads back as the same f64.
    fn number(&mut self, code: u16, value: f64) {
        self.pair(code, format_args!("{value:?}"));
    }

    /// Writes x under `code`, y under `code + 10` and z under `code + 20`.
    fn point(&mut self, code: u16, point: DVec3) {
        self.number(code, point.x);
        self.number(code + 10, point.y);
        self.number(code + 20, point.z);
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

    fn tables(&mut self, layers: &[FileLayer], [low, high]: [DVec3; 2], blocks: &[(&str, u32)]) {
        let (sheet, middle) = (high - low, low.midpoint(high));
        self.table("VPORT", 1, |out, table| {
            out.record("VPORT", "AcDbViewportTableRecord", table, "*ACTIVE");
            // The values are the lower left and upper right of the window, and the centre, height and aspect of the
            // view.
            for (code, x, y) in [(10, 0.0, 0.0), (11, 1.0, 1.0), (12, middle.x, middle.y)] {
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
        let default = ("0".to_owned(), 7, "CONTINUOUS");
        self.table("LAYER", layers.len() + 1, |out, table| {
            for (name, color, line_type) in std::iter::once(&default).chain(layers) {
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
        self.table("APPID", 2, |out, table| {
            for name in ["ACAD", APPLICATION] {
                out.record("APPID", "AcDbRegAppTableRecord", table, name);
            }
        });
        self.table("DIMSTYLE", 1, |out, table| {
            out.record("DIMSTYLE", "AcDbDimStyleTableRecord", table, "STANDARD");
        });
        self.table("BLOCK_RECORD", SPACES.len() + blocks.len(), |out, table| {
            for &(name, handle) in SPACES.iter().chain(blocks) {
                out.pair(0, "BLOCK_RECORD");
                out.handle(5, handle);
                out.handle(330, table);
                out.pair(100, "AcDbSymbolTableRecord");
                out.pair(100, "AcDbBlockTableRecord");
                out.pair(2, name);
            }
        });
    }

    /// Writes model space and paper space, which are empty because their entities have a section of their own, and the
    /// other blocks, which `fill` fills by their number.
    fn blocks(&mut self, blocks: &[(&str, u32)], mut fill: impl FnMut(&mut Self, usize)) {
        for (number, &(name, record)) in SPACES.iter().chain(blocks).enumerate() {
            self.owner = record;
            self.entity("BLOCK", "0", "AcDbBlockBegin");
            self.pair(2, name);
            self.pair(70, 0);
            self.point(10, DVec3::ZERO);
            self.pair(3, name);
            self.pair(1, "");
            if let Some(number) = number.checked_sub(SPACES.len()) {
                fill(self, number);
            }
            self.entity("ENDBLK", "0", "AcDbBlockEnd");
        }
        self.owner = MODEL_SPACE;
    }

    fn entity(&mut self, kind: &str, layer: &str, class: &str) {
        let handle = self.new_handle();
        self.pair(0, kind);
        self.handle(5, handle);
        self.handle(330, self.owner);
        self.pair(100, "AcDbEntity");
        self.pair(8, layer);
        self.pair(100, class);
    }

    fn polygon(&mut self, points: &[DVec2], layer: &str) {
        self.entity("LWPOLYLINE", layer, "AcDbPolyline");
        self.pair(90, points.len());
        self.pair(70, 1);
        for point in points {
            self.number(10, point.x);
            self.number(20, point.y);
        }
    }

    /// Adds the angle of a fold to the line before.
    pub(crate) fn angle(&mut self, angle_deg: f64) {
        self.pair(1001, APPLICATION);
        self.number(1040, angle_deg);
    }

    /// Writes a closed polygon as R13 has it: a list of vertices with an end.
    pub(crate) fn old_polygon(&mut self, points: &[DVec2], layer: &str) {
        self.entity("POLYLINE", layer, "AcDb2dPolyline");
        self.pair(66, 1);
        self.point(10, DVec3::ZERO);
        self.pair(70, 1);
        for point in points {
            self.entity("VERTEX", layer, "AcDbVertex");
            self.pair(100, "AcDb2dVertex");
            self.point(10, point.extend(0.0));
        }
        let handle = self.new_handle();
        self.pair(0, "SEQEND");
        self.handle(5, handle);
        self.handle(330, self.owner);
        self.pair(100, "AcDbEntity");
        self.pair(8, layer);
    }

    pub(crate) fn mark(&mut self, at: DVec3, layer: &str) {
        self.entity("POINT", layer, "AcDbPoint");
        self.point(10, at);
    }

    /// Writes a notch: a point of the outline, with the depth as its third coordinate, the width as its thickness, and
    /// the direction into the piece in degrees.
    pub(crate) fn notch(&mut self, at: DVec2, [depth, width, direction]: [f64; 3], layer: &str) {
        self.mark(at.extend(depth), layer);
        self.number(39, width);
        self.number(50, direction);
    }

    /// Writes a block in its place.
    pub(crate) fn insert(&mut self, name: &str, at: DVec2, layer: &str) {
        self.entity("INSERT", layer, "AcDbBlockReference");
        self.pair(2, name);
        self.point(10, at.extend(0.0));
    }

    pub(crate) fn line(&mut self, [start, end]: [DVec3; 2], layer: &str) {
        self.entity("LINE", layer, "AcDbLine");
        self.point(10, start);
        self.point(11, end);
    }

    pub(crate) fn text(&mut self, text: &str, spot: &Spot, layer: &str) {
        let turn = libm::atan2(spot.direction.y, spot.direction.x).to_degrees();
        let start = spot.starts_left.then(|| spot.start(text));
        self.text_placed(text, start.unwrap_or(spot.at).extend(0.0), spot.height, turn, start.is_none(), layer);
    }

    /// Writes a text around its middle. `turn` is its direction in degrees.
    pub(crate) fn text_at(&mut self, text: &str, at: DVec3, height: f64, turn: f64, layer: &str) {
        self.text_placed(text, at, height, turn, true, layer);
    }

    /// Writes a text around its middle, or from the middle of its left end on.
    fn text_placed(&mut self, text: &str, at: DVec3, height: f64, turn: f64, is_amid: bool, layer: &str) {
        self.entity("TEXT", layer, "AcDbText");
        self.point(10, at);
        self.number(40, height);
        self.pair(1, ascii(text));
        if turn != 0.0 {
            self.number(50, turn);
        }
        self.pair(72, u8::from(is_amid));
        self.point(11, at);
        self.pair(100, "AcDbText");
        self.pair(73, 2);
    }

    fn objects(&mut self, has_cloning: bool) {
        for (handle, owner, entry) in [(ROOT_DICTIONARY, 0, true), (GROUP_DICTIONARY, ROOT_DICTIONARY, false)] {
            self.pair(0, "DICTIONARY");
            self.handle(5, handle);
            self.handle(330, owner);
            self.pair(100, "AcDbDictionary");
            if has_cloning {
                self.pair(281, 1);
            }
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
