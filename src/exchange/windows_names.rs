//! The names that Windows refuses, and its ways to write a path.

use std::path::{Component, Path, PathBuf, Prefix};

/// Returns the reason why Windows does not write to a file with this path, or would write to another one; `None`
/// if there is no such reason in its name.
pub fn refusal(path: &Path) -> Option<String> {
    let mut name = path.file_name().unwrap_or_default().to_string_lossy();
    if let Some(Component::Prefix(prefix)) = path.components().next() {
        let drive = prefix.as_os_str();
        match prefix.kind() {
            // An absolute path to a device's name.
            Prefix::DeviceNS(device) => name = device.to_string_lossy(),
            Prefix::Disk(_) if !Path::new(&format!("{}\\", drive.display())).exists() => {
                return Some(format!("there is no drive {}", drive.display()));
            }
            _ => {}
        }
    }
    if is_device(&name) {
        return Some(format!("{name} is the name of a device of Windows"));
    }
    let is_refused = |c: &char| c.is_ascii_control() || r#"<>:"|?*"#.contains(*c);
    if let Some(letter) = name.chars().find(is_refused) {
        return Some(format!("Windows allows no {letter} in a name"));
    }
    name.ends_with(['.', ' '])
        .then(|| "Windows allows no dot or blank at the end of a name".to_owned())
}

/// Returns true for the names of devices, which end at the first dot, in any case of letters.
fn is_device(name: &str) -> bool {
    let stem = name.split(['.', ':']).next().unwrap_or_default().trim_end().to_lowercase();
    let number = stem.strip_prefix("com").or_else(|| stem.strip_prefix("lpt"));
    ["con", "prn", "aux", "nul", "conin$", "conout$"].contains(&&*stem)
        || number.is_some_and(|number| {
            number.chars().count() == 1
                && number.chars().all(|digit| "0123456789¹²³".contains(digit))
        })
}

/// Returns the path as users and other programs write it, without the mark `\\?\` that Windows puts before a path
/// without links.
pub fn usual(path: PathBuf) -> PathBuf {
    let marked = path.to_str().and_then(|path| path.strip_prefix(r"\\?\"));
    match marked.map(|rest| (rest.strip_prefix(r"UNC\"), rest)) {
        Some((Some(share), _)) => PathBuf::from(format!(r"\\{share}")),
        Some((None, rest)) if rest.as_bytes().get(1) == Some(&b':') => PathBuf::from(rest),
        _ => path,
    }
}
