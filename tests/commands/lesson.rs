//! `--lesson`: what is refused before a window opens.

use super::{run, run_in};

#[test]
fn a_lesson_that_is_not_there_is_refused() {
    run("--lesson 14").refused("there is no lesson 14: there are lessons 1 to 13");
    run("--lesson 0").refused("there is no lesson 0: there are lessons 1 to 13");
    run("--lesson 2.9").refused("lesson 2 has no step 9: it has steps 1 to 6");
    run("--lesson first").refused("a number from 1 to 13, or the path of a .toml file");
    run("canonical --lesson 2").refused("cannot be used with '--lesson");
}

#[test]
fn a_lesson_file_that_is_wrong_says_where() {
    let folder = tempfile::tempdir().unwrap();
    run_in(folder.path(), &["--lesson", "gone.toml"])
        .failed(1, "gone.toml: cannot be read: no such file or directory");
    std::fs::write(folder.path().join("mine.toml"), "pinhole_lesson = 1\ntitle = 3\n").unwrap();
    run_in(folder.path(), &["--lesson", "mine.toml"])
        .failed(1, "mine.toml:2:9: title is 3: it must be text in quotes");
}
