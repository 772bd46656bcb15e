//! The text of a file in which another program keeps a camera.

use std::path::Path;

use super::gltf;
use crate::FileError;

/// The text in a file's bytes: the JSON of a binary glTF, UTF-8, or else Latin-1, of which a note tells.
///
/// # Errors
/// Returns an error if a binary glTF is damaged, or the bytes are no text.
pub fn file_text(path: &Path, bytes: Vec<u8>) -> Result<(String, Option<String>), FileError> {
    if bytes.starts_with(gltf::MAGIC) {
        let json = gltf::json_of(&bytes).map_err(|problem| FileError::of_file(path, problem))?;
        return Ok((json.to_owned(), None));
    }
    let bytes = match String::from_utf8(bytes) {
        Ok(text) => return Ok((text, None)),
        Err(error) => error.into_bytes(),
    };
    // Latin-1 has a letter for every byte; a text has no control characters but blanks.
    if bytes.iter().any(|byte| byte.is_ascii_control() && !byte.is_ascii_whitespace()) {
        return Err(FileError::of_file(path, "not text: a camera is read from text in UTF-8"));
    }
    let note = "it is not UTF-8: read as Latin-1";
    Ok((bytes.into_iter().map(char::from).collect(), Some(note.to_owned())))
}
