//! Explains why a JSON value does not satisfy a schema: the pointer to each wrong value, and a
//! phrase that can follow the pointer, such as "must be a number". Values are never echoed.
//!
//! [`Schemas`] compiles the JSON Schemas of the API document, each when a value is first compared with it. It supports
//! the keywords that these schemas use, and no others. In a union, the type of the JSON value selects the branch with
//! which the value is compared. Among several kinds of objects, the member that the keyword `discriminator` names
//! selects the branch. Therefore all errors come from a single branch.

use crate::rejection::{FieldError, MAX_ERRORS};
use serde_json::{Map, Value};
use std::collections::BTreeMap;
use std::fmt;
use std::sync::OnceLock;

/// Schemas that refer to each other by their names. Each is compiled when it is first needed, because most values need
/// only a few of them.
#[derive(Debug)]
pub struct Schemas<'a>(BTreeMap<&'a str, (&'a Value, OnceLock<Schema>)>);

#[derive(Debug)]
enum Schema {
    Any,
    Null,
    Boolean,
    Number(Number),
    /// A string with a number of characters in this range.
    Text(Count),
    /// A string out of a list.
    Names(Vec<String>),
    List {
        items: Box<Schema>,
        count: Count,
    },
    Object(Object),
    /// Reference to the schema with this name.
    Reference(String),
    /// Branches, of which the JSON type of the value selects one.
    Union(Vec<Schema>),
    /// Objects. The value of the member `tag` selects the schema.
    Tagged {
        tag: String,
        branches: Vec<(String, Schema)>,
    },
}

#[derive(Debug)]
struct Number {
    integer: bool,
    at_least: Option<f64>,
    at_most: Option<f64>,
    more_than: Option<f64>,
    less_than: Option<f64>,
}

#[derive(Debug)]
struct Object {
    members: BTreeMap<String, Schema>,
    required: Vec<String>,
    /// Schema of the members that are not in `members`. If there is none, these members are not allowed.
    others: Option<Box<Schema>>,
    count: Count,
    /// A valid object as JSON text, for errors about other values.
    example: Option<String>,
}

/// Range of a number of items, characters or members.
#[derive(Clone, Copy, Debug)]
struct Count {
    at_least: usize,
    at_most: usize,
}

/// The phrase for null.
const NULL: &str = "null";

/// Keywords without influence on validity.
const ANNOTATIONS: [&str; 10] = [
    "$defs",
    "$schema",
    "default",
    "description",
    "format",
    "title",
    "x-default",
    "x-empty-is-refused",
    "x-enum-descriptions",
    "x-optional",
];

impl Schema {
    /// Compiles a JSON Schema.
    ///
    /// # Panics
    /// Panics if the schema has a keyword that this module cannot explain. Every schema of the service is compiled in a
    /// test.
    fn new(schema: &Value) -> Self {
        // The schema `true` has no keywords.
        let Some(keywords) = schema.as_object() else { return Self::Any };
        let mut keywords = keywords.clone();
        keywords.retain(|keyword, _| !ANNOTATIONS.contains(&keyword.as_str()));
        let example = keywords.remove("examples").and_then(|examples| Some(examples.get(0)?.to_string()));
        let mut compiled = Self::of(&mut keywords);
        if let Self::Object(object) = &mut compiled {
            object.example = example;
        }
        assert!(keywords.is_empty(), "an error cannot explain these keywords: {keywords:?}");
        compiled
    }

    /// Compiles keywords. Each keyword that the result contains is removed from the map.
    fn of(keywords: &mut Map<String, Value>) -> Self {
        if let Some(reference) = keywords.remove("$ref") {
            return Self::Reference(name_of(&reference));
        }
        if let Some(discriminator) = keywords.remove("discriminator") {
            keywords.remove("oneOf");
            let mapping = discriminator["mapping"].as_object().into_iter().flatten();
            let branches = mapping.map(|(value, schema)| (value.clone(), Self::Reference(name_of(schema)))).collect();
            return Self::Tagged { tag: text(&discriminator["propertyName"]), branches };
        }
        if let Some(parts) = keywords.remove("anyOf").or_else(|| keywords.remove("oneOf")) {
            return Self::union(parts.as_array().into_iter().flatten().map(Self::new).collect());
        }
        if let Some(values) = keywords.remove("enum") {
            keywords.remove("type");
            return Self::Names(values.as_array().into_iter().flatten().map(text).collect());
        }
        if let Some(value) = keywords.remove("const") {
            keywords.remove("type");
            return Self::Names(vec![text(&value)]);
        }
        match keywords.remove("type") {
            None => Self::Any,
            Some(Value::Array(types)) => {
                Self::union(types.iter().map(|name| Self::of_type(&text(name), keywords)).collect())
            }
            Some(name) => Self::of_type(&text(&name), keywords),
        }
    }

    fn of_type(name: &str, keywords: &mut Map<String, Value>) -> Self {
        match name {
            "null" => Self::Null,
            "boolean" => Self::Boolean,
            "number" | "integer" => {
                let mut bound = |keyword: &str| keywords.remove(keyword).and_then(|bound| bound.as_f64());
                Self::Number(Number {
                    integer: name == "integer",
                    at_least: bound("minimum"),
                    at_most: bound("maximum"),
                    more_than: bound("exclusiveMinimum"),
                    less_than: bound("exclusiveMaximum"),
                })
            }
            "string" => Self::Text(Count::of("minLength", "maxLength", keywords)),
            "array" => Self::List {
                items: Box::new(keywords.remove("items").map_or(Self::Any, |items| Self::new(&items))),
                count: Count::of("minItems", "maxItems", keywords),
            },
            "object" => {
                let members = keywords.remove("properties");
                let required = keywords.remove("required");
                Self::Object(Object {
                    members: members
                        .iter()
                        .flat_map(|members| members.as_object().into_iter().flatten())
                        .map(|(name, schema)| (name.clone(), Self::new(schema)))
                        .collect(),
                    required: required
                        .iter()
                        .flat_map(|names| names.as_array().into_iter().flatten())
                        .map(text)
                        .collect(),
                    others: match keywords.remove("additionalProperties") {
                        None => Some(Box::new(Self::Any)),
                        Some(Value::Bool(false)) => None,
                        Some(schema) => Some(Box::new(Self::new(&schema))),
                    },
                    count: Count::of("minProperties", "maxProperties", keywords),
                    example: None,
                })
            }
            _ => panic!("{name} is not a type of JSON"),
        }
    }

    /// Returns the union of some branches. If every branch is a list of names, the union is a single list of names.
    fn union(branches: Vec<Self>) -> Self {
        let names: Option<Vec<&[String]>> = branches
            .iter()
            .map(|branch| match branch {
                Self::Names(names) => Some(names.as_slice()),
                _ => None,
            })
            .collect();
        match names {
            Some(names) => Self::Names(names.concat()),
            None => Self::Union(branches),
        }
    }

    /// Returns true for a list of three numbers of any size, which is a point or a vector.
    fn is_point(&self) -> bool {
        let Self::List { items, count: Count { at_least: 3, at_most: 3 } } = self else { return false };
        matches!(
            **items,
            Self::Number(Number { integer: false, at_least: None, at_most: None, more_than: None, less_than: None })
        )
    }
}

fn text(value: &Value) -> String {
    value.as_str().unwrap_or_else(|| panic!("{value} is not a string, and an error cannot explain it")).to_owned()
}

/// Returns the name of the schema to which a reference leads.
fn name_of(reference: &Value) -> String {
    text(reference).rsplit('/').next().unwrap_or_default().to_owned()
}

/// Location of a value in a body.
#[derive(Clone, Copy)]
enum Pointer<'a> {
    Root,
    Member(&'a Pointer<'a>, &'a str),
    Item(&'a Pointer<'a>, usize),
}

/// Writes the JSON Pointer.
impl fmt::Display for Pointer<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Root => Ok(()),
            Self::Member(parent, name) => write!(f, "{parent}/{}", name.replace('~', "~0").replace('/', "~1")),
            Self::Item(parent, index) => write!(f, "{parent}/{index}"),
        }
    }
}

/// Length in bytes of the longest name of an unknown member to which an error points. If the name is longer, the error
/// points to the object.
const MAX_NAME: usize = 200;

impl<'s> Schemas<'s> {
    /// Takes JSON Schemas by their names, and compiles none of them yet.
    #[must_use]
    pub fn new(schemas: &'s Map<String, Value>) -> Self {
        Self(schemas.iter().map(|(name, schema)| (name.as_str(), (schema, OnceLock::new()))).collect())
    }

    /// Returns the errors of a value in the order of its members, at most [`MAX_ERRORS`] + 1. The
    /// value satisfies the schema if there are none.
    ///
    /// # Panics
    /// Panics if there is no schema of this name, or if it has a keyword that this module cannot explain.
    #[must_use]
    pub fn errors(&self, name: &str, value: &Value) -> Vec<FieldError> {
        let mut errors = Vec::new();
        self.check(self.named(name), value, Pointer::Root, &mut errors);
        errors.truncate(MAX_ERRORS + 1);
        errors
    }

    /// Removes the members that count as left out: those that are null, and empty lists in the place of a list. Only
    /// members that the named schema knows and does not require are removed. Empty lists in `kept` stay: each has the
    /// name of the list and the name of the member in which the object with the list lies.
    ///
    /// # Panics
    /// Panics as [`errors`](Self::errors) does.
    #[must_use]
    pub fn without_empty(&self, name: &str, value: &Value, kept: &[(&str, &str)]) -> Value {
        self.pruned(self.named(name), value, "", kept)
    }

    fn pruned(&self, schema: &Schema, value: &Value, within: &str, kept: &[(&str, &str)]) -> Value {
        match (self.resolved(schema), value) {
            (Schema::Object(object), Value::Object(members)) => {
                let stays = |name: &String, member: &Value| {
                    let Some(schema) = object.members.get(name) else { return true };
                    let is_empty = member.is_null()
                        || (member.as_array().is_some_and(Vec::is_empty)
                            && self.takes(schema, member)
                            && !kept.contains(&(name, within)));
                    !is_empty || object.required.contains(name)
                };
                let left = members.iter().filter(|(name, member)| stays(name, member)).map(|(name, member)| {
                    let schema = object.members.get(name);
                    (name.clone(), schema.map_or_else(|| member.clone(), |s| self.pruned(s, member, name, kept)))
                });
                left.collect::<Map<_, _>>().into()
            }
            (Schema::List { items, .. }, Value::Array(values)) => {
                values.iter().map(|value| self.pruned(items, value, within, kept)).collect()
            }
            (Schema::Union(branches), _) => match branches.iter().find(|branch| self.takes(branch, value)) {
                Some(branch) => self.pruned(branch, value, within, kept),
                None => value.clone(),
            },
            _ => value.clone(),
        }
    }

    fn named(&self, name: &str) -> &Schema {
        let (source, compiled) = self.0.get(name).unwrap_or_else(|| panic!("there is no schema {name}"));
        compiled.get_or_init(|| Schema::new(source))
    }

    fn resolved<'a>(&'a self, schema: &'a Schema) -> &'a Schema {
        match schema {
            Schema::Reference(name) => self.resolved(self.named(name)),
            schema => schema,
        }
    }

    fn check(&self, schema: &Schema, value: &Value, pointer: Pointer<'_>, errors: &mut Vec<FieldError>) {
        let schema = self.resolved(schema);
        match (schema, value) {
            (Schema::Any, _) | (Schema::Null, Value::Null) | (Schema::Boolean, Value::Bool(_)) => {}
            (Schema::Names(names), Value::String(name)) if names.contains(name) => {}
            (Schema::Number(number), Value::Number(value)) => {
                if let Some(detail) = number.violation(value) {
                    errors.push(FieldError::new(pointer.to_string(), detail));
                }
            }
            (Schema::Text(count), Value::String(text)) => {
                if let Some(detail) = count.violation(text.chars().count(), "character") {
                    errors.push(FieldError::new(pointer.to_string(), detail));
                }
            }
            (Schema::List { items, count }, Value::Array(values)) => {
                if let Some(detail) = self.violation_of_form(schema, values) {
                    errors.push(FieldError::new(pointer.to_string(), detail));
                    return;
                }
                if let Some(detail) = count.violation(values.len(), self.noun(schema)) {
                    errors.push(FieldError::new(pointer.to_string(), detail));
                }
                let items = self.resolved(items);
                for (index, value) in values.iter().enumerate() {
                    if errors.len() > MAX_ERRORS {
                        return;
                    }
                    self.check(items, value, Pointer::Item(&pointer, index), errors);
                }
            }
            (Schema::Object(object), Value::Object(members)) => self.check_object(object, members, pointer, errors),
            (Schema::Union(branches), _) => match branches.iter().find(|branch| self.takes(branch, value)) {
                Some(branch) => self.check(branch, value, pointer, errors),
                None => errors.push(FieldError::new(pointer.to_string(), self.expected(schema))),
            },
            (Schema::Tagged { tag, branches }, Value::Object(members)) => {
                let given = members.get(tag);
                match branches.iter().find(|(name, _)| given.is_some_and(|given| *given == **name)) {
                    Some((_, branch)) => self.check(branch, value, pointer, errors),
                    None => {
                        let detail = match given {
                            Some(_) => format!("must be one of {}", list(branches.iter().map(|(name, _)| name))),
                            None => "is required".into(),
                        };
                        errors.push(FieldError::new(Pointer::Member(&pointer, tag).to_string(), detail));
                    }
                }
            }
            _ => errors.push(FieldError::new(pointer.to_string(), self.expected(schema))),
        }
    }

    /// Returns whether a schema applies to values of this value's JSON type.
    fn takes(&self, schema: &Schema, value: &Value) -> bool {
        match self.resolved(schema) {
            Schema::Any => true,
            Schema::Null => value.is_null(),
            Schema::Boolean => value.is_boolean(),
            Schema::Number(_) => value.is_number(),
            Schema::Text(_) | Schema::Names(_) => value.is_string(),
            Schema::List { .. } => value.is_array(),
            Schema::Object(_) | Schema::Tagged { .. } => value.is_object(),
            Schema::Union(branches) => branches.iter().any(|branch| self.takes(branch, value)),
            // References were resolved before.
            Schema::Reference(_) => false,
        }
    }

    /// Returns what is wrong with a whole list of coordinates or points, so that its elements need
    /// no errors of their own.
    fn violation_of_form(&self, schema: &Schema, values: &[Value]) -> Option<String> {
        if schema.is_point() {
            if let [Value::Array(_)] = values {
                return Some(format!("has a level of brackets too many: it must be {}", form_of_list(1)));
            }
            return (values.len() != 3).then(|| {
                let flat = if values.len() == 2 { "; in the plane, z is 0" } else { "" };
                format!("must have three coordinates [x, y, z]{flat}")
            });
        }
        let wanted = self.levels(schema);
        // A list with a single element is not judged as a whole, because only that element may be wrong.
        let lacks_level =
            values.len() > 1 && values.iter().all(|value| levels(value).is_some_and(|levels| levels + 1 < wanted));
        let exceeds = wanted > 0
            && !values.is_empty()
            && values.iter().all(|value| levels(value).is_some_and(|levels| levels + 1 > wanted));
        match (lacks_level, exceeds) {
            (true, _) => Some(format!("lacks a level of brackets: it must be {}", form_of_list(wanted))),
            (_, true) => Some(format!("has a level of brackets too many: it must be {}", form_of_list(wanted))),
            _ => None,
        }
    }

    /// Returns the noun for an element of a list, such as "point".
    fn noun(&self, list: &Schema) -> &'static str {
        match self.levels(list) {
            2 => "point",
            3 => "polyline",
            _ => "item",
        }
    }

    /// Returns the number of levels of arrays around the numbers of points: 1 for a point, 2 for a
    /// list of points, 3 for a list of polylines, and 0 for a schema without points.
    fn levels(&self, schema: &Schema) -> usize {
        match self.resolved(schema) {
            point if point.is_point() => 1,
            Schema::List { items, .. } => match self.levels(items) {
                0 => 0,
                levels => levels + 1,
            },
            _ => 0,
        }
    }

    fn check_object(
        &self,
        object: &Object,
        members: &Map<String, Value>,
        pointer: Pointer<'_>,
        errors: &mut Vec<FieldError>,
    ) {
        let before = errors.len();
        let mut unknown = false;
        for (name, value) in members {
            if errors.len() > MAX_ERRORS {
                return;
            }
            match object.members.get(name).or(object.others.as_deref()) {
                Some(schema) => self.check(schema, value, Pointer::Member(&pointer, name), errors),
                None => {
                    unknown = true;
                    errors.push(if name.len() > MAX_NAME {
                        FieldError::new(pointer.to_string(), "has a member with a very long name that it must not have")
                    } else {
                        FieldError::new(Pointer::Member(&pointer, name).to_string(), object.unknown(name))
                    });
                }
            }
        }
        for name in object.required.iter().filter(|name| !members.contains_key(*name)) {
            errors.push(FieldError::new(Pointer::Member(&pointer, name).to_string(), "is required"));
        }
        // The number of members is not reported beside an unknown name, because that name is usually a misspelt known
        // one.
        // A member that is null counts as left out beside others.
        let given = match members.values().filter(|member| !member.is_null()).count() {
            0 => members.len(),
            given => given,
        };
        if let Some(detail) = object.violation(given).filter(|_| !unknown) {
            errors.insert(before, FieldError::new(pointer.to_string(), detail));
        }
    }

    /// Returns the phrase that lists what a schema accepts, for a value of another JSON type or an unknown name.
    fn expected(&self, schema: &Schema) -> String {
        let (mut names, mut forms) = (Vec::new(), Vec::new());
        self.alternatives(schema, &mut names, &mut forms);
        // Null stands for a member that is left out, which needs no mention beside other values.
        if names.len() + forms.len() > 1 {
            forms.retain(|form| form != NULL);
        }
        if let [only] = names[..] {
            names.clear();
            forms.insert(0, only.to_owned());
        }
        let forms = match forms.as_slice() {
            [first @ .., last] if !first.is_empty() => format!("{} or {last}", list(first)),
            one => one.concat(),
        };
        match (names.is_empty(), forms.is_empty()) {
            (true, _) => format!("must be {forms}"),
            (false, true) => format!("must be one of {}", list(names)),
            (false, false) => format!("must be one of {}, or {forms}", list(names)),
        }
    }

    fn alternatives<'a>(&'a self, schema: &'a Schema, names: &mut Vec<&'a str>, forms: &mut Vec<String>) {
        match self.resolved(schema) {
            Schema::Null => forms.push(NULL.into()),
            Schema::Boolean => forms.extend(["true".into(), "false".into()]),
            Schema::Number(Number { integer, .. }) => {
                forms.push(if *integer { "an integer" } else { "a number" }.into())
            }
            Schema::Text(_) => forms.push("a string".into()),
            Schema::Names(own) => names.extend(own.iter().map(String::as_str)),
            of_points @ Schema::List { .. } => forms.push(form_of_list(self.levels(of_points)).into()),
            Schema::Object(object) => forms.push(object.form()),
            Schema::Tagged { tag, .. } => forms.push(format!("an object with the member {tag}")),
            Schema::Union(branches) => branches.iter().for_each(|branch| self.alternatives(branch, names, forms)),
            // Every value satisfies `Any`, and references were resolved.
            Schema::Any | Schema::Reference(_) => {}
        }
    }
}

impl Number {
    fn violation(&self, value: &serde_json::Number) -> Option<String> {
        let number = value.as_f64()?;
        if self.integer && number.fract() != 0.0 {
            return Some("must be an integer".into());
        }
        let violated = |words: &str, bound: Option<f64>, holds: fn(&f64, &f64) -> bool| {
            bound.filter(|bound| !holds(&number, bound)).map(|bound| format!("must be {words} {}", written(bound)))
        };
        violated("at least", self.at_least, f64::ge)
            .or_else(|| violated("more than", self.more_than, f64::gt))
            .or_else(|| violated("at most", self.at_most, f64::le))
            .or_else(|| violated("less than", self.less_than, f64::lt))
    }
}

/// Returns a number in digits, or with an exponent if it is very large or small.
fn written(number: f64) -> String {
    let plain = number == 0.0 || (1e-4..1e12).contains(&number.abs());
    if plain { number.to_string() } else { format!("{number:e}") }
}

impl Count {
    fn of(least: &str, most: &str, keywords: &mut Map<String, Value>) -> Self {
        let mut bound =
            |keyword: &str| keywords.remove(keyword).and_then(|bound| bound.as_u64()).map(|bound| bound as usize);
        Self { at_least: bound(least).unwrap_or(0), at_most: bound(most).unwrap_or(usize::MAX) }
    }

    fn violation(self, count: usize, noun: &str) -> Option<String> {
        let (words, bound) = match self {
            Self { at_least, at_most } if (at_least..=at_most).contains(&count) => return None,
            Self { at_least, at_most } if at_least == at_most => ("exactly", at_least),
            Self { at_least, .. } if count < at_least => ("at least", at_least),
            Self { at_most, .. } => ("at most", at_most),
        };
        Some(format!("must have {words} {bound} {noun}{}", if bound == 1 { "" } else { "s" }))
    }
}

impl Object {
    fn violation(&self, count: usize) -> Option<String> {
        let plain = self.count.violation(count, "member")?;
        match self.count {
            Count { at_least: 1, at_most } if !self.members.is_empty() && (count == 0 || at_most == 1) => {
                Some(format!("must have {}", self.one_of()))
            }
            _ => Some(plain),
        }
    }

    /// Returns the phrase for an object that needs a member of a group: "exactly" or "at least" one of the names.
    fn one_of(&self) -> String {
        let words = if self.count.at_most == 1 { "exactly" } else { "at least" };
        format!("{words} one of the members {}", list(self.members.keys()))
    }

    fn form(&self) -> String {
        if let Some(example) = &self.example {
            return format!("an object, such as {example}");
        }
        match self.required.as_slice() {
            [] if self.count.at_least == 1 && !self.members.is_empty() => format!("an object with {}", self.one_of()),
            [] => "an object".into(),
            [one] => format!("an object with the member {one}"),
            several => format!("an object with the members {}", list(several)),
        }
    }

    /// Returns the text for a member that the object must not have.
    fn unknown(&self, name: &str) -> String {
        /// Largest number of known members for which the text lists all of them.
        const LISTED: usize = 8;
        // People write edgeLength or edge-length for edge_length.
        let plain = |name: &str| name.replace(['_', '-', ' '], "").to_lowercase();
        let given = plain(name);
        let nearest = self.members.keys().map(|known| (edit_distance(&given, &plain(known)), known)).min();
        match nearest {
            Some((steps, known)) if 3 * steps <= known.len() => {
                format!("is not a member of this object; did you mean {known}?")
            }
            Some(_) if self.members.len() <= LISTED => {
                format!("is not a member of this object, whose members are {}", list(self.members.keys()))
            }
            _ => "is not a member of this object".into(),
        }
    }
}

/// Returns the Levenshtein distance of two texts: the least number of characters to insert, delete or replace in one
/// text to reach the other.
pub fn edit_distance(from: &str, to: &str) -> usize {
    let to: Vec<char> = to.chars().collect();
    let mut row: Vec<usize> = (0..=to.len()).collect();
    for (i, a) in from.chars().enumerate() {
        let mut diagonal = std::mem::replace(&mut row[0], i + 1);
        for (j, b) in to.iter().enumerate() {
            let replaced = diagonal + usize::from(a != *b);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[to.len()]
}

/// Returns the number of levels of arrays around the first number of a value, or `None` if it has no number there.
fn levels(value: &Value) -> Option<usize> {
    match value {
        Value::Array(elements) => Some(1 + levels(elements.first()?)?),
        Value::Number(_) => Some(0),
        _ => None,
    }
}

/// Returns the phrase for a list of points that is nested this many levels deep.
fn form_of_list(levels: usize) -> &'static str {
    match levels {
        0 => "a list",
        1 => "a point or vector [x, y, z], such as [0, 0, 1.5]",
        2 => "a list of points [x, y, z], such as [[0, 0, 0], [4, 0, 1], [4, 3, 0]]",
        _ => "a list of polylines, which are lists of points [x, y, z], such as [[[0, 0, 0], [4, 0, 1], [4, 3, 0]]]",
    }
}

fn list<T: AsRef<str>>(names: impl IntoIterator<Item = T>) -> String {
    let mut text = String::new();
    for name in names {
        text.push_str(if text.is_empty() { "" } else { ", " });
        text.push_str(name.as_ref());
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    /// Returns the errors of a value against a schema, each as one text.
    fn errors(schema: Value, value: Value) -> Vec<String> {
        let source = json!({ "S": schema });
        let schemas = Schemas::new(source.as_object().unwrap());
        schemas.errors("S", &value).into_iter().map(|error| format!("{} {}", error.pointer, error.detail)).collect()
    }

    #[test]
    fn each_violation_of_an_object_has_its_pointer_and_a_phrase() {
        let required = ["name", "units"];
        let schema = json!({ "type": "object", "required": required, "additionalProperties": false, "properties": {
            "a/b~": { "type": "integer", "minimum": -1, "maximum": 1e50 },
            "edge_length": { "type": ["number", "null"], "exclusiveMinimum": 0, "exclusiveMaximum": 180 },
            "name": { "type": "string", "minLength": 1, "maxLength": 3 },
            "pair": { "type": "array", "minItems": 2, "maxItems": 2, "items": { "type": "boolean" } },
            "units": { "type": "string", "enum": ["m", "ft"] },
            "kind": { "anyOf": [{ "type": "string", "const": "net" }, { "type": "null" }] },
        } });
        let found = |value| errors(schema.clone(), value);
        assert_eq!(found(json!({ "name": "äöü", "units": "ft", "edge_length": null, "pair": [true, false] })), [""; 0]);
        assert_eq!(found(json!([])), [" must be an object with the members name, units"]);
        assert_eq!(
            found(json!({ "a/b~": 0.5, "edge_length": 0, "name": "", "pair": [true], "units": "mm", "kind": 1 })),
            [
                "/a~1b~0 must be an integer",
                "/edge_length must be more than 0",
                "/kind must be net",
                "/name must have at least 1 character",
                "/pair must have exactly 2 items",
                "/units must be one of m, ft",
            ]
        );
        assert_eq!(
            found(
                json!({ "a/b~": 1e51, "edge_length": 180, "name": "abcd", "pair": [0, {}], "units": 1, "kind": "Net" })
            ),
            [
                "/a~1b~0 must be at most 1e50",
                "/edge_length must be less than 180",
                "/kind must be net",
                "/name must have at most 3 characters",
                "/pair/0 must be true or false",
                "/pair/1 must be true or false",
                "/units must be one of m, ft",
            ]
        );
        let long = "x".repeat(MAX_NAME + 1);
        assert_eq!(
            found(json!({ "a/b~": -2, "edgeLength": 1, "edge_length": "1", "color": 1, long: 1 })),
            [
                "/a~1b~0 must be at least -1",
                "/color is not a member of this object, whose members are a/b~, edge_length, kind, name, pair, units",
                "/edgeLength is not a member of this object; did you mean edge_length?",
                "/edge_length must be a number",
                " has a member with a very long name that it must not have",
                "/name is required",
                "/units is required",
            ]
        );
    }

    #[test]
    fn the_type_of_the_value_chooses_the_branch_of_a_union() {
        let made = json!({ "type": "string", "enum": ["auto", "disk"] });
        let numbers = json!({ "type": "array", "items": { "type": "number" } });
        let given = json!({ "type": "object", "required": ["vertices"], "properties": { "vertices": numbers } });
        let found = |value| errors(json!({ "anyOf": [made, given, { "type": "boolean" }] }), value);
        for valid in [json!("disk"), json!({ "vertices": [1] }), json!(true)] {
            assert_eq!(found(valid), [""; 0]);
        }
        assert_eq!(found(json!("plane")), [" must be one of auto, disk"]);
        assert_eq!(found(json!({ "vertices": ["x"] })), ["/vertices/0 must be a number"]);
        assert_eq!(found(json!({})), ["/vertices is required"]);
        assert_eq!(
            found(json!(7)),
            [" must be one of auto, disk, or an object with the member vertices, true or false"]
        );
    }

    #[test]
    fn the_discriminator_chooses_among_objects() {
        let of_kind = |kind: &str, field: &str| {
            json!({ "type": "object", "additionalProperties": false, "required": ["kind", field],
                "properties": { "kind": { "enum": [kind] }, field: { "type": "number" } } })
        };
        let schemas = json!({
            "S": { "oneOf": [{ "$ref": "#/s/Net" }, { "$ref": "#/s/Film" }],
                "discriminator": { "propertyName": "kind", "mapping": { "net": "#/s/Net", "film": "#/s/Film" } } },
            "Net": of_kind("net", "force"),
            "Film": of_kind("film", "tension"),
        });
        let schemas = Schemas::new(schemas.as_object().unwrap());
        let found = |value| schemas.errors("S", &value).into_iter().map(|e| (e.pointer, e.detail)).collect::<Vec<_>>();
        let one = |pointer: &str, detail: &str| vec![(pointer.to_owned(), detail.to_owned())];
        assert_eq!(found(json!({ "kind": "film", "tension": 1 })), []);
        assert_eq!(found(json!({ "kind": "film", "tension": "1" })), one("/tension", "must be a number"));
        assert_eq!(found(json!({ "kind": "soap" })), one("/kind", "must be one of film, net"));
        assert_eq!(found(json!({ "kind": 1 })), one("/kind", "must be one of film, net"));
        assert_eq!(found(json!({})), one("/kind", "is required"));
        assert_eq!(found(json!([])), one("", "must be an object with the member kind"));
    }

    #[test]
    fn an_object_with_one_of_several_members_names_them() {
        let one = json!({ "type": "object", "additionalProperties": false, "minProperties": 1, "maxProperties": 1,
            "properties": { "triangles": { "type": "integer" }, "edge_length": { "type": "number" } } });
        let members = "exactly one of the members edge_length, triangles";
        assert_eq!(errors(one.clone(), json!(5)), [format!(" must be an object with {members}")]);
        assert_eq!(errors(one.clone(), json!({})), [format!(" must have {members}")]);
        assert_eq!(
            errors(one.clone(), json!({ "triangles": 1, "edge_length": "x" })).first(),
            Some(&format!(" must have {members}"))
        );
        let misspelt = errors(one, json!({ "triangles": 1, "edgelength": 1 }));
        assert_eq!(misspelt, ["/edgelength is not a member of this object; did you mean edge_length?"]);
    }

    #[test]
    #[should_panic(expected = "pattern")]
    fn a_keyword_that_cannot_be_explained_is_no_part_of_a_schema() {
        errors(json!({ "type": "string", "pattern": "x" }), json!("x"));
    }
}
