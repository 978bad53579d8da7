//! Schemas of the messages of Hops for the API document.

use serde_json::{Map, Value, json};

/// Returns the component schemas by name. Hops demands the capital letters.
#[must_use]
pub fn components() -> Map<String, Value> {
    let reference = |name: &str| json!({ "$ref": format!("#/components/schemas/{name}") });
    let list = |of: Value| json!({ "type": "array", "items": of });
    let text = |description: &str| json!({ "type": "string", "description": description });
    let parameter = json!({
        "description": "An input or output of a component of Hops.",
        "type": "object", "required": ["Name", "ParamType", "AtLeast", "AtMost"],
        "properties": {
            "Name": text("Name in messages."), "Nickname": text("Short name."), "Description": text("Tooltip."),
            "ParamType": text("Name of the parameter's type in Grasshopper."),
            "ResultType": text(".NET type of the values."),
            "AtLeast": { "type": "integer", "description": "Smallest number of values." },
            "AtMost": { "type": "integer", "description": "Largest number of values." },
            "Default": { "description": "Value of an input that is left alone: a number, a boolean or a text." },
        },
    });
    let component = json!({
        "description": "A component of Hops.",
        "type": "object", "required": ["Uri", "Name", "Inputs", "Outputs"],
        "properties": {
            "Uri": text("Path of the component."), "Name": text("Name."), "Nickname": text("Short name."),
            "Description": text("Tooltip."), "Category": text("Category."), "Subcategory": text("Part of the category."),
            "Icon": text("PNG in base64."),
            "Inputs": list(reference("HopsParameter")), "Outputs": list(reference("HopsParameter")),
        },
    });
    let item = json!({
        "description": "A value of an input or output.",
        "type": "object", "required": ["data"],
        "properties": {
            "type": text(".NET type of the value."),
            "data": text("The value as JSON text. Curves and meshes are openNURBS objects."),
        },
    });
    let tree = json!({
        "description": "The values of an input or output.",
        "type": "object", "required": ["ParamName", "InnerTree"],
        "properties": {
            "ParamName": text("Name of the input or output."),
            "InnerTree": {
                "type": "object", "description": "Values by branch, such as `{0}`.",
                "additionalProperties": list(reference("HopsItem")),
            },
        },
    });
    let message = json!({
        "description": "The values of a component's inputs. Hops sends further fields, which are not used.",
        "type": "object", "required": ["pointer", "values"],
        "properties": {
            "pointer": text("Name of the component, or its path or address."),
            "values": list(reference("HopsTree")),
            "absolutetolerance": {
                "type": "number", "description": "Distance up to which the ends of a curve count as equal.",
            },
        },
    });
    let answer = json!({
        "description": "The values of a component's outputs.",
        "type": "object", "required": ["values", "errors", "warnings"],
        "properties": {
            "values": list(reference("HopsTree")),
            "errors": { "type": "array", "items": { "type": "string" }, "description": "Lines that name an input." },
            "warnings": { "type": "array", "items": { "type": "string" }, "description": "Warnings of the job." },
        },
    });
    let named = [
        ("HopsParameter", parameter),
        ("HopsComponent", component),
        ("HopsItem", item),
        ("HopsTree", tree),
        ("HopsMessage", message),
        ("HopsAnswer", answer),
    ];
    named.into_iter().map(|(name, schema)| (name.to_owned(), schema)).collect()
}
