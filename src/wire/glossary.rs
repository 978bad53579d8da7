//! Descriptions of members that many answers have with one meaning, for the API document. A member whose Rust type has
//! a comment of its own keeps that description.

use serde_json::{Map, Value};

/// `(member, description)`, for every component that has no entry of its own.
const GENERAL: &[(&str, &str)] = &[
    ("area", "Area, in square units of the request's unit of length."),
    ("bending_energy", "Bending energy of the strip, without a unit."),
    ("boundary", "Number of the boundary, counted from 0."),
    ("boundary_loops", "Number of closed loops of boundary edges."),
    ("bridges", "Number of bridges, which are the edges between the rails."),
    ("cancelled", "Number of cancelled jobs."),
    ("components", "Number of connected parts."),
    ("converged", "Whether the solver has met its own rule."),
    ("convex_bridge_ratio", "Number of locally convex bridges over the number of bridges."),
    ("count", "Number of members."),
    ("degenerate_triangles", "Number of triangles without an area, up to rounding."),
    ("detail", "What was wrong and what to try, in words."),
    ("distinct_lengths", "Number of different lengths of members."),
    ("edges", "Number of edges."),
    ("edges_swapped", "Number of edges that were flipped."),
    ("errors", "Offending values of the request."),
    ("euler_characteristic", "Vertices - edges + triangles."),
    ("events", "Address of the server-sent events."),
    ("examples", "The examples."),
    ("failed", "Number of failed jobs."),
    ("finished_at", "Time of the end (RFC 3339, UTC). Null until then."),
    ("flipped_triangles", "Number of triangles that are turned over against their neighbours."),
    ("force_max", "Largest force."),
    ("force_min", "Smallest force."),
    ("height", "Height of the bounding box."),
    ("history", "Iterations of the solver."),
    ("id", "ULID, which sorts by time of submission."),
    ("iteration", "Number of the iteration, counted from 1."),
    ("iterations", "Number of iterations."),
    ("jobs", "The jobs."),
    ("length", "Length."),
    ("lines", "Sets of lines beside the triangles, such as boundaries and cables."),
    ("longest_bridge", "Length of the longest bridge."),
    ("max", "Largest value."),
    ("mean", "Mean value."),
    ("mean_curvature_variation", "Variation of the mean curvature from bridge to bridge."),
    ("min", "Smallest value."),
    ("mode", "Quantity that was held constant."),
    ("name", "Name."),
    ("nodes", "Number of nodes."),
    ("objective", "Name of the objective, as in `GET /v1/objectives`."),
    ("objective_value", "Value of the objective."),
    ("objectives", "The objectives."),
    ("out_of_range_edges", "Number of members whose length is outside the range of the objective."),
    ("points", "The two ends."),
    ("queued", "Number of jobs that wait."),
    ("radius", "Radius."),
    ("residual", "Residual, without a unit."),
    ("running", "Number of jobs that are being solved."),
    ("self", "Address of the resource itself."),
    ("shortest_bridge", "Length of the shortest bridge."),
    ("started_at", "Time at which the solver began (RFC 3339, UTC). Null until then."),
    ("std_dev", "Standard deviation."),
    ("stop_reason", "Reason for which the solver stopped."),
    ("succeeded", "Number of jobs that have succeeded."),
    ("title", "Title, for people."),
    ("triangles", "Number of triangles."),
    ("values", "Values, in the order of the lines."),
    ("vertex", "Number of the vertex, counted from 0."),
    ("vertices", "Number of vertices."),
    ("warnings", "Warnings about a result that is there."),
    ("width", "Width of the bounding box."),
];

/// `(component, member, description)`.
const SPECIAL: &[(&str, &str, &str)] = &[
    ("BoundaryPoint", "point", "Number of the point, counted from 0."),
    ("Comparison", "secondary_objective", "Objective that decided among strips of equal value."),
    ("Guide", "circle", "A circle."),
    ("Guide", "line", "A straight line."),
    ("Guide", "plane", "A plane."),
    ("Guide", "sphere", "A sphere."),
    ("Guide", "cylinder", "A cylinder."),
    ("MastForce", "length", "Length of the mast in the found shape."),
    ("OutOfRange", "length", "Length of the member."),
    ("OutOfRange", "vertices", "Numbers of its two ends, counted from 0."),
    ("Progress", "objective_value", "Value of the objective after the iteration, if the solver knows it."),
    ("Progress", "residual", "Residual after the iteration, if the solver knows it."),
    ("TensileStatistics", "cables", "The cables with their forces."),
    ("TensileStatistics", "masts", "The masts with their forces."),
    ("TensileStatistics", "rings", "The rings with their places."),
    ("UniformStatistics", "angles_deg", "Angles of the triangles, in degrees."),
    ("MinimalStatistics", "angles_deg", "Angles of the triangles, in degrees."),
    ("TensileStatistics", "angles_deg", "Angles of the triangles, in degrees."),
];

/// Adds a description to each member that has none: that of this list, or the first paragraph of the description of the
/// component to which it refers.
pub fn describe(components: &mut Map<String, Value>) {
    let described: Map<String, Value> = components
        .iter()
        .filter_map(|(name, schema)| Some((name.clone(), schema.get("description")?.clone())))
        .collect();
    for (component, schema) in components {
        let members = schema.get_mut("properties").and_then(Value::as_object_mut);
        for (name, member) in members.into_iter().flatten() {
            let Some(keywords) = member.as_object_mut().filter(|keywords| !keywords.contains_key("description")) else {
                continue;
            };
            let text = own(component, name).or_else(|| first_paragraph(keywords, &described)).or_else(|| general(name));
            if let Some(text) = text.map(Value::from) {
                keywords.insert("description".into(), text);
            }
        }
    }
}

fn own<'a>(component: &str, member: &str) -> Option<&'a str> {
    SPECIAL.iter().find(|(of, name, _)| *of == component && *name == member).map(|(.., text)| *text)
}

fn general<'a>(member: &str) -> Option<&'a str> {
    GENERAL.iter().find(|(name, _)| *name == member).map(|(_, text)| *text)
}

/// Returns the first paragraph of the description of the component to which a member refers.
fn first_paragraph<'a>(member: &Map<String, Value>, described: &'a Map<String, Value>) -> Option<&'a str> {
    let parts = member.get("oneOf").and_then(Value::as_array).map(Vec::as_slice).unwrap_or_default();
    let references = member.get("$ref").into_iter().chain(parts.iter().filter_map(|part| part.get("$ref")));
    let target = references.filter_map(Value::as_str).next()?.rsplit('/').next()?;
    described.get(target)?.as_str()?.split("\n\n").next()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wire::components::components;

    /// Calls `visit` with the name of each member of an object schema at any depth, and its schema.
    fn members(place: &str, schema: &Value, visit: &mut impl FnMut(String, &Value)) {
        match schema {
            Value::Object(keywords) => {
                for (keyword, inner) in keywords {
                    if let ("properties", Value::Object(found)) = (keyword.as_str(), inner) {
                        for (name, member) in found {
                            visit(format!("{place}.{name}"), member);
                        }
                    }
                    members(place, inner, visit);
                }
            }
            Value::Array(items) => items.iter().for_each(|item| members(place, item, visit)),
            _ => {}
        }
    }

    #[test]
    fn every_member_has_a_description() {
        let (mut lacking, mut seen) = (Vec::new(), 0);
        for (name, schema) in components() {
            members(name, schema, &mut |place, member| {
                seen += 1;
                if member.get("description").and_then(Value::as_str).is_none_or(str::is_empty) {
                    lacking.push(place);
                }
            });
        }
        assert!(seen > 700, "{seen}");
        assert!(lacking.is_empty(), "{lacking:?}: write a comment at the Rust type, or a line here");
    }

    #[test]
    fn every_line_is_used() {
        let all: Vec<(&String, &String)> = components()
            .iter()
            .flat_map(|(name, schema)| {
                schema["properties"].as_object().into_iter().flatten().map(move |(member, _)| (name, member))
            })
            .collect();
        for (of, member, _) in SPECIAL {
            assert!(all.iter().any(|(component, name)| component == of && name == member), "{of}.{member}");
        }
        let texts: Vec<&str> = components()
            .values()
            .flat_map(|schema| schema["properties"].as_object().into_iter().flatten())
            .filter_map(|(_, member)| member["description"].as_str())
            .collect();
        let unused: Vec<&str> =
            GENERAL.iter().filter(|(_, text)| !texts.contains(text)).map(|(member, _)| *member).collect();
        assert!(unused.is_empty(), "{unused:?}");
    }
}
