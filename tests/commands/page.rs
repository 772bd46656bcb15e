//! `pinhole page`

use std::fs;
use std::path::Path;

use pinhole_exchange::page::PagePart;

use super::{Run, run_in};

/// A page without the program.
const PAGE: &str =
    "<html><script type=\"application/json\" id=\"part\"></script><p>the program</p></html>";

/// Runs `pinhole page` in a folder that has the page of the program.
fn page(folder: &Path, line: &str) -> Run {
    fs::write(folder.join("pinhole.html"), PAGE).unwrap();
    let line = format!("page {line} --page pinhole.html");
    run_in(folder, &line.split(' ').collect::<Vec<_>>())
}

/// The part of a written page, and the page without it.
fn read(folder: &Path, name: &str) -> (PagePart, String) {
    let page = fs::read_to_string(folder.join(name)).unwrap();
    let begin = page.find('{').unwrap();
    let end = begin + page[begin..].find("</script>").unwrap();
    (PagePart::parse(&page[begin..end]).unwrap(), [&page[..begin], &page[end..]].concat())
}

#[test]
fn a_lesson_is_named_with_its_step() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(page(folder.path(), "--lesson 7.3 -o a.html").done(), "");
    assert_eq!(page(folder.path(), "--lesson 7 --step 3 -o b.html").done(), "");
    let (part, rest) = read(folder.path(), "a.html");
    assert_eq!(part, PagePart { lesson: Some("7.3".to_owned()), ..PagePart::default() });
    assert_eq!(rest, PAGE);
    assert_eq!(read(folder.path(), "b.html").0, part);
    page(folder.path(), "--lesson 7 --step 99 -o c.html").refused("no step 99");
}

#[test]
fn a_scene_goes_into_the_page_with_its_table() {
    let folder = tempfile::tempdir().unwrap();
    let name = "\"</script><script>alert(1)</script>\"";
    let scene = format!(
        "pinhole = 1\nspheres = \"balls/many.csv\"\n[camera]\neye = [0, 0, 0]\nat = [0, 0, -1]\n\
         up = [0, 1, 0]\n[[sphere]]\nname = {name}\ncenter = [0, 0, -5]\nradius = 1\n"
    );
    fs::write(folder.path().join("a.toml"), scene).unwrap();
    fs::create_dir(folder.path().join("balls")).unwrap();
    fs::write(folder.path().join("balls/many.csv"), "x,y,z,r\n0,0,-9,1\n").unwrap();
    page(folder.path(), "a.toml -o a.html").done();
    let (part, rest) = read(folder.path(), "a.html");
    assert_eq!(rest, PAGE, "the name of an object is a text, not a script");
    assert_eq!(part.scene.as_deref(), Some("scene.toml"));
    let there = tempfile::tempdir().unwrap();
    for (name, text) in &part.files {
        fs::write(there.path().join(name), text).unwrap();
    }
    let inspect = |folder, scene| run_in(folder, &["inspect", scene, "--uv", "0,0"]).done();
    assert_eq!(inspect(there.path(), "scene.toml"), inspect(folder.path(), "a.toml"));
}

#[test]
fn a_lesson_of_ones_own_goes_into_the_page_with_its_scenes() {
    let folder = tempfile::tempdir().unwrap();
    let scene = "pinhole = 1\n[camera]\neye = [0, 0, 2]\nat = [0, 0, -1]\nup = [0, 1, 0]\n";
    fs::create_dir(folder.path().join("scenes")).unwrap();
    fs::write(folder.path().join("scenes/far.toml"), scene).unwrap();
    let lesson = "pinhole_lesson = 1\ntitle = \"Mine\"\n[[step]]\ntitle = \"One\"\ntext = \"Look.\"\n\
                  scene = \"scenes/far.toml\"\n[[step]]\ntitle = \"Two\"\ntext = \"Again.\"\n";
    fs::write(folder.path().join("mine.toml"), lesson).unwrap();
    page(folder.path(), "mine.toml --step 2 -o mine.html").done();
    let (part, _) = read(folder.path(), "mine.html");
    assert_eq!((part.lesson.as_deref(), part.step), (Some("mine.toml"), Some(2)));
    assert_eq!(part.files["mine.toml"], lesson);
    assert_eq!(part.files["scenes/far.toml"], scene);
}

#[test]
fn what_cannot_be_written_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    page(folder.path(), "canonical --step 2 -o a.html").refused("--step is for a lesson");
    page(folder.path(), "canonical -o pinhole.html").refused("pinhole.html");
    fs::write(folder.path().join("other.html"), "<html></html>").unwrap();
    let other = ["page", "canonical", "-o", "a.html", "--page", "other.html"];
    let reason = "other.html: not a page of Pinhole: it has no place for a scene";
    run_in(folder.path(), &other).failed(1, reason);
}

const FAR: &str = "pinhole = 1\n[camera]\neye = [0, 0, 2]\nat = [0, 0, -1]\nup = [0, 1, 0]\n";

/// A lesson in a folder of its own, with a step for each of these scenes.
fn lesson(folder: &Path, scenes: &[&str]) {
    let mut text = "pinhole_lesson = 1\ntitle = \"Mine\"\n".to_owned();
    for scene in scenes {
        text += &format!("[[step]]\ntitle = \"A\"\ntext = \"Look.\"\nscene = \"{scene}\"\n");
    }
    fs::create_dir(folder.join("own")).unwrap();
    fs::write(folder.join("own/mine.toml"), text).unwrap();
}

/// In a page, no folder is above the lesson's own.
#[test]
fn scenes_are_found_in_the_page_whatever_way_their_paths_take() {
    let folder = tempfile::tempdir().unwrap();
    lesson(folder.path(), &["./near.toml", "up/../near.toml", "../far/far.toml"]);
    fs::create_dir(folder.path().join("own/up")).unwrap();
    fs::create_dir(folder.path().join("far")).unwrap();
    fs::write(folder.path().join("own/near.toml"), FAR.replace('2', "1")).unwrap();
    let far = FAR.replace("[camera]", "spheres = \"../own/./many.csv\"\n[camera]");
    fs::write(folder.path().join("far/far.toml"), &far).unwrap();
    fs::write(folder.path().join("own/many.csv"), "x,y,z,r\n0,0,-9,1\n").unwrap();
    let run = page(folder.path(), "own/mine.toml -o mine.html");
    let note = "note: own/../far/far.toml is in the page, too: it is outside of the folder of own/mine.toml\n";
    assert_eq!((run.status, &*run.stderr), (0, note));
    let (part, _) = read(folder.path(), "mine.html");
    let names: Vec<&str> = part.files.keys().map(String::as_str).collect();
    assert_eq!(names, ["far/far.toml", "mine.toml", "near.toml", "own/many.csv"]);
    assert_eq!(part.files["far/far.toml"], far);
    // Two files of one name.
    fs::create_dir(folder.path().join("own/far")).unwrap();
    fs::write(folder.path().join("own/far/far.toml"), FAR).unwrap();
    let text = fs::read_to_string(folder.path().join("own/mine.toml")).unwrap();
    let text = text.replace("\"./near.toml", "\"far/far.toml");
    fs::write(folder.path().join("own/mine.toml"), text).unwrap();
    page(folder.path(), "own/mine.toml -o mine.html").failed(
        1,
        "own/far/far.toml: would be far/far.toml in the page, as another file: rename one of them",
    );
}

/// Whoever gets the page gets them.
#[cfg(unix)]
#[test]
fn files_from_outside_of_the_folder_are_told() {
    let (folder, other) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let table = other.path().join("secret.csv");
    fs::write(&table, "x,y,z,r\n0,0,-9,1\n").unwrap();
    std::os::unix::fs::symlink(&table, folder.path().join("link.csv")).unwrap();
    for (name, told) in
        [("link.csv", "link.csv"), (table.to_str().unwrap(), table.to_str().unwrap())]
    {
        let scene = format!("spheres = \"{name}\"\n{FAR}");
        fs::write(folder.path().join("a.toml"), scene).unwrap();
        let run = page(folder.path(), "a.toml -o a.html");
        let note =
            format!("note: {told} is in the page, too: it is outside of the folder of a.toml\n");
        assert_eq!((run.status, &*run.stderr), (0, &*note));
    }
}

#[test]
fn the_scenes_of_a_lesson_are_not_written_over() {
    let folder = tempfile::tempdir().unwrap();
    lesson(folder.path(), &["near.toml"]);
    fs::write(folder.path().join("own/near.toml"), FAR).unwrap();
    page(folder.path(), "own/mine.toml -o own/near.toml").refused("which is read");
    assert_eq!(fs::read_to_string(folder.path().join("own/near.toml")).unwrap(), FAR);
}

#[test]
fn a_missing_table_is_named_with_what_to_do() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.toml"), format!("spheres = \"many.csv\"\n{FAR}")).unwrap();
    page(folder.path(), "a.toml -o a.html").failed(
        1,
        "a.toml:1:11: spheres is \"many.csv\": the table of the scene's spheres must be there, but many.csv: \
         cannot be read: no such file or directory",
    );
}
