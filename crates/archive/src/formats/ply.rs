//! PLY in the client's axes and unit, binary little-endian or text. Coordinates are `double` with every digit. The mean
//! curvature, if known, is the vertex property `mean_curvature` in 1/unit. It is also the property `quality`, which
//! MeshLab shows. Colours, if asked for, are the same as in glTF; where triangles have colours, a vertex between two
//! colours is there once for each, and the added vertices follow those of the mesh. If a lower bound of the area is
//! known, `lower_bound_slack` shows where the bound is not tight. A mesh without triangles, such as a cable net, has
//! `edge` elements with their values, such as `force`.

use std::borrow::Cow;
use std::io::Write as _;

use super::colors::Scale;
use super::obj::one_line;
use super::{Choices, Error, Origin, sheets};
use crate::archive::{Archive, Attribute, Contents, LOWER_BOUND_SLACK, Lines, MEAN_CURVATURE};
use plateau_mesh::Mesh;

/// Writes the vertices and triangles in archive order.
///
/// # Errors
/// Returns [`Error::NoQuantity`] if neither vertices nor triangles have the quantity by which they are to be coloured.
pub fn to_ply(archive: &Archive, choices: Choices) -> Result<Vec<u8>, Error> {
    let contents = archive.contents();
    // The scale ignores line sets, because only vertices have colours in PLY.
    let scale = choices.colors.map(|colors| Scale::new(colors, contents, &[])).transpose()?;
    let at_triangles = scale.as_ref().and_then(|scale| scale.quantity.at_triangles(contents));
    let split = at_triangles.map(|values| sheets::split_by_value(&contents.mesh, &values));
    let mesh = split.as_ref().map_or(&contents.mesh, |(mesh, ..)| mesh);
    let (vertices, triangles) = (&mesh.vertices, &mesh.triangles);
    let named = |name: &str| {
        let values = &contents.at_vertices(name)?.values;
        let of_split = |(_, source, _): &(_, Vec<u32>, _)| source.iter().map(|&v| values[v as usize]).collect();
        Some(split.as_ref().map_or(Cow::Borrowed(values.as_slice()), |split| Cow::Owned(of_split(split))))
    };
    let (curvature, slack) = (named(MEAN_CURVATURE), named(LOWER_BOUND_SLACK));
    let colored = scale.as_ref().and_then(|scale| {
        let of_vertices = || Some(&scale.quantity.at_vertices(contents)?.values);
        Some((scale, split.as_ref().map(|(_, _, values)| values).or_else(of_vertices)?))
    });
    let shift = choices.shift(contents);
    let edges = if triangles.is_empty() { edges(archive, choices) } else { Edges::default() };
    let present = Present { curvature: curvature.is_some(), colors: colored.is_some(), slack: slack.is_some() };
    let mut out = header(contents, mesh, choices, present, &edges).into_bytes();
    let with = |bytes: usize, present: bool| if present { bytes } else { 0 };
    let a_vertex = 24 + with(12, curvature.is_some()) + with(3, colored.is_some()) + with(8, slack.is_some());
    out.reserve(a_vertex * vertices.len() + 13 * triangles.len());
    // Writing to a Vec cannot fail, so `put` handles no errors.
    macro_rules! put {
        ($($argument:tt)*) => { write!(out, $($argument)*).expect("writing to memory") };
    }
    for (index, vertex) in vertices.iter().enumerate() {
        let vertex = *vertex - shift;
        let known = curvature.as_ref().map(|values| (values[index], values[index].min(f64::from(f32::MAX)) as f32));
        let color = colored.map(|(scale, values)| scale.color(values[index]));
        let slack = slack.as_ref().map(|values| values[index]);
        if choices.ascii {
            // `{:?}` gives the shortest text that reads back as the same number.
            put!("{:?} {:?} {:?}", vertex.x, vertex.y, vertex.z);
            known.iter().for_each(|(value, quality)| put!(" {value:?} {quality:?}"));
            color.iter().for_each(|[red, green, blue, _]| put!(" {red} {green} {blue}"));
            slack.iter().for_each(|slack| put!(" {slack:?}"));
            out.push(b'\n');
        } else {
            vertex.to_array().iter().for_each(|x| out.extend_from_slice(&x.to_le_bytes()));
            if let Some((value, quality)) = known {
                out.extend_from_slice(&value.to_le_bytes());
                out.extend_from_slice(&quality.to_le_bytes());
            }
            color.iter().for_each(|[rgb @ .., _]| out.extend_from_slice(rgb));
            slack.iter().for_each(|slack| out.extend_from_slice(&slack.to_le_bytes()));
        }
    }
    for [a, b, c] in triangles {
        if choices.ascii {
            put!("3 {a} {b} {c}");
            out.push(b'\n');
        } else {
            out.push(3);
            [a, b, c].iter().for_each(|v| out.extend_from_slice(&v.to_le_bytes()));
        }
    }
    for (k, pair) in edges.pairs.iter().enumerate() {
        let value = edges.name.map(|_| edges.values[k]);
        if choices.ascii {
            put!("{} {}", pair[0], pair[1]);
            value.iter().for_each(|value| put!(" {value:?}"));
            out.push(b'\n');
        } else {
            pair.iter().for_each(|v| out.extend_from_slice(&v.to_le_bytes()));
            value.iter().for_each(|value| out.extend_from_slice(&value.to_le_bytes()));
        }
    }
    Ok(out)
}

/// The properties that the vertices of a file have besides their coordinates.
#[derive(Clone, Copy)]
struct Present {
    curvature: bool,
    colors: bool,
    slack: bool,
}

/// Returns the lines before the data.
fn header(contents: &Contents, mesh: &Mesh, choices: Choices, present: Present, edges: &Edges<'_>) -> String {
    let triangles = &mesh.triangles;
    let shift = choices.shift(contents);
    let encoding = if choices.ascii { "ascii" } else { "binary_little_endian" };
    let mut header = format!(
        "ply\nformat {encoding} 1.0\ncomment {}\ncomment unit {}, {} up\n",
        one_line(&contents.generator),
        contents.unit.symbol(),
        contents.up.symbol(),
    );
    if choices.origin == Origin::Local {
        header.push_str(&format!("comment origin {:?} {:?} {:?}\n", shift.x, shift.y, shift.z));
    }
    header.push_str(&format!(
        "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n",
        mesh.vertices.len()
    ));
    if present.curvature {
        header.push_str("property double mean_curvature\nproperty float quality\n");
    }
    if present.colors {
        header.push_str("property uchar red\nproperty uchar green\nproperty uchar blue\n");
    }
    if present.slack {
        header.push_str("property double lower_bound_slack\n");
    }
    header.push_str(&format!("element face {}\nproperty list uchar uint vertex_indices\n", triangles.len()));
    if triangles.is_empty() {
        header.push_str(&format!("element edge {}\nproperty int vertex1\nproperty int vertex2\n", edges.pairs.len()));
        if let Some(name) = edges.name {
            header.push_str(&format!("property double {name}\n"));
        }
    }
    header.push_str("end_header\n");
    header
}

/// All segments of a mesh's line sets, and their values if the first attribute of every set has the same name.
#[derive(Default)]
struct Edges<'a> {
    pairs: Vec<[u32; 2]>,
    name: Option<&'a str>,
    values: Vec<f64>,
}

fn name(attribute: Option<&Attribute>) -> Option<&str> {
    attribute.map(|attribute| attribute.name.as_str())
}

fn edges(archive: &Archive, choices: Choices) -> Edges<'_> {
    let segments = || {
        choices.line_sets(archive.contents()).iter().filter_map(|set| match &set.lines {
            Lines::Segments(pairs) => Some((pairs, set.attributes.first())),
            Lines::Polylines(_) | Lines::Arrows(_) => None,
        })
    };
    let first = segments().next().and_then(|(_, attribute)| name(attribute));
    let common = first.filter(|first| segments().all(|(_, attribute)| name(attribute) == Some(*first)));
    Edges {
        pairs: segments().flat_map(|(pairs, _)| pairs.iter().copied()).collect(),
        name: common,
        values: segments().filter_map(|(_, known)| known).flat_map(|known| known.values.iter().copied()).collect(),
    }
}
