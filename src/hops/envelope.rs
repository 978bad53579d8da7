//! The JSON object around an object's bytes: `{"version", "archive3dm", "opennurbs", "data"}`,
//! where the data is base64. RhinoCommon and rhino3dm write and read it.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use plateau_opennurbs::{Defect, Object, read};
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// Version of the JSON object.
const VERSION: i64 = 10_000;
/// Version of the archive in which the bytes are written: Rhino 6 and later read it.
const ARCHIVE: i64 = 60;
/// First version of archives in which lengths have eight bytes: Rhino 5.
const OLDEST_ARCHIVE: i64 = 50;
/// Version of openNURBS for which the layouts hold (8.x), as rhino3dm writes it. Readers compare it with the versions
/// that had defects.
const OPENNURBS: i64 = -1_869_833_980;

#[derive(Serialize)]
struct Written {
    version: i64,
    archive3dm: i64,
    opennurbs: i64,
    data: String,
}

/// Fields that are needed to read an object. Numbers may come as text.
#[derive(Deserialize)]
struct Received {
    version: Option<Value>,
    archive3dm: Option<Value>,
    data: Option<String>,
}

/// Returns the JSON text with an object's bytes.
#[must_use]
pub fn to_json(object: &[u8]) -> String {
    let written =
        Written { version: VERSION, archive3dm: ARCHIVE, opennurbs: OPENNURBS, data: STANDARD.encode(object) };
    // Serialization cannot fail because there are only numbers and text.
    serde_json::to_string(&written).unwrap_or_default()
}

/// Reads an object from its JSON text.
///
/// # Errors
/// Returns [`Defect::Envelope`] if the text is not such a JSON object, and the errors of [`read::object`].
pub fn from_json(text: &str, max_points: usize) -> Result<Object, Defect> {
    let envelope = |detail: &str| Defect::Envelope(detail.into());
    let received: Received = serde_json::from_str(text)
        .map_err(|_| envelope("expected {\"version\", \"archive3dm\", \"opennurbs\", \"data\"}"))?;
    let number = |value: Option<Value>| match value {
        Some(Value::String(text)) => text.parse::<i64>().ok(),
        value => value.and_then(|value| value.as_i64()),
    };
    if number(received.version) != Some(VERSION) {
        return Err(envelope("its version must be 10000"));
    }
    if number(received.archive3dm).is_none_or(|version| version < OLDEST_ARCHIVE) {
        return Err(envelope("its archive3dm must be at least 50, the version of Rhino 5"));
    }
    let data = received.data.ok_or_else(|| envelope("it has no data"))?;
    let bytes = STANDARD.decode(data).map_err(|_| envelope("its data is not base64"))?;
    read::object(&bytes, max_points)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Objects that rhino3dm has encoded, by group and name.
    fn objects() -> Value {
        serde_json::from_str(include_str!("../../crates/opennurbs/tests/it/objects.json")).unwrap()
    }

    #[test]
    fn every_object_of_rhino3dm_is_that_of_its_bytes_and_is_written_as_rhino3dm_writes_it() {
        for group in ["curves", "meshes"] {
            for (name, fixture) in objects()[group].as_object().unwrap() {
                let object = &fixture["object"];
                let bytes = STANDARD.decode(object["data"].as_str().unwrap()).unwrap();
                let read = from_json(&object.to_string(), 20_000);
                assert!(read.is_ok() && read == read::object(&bytes, 20_000), "{name}: {read:?}");
                let written: Value = serde_json::from_str(&to_json(&bytes)).unwrap();
                assert_eq!(written, *object, "{name}");
            }
        }
    }

    #[test]
    fn the_json_around_an_object_is_checked() {
        let good = objects()["curves"]["line"]["object"].clone();
        let mut as_text = good.clone();
        as_text["version"] = "10000".into();
        as_text["archive3dm"] = "70".into();
        as_text["opennurbs"] = "-1912162672".into();
        assert!(from_json(&as_text.to_string(), 2).is_ok());
        for (field, value, said) in [
            ("version", Value::from(1), "its version must be 10000"),
            ("archive3dm", 4.into(), "its archive3dm must be at least 50"),
            ("data", Value::Null, "it has no data"),
            ("data", "?".into(), "its data is not base64"),
        ] {
            let mut bad = good.clone();
            bad[field] = value;
            let error = from_json(&bad.to_string(), 2).unwrap_err().to_string();
            assert!(error.contains(said), "{error}");
        }
        assert!(from_json("[1]", 2).unwrap_err().to_string().starts_with("is not an openNURBS object"));
    }
}
