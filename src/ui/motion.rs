//! The system's setting for reduced motion.

use std::path::Path;

/// Files below the user's configuration folder, each with the key and value that switch animations
/// off.
const SETTINGS: [(&str, &str, &str); 3] = [
    ("gtk-4.0/settings.ini", "gtk-enable-animations", "false"),
    ("gtk-3.0/settings.ini", "gtk-enable-animations", "false"),
    ("kdeglobals", "AnimationDurationFactor", "0"),
];

/// Returns true if the desktop's settings in this folder switch animations off; false if they do
/// not mention them.
pub(crate) fn is_reduced(folder: &Path) -> bool {
    SETTINGS.iter().any(|(file, key, off)| {
        let text = std::fs::read_to_string(folder.join(file)).unwrap_or_default();
        text.lines().any(|line| {
            let said = line.split_once('=').map(|(key, value)| (key.trim(), value.trim()));
            said.is_some_and(|(said, value)| said == *key && (value == *off || is_zero(off, value)))
        })
    })
}

/// Returns true for GTK's other notation of false, 0.
fn is_zero(off: &str, value: &str) -> bool {
    off == "false" && value == "0"
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test that cannot write its input has failed")]
mod tests {
    use super::*;

    #[test]
    fn either_desktop_can_switch_motion_off() {
        let folder = tempfile::tempdir().unwrap();
        let write = |file: &str, text: &str| {
            let path = folder.path().join(file);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, text).unwrap();
        };
        assert!(!is_reduced(folder.path()));
        write("gtk-3.0/settings.ini", "[Settings]\ngtk-enable-animations=true\n");
        assert!(!is_reduced(folder.path()));
        write("gtk-3.0/settings.ini", "[Settings]\ngtk-enable-animations = 0\n");
        assert!(is_reduced(folder.path()));
        write("gtk-3.0/settings.ini", "");
        write("kdeglobals", "[KDE]\nAnimationDurationFactor=0.5\n");
        assert!(!is_reduced(folder.path()));
        write("kdeglobals", "[KDE]\nAnimationDurationFactor=0\n");
        assert!(is_reduced(folder.path()));
    }
}
