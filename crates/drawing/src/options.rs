//! Options of a flat pattern, read from the parameters of a query. Every length is in millimetres.

use crate::parameters::{ParameterError, Refused, Values};
use plateau_mesh::DVec2;

/// What a drawing is for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Profile {
    /// Outlines and folds, to look at and to print.
    #[default]
    Plain,
    /// Closed cut lines alone, one file for each piece.
    Cut,
    /// The blank of thick sheet metal with its bend lines.
    SheetMetal,
    /// Cloth, as ASTM D6673 exchanges sewn products: DXF of AutoCAD R13 with numbered layers and one block a piece.
    Astm,
}

/// Format of a flat pattern.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Format {
    #[default]
    Svg,
    Dxf,
    Pdf,
    Json,
}

impl Format {
    pub const ALL: [Self; 4] = [Self::Svg, Self::Dxf, Self::Pdf, Self::Json];

    /// Returns the short name, which is also the file's extension.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Svg => "svg",
            Self::Dxf => "dxf",
            Self::Pdf => "pdf",
            Self::Json => "json",
        }
    }

    #[must_use]
    pub fn media_type(self) -> &'static str {
        match self {
            Self::Svg => "image/svg+xml",
            Self::Dxf => "image/vnd.dxf",
            Self::Pdf => "application/pdf",
            Self::Json => "application/json",
        }
    }
}

/// Paper of a PDF, upright, in millimetres.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Paper {
    A4,
    A3,
}

impl Paper {
    /// Returns width and height.
    #[must_use]
    pub fn size(self) -> DVec2 {
        match self {
            Self::A4 => DVec2::new(210.0, 297.0),
            Self::A3 => DVec2::new(297.0, 420.0),
        }
    }
}

/// Convention of the k-factor, which places the neutral line of a bend.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Convention {
    /// The neutral line is k t from the inner skin.
    #[default]
    Ansi,
    /// The neutral line is k t / 2 from the inner skin (DIN 6935).
    Din,
}

/// Skin of the sheet that the mesh is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Skin {
    /// The side that the normals of the mesh point to.
    Front,
    #[default]
    Middle,
    Back,
}

/// Relief of bends that meet at a point of a rail.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Relief {
    #[default]
    None,
    /// A circle of inner radius plus thickness where the blank would overlap, or as large as the opening there.
    Auto,
    /// A circle of this radius at every point in which bends meet.
    Radius(f64),
}

/// A layer of a drawing. In an SVG it is a class with the name in lower case.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Layer {
    Cut,
    Sew,
    BendUp,
    BendDown,
    BendZone,
    FoldMountain,
    FoldValley,
    FoldFlat,
    Notch,
    Mark,
    Grain,
    Text,
    Sheet,
    Register,
    ScaleBar,
    Dimension,
}

impl Layer {
    pub const ALL: [Self; 16] = [
        Self::Cut,
        Self::Sew,
        Self::BendUp,
        Self::BendDown,
        Self::BendZone,
        Self::FoldMountain,
        Self::FoldValley,
        Self::FoldFlat,
        Self::Notch,
        Self::Mark,
        Self::Grain,
        Self::Text,
        Self::Sheet,
        Self::Register,
        Self::ScaleBar,
        Self::Dimension,
    ];

    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Cut => "CUT",
            Self::Sew => "SEW",
            Self::BendUp => "BEND_UP",
            Self::BendDown => "BEND_DOWN",
            Self::BendZone => "BEND_ZONE",
            Self::FoldMountain => "FOLD_MOUNTAIN",
            Self::FoldValley => "FOLD_VALLEY",
            Self::FoldFlat => "FOLD_FLAT",
            Self::Notch => "NOTCH",
            Self::Mark => "MARK",
            Self::Grain => "GRAIN",
            Self::Text => "TEXT",
            Self::Sheet => "SHEET",
            Self::Register => "REGISTER",
            Self::ScaleBar => "SCALE_BAR",
            Self::Dimension => "DIMENSION",
        }
    }
}

/// Names of the layers in a file: the client's, or the contract's.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LayerNames(Vec<(Layer, String)>);

impl LayerNames {
    #[must_use]
    pub fn of(&self, layer: Layer) -> &str {
        self.0.iter().find(|(own, _)| *own == layer).map_or(layer.name(), |(_, name)| name)
    }
}

/// Options of the bends of sheet metal.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Metal {
    pub thickness: f64,
    /// Inner radius of every bend.
    pub radius: f64,
    pub convention: Convention,
    /// The k-factor; DIN's formula without one.
    pub k: Option<f64>,
    pub skin: Skin,
    /// Largest distance of the facets of a bend from its cylinder; one hit for each bend without one.
    pub chord_error: Option<f64>,
    pub relief: Relief,
}

/// Distances by which the cut lies outside the outline.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Allowances {
    pub p: f64,
    pub q: f64,
    pub ends: f64,
}

/// Turns of a piece on its sheet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rotate {
    /// By 0 or 180 degrees, so that the grain stays along the sheet.
    #[default]
    Half,
    /// By quarter turns too.
    Free,
}

/// Sheets that the pieces are cut from.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stock {
    /// Length along x, and width.
    pub size: DVec2,
    /// Distance between the boxes of two pieces.
    pub gap: f64,
    pub rotate: Rotate,
}

/// All options of a flat pattern.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PatternOptions {
    pub profile: Profile,
    pub format: Format,
    /// Whether each piece is a file of its own, in a ZIP.
    pub split: bool,
    pub text_height: f64,
    pub angles: bool,
    /// Arc length between neighbouring notches of a seam.
    pub notches: Option<f64>,
    pub allowances: Allowances,
    /// Full width of the cut.
    pub kerf: f64,
    pub cut_at: Vec<u32>,
    pub stock: Option<Stock>,
    /// Largest length of a piece along its strip.
    pub max_length: Option<f64>,
    pub layers: LayerNames,
    /// Paper on which a PDF is tiled; one page of the drawing's size without it.
    pub paper: Option<Paper>,
    pub metal: Option<Metal>,
}

/// Largest length that a parameter may have, in millimetres.
const LARGEST: f64 = 1e6;
/// Largest allowance and kerf, in millimetres.
const LARGEST_ALLOWANCE: f64 = 1e3;
/// Smallest side of a sheet and smallest `max_length`, in millimetres.
const LEAST_SHEET: f64 = 1.0;
/// Distance between pieces on a sheet where none is given, in millimetres: enough for the heads of laser cutters.
const GAP: f64 = 5.0;
/// Smallest distance between notches, in millimetres: less than twice the width of a notch.
const LEAST_SPACING: f64 = 1e-3;

/// Height of the texts where none is given, in millimetres.
const TEXT_HEIGHT: f64 = 5.0;

impl PatternOptions {
    /// Returns the options of a query that names a format only.
    #[must_use]
    pub fn plain(format: Format) -> Self {
        Self { format, text_height: TEXT_HEIGHT, ..Self::default() }
    }

    /// Reads the parameters of a query.
    ///
    /// # Errors
    /// Returns [`Refused::BadQuery`] with every parameter that is unknown, given twice, wrong in itself, or not allowed
    /// with the others.
    pub fn read(given: &[(String, String)]) -> Result<Self, Refused> {
        let mut values = Values::new(given);
        let formats = Format::ALL.map(|format| (format.name(), format));
        let profiles = [
            ("plain", Profile::Plain),
            ("cut", Profile::Cut),
            ("sheet-metal", Profile::SheetMetal),
            ("astm-d6673", Profile::Astm),
        ];
        let profile = values.choice("profile", &profiles).unwrap_or_default();
        let is_astm = profile == Profile::Astm;
        let default = if is_astm { Format::Dxf } else { Format::default() };
        let format = values.choice("format", &formats).unwrap_or(default);
        if is_astm && format != Format::Dxf {
            values.refuse("format", "must be dxf with profile=astm-d6673");
        }
        let split = values.choice("split", &[("pieces", true)]);
        if split.is_some() && profile == Profile::Cut {
            values.refuse("split", "profile=cut has one file for each piece in any case");
        }
        if split.is_some() && format == Format::Json {
            values.refuse("split", "is not allowed with format=json, which lists the pieces");
        }
        if profile == Profile::Cut && matches!(format, Format::Pdf | Format::Json) {
            values.refuse("format", "must be one of svg, dxf with profile=cut");
        }
        let text_height = values.number("text_height", 0.5..=500.0);
        let angles = values.choice("angles", &[("true", true), ("false", false)]);
        if profile == Profile::Cut {
            for (name, is_given) in [("text_height", text_height.is_some()), ("angles", angles.is_some())] {
                if is_given {
                    values.refuse(name, "is not allowed with profile=cut, which has no texts");
                }
            }
        }
        let notches = values.number("notches", LEAST_SPACING..=LARGEST);
        let all = values.number("allowance", 0.0..=LARGEST_ALLOWANCE);
        let own = ["allowance_p", "allowance_q", "allowance_ends"]
            .map(|name| values.number(name, 0.0..=LARGEST_ALLOWANCE).or(all).unwrap_or(0.0));
        let kerf = values.number("kerf", 0.0..=LARGEST_ALLOWANCE).unwrap_or(0.0);
        let cut_at = bridges(&mut values);
        let stock = stock(&mut values);
        if is_astm && !values.is_missing("sheet") {
            values.refuse("sheet", "is not allowed with profile=astm-d6673: a marker program lays the pieces out");
        }
        if split.is_some() && stock.is_some() {
            values.refuse("split", "is not allowed with sheet, on which several pieces lie");
        }
        let max_length = values.number("max_length", LEAST_SHEET..=LARGEST);
        let layers = layers(&mut values);
        if is_astm && !values.is_missing("layers") {
            values.refuse("layers", "is not allowed with profile=astm-d6673, whose layers have numbers");
        }
        let paper = values.choice("paper", &[("a4", Paper::A4), ("a3", Paper::A3)]);
        if paper.is_some() && format != Format::Pdf {
            values.refuse("paper", "is only allowed with format=pdf");
        }
        let metal = metal(&mut values, profile);
        values.end()?;
        Ok(Self {
            profile,
            format,
            split: split.unwrap_or(profile == Profile::Cut),
            text_height: text_height.unwrap_or(TEXT_HEIGHT),
            angles: angles.unwrap_or(profile == Profile::SheetMetal),
            notches,
            allowances: Allowances { p: own[0], q: own[1], ends: own[2] },
            kerf,
            cut_at,
            stock,
            max_length,
            layers,
            paper,
            metal,
        })
    }

    /// Returns the media type of the file.
    #[must_use]
    pub fn media_type(&self) -> &'static str {
        if self.split { "application/zip" } else { self.format.media_type() }
    }

    /// Returns the extension of the file's name.
    #[must_use]
    pub fn extension(&self) -> &'static str {
        if self.split { "zip" } else { self.format.name() }
    }
}

fn bridges(values: &mut Values<'_>) -> Vec<u32> {
    let Some(text) = values.text("cut_at") else { return Vec::new() };
    match text.split(',').map(str::parse).collect() {
        Ok(numbers) => numbers,
        Err(_) => {
            values.refuse("cut_at", "must be the number of a bridge, from 0, or several with commas between them");
            Vec::new()
        }
    }
}

fn stock(values: &mut Values<'_>) -> Option<Stock> {
    let size = values.text("sheet").and_then(|text| {
        let side = |text: &str| text.parse::<f64>().ok().filter(|side| (LEAST_SHEET..=LARGEST).contains(side));
        let size = text.split_once(',').and_then(|(length, width)| Some(DVec2::new(side(length)?, side(width)?)));
        if size.is_none() {
            let detail =
                format!("must be a length and a width from {LEAST_SHEET} to {LARGEST} with a comma between them");
            values.refuse("sheet", detail);
        }
        size
    });
    let gap = values.number("gap", 0.0..=LARGEST_ALLOWANCE);
    let rotate = values.choice("rotate", &[("half", Rotate::Half), ("free", Rotate::Free)]);
    if values.is_missing("sheet") {
        for (name, is_given) in [("gap", gap.is_some()), ("rotate", rotate.is_some())] {
            if is_given {
                values.refuse(name, "is only allowed with sheet");
            }
        }
    }
    size.map(|size| Stock { size, gap: gap.unwrap_or(GAP), rotate: rotate.unwrap_or_default() })
}

fn layers(values: &mut Values<'_>) -> LayerNames {
    let Some(text) = values.text("layers") else { return LayerNames::default() };
    let mut names: Vec<(Layer, String)> = Vec::new();
    for entry in text.split(',') {
        let parts = entry.split_once(':');
        let found = parts.and_then(|(layer, name)| {
            let layer = Layer::ALL.into_iter().find(|own| own.name().eq_ignore_ascii_case(layer))?;
            // Letters of layers that every version of DXF allows.
            let is_plain = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | '$');
            let is_name = (1..=31).contains(&name.len()) && name.chars().all(is_plain);
            (is_name && names.iter().all(|(other, _)| *other != layer)).then(|| (layer, name.to_owned()))
        });
        let Some(found) = found else {
            let known = Layer::ALL.map(|layer| layer.name().to_lowercase()).join(", ");
            let detail = format!(
                "must be pairs LAYER:NAME with commas between them, each layer once, of the layers {known}, with names \
                 of 1 to 31 letters, digits, _, - or $"
            );
            values.refuse("layers", detail);
            return LayerNames::default();
        };
        names.push(found);
    }
    LayerNames(names)
}

fn metal(values: &mut Values<'_>, profile: Profile) -> Option<Metal> {
    let thickness = values.number("thickness", 1e-3..=1e3);
    let radius = values.number("radius", 0.0..=1e5);
    let convention = values.choice("convention", &[("ansi", Convention::Ansi), ("din", Convention::Din)]);
    let k = values.number("k", 0.0..=1.0);
    let skins = [("front", Skin::Front), ("middle", Skin::Middle), ("back", Skin::Back)];
    let skin = values.choice("skin", &skins);
    let chord_error = values.number("chord_error", 1e-4..=1e3);
    let relief = match values.text("relief") {
        None => None,
        Some("none") => Some(Relief::None),
        Some("auto") => Some(Relief::Auto),
        Some(text) => match text.parse::<f64>() {
            Ok(radius) if radius > 0.0 && radius <= 1e3 => Some(Relief::Radius(radius)),
            _ => {
                values.refuse("relief", "must be auto, none, or a radius above 0 and up to 1000");
                None
            }
        },
    };
    if profile != Profile::SheetMetal {
        let given = [
            ("thickness", thickness.is_some()),
            ("radius", radius.is_some()),
            ("convention", convention.is_some()),
            ("k", k.is_some()),
            ("skin", skin.is_some()),
            ("chord_error", chord_error.is_some()),
            ("relief", relief.is_some()),
        ];
        for (name, _) in given.iter().filter(|(_, is_given)| *is_given) {
            values.refuse(name, "is only allowed with profile=sheet-metal");
        }
        return None;
    }
    let Some(thickness) = thickness else {
        values.refuse("thickness", "is required with profile=sheet-metal");
        return None;
    };
    let radius = radius.unwrap_or(thickness);
    if radius < 0.5 * thickness {
        values.refuse("radius", format!("must be at least half the thickness, {} mm", 0.5 * thickness));
    }
    Some(Metal {
        thickness,
        radius,
        convention: convention.unwrap_or_default(),
        k,
        skin: skin.unwrap_or_default(),
        chord_error,
        relief: relief.unwrap_or_default(),
    })
}

impl From<ParameterError> for Refused {
    fn from(error: ParameterError) -> Self {
        Self::BadQuery(vec![error])
    }
}

/// A parameter of a query, as the API document describes it.
#[derive(Clone, Copy, Debug)]
pub struct Parameter {
    pub name: &'static str,
    pub description: &'static str,
    kind: Kind,
}

/// Values that a parameter allows.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Kind {
    Choice(&'static [&'static str]),
    Number(f64, f64),
    Text(&'static str),
}

impl Parameter {
    /// Returns the JSON Schema of the parameter's values.
    #[must_use]
    pub fn schema(&self) -> serde_json::Value {
        match self.kind {
            Kind::Choice(values) => serde_json::json!({ "type": "string", "enum": values }),
            Kind::Number(low, high) => {
                serde_json::json!({ "type": "number", "format": "double", "minimum": low, "maximum": high })
            }
            Kind::Text(pattern) => serde_json::json!({ "type": "string", "pattern": pattern }),
        }
    }
}

pub(crate) const fn parameter(name: &'static str, kind: Kind, description: &'static str) -> Parameter {
    Parameter { name, description, kind }
}

/// Every parameter of a flat pattern.
pub const PARAMETERS: &[Parameter] = &[
    parameter(
        "profile",
        Kind::Choice(&["plain", "cut", "sheet-metal", "astm-d6673"]),
        "What the drawing is for. `plain` (the default): outlines and folds. `cut`: closed cut lines alone, one file \
         for each piece, in a ZIP. `sheet-metal`: the blank of thick metal with bend lines. `astm-d6673`: cloth, with \
         one block for each piece and numbered layers, as DXF of AutoCAD R13.",
    ),
    parameter(
        "format",
        Kind::Choice(&["svg", "dxf", "pdf", "json"]),
        "The default is `svg`. `cut` has `svg` and `dxf`, and `astm-d6673` only `dxf`. Every file is in \
         millimetres. Without `format`, `profile` and `split` the format follows `Accept`.",
    ),
    parameter("split", Kind::Choice(&["pieces"]), "`pieces` gives a ZIP with one file for each piece."),
    parameter("text_height", Kind::Number(0.5, 500.0), "Height of capitals in mm. The default is 5."),
    parameter(
        "angles",
        Kind::Choice(&["true", "false"]),
        "Whether the angles of the folds are printed. The default is true with `profile=sheet-metal` only. Lines have \
         their angles in all digits in any case.",
    ),
    parameter(
        "notches",
        Kind::Number(LEAST_SPACING, LARGEST),
        "Distance between notches along each seam in mm. Both pieces at a seam have them at the same places. Without \
         it there are none.",
    ),
    parameter("allowance", Kind::Number(0.0, LARGEST_ALLOWANCE), "Distance of the cut from the outline in mm, mitred."),
    parameter("allowance_p", Kind::Number(0.0, LARGEST_ALLOWANCE), "The allowance along the first rail of each strip."),
    parameter(
        "allowance_q",
        Kind::Number(0.0, LARGEST_ALLOWANCE),
        "The allowance along the second rail of each strip.",
    ),
    parameter("allowance_ends", Kind::Number(0.0, LARGEST_ALLOWANCE), "The allowance at the ends of each strip."),
    parameter(
        "kerf",
        Kind::Number(0.0, LARGEST_ALLOWANCE),
        "Full width of the cut in mm. The cut line lies half of it outside the outline.",
    ),
    parameter(
        "cut_at",
        Kind::Text("^[0-9]{1,9}(,[0-9]{1,9})*$"),
        "Bridges at which strips are cut, counted from 0 over all strips, with commas between them. A closed strip \
         opens at its first one; without one, at the bridge of least fold.",
    ),
    parameter(
        "sheet",
        Kind::Text(r"^[1-9][0-9]{0,5}(\.[0-9]{1,6})?,[1-9][0-9]{0,5}(\.[0-9]{1,6})?$"),
        "Length and width of the sheets in mm, such as `3000,1500`. The pieces lie on sheets, and strips that do not fit \
         are cut at bridges.",
    ),
    parameter(
        "gap",
        Kind::Number(0.0, LARGEST_ALLOWANCE),
        "Distance between the boxes of pieces on a sheet in mm. The default is 5.",
    ),
    parameter(
        "rotate",
        Kind::Choice(&["half", "free"]),
        "Turns of pieces on a sheet: by 0 or 180 degrees (`half`, the default), which keeps the grain along the sheet, \
         or by quarter turns too (`free`).",
    ),
    parameter(
        "max_length",
        Kind::Number(LEAST_SHEET, LARGEST),
        "Largest length of a piece in mm. Longer strips are cut at bridges.",
    ),
    parameter(
        "layers",
        Kind::Text("^[A-Za-z_]+:[A-Za-z0-9_$-]{1,31}(,[A-Za-z_]+:[A-Za-z0-9_$-]{1,31})*$"),
        "Names of the client for layers, such as `cut:LASER,text:ENGRAVE`. In an SVG they are classes.",
    ),
    parameter(
        "paper",
        Kind::Choice(&["a4", "a3"]),
        "Paper on which a PDF is tiled at true scale, with register marks. Without it the PDF has one page of the \
         drawing's size.",
    ),
    parameter(
        "thickness",
        Kind::Number(1e-3, 1e3),
        "Sheet metal: thickness in mm. Required with `profile=sheet-metal`.",
    ),
    parameter(
        "radius",
        Kind::Number(0.0, 1e5),
        "Sheet metal: inner radius of the bends in mm, at least half the thickness. The default is the thickness.",
    ),
    parameter(
        "convention",
        Kind::Choice(&["ansi", "din"]),
        "Sheet metal: convention of the k-factor. The neutral line is k t from the inner skin (`ansi`, the default) or \
         k t / 2 (`din`).",
    ),
    parameter(
        "k",
        Kind::Number(0.0, 1.0),
        "Sheet metal: k-factor. The default is 0.44 with `ansi`, and DIN 6935's 0.65 + log10(radius / thickness) / 2, \
         at most 1, with `din`.",
    ),
    parameter(
        "skin",
        Kind::Choice(&["front", "middle", "back"]),
        "Sheet metal: skin of the sheet that the mesh is. `front` is the side of the normals. The default is `middle`.",
    ),
    parameter(
        "chord_error",
        Kind::Number(1e-4, 1e3),
        "Sheet metal: largest distance in mm of the facets of a bend from its cylinder. Each bend gets as many hits as \
         that takes. Without it, each bend has one line.",
    ),
    parameter(
        "relief",
        Kind::Text(r"^(auto|none|[1-9][0-9]{0,2}(\.[0-9]{1,6})?)$"),
        "Sheet metal: relief of bends that meet at a point of a rail. `none` (the default), `auto` (a circle of radius \
         plus thickness where the blank would overlap, or as large as the opening there), or the radius of a circle in \
         mm.",
    ),
];
