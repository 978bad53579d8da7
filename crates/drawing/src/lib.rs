//! Drawings and lists that are made from a result: what a shop cuts, and what a site assembles.
//!
//! [`pattern`] makes the flat pattern of a ruled surface from a stored result and the parameters of a query. Every
//! length in a drawing is in millimetres. Every function is pure: the same result and the same query give the same
//! bytes.
//!
//! # Example
//! ```
//! use plateau_archive::{Archive, Contents, LineSet, Lines};
//! use plateau_drawing::{PatternOptions, pattern};
//! use plateau_mesh::{DVec3, Mesh};
//!
//! // A square of one metre as a strip of two triangles.
//! let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
//! let bridges = Lines::Segments(vec![[0, 2], [1, 2], [1, 3]]);
//! let archive = Archive::new(Contents {
//!     mesh: Mesh::new(corners.to_vec(), vec![[0, 1, 2], [1, 3, 2]]),
//!     line_sets: vec![LineSet { name: "bridges".into(), group: String::new(), lines: bridges, attributes: vec![] }],
//!     statistics: "{}".into(),
//!     unrolls: true,
//!     ..Contents::default()
//! })?;
//! let query = [("format".to_owned(), "json".to_owned())];
//! let options = PatternOptions::read(&query).expect("the query is right");
//! let file = pattern(archive.contents(), &options).expect("a strip has a pattern");
//! assert!(String::from_utf8_lossy(&file).contains(r#""size":{"height":1000.0,"width":1000.0}"#));
//! # Ok::<(), plateau_archive::Defect>(())
//! ```

#![forbid(unsafe_code)]
#![cfg_attr(test, allow(clippy::disallowed_methods, clippy::disallowed_types, clippy::disallowed_macros))]

mod astm;
mod columns;
pub mod divide;
pub mod drawing;
pub mod dxf;
pub mod figure;
pub mod json;
mod kinds;
pub mod label;
pub mod metal;
pub mod options;
pub mod parameters;
pub mod pdf;
pub mod piece;
pub mod polygon;
mod relief;
pub mod schedule;
pub mod sheets;
pub mod svg;

pub use options::{Format, PatternOptions};
pub use parameters::{ParameterError, Refused};
pub use piece::{Fold, Pattern, Piece};
pub use schedule::{ScheduleOptions, schedule};

use drawing::Drawing;
use options::Profile;
use plateau_archive::Contents;
use plateau_archive::zip::Zip;

/// Makes the flat pattern of a result.
///
/// # Errors
/// Returns [`Refused::NoPattern`] unless the result is a ruled surface, [`Refused::Unsuitable`] if a parameter does not
/// suit the result, and [`Refused::TooLarge`] if the format cannot hold the file.
pub fn pattern(contents: &Contents, options: &PatternOptions) -> Result<Vec<u8>, Refused> {
    let figures = divide::of_result(contents, options)?;
    let layout = options.stock.map(|stock| sheets::place(&figures, &stock)).transpose()?;
    if options.format == Format::Json {
        return Ok(json::to_json(&figures, layout.as_ref()));
    }
    let file = |drawing: &Drawing| match options.format {
        Format::Dxf => Ok(dxf::to_dxf(drawing, &options.layers)),
        Format::Pdf => pdf::to_pdf(drawing, options.paper),
        Format::Svg | Format::Json => Ok(svg::to_svg(drawing, &options.layers)),
    };
    let generator = contents.generator.as_str();
    let is_astm = options.profile == Profile::Astm;
    if is_astm && !options.split {
        return Ok(astm::to_dxf(&figures, options, [&contents.title, generator]));
    }
    if !options.split {
        return file(&match &layout {
            Some(layout) => {
                let all = 0..layout.sheets.len();
                drawing::on_sheets(&figures, layout, all, options, [&contents.title, generator])
            }
            None => drawing::stacked(&figures, options, &contents.title, generator),
        });
    }
    let too_large = |_| Refused::TooLarge("ZIP");
    let (mut zip, mut bytes) = (Zip::default(), Vec::new());
    let count = layout.as_ref().map_or(figures.len(), |layout| layout.sheets.len());
    for k in 0..count {
        let name = if layout.is_some() { format!("sheet {}", k + 1) } else { figures[k].name.clone() };
        let content = match &layout {
            Some(layout) => file(&drawing::on_sheets(&figures, layout, k..k + 1, options, [&name, generator]))?,
            None if is_astm => astm::to_dxf(&figures[k..=k], options, [&contents.title, generator]),
            None => file(&drawing::stacked(&figures[k..=k], options, &name, generator))?,
        };
        let name = format!("{name}.{}", options.format.name());
        bytes.extend(zip.entry(&name, &content).map_err(too_large)?);
        bytes.extend_from_slice(&content);
    }
    bytes.extend(zip.end().map_err(too_large)?);
    Ok(bytes)
}

/// Makes the flat pattern of a result as SVG: the bytes of [`pattern`] for a query that names this format only. A web
/// page calls this function, because its module then has nothing of what the other options and formats need.
///
/// # Errors
/// Returns [`Refused::NoPattern`] unless the result is a ruled surface.
pub fn plain_svg(contents: &Contents) -> Result<Vec<u8>, Refused> {
    let options = PatternOptions::plain(Format::Svg);
    Ok(svg::to_svg(&plain(contents, &options)?, &options.layers))
}

/// Makes the flat pattern of a result as DXF, as [`plain_svg`] does as SVG.
///
/// # Errors
/// Returns [`Refused::NoPattern`] unless the result is a ruled surface.
pub fn plain_dxf(contents: &Contents) -> Result<Vec<u8>, Refused> {
    let options = PatternOptions::plain(Format::Dxf);
    Ok(dxf::to_dxf(&plain(contents, &options)?, &options.layers))
}

fn plain(contents: &Contents, options: &PatternOptions) -> Result<Drawing, Refused> {
    let figures = divide::of_result(contents, options)?;
    Ok(drawing::stacked(&figures, options, &contents.title, &contents.generator))
}

/// Compiles and runs the example of the README with the other doctests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
