//! Component schemas of requests and statistics, as the API document of the service has them.
//!
//! schemars makes them from the Rust types. They are then rewritten into forms that client generators understand,
//! without a change of meaning: shapes that occur often get names, an enumeration becomes a list of values, and a union
//! whose parts have a tag names that tag.
//!
//! | schemars writes | the document has | because otherwise |
//! | --- | --- | --- |
//! | `default` | `x-default`, and a sentence in the description | clients make the field required or always send it |
//! | `default: null` | nothing | the default of a field without null violates its own type |
//! | `anyOf` | `oneOf` | clients in TypeScript and Java lose the parts of the union |
//! | `oneOf` of `const` | `enum`, with `x-enum-descriptions` | openapi-generator cannot parse a value |
//! | `true` as a schema | `{}` | openapi-python-client writes nothing at all |
//! | formats of unsigned integers | nothing | tools warn about unknown formats; type and minimum say the same |

use crate::kind::Kind;
use schemars::generate::{SchemaGenerator, SchemaSettings};
use schemars::transform::transform_subschemas;
use schemars::{Schema, json_schema};
use serde_json::{Map, Value, json};
use std::borrow::Cow;
use std::sync::LazyLock;

/// Returns the component schemas of requests by name.
#[must_use]
pub fn components() -> &'static Map<String, Value> {
    static COMPONENTS: LazyLock<Map<String, Value>> = LazyLock::new(|| {
        let mut components = rewritten(SchemaSettings::draft2020_12(), requests);
        for shape in &SHAPES {
            components.insert(shape.name.into(), (shape.schema)());
        }
        describe_options(&mut components);
        allow_null(&mut components);
        with_kinds(&mut components);
        components
    });
    &COMPONENTS
}

/// Adds the statistics of every kind to a generator, and returns the union of their schemas with null.
pub fn statistics(generator: &mut SchemaGenerator) -> Schema {
    let of_kinds = Kind::ALL.iter().map(|kind| (kind.types().statistics.reference)(generator).to_value());
    let parts: Vec<Value> = of_kinds.chain([json!({ "type": "null" })]).collect();
    json_schema!({ "oneOf": parts })
}

/// Returns the definitions that `add` adds to a generator, rewritten into the forms of the API document.
pub fn rewritten(settings: SchemaSettings, add: impl FnOnce(&mut SchemaGenerator)) -> Map<String, Value> {
    definitions(settings.with_transform(plain), add)
}

/// Component name of a request with the member `kind`.
pub const REQUEST_WITH_KIND: &str = "RequestWithKind";

/// Returns the component name of a kind's request.
#[must_use]
pub fn request_component(kind: Kind) -> Cow<'static, str> {
    (kind.types().request.name)()
}

/// Returns the component name of a kind's statistics.
#[must_use]
pub fn statistics_component(kind: Kind) -> Cow<'static, str> {
    (kind.types().statistics.name)()
}

/// Returns a reference to a component schema.
#[must_use]
pub fn reference(component: &str) -> Value {
    json!({ "$ref": format!("#/components/schemas/{component}") })
}

/// Adds to the description of each option the choices with which it acts.
fn describe_options(components: &mut Map<String, Value>) {
    for &kind in Kind::ALL {
        let properties = &mut components[&*request_component(kind)]["properties"];
        for option in kind.types().options {
            let member = properties.get_mut(option.name).and_then(Value::as_object_mut);
            if let (Some(keywords), Some(phrase)) = (member, option.phrase(|_| false)) {
                add_text(keywords, &format!(" Only with {phrase}."));
            }
        }
    }
}

/// Keyword of the optional members of requests. Null is among their types only because it counts as left out.
pub const OPTIONAL: &str = "x-optional";

/// Keyword of the optional lists for which the empty list does not count as left out.
pub const EMPTY_IS_REFUSED: &str = "x-empty-is-refused";

/// Allows null, and the empty list, for each optional member of a request, because both count as left out. An object
/// that has exactly one member is no exception to this rule, but its schema does not say so, because JSON Schema counts
/// a null as a member.
pub fn allow_null(components: &mut Map<String, Value>) {
    let described: Map<String, Value> = components
        .iter()
        .filter_map(|(name, schema)| Some((name.clone(), schema.get("description")?.clone())))
        .collect();
    for schema in components.values_mut() {
        let required: Vec<Value> = schema["required"].as_array().cloned().unwrap_or_default();
        let has_one = schema.get("maxProperties").is_some_and(|most| *most == 1);
        let members = schema.get_mut("properties").and_then(Value::as_object_mut);
        for (name, member) in members.into_iter().flatten() {
            let optional = !has_one && !required.iter().any(|required| required == name);
            if let (true, Value::Object(keywords)) = (optional, member) {
                allow_null_in(keywords, &described);
            }
        }
    }
}

fn allow_null_in(keywords: &mut Map<String, Value>, described: &Map<String, Value>) {
    if let Some(reference) = keywords.remove("$ref") {
        let target = reference.as_str().and_then(|path| path.rsplit('/').next()).unwrap_or_default();
        if let (None, Some(text)) = (keywords.get("description"), described.get(target).and_then(Value::as_str)) {
            // The first paragraph says what the target is. The next ones list its values.
            keywords.insert("description".into(), text.split("\n\n").next().unwrap_or_default().into());
        }
        keywords.insert("oneOf".into(), json!([{ "$ref": reference }, { "type": "null" }]));
    } else if let Some(types) = keywords.get_mut("type") {
        if types.is_string() {
            *types = json!([types.take(), "null"]);
        }
        // The smallest number of items above 1 is that of a list that is not left out.
        if keywords.get("minItems").is_some_and(|least| *least == 1) && !keywords.contains_key(EMPTY_IS_REFUSED) {
            keywords.remove("minItems");
        }
    } else {
        return;
    }
    keywords.insert(OPTIONAL.into(), true.into());
}

fn requests(generator: &mut SchemaGenerator) {
    for kind in Kind::ALL {
        (kind.types().request.reference)(generator);
    }
}

fn definitions(settings: SchemaSettings, add: impl FnOnce(&mut SchemaGenerator)) -> Map<String, Value> {
    let mut generator = settings
        .with(|settings| {
            settings.definitions_path = "/components/schemas".into();
            settings.meta_schema = None;
        })
        .into_generator();
    add(&mut generator);
    generator.take_definitions(true)
}

/// Rewrites a schema and every schema inside it, the inner ones first.
fn plain(schema: &mut Schema) {
    // `additionalProperties` may be a boolean instead of a schema. The rewriting must not change it then.
    let others = schema.get("additionalProperties").filter(|others| others.is_boolean()).cloned();
    transform_subschemas(&mut plain, schema);
    if let Some(others) = others {
        schema.insert("additionalProperties".into(), others);
    }
    if schema.as_bool() == Some(true) {
        *schema = json_schema!({});
    }
    let Some(keywords) = schema.as_object_mut() else { return };
    if keywords.get("format").and_then(Value::as_str).is_some_and(|format| format.starts_with("uint")) {
        keywords.remove("format");
        // An integer without a format is one of 32 bits in the clients of Go and Java.
        if !keywords.get("maximum").and_then(Value::as_f64).is_some_and(|maximum| maximum <= f64::from(i32::MAX)) {
            keywords.insert("format".into(), "int64".into());
        }
    }
    if let Some(parts) = keywords.remove("anyOf") {
        keywords.insert("oneOf".into(), parts);
    }
    describe_default(keywords);
    list_values(keywords);
    if let Some(shape) = SHAPES.iter().find(|shape| *keywords == shape.bare()) {
        *schema = Schema::new_ref(format!("#/components/schemas/{}", shape.name));
    }
}

fn describe_default(keywords: &mut Map<String, Value>) {
    let Some(default) = keywords.remove("default").filter(|default| !default.is_null()) else { return };
    let written = default.as_str().map_or_else(|| default.to_string(), str::to_owned);
    add_text(keywords, &format!(" Default: `{written}`."));
    keywords.insert("x-default".into(), default);
}

fn add_text(keywords: &mut Map<String, Value>, text: &str) {
    let description = keywords.get("description").and_then(Value::as_str).unwrap_or_default();
    let description = format!("{description}{text}").trim_start().to_owned();
    keywords.insert("description".into(), description.into());
}

/// Replaces a union of named strings by a list of them. The names' descriptions become part of the description, and of
/// `x-enum-descriptions` in the order of the names.
fn list_values(keywords: &mut Map<String, Value>) {
    let Some(parts) = keywords.get("oneOf").and_then(Value::as_array) else { return };
    let mut values = Vec::new();
    for part in parts {
        let text = part.get("description").and_then(Value::as_str).unwrap_or_default();
        match (part.get("const"), part.get("enum").and_then(Value::as_array)) {
            (Some(value), _) => values.push((value.clone(), text.to_owned())),
            (None, Some(list)) => values.extend(list.iter().map(|value| (value.clone(), text.to_owned()))),
            (None, None) => return,
        }
    }
    if values.iter().any(|(value, _)| !value.is_string()) {
        return;
    }
    let described = values.iter().filter(|(_, text)| !text.is_empty());
    let list: String =
        described.map(|(value, text)| format!("\n- `{}`: {text}", value.as_str().unwrap_or_default())).collect();
    let (values, descriptions): (Vec<Value>, Vec<String>) = values.into_iter().unzip();
    keywords.remove("oneOf");
    keywords.insert("type".into(), "string".into());
    keywords.insert("enum".into(), values.into());
    if !list.is_empty() {
        add_text(keywords, &format!("\n{list}"));
        keywords.insert("x-enum-descriptions".into(), descriptions.into());
    }
}

/// A shape that occurs in many places and has a name in the document.
struct Shape {
    name: &'static str,
    schema: fn() -> Value,
}

/// The named shapes. A shape comes after the shapes that it contains.
const SHAPES: [Shape; 3] = [
    Shape {
        name: "Point",
        schema: || {
            json!({ "type": "array", "items": { "type": "number", "format": "double" }, "minItems": 3, "maxItems": 3,
                "description": "A point or vector `[x, y, z]` in the client's axes and unit." })
        },
    },
    Shape {
        name: "Polyline",
        schema: || {
            json!({ "type": "array", "items": reference("Point"), "minItems": 2,
            "description": "Points in order." })
        },
    },
    Shape {
        name: "Polygon",
        schema: || {
            json!({ "type": "array", "items": reference("Point"), "minItems": 3,
                "description": "The points of a closed polygon in order. The first point is not repeated." })
        },
    },
];

impl Shape {
    /// Returns the schema without its description. In this form the shape occurs inside other schemas until they refer
    /// to it by name.
    fn bare(&self) -> Map<String, Value> {
        let Value::Object(mut keywords) = (self.schema)() else { return Map::new() };
        keywords.remove("description");
        keywords
    }
}

/// Returns the union of one component for each kind. The member `kind` of a value tells which component applies.
#[must_use]
pub fn by_kind(description: &str, component: impl Fn(Kind) -> String) -> Value {
    let path = |kind| format!("#/components/schemas/{}", component(kind));
    let mapping: Map<String, Value> =
        Kind::ALL.iter().map(|&kind| (kind.name().to_owned(), path(kind).into())).collect();
    let references: Vec<Value> = Kind::ALL.iter().map(|&kind| json!({ "$ref": path(kind) })).collect();
    json!({
        "description": description,
        "oneOf": references,
        "discriminator": { "propertyName": "kind", "mapping": mapping },
    })
}

/// Returns the schema of a member `kind` whose only value is this kind.
#[must_use]
pub fn only_kind(kind: Kind) -> Value {
    json!({ "type": "string", "enum": [kind.name()], "description": "Kind of the request." })
}

/// Returns the component name of a kind's request with the member `kind`.
#[must_use]
pub fn with_kind_component(kind: Kind) -> String {
    format!("{}WithKind", request_component(kind))
}

/// Adds a component for each kind's request with a required member `kind`, and the union of these components.
fn with_kinds(components: &mut Map<String, Value>) {
    let name = with_kind_component;
    for &kind in Kind::ALL {
        let mut request = components[&*request_component(kind)].clone();
        request["properties"]["kind"] = only_kind(kind);
        if let Some(required) = request["required"].as_array_mut() {
            required.insert(0, "kind".into());
        }
        components.insert(name(kind), request);
    }
    components.insert(REQUEST_WITH_KIND.into(), by_kind("A request that names its kind.", name));
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plainly(schema: Value) -> Value {
        let mut schema: Schema = schema.try_into().unwrap();
        plain(&mut schema);
        schema.into()
    }

    #[test]
    fn defaults_are_described_and_null_is_no_default() {
        let schema = json!({ "properties": {
            "default": { "type": ["number", "null"], "default": null },
            "up": { "$ref": "#/x", "description": "Axis.", "default": "z" },
            "seed": { "type": "integer", "format": "uint32", "default": 1 },
            "rounds": { "type": "integer", "format": "uint32", "maximum": 50 },
        } });
        let expected = json!({ "properties": {
            "default": { "type": ["number", "null"] },
            "up": { "$ref": "#/x", "description": "Axis. Default: `z`.", "x-default": "z" },
            "seed": { "type": "integer", "format": "int64", "description": "Default: `1`.", "x-default": 1 },
            "rounds": { "type": "integer", "maximum": 50 },
        } });
        assert_eq!(plainly(schema), expected);
    }

    #[test]
    fn a_union_of_names_is_a_list_of_values() {
        let schema = json!({ "description": "Aim.", "oneOf": [
            { "type": "string", "enum": ["a", "b"] }, { "type": "string", "const": "c", "description": "The third." },
        ] });
        let expected = json!({ "type": "string", "enum": ["a", "b", "c"], "description": "Aim.\n\n- `c`: The third.",
            "x-enum-descriptions": ["", "", "The third."] });
        assert_eq!(plainly(schema), expected);
        let mixed = json!({ "oneOf": [{ "const": "a" }, { "type": "object" }] });
        assert_eq!(plainly(mixed.clone()), mixed);
    }

    #[test]
    fn points_and_polygons_have_names() {
        let point =
            json!({ "type": "array", "items": { "type": "number", "format": "double" }, "minItems": 3, "maxItems": 3 });
        let polygons = json!({ "type": "array", "items": { "type": "array", "items": point, "minItems": 3 } });
        assert_eq!(plainly(polygons), json!({ "type": "array", "items": reference("Polygon") }));
        assert_eq!(plainly(json!({ "type": "array", "items": true })), json!({ "type": "array", "items": {} }));
    }
}
