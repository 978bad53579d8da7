pub mod export;
pub mod store;
