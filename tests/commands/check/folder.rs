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
        few,few.csv,wrong,hits,1200,1040,0,,"The answers are right to 3 digits; write at least six.",
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

/// Names with what spreadsheets run, terminals obey and readers do not see; some differ only by that.
#[cfg(unix)]
const HOSTILE: &[&[u8]] = &[
    b"=HYPERLINK(\"http:x\",\"y\")",
    b"'=HYPERLINK(\"http:x\",\"y\")",
    b"=1",
    b"'=1",
    b"''=1",
    b"\"=1",
    b" =1",
    b"+1",
    b"-1",
    b"@SUM(A1)",
    b"\t=1",
    b"\r=1",
    b"\n=1",
    b"\\t=1",
    "\u{ff1d}1".as_bytes(),
    "\u{ff0b}1".as_bytes(),
    "\u{ff0d}1".as_bytes(),
    "\u{ff20}1".as_bytes(),
    b"a;=1",
    b"a;'=1",
    b"a;\"=1\"",
    b"a,=1",
    b"anna",
    b"anna ",
    b"anna\xff",
    b"anna\xfe",
    b"anna\\xff",
    "anna\u{fffd}".as_bytes(),
    "anna\u{202e}vsc".as_bytes(),
    b"anna\\u{202e}vsc",
    b"anna\\\\u{202e}vsc",
    "anna\u{2066}".as_bytes(),
    "anna\u{200b}".as_bytes(),
    "anna\u{feff}".as_bytes(),
    "anna\u{3164}".as_bytes(),
    "anna\u{ad}".as_bytes(),
    "anna\u{e0041}".as_bytes(),
    "anna\u{a0}".as_bytes(),
    b"anna\x1b[31m",
    b"anna\x7f",
    "anna\u{9b}31m".as_bytes(),
    b"anna\nbo",
    b"O'Brien",
    "\u{5c71}\u{7530}".as_bytes(),
    "E\u{301}va".as_bytes(),
];

/// Returns the cells of a CSV text.
#[cfg(unix)]
fn cells(text: &str) -> Vec<Vec<String>> {
    let (mut rows, mut row, mut cell, mut is_quoted) = (vec![], vec![], String::new(), false);
    let mut chars = text.chars().peekable();
    while let Some(c) = chars.next() {
        match c {
            '"' if is_quoted && chars.peek() == Some(&'"') => cell.extend(chars.next()),
            '"' => is_quoted = !is_quoted,
            ',' if !is_quoted => row.push(std::mem::take(&mut cell)),
            '\n' if !is_quoted => {
                row.push(std::mem::take(&mut cell));
                rows.push(std::mem::take(&mut row));
            }
            c => cell.push(c),
        }
    }
    rows
}

#[cfg(unix)]
#[test]
fn no_name_is_a_formula_or_hides_a_part_and_unlike_ones_stay_unlike() {
    use std::collections::BTreeSet;
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt as _;

    let folder = class(&[]);
    for name in HOSTILE {
        let file = [name, &b".csv"[..]].concat();
        fs::write(folder.path().join("class").join(OsStr::from_bytes(&file)), "").unwrap();
    }
    let is_unseen = |c: char| {
        let hidden = "\u{202e}\u{2066}\u{200b}\u{feff}\u{3164}\u{ad}\u{e0041}\u{a0}";
        c.is_control() && c != '\n' || hidden.contains(c)
    };
    let csv = graded(folder.path(), &["--csv"]);
    let rows = cells(&csv.stdout);
    assert_eq!((rows.len(), csv.status), (HOSTILE.len() + 1, 2));
    for row in &rows {
        assert_eq!(row.len(), 10, "{row:?}");
        // Where semicolons separate cells, too, nothing that a spreadsheet runs begins one.
        let parts = row.iter().flat_map(|cell| cell.split(';'));
        for part in parts.map(|part| part.trim_start_matches(['"', ' '])) {
            assert!(!part.starts_with(['=', '+', '-', '@', '\t', '\r', '\n']), "{row:?}");
            assert!(!part.starts_with(['\u{ff1d}', '\u{ff0b}', '\u{ff0d}', '\u{ff20}']), "{row:?}");
        }
    }
    let shown: BTreeSet<&str> = rows[1..].iter().map(|row| &*row[0]).collect();
    assert_eq!(shown.len(), HOSTILE.len(), "{shown:?}");
    for name in [
        "O'Brien",
        "\u{5c71}\u{7530}",
        "E\u{301}va",
        "'=1",
        "''=1",
        "'''=1",
        "a;'=1",
        "a;''=1",
        r"anna\u{202e}vsc",
        r"anna\\u{202e}vsc",
        r"anna\xff",
        r"anna\\xff",
        r"anna\nbo",
        r"anna\u{20}",
    ] {
        assert!(shown.contains(name), "{name} in {shown:?}");
    }

    let json = graded(folder.path(), &["--json"]);
    let found: Value = serde_json::from_str(&json.stdout).unwrap();
    let students = found["students"].as_array().unwrap();
    let names: BTreeSet<&str> = students.iter().map(|own| own["name"].as_str().unwrap()).collect();
    assert_eq!(names.len(), HOSTILE.len(), "{names:?}");
    assert!(names.contains("=1") && !names.iter().any(|name| name.contains('\n')), "{names:?}");
    let text = graded(folder.path(), &[]);
    assert_eq!(text.stdout.lines().take_while(|line| !line.is_empty()).count(), HOSTILE.len());
    for said in [&csv, &json, &text] {
        assert!(!said.stdout.contains(is_unseen), "{:?}", said.stdout);
    }

    fs::create_dir(folder.path().join("class/old\u{202e}")).unwrap();
    let note = "note: skipped as hidden or a folder: old\\u{202e}\n";
    assert!(graded(folder.path(), &["--csv"]).stderr.starts_with(note));
}

#[test]
fn a_long_name_does_not_push_the_class_aside() {
    let name = |middle: &str| format!("{}{middle}{}.csv", "a".repeat(120), "z".repeat(120));
    let (one, other) = (name("b"), name("c"));
    // A short name may look like the one of a long file.
    let alike = format!("{}…{}.csv", "a".repeat(20), "z".repeat(19));
    let folder = class(&[
        (&alike, RIGHT_BASIS.as_bytes()),
        ("bo.csv", RIGHT_BASIS.as_bytes()),
        (&one, RIGHT_BASIS.as_bytes()),
        (&other, RIGHT_BASIS.as_bytes()),
    ]);
    let said = graded(folder.path(), &[]).done();
    let (start, end) = ("a".repeat(20), "z".repeat(19));
    let expected = format!(
        "{start}…2…{end}  right  basis: 3 of 3\n\
         {start}…3…{end}  right  basis: 3 of 3\n\
         {start}…{end}    right  basis: 3 of 3\n\
         bo{}right  basis: 3 of 3\n",
        " ".repeat(42)
    );
    assert!(said.starts_with(&expected), "{said}");
    for format in ["--csv", "--json"] {
        let said = graded(folder.path(), &[format]).done();
        assert!(said.contains(&one) && said.contains(&other), "{said}");
    }
}

/// What a link points at is not for those who read the grades.
#[cfg(unix)]
#[test]
fn a_link_out_of_the_folder_is_not_followed() {
    use std::os::unix::fs::symlink;

    let folder = class(&[("amy.csv", RIGHT_BASIS.as_bytes())]);
    let within = folder.path().join("class");
    fs::write(folder.path().join("secret"), "root:x:0:0\n").unwrap();
    fs::write(folder.path().join("right.csv"), RIGHT_BASIS).unwrap();
    fs::create_dir(within.join("old")).unwrap();
    fs::write(within.join("old/eve.csv"), RIGHT_BASIS).unwrap();
    for (target, link) in [
        ("../secret", "bo.csv"),
        ("bo.csv", "carl.csv"),
        ("/etc/passwd", "dora.csv"),
        ("../right.csv", "fay.csv"),
        ("old/eve.csv", "eve.csv"),
        ("../class/amy.csv", "gus.csv"),
        ("..", "up"),
    ] {
        symlink(target, within.join(link)).unwrap();
    }
    for more in [&[][..], &["--csv"], &["--json"]] {
        let run = graded(folder.path(), more);
        assert_eq!(run.status, 1);
        assert!(!(run.stdout + &run.stderr).contains("root:"), "{more:?}");
    }
    let found: Value = serde_json::from_str(&graded(folder.path(), &["--json"]).stdout).unwrap();
    let told = |name: &str| {
        let students = found["students"].as_array().unwrap();
        let own = students.iter().find(|student| student["name"] == name).unwrap();
        own["problem"].as_str().unwrap_or("none").to_owned()
    };
    let out = |name: &str, target: &str| {
        let target = folder.path().join(target).canonicalize().unwrap();
        let target = target.display();
        format!("class/{name}: it is a link out of the folder, to {target}, which is not followed")
    };
    assert_eq!(told("bo"), out("bo.csv", "secret"));
    assert_eq!(told("carl"), out("carl.csv", "secret"));
    assert_eq!(told("dora"), out("dora.csv", "/etc/passwd"));
    assert_eq!(told("fay"), out("fay.csv", "right.csv"));
    assert_eq!([told("eve"), told("gus")], ["none", "none"]);
    // The folder itself may be given by a link.
    symlink("class", folder.path().join("tuesday")).unwrap();
    let run = run_in(folder.path(), &["check", "s.toml", "--answers", "tuesday"]);
    assert!(run.stdout.contains("\n  right      3  ###\n"), "{}", run.stdout);
}

/// Returns a picture of one bit a pixel, all of them black, with these chunks behind its header.
#[cfg(target_os = "linux")]
fn black([width, height]: [u32; 2], chunks: &[(&[u8; 4], &[u8])]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_depth(png::BitDepth::One);
    encoder.set_compression(png::Compression::Fast);
    let mut writer = encoder.write_header().unwrap();
    for (kind, content) in chunks {
        writer.write_chunk(png::chunk::ChunkType(**kind), content).unwrap();
    }
    writer.write_image_data(&vec![0; (width.div_ceil(8) * height) as usize]).unwrap();
    writer.finish().unwrap();
    bytes
}

/// Grades the class in two gigabytes of memory.
#[cfg(target_os = "linux")]
fn graded_in_2_gb(folder: &Path) -> String {
    let mut shell = std::process::Command::new("sh");
    let script = "ulimit -v 2097152; exec \"$0\" check s.toml --answers class";
    shell.args(["-c", script, env!("CARGO_BIN_EXE_pinhole")]).current_dir(folder);
    let run = finished(shell.env("RAYON_NUM_THREADS", "2").output().unwrap());
    assert_eq!((run.status, &*run.stderr), (1, ""));
    run.stdout
}

#[cfg(target_os = "linux")]
#[test]
fn a_file_that_would_take_all_memory_is_told_and_the_others_are_graded() {
    let huge = black([16_384, 16_384], &[]);
    // The picture's content, 134 MB, stands in a profile and in a text.
    let large = black([32_768, 32_768], &[]);
    let bomb = [b"x\0\0", &large[41..]].concat();
    let bombs = black([40, 30], &[(b"iCCP", &bomb), (b"zTXt", &bomb)]);
    let folder = class(&[
        ("amy.csv", RIGHT_BASIS.as_bytes()),
        ("bo.png", &huge),
        ("carl.png", &huge),
        ("commas.csv", &vec![b','; 15 << 20]),
        ("profile.png", &bombs),
        ("zoe.csv", RIGHT_BASIS.as_bytes()),
    ]);
    for name in ["long.csv", "long.png"] {
        let file = fs::File::create(folder.path().join("class").join(name)).unwrap();
        file.set_len(1 << 30).unwrap();
    }
    expect![[r#"
        amy.csv      right   basis: 3 of 3
        bo.png       broken                      class/bo.png: the picture has 16384 x 16384 pixels: it must have 40 x 30, as the scene's image has
        carl.png     broken                      class/carl.png: the picture has 16384 x 16384 pixels: it must have 40 x 30, as the scene's image has
        commas.csv   broken                      class/commas.csv:1:1: the first line is ",,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,": it must name the columns ux,uy,uz,vx,vy,vz,wx,wy,wz, or row,column,ox,oy,oz,dx,dy,dz, or row,column with t or x,y,z or object; or the file must be a picture in PNG
        long.csv     broken                      class/long.csv: it is too large: at most 16 MiB are read
        long.png     broken                      class/long.png: it is too large: at most 16 MiB are read
        profile.png  wrong   picture: 0 of 1200  another mistake
        zoe.csv      right   basis: 3 of 3

        class: 8 files
          right               2  ##
          broken              5  #####
          another mistake     1  #
    "#]].assert_eq(&graded_in_2_gb(folder.path()));
}

/// A scene may need more memory than there is, of which its small files know nothing.
#[cfg(target_os = "linux")]
#[test]
fn answers_that_take_too_much_memory_are_told_one_by_one() {
    let picture = black([10_000, 10_000], &[]);
    let folder =
        class(&[("amy.csv", RIGHT_BASIS.as_bytes()), ("bo.png", &picture), ("carl.png", &picture)]);
    let scene = SCENE.replace("= 40", "= 10000").replace("= 30", "= 10000");
    fs::write(folder.path().join("s.toml"), scene).unwrap();
    expect![[r#"
        amy   right   basis: 3 of 3
        bo    broken                 class/bo.png: there is too little memory: grading it takes 8000 MB
        carl  broken                 class/carl.png: there is too little memory: grading it takes 8000 MB

        class: 3 files
          right      1  #
          broken     2  ##
    "#]].assert_eq(&graded_in_2_gb(folder.path()));
}
