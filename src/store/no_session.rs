//! The place of sessions with PostgreSQL in a build without the feature `postgres` (see `no_postgres.rs`).

use std::convert::Infallible;

use super::value::Value;
use super::{Result, StoreError};

#[derive(Debug)]
pub(super) struct Server;

impl Server {
    pub(super) fn at(_url: &str) -> Result<Self> {
        Err(StoreError::Url("this program was built without the feature postgres; use sqlite://PATH".into()))
    }
}

#[derive(Debug)]
pub(super) enum Session {}

impl Session {
    pub(super) fn rows(&mut self, _text: &str, _values: &[Value<'_>]) -> Result<Vec<Row>> {
        match *self {}
    }

    pub(super) fn execute(&mut self, _text: &str, _values: &[Value<'_>]) -> Result<u64> {
        match *self {}
    }

    pub(super) fn script(&mut self, _text: &str) -> Result<()> {
        match *self {}
    }
}

#[derive(Debug)]
pub(super) enum Row {}

impl Row {
    pub(super) fn try_get<T>(&self, _column: &str) -> std::result::Result<T, Infallible> {
        match *self {}
    }
}

pub(super) trait FromSql<'r> {}
impl<T> FromSql<'_> for T {}
