//! `POST /v1/batches`: many requests at once, each with its `kind`.

use super::envelope::URL_BYTES;
use super::incoming::{CheckedJob, Incoming};
use super::job::{JobKind, Links};
use crate::config::LimitsConfig;
use crate::status::Status;
use plateau_engine::components::{REQUEST_WITH_KIND, reference};
use plateau_engine::kind::Kind;
use plateau_engine::limits::{check_count, may_be_values, refuse_too_many_values, refuse_too_much_as_values};
use plateau_engine::source::Find;
use plateau_strict_json::bounds::Text;
use plateau_strict_json::explain::Schemas;
use plateau_strict_json::json;
use plateau_strict_json::rejection::{FieldError, MAX_ERRORS, Rejection};
use schemars::JsonSchema;
use serde::de::{Deserializer, IgnoredAny, SeqAccess, Visitor};
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;
use serde_json::{Map, Value, json};
use sha2::{Digest, Sha256};
use std::fmt;
use std::sync::LazyLock;

/// Component name of a batch's body.
pub const BATCH: &str = "BatchRequest";

/// A batch's body that passed every check before solving.
#[derive(Debug)]
pub struct BatchRequest {
    pub requests: Vec<CheckedJob>,
    pub callback_url: Option<String>,
    /// Hash of the body. Bodies that mean the same have the same hash.
    pub hash: [u8; 32],
}

/// Number of requests that are looked at in any batch.
const MAX_LISTED: usize = 100_000;

/// A batch's body whose requests have not been read.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Shell<'b> {
    #[serde(borrow)]
    requests: Listed<'b>,
    #[serde(default)]
    callback_url: Option<Text<0, URL_BYTES>>,
}

/// The first [`MAX_LISTED`] requests, and the number of all of them.
struct Listed<'b> {
    items: Vec<&'b RawValue>,
    count: usize,
}

impl<'de: 'b, 'b> Deserialize<'de> for Listed<'b> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Items;
        impl<'de> Visitor<'de> for Items {
            type Value = Listed<'de>;
            fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
                formatter.write_str("a list of requests")
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Listed<'de>, A::Error> {
                let mut items = Vec::new();
                while items.len() < MAX_LISTED
                    && let Some(item) = list.next_element()?
                {
                    items.push(item);
                }
                let mut count = items.len();
                while list.next_element::<IgnoredAny>()?.is_some() {
                    count += 1;
                }
                Ok(Listed { items, count })
            }
        }
        deserializer.deserialize_seq(Items)
    }
}

/// Reads a batch's body without its requests, so that no more than one request is in memory as JSON values.
fn read_shell(body: &[u8]) -> Result<Shell<'_>, Rejection> {
    // serde would read a list as the fields of the struct.
    let is_object = body.trim_ascii_start().first() == Some(&b'{');
    let error = match serde_json::from_slice(body) {
        Ok(shell) if is_object => return Ok(shell),
        Ok(_) => None,
        Err(error) => Some(error),
    };
    if let Some(error) = error.filter(|error| !error.is_data() && !may_be_values(body)) {
        return Err(Rejection::Malformed(error.to_string()));
    }
    refuse_too_much_as_values(body)?;
    refuse_shell(&json::parse(body)?)?;
    Err(FieldError::new("", "must have the form that the schema requires").into())
}

/// Returns the published schema of the body.
pub(super) fn request_schema() -> Value {
    json!({
        "type": "object",
        "description": "Requests of any kinds. Each becomes a separate job.",
        "required": ["requests"],
        "additionalProperties": false,
        "properties": {
            "requests": {
                "type": "array", "minItems": 1, "items": reference(REQUEST_WITH_KIND),
                "description": "Each request names its `kind`. `GET /v1/limits` shows how many requests a batch may \
                 have.",
            },
            "callback_url": {
                "type": ["string", "null"], "maxLength": URL_BYTES,
                "description": "URL (https) that receives a signed POST when every job has ended. Requires webhooks to \
                 be enabled on this server: see `webhooks` of `GET /v1/limits`.",
            },
        },
    })
}

impl BatchRequest {
    /// Reads and checks all requests of a batch.
    ///
    /// # Errors
    /// Returns the errors of [`Incoming::from_value`] for all requests, with pointers from the body's root.
    pub fn read(body: &[u8], find: Find<'_>, limits: &LimitsConfig) -> Result<Self, Rejection> {
        refuse_too_many_values(body, &limits.requests())?;
        let Shell { requests: Listed { items, count }, callback_url } = read_shell(body)?;
        check_count("/requests", count, limits.batch_requests.min(MAX_LISTED), "requests")?;
        if items.is_empty() {
            refuse_shell(&json!({ "requests": [] }))?;
        }
        let mut hash = Sha256::new();
        let (mut requests, mut invalid, mut too_large) = (Vec::with_capacity(items.len()), Vec::new(), Vec::new());
        for (index, item) in items.iter().enumerate() {
            match Incoming::read_naming_kind(item.get().as_bytes(), find, limits) {
                Ok(Incoming { request, envelope, text }) => {
                    // Lengths keep the texts apart.
                    let members = Value::Object(envelope.members.clone()).to_string();
                    for part in [text.as_slice(), members.as_bytes()] {
                        hash.update((part.len() as u64).to_le_bytes());
                        hash.update(part);
                    }
                    requests.push(CheckedJob::of(&request, envelope, text));
                }
                Err(Rejection::Malformed(detail)) => {
                    invalid.push(FieldError::new(format!("/requests/{index}"), detail))
                }
                Err(Rejection::Invalid(errors)) => invalid.extend(within(index, errors)),
                Err(Rejection::TooLarge(errors)) => too_large.extend(within(index, errors)),
            }
            if invalid.len() > MAX_ERRORS {
                break;
            }
        }
        if !invalid.is_empty() {
            // Requests that are too large are named too, because the client corrects both.
            invalid.extend(too_large);
            invalid.truncate(MAX_ERRORS + 1);
            return Err(Rejection::Invalid(invalid));
        }
        if !too_large.is_empty() {
            too_large.truncate(MAX_ERRORS + 1);
            return Err(Rejection::TooLarge(too_large));
        }
        let callback_url = callback_url.as_deref().map(str::to_owned);
        hash.update(callback_url.as_deref().unwrap_or_default());
        Ok(Self { requests, callback_url, hash: hash.finalize().into() })
    }
}

/// Checks the members of a batch's body. The requests in it are not checked here, but one by one.
pub(super) fn refuse_shell(value: &Value) -> Result<(), Rejection> {
    static SHELL: LazyLock<Map<String, Value>> = LazyLock::new(|| {
        let mut shell = request_schema();
        shell["properties"]["requests"]["items"] = json!({});
        Map::from_iter([(BATCH.to_owned(), shell)])
    });
    static SCHEMAS: LazyLock<Schemas> = LazyLock::new(|| Schemas::new(&SHELL));
    let errors = SCHEMAS.errors(BATCH, value);
    if errors.is_empty() { Ok(()) } else { Err(Rejection::Invalid(errors)) }
}

fn within(index: usize, errors: Vec<FieldError>) -> impl Iterator<Item = FieldError> {
    errors.into_iter().map(move |error| FieldError::new(format!("/requests/{index}{}", error.pointer), error.detail))
}

/// Short form of a job of a batch. Its `self` link leads to the full job, which also links to its flat pattern and its
/// certificate.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct BatchJob {
    /// Index of the job's request in the batch, counted from 0.
    pub index: u64,
    pub id: String,
    #[schemars(with = "Kind")]
    pub kind: JobKind,
    pub status: Status,
    pub links: Links,
}

/// Number of jobs of a batch in each state.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub struct BatchCounts {
    pub queued: u64,
    pub running: u64,
    pub succeeded: u64,
    pub failed: u64,
    pub cancelled: u64,
}

/// Addresses that belong to a batch.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct BatchLinks {
    #[serde(rename = "self")]
    pub this: String,
    /// Address of all meshes in one file. Present once every job has ended and one has succeeded.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub meshes: Option<String>,
    /// Address that cancels the jobs of the batch. Present until every job has ended.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cancel: Option<String>,
}

impl BatchLinks {
    /// Returns the links of a batch. `base` is the path that a proxy puts before the paths of this server.
    #[must_use]
    pub fn of(base: &str, id: &str, counts: &BatchCounts) -> Self {
        let this = format!("{base}/v1/batches/{id}");
        let ended = counts.status().is_final();
        Self {
            meshes: (ended && counts.succeeded > 0).then(|| format!("{this}/meshes")),
            cancel: (!ended).then(|| format!("{this}/cancel")),
            this,
        }
    }
}

/// Requests that were submitted together, and the state of their jobs.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Batch {
    /// ULID, which sorts by time of submission.
    pub id: String,
    /// `queued` until the first job starts, then `running` until the last job has ended. The final status is `failed`
    /// if any job has failed, otherwise `cancelled` if any was cancelled, otherwise `succeeded`.
    pub status: Status,
    /// Time of submission (RFC 3339, UTC).
    pub created_at: String,
    /// Time at which the last job ended. Null until then.
    pub finished_at: Option<String>,
    pub counts: BatchCounts,
    /// Jobs in the order of the requests. Jobs that were deleted or have expired are left out.
    pub jobs: Vec<BatchJob>,
    pub links: BatchLinks,
}

impl BatchCounts {
    #[must_use]
    pub fn of(statuses: impl Iterator<Item = Status>) -> Self {
        let mut counts = Self::default();
        for status in statuses {
            *match status {
                Status::Queued => &mut counts.queued,
                Status::Running => &mut counts.running,
                Status::Succeeded => &mut counts.succeeded,
                Status::Failed => &mut counts.failed,
                Status::Cancelled => &mut counts.cancelled,
            } += 1;
        }
        counts
    }

    /// Returns the status of the batch.
    #[must_use]
    pub fn status(&self) -> Status {
        let ended = self.succeeded + self.failed + self.cancelled;
        match self {
            Self { queued: 1.., running: 0, .. } if ended == 0 => Status::Queued,
            Self { queued: 1.., .. } | Self { running: 1.., .. } => Status::Running,
            Self { failed: 1.., .. } => Status::Failed,
            Self { cancelled: 1.., .. } => Status::Cancelled,
            _ => Status::Succeeded,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use plateau_engine::source::no_jobs;

    #[test]
    fn the_status_of_a_batch_follows_from_its_jobs() {
        use Status::{Cancelled, Failed, Queued, Running, Succeeded};
        for (parts, whole) in [
            (&[Queued, Queued][..], Queued),
            (&[Queued, Running], Running),
            (&[Queued, Succeeded], Running),
            (&[Running, Failed], Running),
            (&[Succeeded, Failed, Cancelled], Failed),
            (&[Succeeded, Cancelled], Cancelled),
            (&[Succeeded, Succeeded], Succeeded),
        ] {
            assert_eq!(BatchCounts::of(parts.iter().copied()).status(), whole, "{parts:?}");
        }
    }

    fn read(body: &Value) -> Result<BatchRequest, Rejection> {
        BatchRequest::read(
            body.to_string().as_bytes(),
            &no_jobs,
            &LimitsConfig { batch_requests: 3, ..LimitsConfig::default() },
        )
    }

    fn strip() -> Value {
        json!({ "kind": "ruled_surface", "directrices": [[[0, 0, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, 1]]] })
    }

    #[test]
    fn pointers_lead_from_the_root_to_each_wrong_value() {
        let mut wrong = strip();
        wrong["directrices"][0][1][2] = "x".into();
        let Err(Rejection::Invalid(errors)) =
            read(&json!({ "requests": [strip(), wrong, { "kind": "ruled_surface" }] }))
        else {
            panic!("should be invalid")
        };
        let pointers: Vec<&str> = errors.iter().map(|error| error.pointer.as_str()).collect();
        assert_eq!(pointers, ["/requests/1/directrices/0/1/2", "/requests/2/directrices"]);
    }

    #[test]
    fn what_is_too_large_is_named_beside_what_is_invalid() {
        let limits = LimitsConfig { points: 10, ..LimitsConfig::default() };
        let mut large = strip();
        large["directrices"][0] = (0..11).map(|k| json!([k, 0, 0])).collect();
        let mut invalid = strip();
        invalid["sampling"] = json!({ "by": "chord_height" });
        let body = json!({ "requests": [large, invalid] }).to_string();
        let Err(Rejection::Invalid(errors)) = BatchRequest::read(body.as_bytes(), &no_jobs, &limits) else {
            panic!("invalid")
        };
        let named = |request: &str| errors.iter().any(|error| error.pointer.starts_with(request));
        assert!(named("/requests/0/") && named("/requests/1/"), "{errors:?}");
    }

    #[test]
    fn a_batch_that_is_no_list_of_requests_is_refused() {
        for (body, pointer) in [
            (json!([]), ""),
            (json!({}), "/requests"),
            (json!({ "requests": [] }), "/requests"),
            (json!({ "requests": [1] }), "/requests/0"),
            (json!({ "requests": [{}] }), "/requests/0/kind"),
            (json!({ "requests": [{ "kind": "soap" }] }), "/requests/0/kind"),
            (json!({ "requests": [strip()], "more": 1 }), "/more"),
        ] {
            let Err(Rejection::Invalid(errors)) = read(&body) else { panic!("{body} should be invalid") };
            assert_eq!(errors[0].pointer, pointer, "{body}");
        }
        assert!(matches!(read(&json!({ "requests": vec![strip(); 4] })), Err(Rejection::TooLarge(_))));
        let read = read(&json!({ "requests": vec![strip(); 3], "callback_url": "https://example.org" })).unwrap();
        assert_eq!((read.requests.len(), read.callback_url.as_deref()), (3, Some("https://example.org")));
    }
}
