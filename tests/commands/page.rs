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
