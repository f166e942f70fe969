//! The results of requests.

/// A result as JSON, or a message about why there is none.
pub type RequestResult = Result<serde_json::Value, String>;
