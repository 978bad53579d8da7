//! Cables and supports, with the forces of the statistics.

use super::csv::{Cell, Table};
use plateau_archive::archive::CABLES;
use plateau_archive::{Contents, Lines};
use serde_json::Value;

fn entries<'a>(statistics: &'a Value, name: &str) -> &'a [Value] {
    statistics[name].as_array().map_or(&[], Vec::as_slice)
}

/// Returns the units of length and force.
fn units<'a>(contents: &Contents, statistics: &'a Value) -> (&'static str, &'a str) {
    (contents.unit.symbol(), statistics["force_unit"].as_str().unwrap_or("kN"))
}

fn number(value: &Value, name: &str) -> Cell<'static> {
    value[name].as_f64().into()
}

/// Returns the table of cables, one row for each.
pub(super) fn cables(contents: &Contents, statistics: &Value) -> Table {
    let (length, force) = units(contents, statistics);
    let mut table = Table::new(&[
        "cable".to_owned(),
        "name".to_owned(),
        format!("force_{force}"),
        format!("force_max_{force}"),
        format!("length_{length}"),
        format!("unstressed_length_{length}"),
        format!("axial_stiffness_{force}"),
    ]);
    for (cable, value) in entries(statistics, "cables").iter().enumerate() {
        table.row(&[
            Cell::Count(cable),
            Cell::Text(value["name"].as_str().unwrap_or_default()),
            number(value, "force"),
            number(value, "force_max"),
            number(value, "length"),
            number(value, "unstressed_length"),
            number(value, "axial_stiffness"),
        ]);
    }
    table
}

/// Returns the table of the edges of cables. Edges count from 0 over all cables.
pub(super) fn cable_edges(contents: &Contents, statistics: &Value) -> Table {
    let (length, force) = units(contents, statistics);
    let mut table = Table::new(&[
        "edge".to_owned(),
        "cable".to_owned(),
        "name".to_owned(),
        "from".to_owned(),
        "to".to_owned(),
        format!("force_{force}"),
        format!("length_{length}"),
        format!("unstressed_length_{length}"),
        format!("axial_stiffness_{force}"),
    ]);
    let at = |vertex: u32| contents.mesh.vertices[vertex as usize];
    let mut edge = 0;
    let sets = contents.line_sets.iter().filter(|set| set.name == CABLES);
    for (cable, (set, value)) in sets.zip(entries(statistics, "cables")).enumerate() {
        let Lines::Segments(pairs) = &set.lines else { continue };
        let stiffness = value["axial_stiffness"].as_f64();
        let forces = set.attributes.first().map_or(&[][..], |forces| &forces.values);
        for (k, &[from, to]) in pairs.iter().enumerate() {
            let along = at(from).distance(at(to));
            let own = forces.get(k).copied();
            let stretch = own.zip(stiffness).map(|(force, stiffness)| 1.0 + force / stiffness);
            table.row(&[
                Cell::Count(edge),
                Cell::Count(cable),
                Cell::Text(value["name"].as_str().unwrap_or_default()),
                Cell::Count(from as usize),
                Cell::Count(to as usize),
                own.into(),
                Cell::Number(along),
                stretch.filter(|&stretch| stretch > 0.0).map(|stretch| along / stretch).into(),
                stiffness.into(),
            ]);
            edge += 1;
        }
    }
    table
}

/// Returns the name of a support as the studio shows it, counted from 1.
fn support_name(value: &Value) -> String {
    match (value["boundary"].as_u64(), value["point"].as_u64(), value["vertex"].as_u64()) {
        (Some(boundary), Some(point), _) => format!("Boundary {}, point {}", boundary + 1, point + 1),
        (Some(boundary), None, _) => format!("Boundary {}", boundary + 1),
        (None, _, vertex) => format!("Vertex {}", vertex.unwrap_or_default() + 1),
    }
}

/// Returns the components of a force and its size.
fn force(value: &Value) -> [f64; 4] {
    let component = |k: usize| value["force"][k].as_f64().unwrap_or_default();
    let [x, y, z] = [component(0), component(1), component(2)];
    [x, y, z, plateau_mesh::DVec3::new(x, y, z).length()]
}

fn force_columns(unit: &str) -> [String; 4] {
    ["force_x", "force_y", "force_z", "resultant"].map(|name| format!("{name}_{unit}"))
}

/// Returns the table of supports at points: the forces of the supports on the structure.
pub(super) fn reactions(contents: &Contents, statistics: &Value) -> Table {
    let (length, unit) = units(contents, statistics);
    let mut columns = vec!["vertex".to_owned(), "name".to_owned()];
    columns.extend(["x", "y", "z"].map(|axis| format!("{axis}_{length}")));
    columns.extend(force_columns(unit));
    let mut table = Table::new(&columns);
    for value in entries(statistics, "reactions") {
        let vertex = value["vertex"].as_u64().and_then(|vertex| usize::try_from(vertex).ok()).unwrap_or_default();
        let name = support_name(value);
        let at = contents.mesh.vertices.get(vertex).copied().unwrap_or_default();
        let mut cells = vec![Cell::Count(vertex), Cell::Text(&name)];
        cells.extend(at.to_array().map(Cell::Number));
        cells.extend(force(value).map(Cell::Number));
        table.row(&cells);
    }
    table
}

/// Returns the table of supports along boundaries: the forces of the supports on the structure.
pub(super) fn edge_reactions(contents: &Contents, statistics: &Value) -> Table {
    let (length, unit) = units(contents, statistics);
    let mut columns = vec!["boundary".to_owned(), "name".to_owned()];
    columns.extend(force_columns(unit));
    columns.extend(["min", "max"].map(|end| format!("force_per_length_{end}_{unit}_per_{length}")));
    let mut table = Table::new(&columns);
    for value in entries(statistics, "edge_reactions") {
        let boundary = value["boundary"].as_u64().and_then(|number| usize::try_from(number).ok()).unwrap_or_default();
        let name = support_name(value);
        let mut cells = vec![Cell::Count(boundary), Cell::Text(&name)];
        cells.extend(force(value).map(Cell::Number));
        let range = &value["force_per_length"];
        cells.extend([number(range, "min"), number(range, "max")]);
        table.row(&cells);
    }
    table
}
