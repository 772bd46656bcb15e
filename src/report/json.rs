//! The report as one JSON object.

use super::model::Report;

/// The object, with a line break behind it. Numbers read back to the same `f64`.
///
/// # Errors
/// None: a report holds nothing that JSON does not.
pub fn to_json(report: &Report) -> serde_json::Result<String> {
    Ok(serde_json::to_string_pretty(report)? + "\n")
}
