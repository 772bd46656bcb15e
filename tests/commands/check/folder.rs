//! A folder with the answers of a class, a file for each student.

use super::*;

/// A folder with the scene, and with a class's answers in `class`.
fn class(files: &[(&str, &[u8])]) -> tempfile::TempDir {
    let folder = folder("");
    fs::create_dir(folder.path().join("class")).unwrap();
    for (name, content) in files {
        fs::write(folder.path().join("class").join(name), content).unwrap();
    }
    folder
}

fn graded(folder: &Path, more: &[&str]) -> Run {
    run_in(folder, &[&["check", "s.toml", "--answers", "class"], more].concat())
}

/// A class of every kind: right, wrong by a known mistake, by another or for too few digits, and broken.
fn mixed() -> tempfile::TempDir {
    let far = hits(true, 0);
    let nothing = far.replace("14,19,5.9", "14,19,5.7");
    let rounded = |line: &str| match line.rsplit_once(',') {
        Some((pixel, t)) if t.parse::<f64>().is_ok() => {
            format!("{pixel},{:.2}", t.parse::<f64>().unwrap())
        }
        _ => line.to_owned(),
    };
    let few = hits(false, 0).lines().map(rounded).collect::<Vec<_>>().join("\n");
    let folder = class(&[
        ("zoe.csv", hits(false, 0).as_bytes()),
        ("bob.csv", far.as_bytes()),
        ("ben.csv", far.as_bytes()),
        ("Ada, A.csv", RIGHT_BASIS.as_bytes()),
        ("carl.csv", nothing.as_bytes()),
        ("dora.csv", RIGHT_BASIS.replace("1,0,0,0,1,0,0,0,1", "-1,0,0,0,1,0,0,0,-1").as_bytes()),
        ("few.csv", few.as_bytes()),
        ("latin.csv", b"row,column,t\n1,2,\xe9\n"),
        ("nan.csv", b"row,column,t,object\n14,19,nan,0\n"),
        ("empty.csv", b""),
        ("cut.png", b"\x89PNG\r\n\x1a\nno more"),
        (".hidden.csv", b"no answer"),
    ]);
    fs::create_dir(folder.path().join("class/old")).unwrap();
    folder
}

#[test]
fn each_student_has_a_line_and_the_class_a_table() {
    let folder = mixed();
    let run = graded(folder.path(), &[]);
    assert_eq!(run.status, 1);
    assert_eq!(run.stderr, "note: skipped as hidden or a folder: .hidden.csv, old\n");
    expect![[r#"
        Ada, A  right   basis: 3 of 3
        ben     wrong   hits: 1040 of 1200  far-root
        bob     wrong   hits: 1040 of 1200  far-root
        carl    wrong   hits: 1040 of 1200  another mistake
        cut     broken                      class/cut.png: cannot be read as PNG: the picture ends too early: is all of the file there?
        dora    wrong   basis: 1 of 3       w-as-printed
        empty   broken                      class/empty.csv: the file is empty: did the program that writes it end well?
        few     wrong   hits: 1040 of 1200  too few digits
        latin   broken                      class/latin.csv:2:5: column t is "�": it must be a finite number; a miss leaves its cells empty, or has inf in them
        nan     broken                      class/nan.csv:2:7: column t is "nan": it must be a finite number, as the row's other cells tell of a hit
        zoe     right   hits: 1200 of 1200

        class: 11 files
          right               2  ##
          broken              4  ####
          far-root            2  ##
          another mistake     1  #
          too few digits      1  #
          w-as-printed        1  #
          w-as-printed: Look at w: it points backwards, w = -view/|view| = normalize(eye - at), so that w . view is below 0.
          far-root: Look at which root is taken: the smallest t above 0 is the hit, of one object and among all.
    "#]].assert_eq(&run.stdout);
}

#[test]
fn students_are_told_apart_and_in_the_order_of_a_list_of_names() {
    let folder =
        class(&[("Zoe.csv", b""), ("Bo-Lee.csv", b""), ("anna.csv", b""), ("Bo.csv", b"")]);
    let names = |folder: &Path| {
        let run = graded(folder, &["--csv"]);
        let first = run.stdout.lines().skip(1).map(|line| line.split(',').next().unwrap());
        first.map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(names(folder.path()), ["anna", "Bo", "Bo-Lee", "Zoe"]);
    fs::write(folder.path().join("class/anna.png"), b"").unwrap();
    assert_eq!(names(folder.path()), ["anna.csv", "anna.png", "Bo.csv", "Bo-Lee.csv", "Zoe.csv"]);
}

#[test]
fn a_spreadsheet_reads_the_same_from_csv() {
    let folder = mixed();
    let run = graded(folder.path(), &["--csv"]);
    assert_eq!(run.status, 1);
    expect![[r#"
        name,file,verdict,kind,answers,agree,not_judged,mistakes,advice,problem
        "Ada, A","Ada, A.csv",right,basis,3,3,0,,All answers agree.,
        ben,ben.csv,wrong,hits,1200,1040,0,far-root,"Look at which root is taken: the smallest t above 0 is the hit, of one object and among all.",
        bob,bob.csv,wrong,hits,1200,1040,0,far-root,"Look at which root is taken: the smallest t above 0 is the hit, of one object and among all.",
        carl,carl.csv,wrong,hits,1200,1040,0,,No known mistake explains this.,
        cut,cut.png,broken,,,,,,,class/cut.png: cannot be read as PNG: the picture ends too early: is all of the file there?
        dora,dora.csv,wrong,basis,3,1,0,w-as-printed,"Look at w: it points backwards, w = -view/|view| = normalize(eye - at), so that w . view is below 0.",
        empty,empty.csv,broken,,,,,,,class/empty.csv: the file is empty: did the program that writes it end well?
        few,few.csv,wrong,hits,1200,1040,0,,The answers are right to 3 digits; write at least six.,
        latin,latin.csv,broken,,,,,,,"class/latin.csv:2:5: column t is ""�"": it must be a finite number; a miss leaves its cells empty, or has inf in them"
        nan,nan.csv,broken,,,,,,,"class/nan.csv:2:7: column t is ""nan"": it must be a finite number, as the row's other cells tell of a hit"
        zoe,zoe.csv,right,hits,1200,1200,0,,All answers agree.,
    "#]].assert_eq(&run.stdout);
    let run = run_in(folder.path(), &["check", "s.toml", "--answers", "class/bob.csv", "--csv"]);
    run.failed(2, "--csv has a row for each student: --answers must be a folder");
}

#[test]
fn json_has_what_is_known_of_each_student() {
    let folder = mixed();
    let run = graded(folder.path(), &["--json"]);
    assert_eq!(run.status, 1);
    let found: Value = serde_json::from_str(&run.stdout).unwrap();
    let students = found["students"].as_array().unwrap();
    assert_eq!(students.len(), 11);
    let of = |name: &str| students.iter().find(|student| student["name"] == name).unwrap();
    fs::copy(folder.path().join("class/bob.csv"), folder.path().join("in.csv")).unwrap();
    let mut alone = json_of(&check(folder.path(), &["--json"]));
    alone["name"] = json!("bob");
    alone["file"] = json!("bob.csv");
    alone["verdict"] = json!("wrong");
    assert_eq!(of("bob"), &alone);
    let broken = json!({"name": "empty", "file": "empty.csv", "verdict": "broken", "problem":
        "class/empty.csv: the file is empty: did the program that writes it end well?"});
    assert_eq!(of("empty"), &broken);
    assert_eq!(found["counts"][0], json!(["right", 2]));
    assert!(found["counts"].as_array().unwrap().contains(&json!(["far-root", 2])), "{found}");
    assert!(found["explanations"][0].as_str().unwrap().starts_with("w-as-printed: "), "{found}");
    assert_eq!(found["skipped"], json!([".hidden.csv", "old"]));
}

#[test]
fn the_status_is_that_of_the_worst_file_unless_none_can_be_graded() {
    let right = hits(false, 0);
    let folder = class(&[("amy.csv", right.as_bytes()), ("bo.csv", RIGHT_BASIS.as_bytes())]);
    let said = graded(folder.path(), &[]).done();
    assert_eq!(
        said,
        "amy  right  hits: 1200 of 1200\nbo   right  basis: 3 of 3\n\nclass: 2 files\n  right     2  ##\n"
    );
    // What is asked of one student is asked of each.
    let run = graded(folder.path(), &["--kind", "hits"]);
    assert_eq!(run.status, 1);
    let told = "bo   broken                      class/bo.csv: these are answers of the kind basis, not hits\n";
    assert!(run.stdout.contains(told), "{}", run.stdout);
    let run = graded(folder.path(), &["--kind", "rays"]);
    let told = "error: class: none of its files can be graded\n";
    assert_eq!((run.status, run.stderr.as_str()), (2, told));
    assert!(run.stdout.contains("amy  broken"), "{}", run.stdout);

    fs::write(folder.path().join("class/amy.csv"), "row,column,t\n0,0,\n").unwrap();
    let run = graded(folder.path(), &["--complete"]);
    assert_eq!(run.status, 1);
    assert!(run.stdout.starts_with("amy  not complete  hits: 1 of 1200\n"), "{}", run.stdout);

    graded(folder.path(), &["--map", "m.png"])
        .failed(2, "--map shows one student's answers, and --answers is a folder");
    for name in ["amy.csv", "bo.csv"] {
        fs::remove_file(folder.path().join("class").join(name)).unwrap();
    }
    graded(folder.path(), &[])
        .failed(2, "class: there is no file in it: it must have a file for each student");
    assert_eq!(entries(folder.path()), ["class", "in.csv", "s.toml"]);
}

/// What is no file, or may not be read, is told and stops nothing: not even a pipe that nobody writes.
#[cfg(unix)]
#[test]
fn what_is_no_file_is_a_broken_one() {
    let folder = class(&[("amy.csv", RIGHT_BASIS.as_bytes())]);
    let within = folder.path().join("class");
    let made = std::process::Command::new("mkfifo").arg(within.join("pipe.csv")).status().unwrap();
    assert!(made.success());
    std::os::unix::fs::symlink("nowhere", within.join("link.csv")).unwrap();
    std::os::unix::fs::symlink("amy.csv", within.join("same.csv")).unwrap();
    fs::write(within.join("b\u{1b}[31m.csv"), "").unwrap();
    let run = graded(folder.path(), &[]);
    assert_eq!((run.status, run.stderr.as_str()), (1, ""));
    expect![[r#"
        amy          right   basis: 3 of 3
        b\u{1b}[31m  broken                 class/b\u{1b}[31m.csv: the file is empty: did the program that writes it end well?
        link         broken                 class/link.csv: cannot be read: no such file or directory
        pipe         broken                 class/pipe.csv: cannot be read: it is a device or a pipe, and must be a file
        same         right   basis: 3 of 3

        class: 5 files
          right      2  ##
          broken     3  ###
    "#]].assert_eq(&run.stdout);
}
