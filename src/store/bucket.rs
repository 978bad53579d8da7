//! Large results as objects of an S3-compatible bucket (cargo feature `s3`).

use std::fmt;
use std::sync::Arc;
use std::time::{Duration, SystemTime};

use futures_util::TryStreamExt;
use object_store::aws::AmazonS3Builder;
use object_store::path::Path as ObjectPath;
use object_store::{ObjectStore, ObjectStoreExt, PutPayload, RetryConfig};

use super::{Result, StoreError};

/// Number of retries of a request.
const RETRIES: usize = 3;
/// Time limit of all tries of a request together. It is shorter than a lease, so that the worker learns of a failed
/// write while it still owns the job.
const PATIENCE: Duration = Duration::from_secs(10);

#[derive(Clone)]
pub(super) struct Bucket {
    objects: Arc<dyn ObjectStore>,
    prefix: ObjectPath,
}

// `objects` holds credentials, so it is not shown.
impl fmt::Debug for Bucket {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("Bucket").field("prefix", &self.prefix).finish_non_exhaustive()
    }
}

impl Bucket {
    /// Opens `BUCKET/PREFIX`. Region, endpoint and credentials come from the same environment variables as for every S3
    /// client (`AWS_REGION`, `AWS_ENDPOINT_URL`, `AWS_ACCESS_KEY_ID`, `AWS_SECRET_ACCESS_KEY`) or from the machine's
    /// role.
    pub(super) fn open(location: &str) -> Result<Self> {
        let (name, prefix) = location.split_once('/').unwrap_or((location, ""));
        let unusable = |error: &dyn fmt::Display| StoreError::Url(format!("s3://{location}: {error}"));
        // Installing fails if the process already has a provider, which serves as well.
        let _ = rustls::crypto::ring::default_provider().install_default();
        let retry = RetryConfig { max_retries: RETRIES, retry_timeout: PATIENCE, ..RetryConfig::default() };
        let objects = AmazonS3Builder::from_env().with_bucket_name(name).with_retry(retry).build();
        let objects: Arc<dyn ObjectStore> = Arc::new(objects.map_err(|error| unusable(&error))?);
        Ok(Self { objects, prefix: ObjectPath::parse(prefix).map_err(|error| unusable(&error))? })
    }

    fn path(&self, file: &str) -> ObjectPath {
        self.prefix.clone().join(file)
    }

    pub(super) async fn read(&self, file: &str) -> Result<Option<Vec<u8>>> {
        match self.objects.get(&self.path(file)).await {
            Ok(object) => Ok(Some(object.bytes().await?.into())),
            Err(object_store::Error::NotFound { .. }) => Ok(None),
            Err(error) => Err(error.into()),
        }
    }

    pub(super) async fn write(&self, file: &str, bytes: &[u8]) -> Result<()> {
        self.objects.put(&self.path(file), PutPayload::from(bytes.to_vec())).await?;
        Ok(())
    }

    pub(super) async fn remove(&self, file: &str) -> Result<()> {
        Ok(self.objects.delete(&self.path(file)).await?)
    }

    /// Returns the names of objects that were last written longer ago than `age`. The age of an object is measured by
    /// this machine's clock, so `age` must be longer than the difference between this clock and the bucket's clock.
    pub(super) async fn older_than(&self, age: Duration) -> Result<Vec<String>> {
        let prefix = Some(&self.prefix).filter(|prefix| !prefix.as_ref().is_empty());
        let objects: Vec<_> = self.objects.list(prefix).try_collect().await?;
        let old = objects
            .into_iter()
            .filter(|object| SystemTime::from(object.last_modified).elapsed().unwrap_or_default() >= age);
        // Objects in subfolders do not belong to this store.
        let names = old.filter_map(|object| {
            let name = object.location.filename()?.to_owned();
            (self.path(&name) == object.location).then_some(name)
        });
        Ok(names.collect())
    }
}

impl From<object_store::Error> for StoreError {
    fn from(error: object_store::Error) -> Self {
        Self::Unavailable(format!("the bucket: {error}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[tokio::test]
    async fn objects_can_be_written_read_listed_and_removed() {
        let objects: Arc<dyn ObjectStore> = Arc::new(object_store::memory::InMemory::new());
        for prefix in ["", "results/of-ours"] {
            let bucket = Bucket { objects: objects.clone(), prefix: ObjectPath::parse(prefix).unwrap() };
            bucket.write("one-1", b"mesh").await.unwrap();
            bucket.write("two-1", b"other").await.unwrap();
            // An object in a subfolder belongs to another user of the bucket.
            bucket.objects.put(&bucket.path("else").join("three-1"), PutPayload::from("theirs")).await.unwrap();
            assert_eq!(bucket.read("one-1").await.unwrap().as_deref(), Some(&b"mesh"[..]));
            let mut names = bucket.older_than(Duration::ZERO).await.unwrap();
            names.sort();
            assert_eq!(names, ["one-1", "two-1"], "in {prefix:?}");
            assert!(bucket.older_than(Duration::from_secs(3600)).await.unwrap().is_empty());
            bucket.remove("one-1").await.unwrap();
            assert_eq!(bucket.read("one-1").await.unwrap(), None);
            assert_eq!(bucket.older_than(Duration::ZERO).await.unwrap(), ["two-1"]);
        }
    }

    #[test]
    fn the_debug_form_of_a_bucket_shows_no_credentials() {
        let objects: Arc<dyn ObjectStore> = Arc::new(object_store::memory::InMemory::new());
        let shown = format!("{:?}", Bucket { objects, prefix: ObjectPath::parse("results").unwrap() });
        assert_eq!(shown, "Bucket { prefix: Path { raw: \"results\" }, .. }");
    }
}
