//! The name of standard input and output.

use std::path::Path;

/// Returns true for `-`, which stands for standard input or output.
pub(super) fn is_standard(path: &Path) -> bool {
    path == Path::new("-")
}
