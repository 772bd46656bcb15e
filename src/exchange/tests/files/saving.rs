//! Tests of saving over an existing file: what is kept, and what happens if saving fails.

use std::fs;
use std::path::Path;

use pinhole_core::{Basis, DVec3, ImageSize, Orientation, Plane, Sphere};
use pinhole_exchange::document::{Document, Item, StoredObserver};
use pinhole_exchange::{atomic, scene_file, windows_names};

const COMMENTED: &str = r##"# Look at the ball.

# The version stays 1.
pinhole = 1   # format

[camera]      # by at
eye = [ 0, 0.0, 0x0 ]          # integers stay integers
at = [
    0.0,  # x
    0.0,
    -1.0, # z
]
up = [0, 1, 0]

# the first one
[[sphere]]
radius = 1.0     # metres
center = [0, 0, -5]
color = "#E69F00"

# the second one
[[sphere]]
center = [1, 0, -5]
radius = 0.5

# the wall
[[plane]]
point = [0, 0, -6]
normal = [0, 0, 1]
# the end
"##;

fn read(text: &str) -> Document {
    scene_file::parse(text, Path::new("scene.toml"), Path::new("")).unwrap()
}

/// Checks that saving an edited document over [`COMMENTED`] changes only the texts in `changes`, each
/// from the first to the second.
fn check(edit: impl Fn(&mut Document), changes: &[(&str, &str)]) {
    for original in [COMMENTED.to_owned(), COMMENTED.replace('\n', "\r\n")] {
        let returns = |text: &str| {
            if original.contains('\r') { text.replace('\n', "\r\n") } else { text.to_owned() }
        };
        let mut document = read(&original);
        edit(&mut document);
        let mut expected = original.clone();
        for (from, to) in changes {
            let (from, to) = (returns(from), returns(to));
            assert_eq!(expected.matches(&from).count(), 1, "{from}");
            expected = expected.replace(&from, &to);
        }
        assert_eq!(scene_file::to_text(&document, Some(&original)), expected);
        assert_eq!(read(&expected), document);
    }
}

#[test]
fn only_what_has_changed_changes() {
    check(|_| (), &[]);
    check(|d| d.camera.eye.y = 2.5, &[("[ 0, 0.0, 0x0 ]", "[ 0, 2.5, 0x0 ]")]);
    check(|d| d.spheres[0].shape.radius = 3.0, &[("1.0     # metres", "3.0     # metres")]);
    check(|d| d.spheres[0].color = Some([0, 0, 1]), &[("#E69F00", "#000001")]);
    check(|d| d.spheres[0].color = None, &[("color = \"#E69F00\"\n", "")]);
    check(|d| d.planes[0].shape.normal.x = -0.0, &[("normal = [0, 0", "normal = [-0.0, 0")]);
    check(
        |d| d.spheres[1].name = Some("B".to_owned()),
        &[("radius = 0.5\n", "radius = 0.5\nname = \"B\"\n")],
    );
    let at = |d: &mut Document| {
        d.camera.orientation = Orientation::At { at: DVec3::new(0.0, 0.0, -7.5), up: DVec3::Y };
    };
    check(at, &[("-1.0, # z", "-7.5, # z")]);
}

#[test]
fn the_note_is_replaced_at_the_head() {
    check(
        |d| d.note = "Look away.\nNow.".to_owned(),
        &[("# Look at the ball.\n", "# Look away.\n# Now.\n")],
    );
    check(|d| d.note.clear(), &[("# Look at the ball.\n", "")]);
}

#[test]
fn tables_come_and_go() {
    check(
        |d| d.camera.image = ImageSize::new(800, 400).unwrap(),
        &[("up = [0, 1, 0]\n", "up = [0, 1, 0]\n\n[image]\nwidth = 800\n")],
    );
    check(
        |d| drop(d.spheres.remove(0)),
        &[(
            "\n# the first one\n[[sphere]]\nradius = 1.0     # metres\ncenter = [0, 0, -5]\ncolor = \"#E69F00\"\n",
            "",
        )],
    );
    check(
        |d| drop(d.spheres.remove(1)),
        &[("\n# the second one\n[[sphere]]\ncenter = [1, 0, -5]\nradius = 0.5\n", "")],
    );
    let ball = Item::plain(Sphere { center: DVec3::X, radius: 2.0 });
    let text = "\n[[sphere]]\ncenter = [1.0, 0.0, 0.0]\nradius = 2.0\n";
    let behind_first = format!("{text}\n# the second one\n");
    check(|d| d.spheres.insert(1, ball.clone()), &[("\n# the second one\n", &behind_first)]);
    let before_first = format!("{text}\n# the first one\n");
    check(|d| d.spheres.insert(0, ball.clone()), &[("\n# the first one\n", &before_first)]);
    let last = format!("{text}\n# the wall\n");
    check(|d| d.spheres.push(ball.clone()), &[("\n# the wall\n", &last)]);
    check(
        |d| d.planes.push(Item::plain(Plane { point: DVec3::ZERO, normal: DVec3::Y })),
        &[(
            "# the end\n",
            "\n[[plane]]\npoint = [0.0, 0.0, 0.0]\nnormal = [0.0, 1.0, 0.0]\n# the end\n",
        )],
    );
}

#[test]
fn an_observer_is_kept_beside_the_comments_and_forgotten() {
    let target = DVec3::new(0.0, 0.5, -3.0);
    let observer = StoredObserver { target, azimuth: 40.0, elevation: -20.25, distance: 12.0 };
    let table = "\n[observer]\ntarget = [0.0, 0.5, -3.0]\nazimuth = 40.0\nelevation = -20.25\ndistance = 12.0\n";
    let with_table = format!("up = [0, 1, 0]\n{table}");
    check(|d| d.observer = Some(observer), &[("up = [0, 1, 0]\n", &with_table)]);
    let commented = COMMENTED.replace("up = [0, 1, 0]\n", &with_table);
    let mut document = read(&commented);
    assert_eq!(document.observer, Some(observer));
    document.observer = None;
    assert_eq!(scene_file::to_text(&document, Some(&commented)), COMMENTED);
}

#[test]
fn the_camera_can_be_given_in_another_way() {
    check(
        |d| d.camera.orientation = Orientation::Basis(Basis::CANONICAL),
        &[
            ("at = [\n    0.0,  # x\n    0.0,\n    -1.0, # z\n]\n", ""),
            (
                "up = [0, 1, 0]\n",
                "basis = { u = [1.0, 0.0, 0.0], v = [0.0, 1.0, 0.0], w = [0.0, 0.0, 1.0] }\n",
            ),
        ],
    );
}

#[test]
fn a_file_that_is_no_scene_is_replaced() {
    let document = read(COMMENTED);
    let fresh = scene_file::to_text(&document, None);
    for previous in ["", "hello", "pinhole = 2\n", "pinhole = 1\n"] {
        assert_eq!(scene_file::to_text(&document, Some(previous)), fresh);
    }
}

#[test]
fn other_layouts_can_be_edited() {
    let text = "pinhole = 1\ncamera = { eye = [0, 0, 0], view = [0, 0, -1], up = [0, 1, 0] } # c\n\
                sphere = [{ center = [0, 0, -5], radius = 1 }] # s\n";
    let mut document = read(text);
    document.camera.eye.x = 1.5;
    let edited = scene_file::to_text(&document, Some(text));
    assert_eq!(edited, text.replace("{ eye = [0,", "{ eye = [1.5,"));
    document.spheres[0].shape.radius = 2.0;
    let edited = scene_file::to_text(&document, Some(&edited));
    assert_eq!(read(&edited), document);
    assert!(edited.contains("# c\n"), "{edited}");
}

#[test]
fn a_document_that_could_not_be_read_back_is_not_saved() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    fs::write(&path, COMMENTED).unwrap();
    let refused = |edit: &dyn Fn(&mut Document), expected: &str| {
        let mut document = read(COMMENTED);
        edit(&mut document);
        let message = scene_file::save(&document, &path, Some(COMMENTED)).unwrap_err().to_string();
        assert_eq!(message, format!("{}: not saved: {expected}", path.display()));
        assert_eq!(fs::read_to_string(&path).unwrap(), COMMENTED);
    };
    refused(
        &|d| d.spheres[1].shape.radius = -1.0,
        "sphere[1].radius is -1.0: it must be greater than 0",
    );
    refused(
        &|d| d.camera.viewport.distance = f64::NAN,
        "viewport.distance is nan: it must be a finite number",
    );
    refused(
        &|d| d.camera.eye.z = f64::INFINITY,
        "camera.eye[2] is inf: it must be a finite number",
    );
}

fn entries(folder: &Path) -> Vec<String> {
    let names = fs::read_dir(folder).unwrap();
    names.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
}

#[test]
fn a_failing_write_leaves_the_old_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    fs::write(&path, "old").unwrap();
    let error = atomic::write(&path, |file| {
        std::io::Write::write_all(file, b"half of the new")?;
        Err(std::io::Error::from(std::io::ErrorKind::StorageFull))
    });
    let message = error.unwrap_err().to_string();
    assert_eq!(message, format!("{}: cannot be written: no storage space", path.display()));
    assert_eq!(fs::read_to_string(&path).unwrap(), "old");
    assert_eq!(entries(folder.path()), ["scene.toml"]);
}

#[test]
fn of_several_files_all_are_as_before_if_one_cannot_get_its_name() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    fs::write(path("old"), "old").unwrap();
    let mut batch = atomic::Batch::default();
    for name in ["old", "new", "taken"] {
        batch.add(&path(name), |file| std::io::Write::write_all(file, b"new")).unwrap();
    }
    fs::create_dir(path("taken")).unwrap();
    let message = batch.finish().unwrap_err().to_string();
    assert!(message.contains("taken: cannot be written"), "{message}");
    assert_eq!(fs::read_to_string(path("old")).unwrap(), "old");
    let mut left = entries(folder.path());
    left.sort();
    assert_eq!(left, ["old", "taken"]);
}

#[test]
fn a_file_marked_read_only_is_not_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    fs::write(&path, "old").unwrap();
    let mut permissions = fs::metadata(&path).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(&path, permissions).unwrap();
    let message = scene_file::save(&read(COMMENTED), &path, None).unwrap_err().to_string();
    assert_eq!(message, format!("{}: cannot be written: the file is read-only", path.display()));
    assert_eq!(fs::read_to_string(&path).unwrap(), "old");
    assert_eq!(entries(folder.path()), ["scene.toml"]);
}

#[test]
fn a_folder_is_no_file_and_none_is_made() {
    let folder = tempfile::tempdir().unwrap();
    let message =
        |path: &Path| scene_file::save(&read(COMMENTED), path, None).unwrap_err().to_string();
    let missing = folder.path().join("missing").join("scene.toml");
    assert_eq!(
        message(&missing),
        format!("{}: cannot be written: no such file or directory", missing.display())
    );
    assert_eq!(
        message(folder.path()),
        format!("{}: cannot be written: is a directory", folder.path().display())
    );
    assert_eq!(entries(folder.path()), Vec::<String>::new());
}

#[cfg(unix)]
mod unix {
    use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};

    use super::*;

    #[test]
    fn permissions_and_links_stay() {
        let folder = tempfile::tempdir().unwrap();
        let (file, link) = (folder.path().join("file.toml"), folder.path().join("link.toml"));
        fs::write(&file, COMMENTED).unwrap();
        fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
        symlink("file.toml", &link).unwrap();
        let mut document = read(COMMENTED);
        document.camera.eye.y = 2.5;
        scene_file::save(&document, &link, Some(COMMENTED)).unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::metadata(&file).unwrap().mode() & 0o777, 0o640);
        assert_eq!(fs::read_to_string(&file).unwrap(), COMMENTED.replace("0.0, 0x0", "2.5, 0x0"));
    }

    #[test]
    fn a_link_to_nothing_gets_its_file() {
        let folder = tempfile::tempdir().unwrap();
        let link = folder.path().join("link.toml");
        symlink("file.toml", &link).unwrap();
        scene_file::save(&Document::default(), &link, None).unwrap();
        assert!(folder.path().join("file.toml").is_file());
        // Others may read a new file as they may read any other.
        let plain = folder.path().join("plain");
        fs::write(&plain, "").unwrap();
        assert_eq!(fs::metadata(&link).unwrap().mode(), fs::metadata(&plain).unwrap().mode());
    }
}

#[test]
fn names_that_windows_refuses_are_known_everywhere() {
    let device = ["con.toml", "AUX", "nul.tar.gz", "Com1.png", "lpt².csv", "conin$", "prn .toml"];
    let letter = ["one:two.toml", "why?", "a<b", "a>b", "a|b", "st*r", "quo\"te", "tab\t"];
    let end = ["dot.", "blank ", "scene.toml..."];
    let refused = |names: &[&str], reason: &str| {
        for name in names {
            let folder = Path::new("Übung 3").join(name);
            let told = windows_names::refusal(&folder).unwrap_or_default();
            assert!(told.contains(reason), "{name}: {told}");
        }
    };
    refused(&device, "is the name of a device of Windows");
    refused(&letter, "in a name");
    refused(&end, "no dot or blank at the end");
    for name in [
        "scene.toml",
        "contour.toml",
        "com10",
        "com",
        "a.con",
        ".hidden",
        "..",
        "ein Blank.csv",
        "nul²",
    ] {
        assert_eq!(windows_names::refusal(Path::new(name)), None, "{name}");
    }
}

#[test]
fn paths_are_written_as_users_of_windows_write_them() {
    for (path, usual) in [
        (r"\\?\C:\Übung\a.csv", r"C:\Übung\a.csv"),
        (r"\\?\UNC\server\share\a.csv", r"\\server\share\a.csv"),
        (r"\\?\Volume{1}\a.csv", r"\\?\Volume{1}\a.csv"),
        (r"C:\a.csv", r"C:\a.csv"),
        ("/home/a.csv", "/home/a.csv"),
    ] {
        assert_eq!(windows_names::usual(path.into()), Path::new(usual));
    }
}
