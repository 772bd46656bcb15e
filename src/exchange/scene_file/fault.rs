//! The position in a scene file of numbers that make no camera.

use std::path::Path;

use pinhole_core::{BasisError, CameraError};

use super::toml;
use crate::fields::{Section, Source};
use crate::{FileError, limits};

/// The error of a file's camera at the position of the field at fault, as
/// `room.toml:5:6: camera.at: eye and at are the same point (1, 2, 3): move one of them`.
///
/// The file is read again: a document, which is edited, knows nothing of places. `None` where the
/// field is not there, be it that the file has changed or that it has the value by default.
pub fn camera_fault(path: &Path, error: &CameraError) -> Option<FileError> {
    let text = limits::read_text(path).ok()?;
    let source = Source { text: &text, path };
    let toml = toml(&source).ok()?;
    let field = field_at_fault(error)?;
    let (tables, key) = field.rsplit_once('.')?;
    let mut section = Section::root(&source, toml.as_table());
    for table in tables.split('.') {
        section = section.get(table)?.section().ok()?;
    }
    Some(section.get(key)?.fault(error))
}

/// The field with its tables, as messages call it.
fn field_at_fault(error: &CameraError) -> Option<String> {
    Some(match error {
        CameraError::Basis(error) => match error {
            BasisError::NotFinite { field, .. } => format!("camera.{field}"),
            BasisError::EyeIsAt { .. } => "camera.at".to_owned(),
            BasisError::ViewIsZero => "camera.view".to_owned(),
            BasisError::UpIsZero | BasisError::UpParallelToView { .. } => "camera.up".to_owned(),
            BasisError::NotUnit { vector, .. } => format!("camera.basis.{vector}"),
            BasisError::NotOrthogonal { .. } | BasisError::LeftHanded => "camera.basis".to_owned(),
            _ => return None,
        },
        CameraError::Viewport(error) => format!("viewport.{}", error.field),
        _ => return None,
    })
}
