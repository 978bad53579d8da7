//! The place of PostgreSQL in a build without the feature `postgres`. No value of these types exists, so that the
//! compiler removes what would use one.

use std::sync::Arc;
use std::sync::mpsc::Receiver;

use super::session::Server;
use super::tx::{AfterCommit, Tx};
use super::{Result, StoreError, StoreOptions};

#[derive(Debug)]
pub(super) enum Database {}

impl Database {
    pub(super) async fn open(url: &str, _options: &StoreOptions) -> Result<Self> {
        Server::at(url)?;
        Err(StoreError::Url(String::new()))
    }

    pub(super) async fn write<T>(&self, _work: impl Fn(&mut Tx<'_>) -> Result<T>) -> Result<(T, AfterCommit)> {
        match *self {}
    }

    pub(super) async fn read<T>(&self, _work: impl Fn(&mut Tx<'_>) -> Result<T>) -> Result<T> {
        match *self {}
    }

    pub(super) fn listen(self: &Arc<Self>, _stopped: Receiver<()>, _changed: impl Fn(Option<&str>)) -> Result<()> {
        match **self {}
    }

    pub(super) async fn notify(&self, _payload: String) -> Result<()> {
        match *self {}
    }

    pub(super) async fn close(&self) {
        match *self {}
    }
}
