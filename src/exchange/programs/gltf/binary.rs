//! Binary glTF: a header of 12 bytes, then chunks, of which the first is the JSON (Khronos, *glTF 2.0
//! Specification*, section 4.4). A camera needs nothing of the others.

use std::str;

/// The bytes with which a binary glTF begins.
pub(in crate::programs) const MAGIC: &[u8] = b"glTF";

/// The JSON of a binary glTF.
///
/// # Errors
/// Returns what is wrong with its header or its first chunk.
pub(in crate::programs) fn json_of(bytes: &[u8]) -> Result<&str, String> {
    let is_cut = |what: &str, has: u32, of: usize| {
        format!("binary glTF: {what} is {has} bytes, and {of} are there: is all of the file there?")
    };
    let Some((header, rest)) = bytes.split_at_checked(20) else {
        return Err(is_cut("the header with that of the JSON", 20, bytes.len()));
    };
    let number = |at: usize| header[at..].first_chunk().map_or(0, |four| u32::from_le_bytes(*four));
    let [version, whole, json] = [4, 8, 12].map(number);
    if version != 2 {
        return Err(format!("binary glTF: the version is {version}: it must be 2"));
    }
    if u64::from(whole) > bytes.len() as u64 {
        return Err(is_cut("the length", whole, bytes.len()));
    }
    let kind = &header[16..];
    if kind != b"JSON" {
        let kind = kind.escape_ascii();
        return Err(format!("binary glTF: the first chunk's type is {kind}: it must be JSON"));
    }
    let chunk = usize::try_from(json).ok().and_then(|length| rest.get(..length));
    let chunk = chunk.ok_or_else(|| is_cut("the JSON", json, rest.len()))?;
    str::from_utf8(chunk).map_err(|_| "binary glTF: the JSON must be UTF-8".to_owned())
}
