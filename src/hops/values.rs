//! Reads the message in which Hops sends the values of a component's inputs.

use super::HopsError;
use super::component::{Component, find};
use crate::hops::envelope;
use plateau_engine::blocks::{Input, Type};
use plateau_engine::common::Point;
use plateau_opennurbs::curve::Curve;
use plateau_opennurbs::{Mesh, Object};
use serde::de::{DeserializeSeed, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, de};
use serde_json::Value;
use std::collections::BTreeMap;

/// Part of a message that this server uses. Hops sends further fields for definitions of Grasshopper.
#[derive(Deserialize)]
struct Message {
    #[serde(default)]
    pointer: Option<String>,
    #[serde(default)]
    values: Vec<Tree>,
    /// Tolerance of the document. Older versions of Hops send 0.
    #[serde(default)]
    absolutetolerance: Option<f64>,
    /// Unit of the document by the name of Rhino's `UnitSystem`. Older versions of Hops send none.
    #[serde(default)]
    modelunits: Option<String>,
}

#[derive(Debug, Deserialize)]
struct Tree {
    #[serde(rename = "ParamName")]
    name: String,
    #[serde(rename = "InnerTree", default)]
    items: Items,
}

#[derive(Debug, Deserialize)]
struct Item {
    /// JSON text of the value.
    data: Option<String>,
}

/// The values of all branches of a tree, in the order of the message.
#[derive(Debug, Default)]
struct Items(Vec<Item>);

impl<'de> Deserialize<'de> for Items {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Branches;

        impl<'de> Visitor<'de> for Branches {
            type Value = Items;

            fn expecting(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                formatter.write_str("branches such as {\"{0}\": [{\"type\", \"data\"}]}")
            }

            fn visit_unit<E: de::Error>(self) -> Result<Items, E> {
                Ok(Items::default())
            }

            fn visit_map<A: MapAccess<'de>>(self, mut branches: A) -> Result<Items, A::Error> {
                let mut items = Vec::new();
                while branches.next_key::<IgnoredAny>()?.is_some() {
                    branches.next_value_seed(Branch(&mut items))?;
                }
                Ok(Items(items))
            }
        }

        deserializer.deserialize_any(Branches)
    }
}

/// Largest number of values of an input. An input of so many values is no design, and the values of a message are held
/// in memory before they are read.
const MOST_ITEMS: usize = 1 << 20;

/// Adds the values of a branch to those of the branches before it.
struct Branch<'i>(&'i mut Vec<Item>);

impl<'de> DeserializeSeed<'de> for Branch<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for Branch<'_> {
    type Value = ();

    fn expecting(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str("a list such as [{\"type\", \"data\"}]")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<(), A::Error> {
        while let Some(item) = items.next_element::<Option<Item>>()? {
            if self.0.len() == MOST_ITEMS {
                return Err(de::Error::custom(format_args!("an input has more than {MOST_ITEMS} values")));
            }
            self.0.push(item.unwrap_or(Item { data: None }));
        }
        Ok(())
    }
}

/// A value of an input, or its list of values.
#[derive(Clone, Debug)]
enum Given {
    Boolean(bool),
    Curves(Vec<Curve>),
    Integer(i64),
    Mesh(Mesh),
    Number(f64),
    Points(Vec<Point>),
    Text(String),
}

/// The values of a component's inputs. Every input has a value, of the type that the component declares.
#[derive(Clone, Debug)]
pub struct Values {
    given: BTreeMap<&'static str, Given>,
    /// Distance up to which the ends of a curve count as equal. 0 if the client names none.
    pub document_tolerance: f64,
    /// Name of the document's unit. Empty if the client names none.
    pub document_unit: String,
}

/// A message that names a component.
#[derive(Debug)]
pub struct Named {
    pub component: &'static Component,
    values: Vec<Tree>,
    document_tolerance: f64,
    document_unit: String,
}

/// Reads a message and finds the component that it names. The values of its inputs are read later, by [`read`].
///
/// # Errors
/// Returns [`HopsError::Malformed`] or [`HopsError::Unknown`].
pub fn message(body: &[u8]) -> Result<Named, HopsError> {
    let message: Message = serde_json::from_slice(body)
        .map_err(|error| HopsError::Malformed(format!("the body is not a message of Hops: {error}")))?;
    let component = find(&message.pointer.unwrap_or_default()).map_err(HopsError::Unknown)?;
    let document_tolerance = message.absolutetolerance.filter(|tolerance| *tolerance > 0.0).unwrap_or(0.0);
    let document_unit = shortened(&message.modelunits.unwrap_or_default());
    Ok(Named { component, values: message.values, document_tolerance, document_unit })
}

/// Reads the values of a component's inputs. Curves and meshes may have at most `max_points` points.
///
/// # Errors
/// Returns [`HopsError::Outdated`] or [`HopsError::Invalid`], with a line for each input that cannot be used.
pub fn read(message: &Named, max_points: usize) -> Result<Values, HopsError> {
    let Named { component, values, document_tolerance, document_unit } = message;
    let mut sent: BTreeMap<&str, &[Item]> = BTreeMap::new();
    let mut outdated = Vec::new();
    for tree in values {
        if component.inputs.iter().any(|input| input.name == tree.name) {
            sent.insert(&tree.name, &tree.items.0);
        } else {
            outdated.push(format!("{} is not an input of this component", shortened(&tree.name)));
        }
    }
    let missing = component.inputs.iter().filter(|input| input.default.is_none() && !sent.contains_key(input.name));
    outdated.extend(missing.map(|input| format!("{}: is required", input.name)));
    if !outdated.is_empty() {
        return Err(HopsError::Outdated(outdated));
    }
    let mut given = BTreeMap::new();
    let mut errors = Vec::new();
    for input in &component.inputs {
        match Given::read(input, sent.get(input.name).copied().unwrap_or_default(), max_points) {
            Ok(value) => drop(given.insert(input.name, value)),
            Err(more) => errors.extend(more),
        }
    }
    if !errors.is_empty() {
        return Err(HopsError::Invalid(errors));
    }
    Ok(Values { given, document_tolerance: *document_tolerance, document_unit: document_unit.clone() })
}

/// Removes control characters from a name that a client has sent, and cuts the name to 50 characters.
fn shortened(name: &str) -> String {
    name.chars().filter(|character| !character.is_control()).take(50).collect()
}

/// Returns the name by which errors refer to one value of a list.
#[must_use]
pub fn nth(name: &str, index: usize) -> String {
    format!("{name}[{index}]")
}

impl Given {
    /// Reads the values of an input.
    fn read(input: &Input, items: &[Item], max_points: usize) -> Result<Self, Vec<String>> {
        let error = |text: &str| vec![format!("{}: {text}", input.name)];
        if let Some(least) = input.at_least {
            if items.len() < least as usize {
                return Err(error(&format!("needs at least {least} values, and has {}", items.len())));
            }
            return match input.of {
                Type::Curve => all(input, items, |data| curve(data, max_points)).map(Given::Curves),
                _ => all(input, items, point).map(Given::Points),
            };
        }
        let data = match (items, &input.default) {
            ([Item { data: Some(data) }], _) if data.trim() != NULL => data.clone(),
            ([_], _) => return Err(error("is null, so something upstream gave no value")),
            ([], Some(default)) => Value::from(*default).to_string(),
            ([], None) => return Err(error("has no value")),
            _ => return Err(error(&format!("takes one value, and has {}", items.len()))),
        };
        let given = match input.of {
            Type::Boolean => boolean(&data).map(Given::Boolean),
            Type::Integer => integer(&data).map(Given::Integer),
            Type::Mesh => mesh(&data, max_points).map(Given::Mesh),
            Type::Text => Ok(Given::Text(text(&data))),
            _ => number(&data).map(Given::Number),
        };
        given.map_err(|text| error(&text))
    }
}

/// JSON text of an item without a value.
const NULL: &str = "null";

fn all<T>(input: &Input, items: &[Item], read: impl Fn(&str) -> Result<T, String>) -> Result<Vec<T>, Vec<String>> {
    let mut values = Vec::with_capacity(items.len());
    let mut errors = Vec::new();
    for (index, item) in items.iter().enumerate() {
        let data = item.data.as_deref().unwrap_or(NULL);
        let read = if data.trim() == NULL {
            Err("is null, so something upstream gave no value; remove nulls, for example with the component Clean Tree"
                .into())
        } else {
            read(data)
        };
        match read {
            Ok(value) => values.push(value),
            Err(text) => errors.push(format!("{}: {text}", nth(input.name, index))),
        }
    }
    if errors.is_empty() { Ok(values) } else { Err(errors) }
}

fn curve(data: &str, max_points: usize) -> Result<Curve, String> {
    match envelope::from_json(data, max_points) {
        Ok(Object::Curve(curve)) => Ok(curve),
        Ok(Object::Mesh(_)) => Err("is a mesh, and must be a curve".into()),
        Err(defect) => Err(defect.to_string()),
    }
}

fn mesh(data: &str, max_points: usize) -> Result<Mesh, String> {
    match envelope::from_json(data, max_points) {
        Ok(Object::Mesh(mesh)) => Ok(mesh),
        Ok(Object::Curve(_)) => Err("is a curve, and must be a mesh".into()),
        Err(defect) => Err(defect.to_string()),
    }
}

/// Returns the JSON value of a data text. Text within quotes is read as the value that it names, because .NET writes
/// NaN and some numbers like that.
fn scalar(data: &str) -> Option<Value> {
    match serde_json::from_str(data).ok()? {
        Value::String(text) => serde_json::from_str(&text.to_ascii_lowercase()).ok(),
        value => Some(value),
    }
}

fn number(data: &str) -> Result<f64, String> {
    let number = scalar(data).and_then(|value| value.as_f64());
    number.ok_or_else(|| "must be a finite number".into())
}

fn integer(data: &str) -> Result<i64, String> {
    let whole = |number: f64| (number.fract() == 0.0 && number.abs() <= 1e15).then_some(number as i64);
    number(data).ok().and_then(whole).ok_or_else(|| "must be a whole number".into())
}

fn boolean(data: &str) -> Result<bool, String> {
    scalar(data).and_then(|value| value.as_bool()).ok_or_else(|| "must be true or false".into())
}

fn text(data: &str) -> String {
    serde_json::from_str(data).unwrap_or_else(|_| data.to_owned())
}

fn point(data: &str) -> Result<Point, String> {
    #[derive(Deserialize)]
    #[serde(rename_all = "PascalCase")]
    struct Point3d {
        x: f64,
        y: f64,
        z: f64,
    }
    let point: Option<Point3d> = serde_json::from_str(data).ok();
    point.map(|Point3d { x, y, z }| [x, y, z]).ok_or_else(|| "must be a point {X, Y, Z} of finite numbers".into())
}

/// Access by name. The component's table and the recipes agree on names and types, which a test checks by solving with
/// every component.
impl Values {
    /// Returns the value of an input that takes one boolean, number or text.
    #[must_use]
    pub fn value(&self, name: &str) -> Value {
        match self.given.get(name) {
            Some(Given::Boolean(value)) => (*value).into(),
            Some(Given::Integer(value)) => (*value).into(),
            Some(Given::Number(value)) => (*value).into(),
            Some(Given::Text(value)) => value.as_str().into(),
            _ => Value::Null,
        }
    }

    #[must_use]
    pub fn curves(&self, name: &str) -> &[Curve] {
        if let Some(Given::Curves(curves)) = self.given.get(name) { curves } else { &[] }
    }

    #[must_use]
    pub fn points(&self, name: &str) -> &[Point] {
        if let Some(Given::Points(points)) = self.given.get(name) { points } else { &[] }
    }

    #[must_use]
    pub fn mesh(&self, name: &str) -> Option<&Mesh> {
        if let Some(Given::Mesh(mesh)) = self.given.get(name) { Some(mesh) } else { None }
    }

    #[must_use]
    pub fn number(&self, name: &str) -> f64 {
        if let Some(Given::Number(number)) = self.given.get(name) { *number } else { 0.0 }
    }

    #[must_use]
    pub fn integer(&self, name: &str) -> i64 {
        if let Some(Given::Integer(number)) = self.given.get(name) { *number } else { 0 }
    }

    #[must_use]
    pub fn boolean(&self, name: &str) -> bool {
        matches!(self.given.get(name), Some(Given::Boolean(true)))
    }

    #[must_use]
    pub fn text(&self, name: &str) -> &str {
        if let Some(Given::Text(text)) = self.given.get(name) { text } else { "" }
    }
}
