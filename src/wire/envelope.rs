//! The fields that every request has because they concern the job and not its result. The service reads them, and
//! `plateau_engine` the rest.

use plateau_engine::components::{allow_null, rewritten};
use plateau_strict_json::bounds::Text;
use plateau_strict_json::explain::Schemas;
use plateau_strict_json::rejection::{FieldError, Rejection};
use plateau_strict_json::strict;
use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde::Deserialize;
use serde_json::{Map, Value};
use std::io::{self, Write};
use std::sync::LazyLock;

/// Whether the result of an equal earlier request may be returned. Results are deterministic, so it has the same bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Cache {
    /// Return a stored result if there is one, and store this one for later requests.
    #[default]
    Reuse,
    /// Solve again, and do not store the result for later requests.
    Bypass,
}

/// Largest length of a `callback_url` in bytes.
pub const URL_BYTES: usize = 2000;

/// Fields that requests of every kind have because they concern the job and not its result.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JobFields {
    /// Whether the stored result of an equal earlier request may be returned.
    #[serde(default)]
    pub cache: Cache,
    /// URL (https) that receives a signed POST when the job ends. Requires webhooks to be enabled on this server: see
    /// `webhooks` of `GET /v1/limits`.
    #[serde(default)]
    pub callback_url: Option<Text<0, URL_BYTES>>,
    /// Name of the job for people. The job and lists of jobs show it.
    #[serde(default)]
    pub label: Option<Text<0, 200>>,
    /// Any fields of the client, at most 4096 bytes as JSON text. The job and lists of jobs show them.
    #[serde(default)]
    pub metadata: Option<Map<String, Value>>,
    /// Key of a series of requests of which only the newest counts, such as those of one drag. Once this request is
    /// accepted, older jobs with the same key that have not ended are cancelled.
    #[serde(default)]
    pub supersede: Option<Text<1, 200>>,
    /// Cancel the job if the client closes the connection while it waits for the end. Requires `Prefer: wait`.
    #[serde(default)]
    pub cancel_on_disconnect: bool,
}

/// Component name of the schema of [`JobFields`].
pub const COMPONENT: &str = "JobFields";

/// Names of the members of [`JobFields`].
pub const MEMBERS: [&str; 6] = ["cache", "callback_url", "label", "metadata", "supersede", "cancel_on_disconnect"];

/// Returns, by name, the schema of [`JobFields`] and the schemas to which it refers.
pub fn schemas() -> Map<String, Value> {
    let mut schemas = rewritten(SchemaSettings::draft2020_12(), |generator| {
        generator.subschema_for::<JobFields>();
    });
    allow_null(&mut schemas);
    schemas
}

/// Members of a request that concern its job.
#[derive(Clone, Debug, Default)]
pub struct Envelope {
    /// Whether the kept result of an equal request may be reused.
    pub cache: Cache,
    /// The URL that receives a message when the job ends.
    pub callback_url: Option<String>,
    pub label: Option<String>,
    /// A JSON object as text.
    pub metadata: Option<String>,
    pub supersede: Option<String>,
    pub cancel_on_disconnect: bool,
    /// The members as they were in the body.
    pub members: Map<String, Value>,
}

/// Largest length of a job's metadata as JSON text in bytes.
const METADATA_BYTES: usize = 4096;

impl Envelope {
    /// Takes the members that concern the job out of a body.
    ///
    /// # Errors
    /// Returns every offending value.
    pub fn take(body: &mut Value) -> Result<Self, Rejection> {
        let Some(body) = body.as_object_mut() else { return Ok(Self::default()) };
        Self::of(MEMBERS.iter().filter_map(|&name| body.remove_entry(name)).collect())
    }

    /// Reads the members that concern the job.
    ///
    /// # Errors
    /// Returns every offending value.
    pub fn of(mut members: Map<String, Value>) -> Result<Self, Rejection> {
        static SOURCES: LazyLock<Map<String, Value>> = LazyLock::new(schemas);
        static SCHEMAS: LazyLock<Schemas> = LazyLock::new(|| Schemas::new(&SOURCES));
        if members.is_empty() {
            return Ok(Self::default());
        }
        let mut errors = Vec::new();
        // Long metadata are not copied, only counted.
        if let Some(metadata @ Value::Object(_)) = members.get_mut("metadata") {
            let bytes = text_length(metadata);
            if bytes > METADATA_BYTES {
                let detail = format!("has {bytes} bytes as JSON text, more than {METADATA_BYTES}");
                errors.push(FieldError::new("/metadata", detail));
                *metadata = Value::Null;
            }
        }
        // A member that is null counts as left out.
        let given = |(name, member): (&String, &Value)| (!member.is_null()).then(|| (name.clone(), member.clone()));
        let value = Value::Object(members.iter().filter_map(given).collect());
        let fields: JobFields = match strict::deserialize(&value) {
            Ok(fields) => fields,
            Err(rejection) => {
                errors.extend(SCHEMAS.errors(COMPONENT, &value));
                return Err(if errors.is_empty() { rejection } else { Rejection::Invalid(errors) });
            }
        };
        let label = fields.label.as_deref().map(str::to_owned);
        let supersede = fields.supersede.as_deref().map(str::to_owned);
        for (pointer, text) in [("/label", &label), ("/supersede", &supersede)] {
            // PostgreSQL cannot store a NUL, and no other control character belongs on one line.
            if text.as_ref().is_some_and(|text| text.chars().any(char::is_control)) {
                errors.push(FieldError::new(pointer, "must not contain control characters"));
            }
        }
        let metadata = fields.metadata.map(|fields| Value::Object(fields).to_string());
        if !errors.is_empty() {
            return Err(Rejection::Invalid(errors));
        }
        Ok(Self {
            cache: fields.cache,
            callback_url: fields.callback_url.as_deref().map(str::to_owned),
            label,
            metadata,
            supersede,
            cancel_on_disconnect: fields.cancel_on_disconnect,
            members,
        })
    }
}

/// Returns the length of a value as JSON text in bytes.
fn text_length(value: &Value) -> usize {
    struct Counter(usize);
    impl Write for Counter {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            self.0 += bytes.len();
            Ok(bytes.len())
        }
        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }
    let mut counter = Counter(0);
    // Writing cannot fail, because the names of an object are strings and the counter takes all bytes.
    let _ = serde_json::to_writer(&mut counter, value);
    counter.0
}
