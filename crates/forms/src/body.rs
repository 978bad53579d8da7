//! Body of a request: a JSON value, with its long lists of points stored separately. In a JSON value every point is a
//! separate allocation, and these allocations take longer than all other steps of reading a strip.

use crate::common::Point;
use crate::json::{self, Strict};
use crate::limits::{Limits, refuse_too_many_values};
use crate::rejection::Rejection;
use serde::de::{Deserializer as _, MapAccess, Visitor};
use serde::{Serialize, Serializer, ser::SerializeMap};
use serde_json::{Map, Value};
use std::fmt;

/// Number of points of each polyline that stay in the outline: the largest minimum that a schema demands.
const OUTLINE_POINTS: usize = 3;

/// Body of a request, which is normally a JSON object.
#[derive(Clone, Debug)]
pub struct Body {
    /// The value, with only the first [`OUTLINE_POINTS`] points of each polyline in `lists`.
    outline: Value,
    lists: Vec<PointList>,
}

/// Polylines of one field of a body.
#[derive(Clone, Debug)]
pub struct PointList {
    pub field: &'static str,
    pub polylines: Vec<Vec<Point>>,
}

/// Value of a field, from the outline or from the point lists.
#[derive(Clone, Copy, Debug, Serialize)]
#[serde(untagged)]
pub enum Field<'a> {
    Value(&'a Value),
    Points(&'a [Vec<Point>]),
}

impl From<Value> for Body {
    fn from(outline: Value) -> Self {
        Self { outline, lists: Vec::new() }
    }
}

impl Body {
    /// Reads the JSON of a request whose fields of the given names are lists of polylines.
    ///
    /// # Errors
    /// Returns the errors of [`json::parse`], and [`Rejection::TooLarge`] for a body with very many values.
    pub fn read(point_fields: &'static [&'static str], body: &[u8], limits: &Limits) -> Result<Self, Rejection> {
        refuse_too_many_values(body, limits)?;
        // The fast reader gives no reason for refusing a body. The strict reader then reports every error.
        match Self::with_lists(body, point_fields) {
            Some(read) => Ok(read),
            None => json::parse(body).map(Self::from),
        }
    }

    /// Reads an object whose `fields` are lists of polylines. Returns `None` for every other body;
    /// [`json::parse`] then finds the errors, if there are any.
    fn with_lists(body: &[u8], fields: &'static [&'static str]) -> Option<Self> {
        let mut deserializer = serde_json::Deserializer::from_slice(body);
        let read = deserializer.deserialize_map(Reader { fields }).ok()?;
        deserializer.end().ok()?;
        Some(read)
    }

    /// Returns the body without the points that are only in [`lists`](Self::lists).
    #[must_use]
    pub fn outline(&self) -> &Value {
        &self.outline
    }

    #[must_use]
    pub fn lists(&self) -> &[PointList] {
        &self.lists
    }

    /// Takes a field that is not a list of points out of the body.
    pub fn take(&mut self, field: &str) -> Option<Value> {
        self.outline.as_object_mut()?.remove(field)
    }

    /// Returns the whole body as one value.
    pub(crate) fn whole(&self) -> Value {
        let mut whole = self.outline.clone();
        for list in &self.lists {
            whole[list.field] = list
                .polylines
                .iter()
                .map(|line| line.iter().map(|p| Value::from(p.to_vec())).collect::<Value>())
                .collect();
        }
        whole
    }

    /// Returns the fields of an object in the order of their names, or `None` if the body is not an object.
    #[must_use]
    pub fn fields(&self) -> Option<impl ExactSizeIterator<Item = (&str, Field<'_>)>> {
        Some(self.outline.as_object()?.iter().map(|(name, value)| {
            let list = self.lists.iter().find(|list| list.field == name);
            (name.as_str(), list.map_or(Field::Value(value), |list| Field::Points(&list.polylines)))
        }))
    }
}

impl Serialize for Body {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Some(fields) = self.fields() else { return self.outline.serialize(serializer) };
        let mut map = serializer.serialize_map(Some(fields.len()))?;
        for (name, field) in fields {
            map.serialize_entry(name, &field)?;
        }
        map.end()
    }
}

struct Reader {
    fields: &'static [&'static str],
}

impl<'de> Visitor<'de> for Reader {
    type Value = Body;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a request")
    }
    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Body, A::Error> {
        let (mut outline, mut lists) = (Map::new(), Vec::new());
        while let Some(name) = entries.next_key::<String>()? {
            if outline.contains_key(&name) {
                return Err(serde::de::Error::custom("an object repeats a key"));
            }
            let value = match self.fields.iter().find(|&&field| field == name) {
                None => entries.next_value_seed(Strict)?,
                Some(field) => match entries.next_value::<Option<Vec<Vec<Point>>>>()? {
                    None => Value::Null,
                    Some(polylines) => {
                        let kept = polylines.iter().map(|line| {
                            line.iter().take(OUTLINE_POINTS).map(|point| Value::from(point.to_vec())).collect::<Value>()
                        });
                        let kept = kept.collect();
                        lists.push(PointList { field, polylines });
                        kept
                    }
                },
            };
            outline.insert(name, value);
        }
        Ok(Body { outline: Value::Object(outline), lists })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::components::{components, request_component};
    use crate::kind::Kind;

    fn read(body: &str) -> Option<Body> {
        Body::with_lists(body.as_bytes(), &["rails", "normals"])
    }

    #[test]
    fn a_body_is_serialized_as_it_was_read() {
        for text in [
            r#"{"rails": [[[0, 1.5, -2e3], [1, 2, 3], [4, 5, 6], [0.1, 0.2, 7]], [], [[1e-300, 0, 9]]], "b": {"c": [1, null]}, "a": "x"}"#,
            r#"{"normals": null, "rails": []}"#,
            r#"{"other": [[[1, 2, 3]]]}"#,
            "{}",
        ] {
            let (body, value) = (read(text).expect(text), json::parse(text.as_bytes()).unwrap());
            assert_eq!(json::parse(&serde_json::to_vec(&body).unwrap()).unwrap(), value);
            let names: Vec<&str> = body.fields().unwrap().map(|(name, _)| name).collect();
            assert_eq!(names, value.as_object().unwrap().keys().collect::<Vec<_>>());
        }
        let body = read(r#"{"rails": [[[0, 1, 2], [1, 2, 3], [4, 5, 6], [0, 2, 7]], [[0, 0, 0]]]}"#).unwrap();
        assert_eq!(body.lists()[0].polylines[0][3], [0.0, 2.0, 7.0]);
        assert_eq!(
            body.outline()["rails"].as_array().unwrap().iter().map(|l| l.as_array().unwrap().len()).sum::<usize>(),
            4
        );
    }

    #[test]
    fn invalid_and_unusual_bodies_are_refused_by_the_fast_reader() {
        for text in [
            "",
            "[]",
            "3",
            r#"{"rails": 3}"#,
            r#"{"rails": [[[0, 1]]]}"#,
            r#"{"rails": [[[0, 1, 2, 3]]]}"#,
            r#"{"rails": [[[0, 1, "2"]]]}"#,
            r#"{"rails": [[[0, 1, null]]]}"#,
            r#"{"rails": [[[0, 1, 1e999]]]}"#,
            r#"{"rails": [], "rails": []}"#,
            r#"{"a": {"b": 1, "b": 2}}"#,
            r#"{"rails": []} x"#,
        ] {
            assert!(read(text).is_none(), "{text}");
        }
    }

    /// The schema sees only the first points. It must therefore not demand more points, and it must demand only numbers
    /// as coordinates.
    #[test]
    fn schemas_check_only_the_points_that_are_in_the_outline() {
        let mut seen = 0;
        for kind in Kind::ALL {
            for field in kind.point_fields() {
                let resolved = |schema: &'static Value| {
                    let name = schema["$ref"].as_str().and_then(|reference| reference.rsplit('/').next());
                    name.map_or(schema, |name| &components()[name])
                };
                let list = resolved(&components()[&*request_component(*kind)]["properties"][field]);
                let line = resolved(&list["items"]);
                let point = resolved(&line["items"]);
                assert!(line["minItems"].as_u64().unwrap_or(0) <= OUTLINE_POINTS as u64, "{field}");
                assert_eq!((point["minItems"].as_u64(), point["maxItems"].as_u64()), (Some(3), Some(3)), "{field}");
                let known = ["type", "items", "minItems", "description", "default"];
                for part in [list, line] {
                    assert!(part.as_object().unwrap().keys().all(|key| known.contains(&key.as_str())), "{part}");
                }
                assert_eq!(point["items"], serde_json::json!({ "type": "number", "format": "double" }), "{field}");
                seen += 1;
            }
        }
        assert_eq!(seen, 5);
    }
}
