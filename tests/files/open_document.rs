//! The open document: what stays of it and of its comments when it is saved, here and elsewhere.

use std::fs;
use std::path::Path;
use std::sync::Arc;

use pinhole::model::files::OpenDocument;
use pinhole_exchange::document::Document;
use pinhole_exchange::scenes::{BuiltinScene, SceneSource};

const SCENE: &str = "# Many balls.\n\npinhole = 1\nspheres = \"data/balls.csv\" # measured\n\n\
                     [camera] # by hand\neye = [0, 0, 0] # here\nview = [0, 0, -1]\nup = [0, 1, 0]\n";
const STRANGER: &str = "# A stranger.\npinhole = 1\n[camera]\n# not this\neye = [9, 9, 9]\n\
                        view = [0, 0, -1]\nup = [0, 1, 0]\n";

fn open(path: &Path) -> OpenDocument {
    let source = SceneSource::File(path.to_owned());
    OpenDocument::open(source).unwrap()
}

/// A folder with [`SCENE`] as `scene.toml`, and its spheres.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("data")).unwrap();
    fs::write(folder.path().join("data/balls.csv"), "x,y,z,r\n1,2,3,4\n").unwrap();
    fs::write(folder.path().join("scene.toml"), SCENE).unwrap();
    folder
}

#[test]
fn a_step_is_saved_under_its_own_name() {
    let step = OpenDocument::of_step(Document::default(), "Lesson 7, step 3".to_owned());
    assert_eq!(step.file_name(), "lesson-7-step-3.toml");
}

#[test]
fn saving_reads_no_spheres_again() {
    let later: [fn(&Path); 2] =
        [|csv| fs::remove_file(csv).unwrap(), |csv| fs::write(csv, "x,y,z,r\n5,6,7,8\n").unwrap()];
    for meanwhile in later {
        let folder = folder();
        let path = folder.path().join("scene.toml");
        let mut open = open(&path);
        open.document.camera.eye.x = 0.5;
        assert!(open.has_changes());
        let before = open.document.clone();
        meanwhile(&folder.path().join("data/balls.csv"));
        // Under its own name, and beside it in another folder.
        fs::create_dir(folder.path().join("other")).unwrap();
        for (name, reference) in
            [("scene.toml", "data/balls.csv"), ("other/copy.toml", "../data/balls.csv")]
        {
            open.save_to(&folder.path().join(name)).unwrap();
            assert!(!open.has_changes());
            let (old, new) = (before.csv_spheres.as_ref(), open.document.csv_spheres.as_ref());
            let (old, new) = (old.unwrap(), new.unwrap());
            assert!(Arc::ptr_eq(&old.items, &new.items));
            assert_eq!(new.path, reference);
            let text = fs::read_to_string(folder.path().join(name)).unwrap();
            let expected =
                SCENE.replace("data/balls.csv", reference).replace("eye = [0,", "eye = [0.5,");
            assert_eq!(text, expected);
            if name == "scene.toml" {
                assert_eq!(open.document, before);
            }
        }
    }
}

#[test]
fn the_comments_go_along_to_another_name() {
    let folder = folder();
    let mut open = open(&folder.path().join("scene.toml"));
    let (copy, stranger) = (folder.path().join("copy.toml"), folder.path().join("stranger.toml"));
    fs::write(&stranger, STRANGER).unwrap();
    for path in [&copy, &stranger] {
        open.save_to(path).unwrap();
        assert_eq!(fs::read_to_string(path).unwrap(), SCENE);
        assert_eq!(open.scene_file(), Some(path.as_path()));
    }
    // The source is gone, and its comments are not.
    fs::remove_file(&stranger).unwrap();
    open.save_to(&stranger).unwrap();
    assert_eq!(fs::read_to_string(&stranger).unwrap(), SCENE);
}

#[test]
fn a_built_in_scene_takes_its_comments_along() {
    let folder = tempfile::tempdir().unwrap();
    for scene in BuiltinScene::all() {
        let path = folder.path().join(format!("{}.toml", scene.name));
        fs::write(&path, STRANGER).unwrap();
        let mut open = OpenDocument::open(SceneSource::Builtin(scene)).unwrap();
        open.save_to(&path).unwrap();
        let saved = fs::read_to_string(&path).unwrap();
        assert_eq!(saved, scene.text);
    }
}

#[test]
fn comments_written_meanwhile_stay() {
    let folder = folder();
    let path = folder.path().join("scene.toml");
    let mut open = open(&path);
    let edited = SCENE.replace("# here", "# here and now");
    fs::write(&path, &edited).unwrap();
    // The same file by another spelling.
    open.save_to(&folder.path().join("data/../scene.toml")).unwrap();
    assert_eq!(fs::read_to_string(&path).unwrap(), edited);
}

/// `cp -p` and `rsync -t` keep a file's time.
#[test]
fn a_change_of_the_same_length_and_time_is_noticed() {
    let folder = folder();
    let path = folder.path().join("scene.toml");
    let mut open = open(&path);
    assert!(open.touched().is_none() && !open.was_changed_by_others());
    let time = fs::metadata(&path).unwrap().modified().unwrap();
    fs::write(&path, SCENE.replace("eye = [0", "eye = [7")).unwrap();
    fs::File::options().write(true).open(&path).unwrap().set_modified(time).unwrap();
    assert!(open.touched().is_some() && open.was_changed_by_others());
    open.keep_mine();
    assert!(open.touched().is_none() && !open.was_changed_by_others());
    fs::write(&path, SCENE).unwrap();
    assert!(open.was_changed_by_others(), "it is as it was read, but not as it was kept from");
}

#[test]
fn a_scene_whose_file_was_removed_is_not_saved() {
    let folder = folder();
    let path = folder.path().join("scene.toml");
    let mut open = open(&path);
    fs::remove_file(&path).unwrap();
    assert!(open.take_removal() && open.has_changes() && !open.has_edits());
    open.save_to(&path).unwrap();
    assert!(!open.has_changes());
}

/// A large table takes a while to read.
#[test]
fn a_change_while_the_files_are_read_is_noticed() {
    for (changed, theirs) in [
        ("scene.toml", SCENE.replace("eye = [0", "eye = [7")),
        ("data/balls.csv", "x,y,z,r\n5,6,7,8\n".to_owned()),
    ] {
        let folder = folder();
        let at = |name: &str| folder.path().join(name);
        let table = "x,y,z,r\n".to_owned() + &"1,2,3,4\n".repeat(200_000);
        fs::write(at("data/balls.csv"), table).unwrap();
        fs::write(at("theirs"), theirs).unwrap();
        let [from, to] = [at("theirs"), at(changed)];
        let writer = std::thread::spawn(move || {
            std::thread::sleep(std::time::Duration::from_millis(20));
            fs::rename(from, to).unwrap();
        });
        let mut open = open(&at("scene.toml"));
        writer.join().unwrap();
        let is_read = open.document.camera.eye.x == 7.0 || open.document.object_count() == 1;
        assert!(is_read || open.changed_by_others().is_some(), "{changed}");
    }
}

#[test]
fn a_save_that_fails_changes_nothing() {
    let folder = folder();
    let path = folder.path().join("scene.toml");
    let mut open = open(&path);
    open.document.camera.eye.x = 0.5;
    let missing = folder.path().join("no/scene.toml");
    let message = open.save_to(&missing).unwrap_err();
    let expected = format!("{}: cannot be written: no such file or directory", missing.display());
    assert_eq!(message, expected);
    assert!(open.has_changes());
    assert_eq!(open.scene_file(), Some(path.as_path()));
}
