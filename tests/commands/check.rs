//! `pinhole check`

mod codes;
mod folder;
mod judged;
mod written;

use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::path::Path;
use std::process::Stdio;

use expect_test::expect;
use serde_json::{Value, json};

use super::{Run, command_in, entries, finished, run_in};

/// The lecture's sphere, seen by the canonical camera in 40 x 30 pixels.
const SCENE: &str = "pinhole = 1\n[camera]\neye = [0, 0, 0]\nat = [0, 0, -1]\nup = [0, 1, 0]\n\
                     [image]\nwidth = 40\nheight = 30\n[[sphere]]\ncenter = [0, 0, -5]\nradius = 1\n";
const RIGHT_BASIS: &str = "ux,uy,uz,vx,vy,vz,wx,wy,wz\n1,0,0,0,1,0,0,0,1\n";

fn folder(answers: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("s.toml"), SCENE).unwrap();
    fs::write(folder.path().join("in.csv"), answers).unwrap();
    folder
}

fn check(folder: &Path, more: &[&str]) -> Run {
    run_in(folder, &[&["check", "s.toml", "--answers", "in.csv"], more].concat())
}

fn json_of(run: &Run) -> Value {
    assert_eq!(run.stderr, "");
    serde_json::from_str(&run.stdout).unwrap()
}

/// What a student prints who takes the near root, or the far one, and counts from 0 or 1.
fn hits(is_far: bool, count_from: u32) -> String {
    let mut text = String::from("row,column,t\n");
    for i in 0..30 {
        for j in 0..40 {
            let u = (f64::from(j) + 0.5) / 40.0 - 0.5;
            let v = 0.5 - (f64::from(i) + 0.5) / 30.0;
            let (a, b, c) = (u * u + v * v + 1.0, -5.0, 24.0);
            let root = f64::sqrt(b * b - a * c);
            let t = if is_far { (-b + root) / a } else { (-b - root) / a };
            let (i, j) = (i + count_from, j + count_from);
            let t = if t.is_nan() { String::new() } else { format!("{t:.6}") };
            writeln!(text, "{i},{j},{t}").unwrap();
        }
    }
    text
}

#[test]
fn right_answers_are_status_0() {
    let folder = folder(&hits(false, 0));
    let said = check(folder.path(), &[]).done();
    assert_eq!(said, "hits: 1200 of 1200 hits agree, within 0.00001 of their distance\n");
    fs::write(folder.path().join("in.csv"), RIGHT_BASIS).unwrap();
    let said = check(folder.path(), &[]).done();
    assert_eq!(said, "basis: 3 of 3 vectors agree, within 0.00001 in each coordinate\n");
    let rays = "row,column,ox,oy,oz,dx,dy,dz\n0,0,0,0,0,-39,29,-80\n29,39,0,0,0,0.4875,-29e-2,-1\n";
    let rays = rays.replace("-39,29,-80", "-0.4875,0.483333,-1").replace("-29e-2", "-0.483333");
    fs::write(folder.path().join("in.csv"), rays).unwrap();
    check(folder.path(), &[]).done();
}

#[test]
fn wrong_answers_are_status_1_and_their_mistake_is_named() {
    let folder = folder(&hits(true, 0));
    let run = check(folder.path(), &[]);
    assert_eq!((run.status, run.stderr.as_str()), (1, ""));
    let lines: Vec<&str> = run.stdout.lines().collect();
    assert_eq!(lines[0], "hits: 1040 of 1200 hits agree, within 0.00001 of their distance");
    assert!(lines[1].starts_with("worst: row 14, column 19 is t = 5.9"), "{}", lines[1]);
    assert!(lines[1].contains("; right is t = 4.0"), "{}", lines[1]);
    assert_eq!(lines[2], format!("where: {}", ".".repeat(40)));
    assert_eq!(lines[9], format!("       {}{}{}", ".".repeat(12), "#".repeat(16), ".".repeat(12)));
    assert_eq!(
        lines[18..],
        [
            "       # wrong, . right, blank not answered",
            "mistake: far-root",
            "  Look at which root is taken: the smallest t above 0 is the hit, of one object and \
             among all.",
        ]
    );
}

#[test]
fn json_has_the_fields_of_the_contract() {
    let folder = folder(&hits(true, 0));
    let run = check(folder.path(), &["--json"]);
    assert_eq!(run.status, 1);
    let found = json_of(&run);
    let fields: Vec<&str> = found.as_object().unwrap().keys().map(String::as_str).collect();
    for field in ["kind", "answers", "agree", "tolerance", "worst", "mistakes", "advice"] {
        assert!(fields.contains(&field), "{fields:?}");
    }
    assert_eq!(fields.len(), 11, "{fields:?}");
    assert_eq!(found["kind"], "hits");
    assert_eq!((&found["answers"], &found["agree"]), (&json!(1200), &json!(1040)));
    assert_eq!(found["tolerance"], json!(1e-5));
    assert_eq!(found["mistakes"], json!(["far-root"]));
    assert_eq!(found["alternatives"], json!([]));
    assert!(found["advice"].as_str().unwrap().starts_with("Look at which root"));
    let worst = &found["worst"];
    assert_eq!((&worst["row"], &worst["column"]), (&json!(14), &json!(19)));
    let right = worst["right"]["t"].as_f64().unwrap();
    assert!(
        (worst["given"]["t"].as_f64().unwrap() / right - 1.0 - worst["error"].as_f64().unwrap())
            < 1e-9
    );

    fs::write(folder.path().join("in.csv"), RIGHT_BASIS).unwrap();
    let run = check(folder.path(), &["--json"]);
    assert_eq!(run.status, 0);
    let found = json_of(&run);
    assert_eq!(
        (&found["kind"], &found["answers"], &found["agree"]),
        (&json!("basis"), &json!(3), &json!(3))
    );
    assert_eq!((&found["mistakes"], &found["advice"]), (&json!([]), &json!("All answers agree.")));
    assert_eq!((&found["worst"]["vector"], &found["worst"]["error"]), (&json!("u"), &json!(0.0)));

    let backwards = RIGHT_BASIS.replace("1,0,0,0,1,0,0,0,1", "-1,0,0,0,1,0,0,0,-1");
    fs::write(folder.path().join("in.csv"), backwards).unwrap();
    let found = json_of(&check(folder.path(), &["--json"]));
    assert_eq!((&found["agree"], &found["mistakes"]), (&json!(1), &json!(["w-as-printed"])));
    assert_eq!(found["worst"]["right"], json!([1.0, 0.0, 0.0]));
}

#[test]
fn what_nothing_explains_is_said_so() {
    let folder = folder("row,column,t\n14,19,4.7\n0,0,\n");
    let run = check(folder.path(), &[]);
    assert_eq!(run.status, 1);
    assert!(run.stdout.ends_with("mistake: No known mistake explains this.\n"), "{}", run.stdout);
    let found = json_of(&check(folder.path(), &["--json"]));
    assert_eq!((&found["agree"], &found["mistakes"]), (&json!(1), &json!([])));
    // A tolerance of a fifth lets it pass.
    check(folder.path(), &["--tolerance", "0.2"]).done();
}

#[test]
fn what_is_given_and_what_is_right_look_different() {
    let folder = folder(&RIGHT_BASIS.replace(",1\n", ",1.000000002\n"));
    let run = check(folder.path(), &["--tolerance", "1e-12"]);
    assert_eq!(run.status, 1);
    let worst = "worst: w is (0, 0, 1.000000002); right is (0, 0, 1) (off by 2e-9)\n";
    assert!(run.stdout.contains(worst), "{}", run.stdout);
}

#[test]
fn what_was_asked_for_must_be_there() {
    let folder = folder("row,column,t\n0,0,\n");
    let said = check(folder.path(), &["--kind", "hits"]).done();
    assert_eq!(said, "hits: 1 of 1 hits agrees, within 0.00001 of their distance\n");
    let run = check(folder.path(), &["--complete"]);
    assert_eq!(run.status, 1);
    let expected = "hits: 1 of 1200 hits agrees, within 0.00001 of their distance\n\
                    missing: 1199 pixels are not answered\n";
    assert_eq!(run.stdout, expected);
    let found = json_of(&check(folder.path(), &["--complete", "--json"]));
    assert_eq!((&found["agree"], &found["answers"]), (&json!(1), &json!(1200)));
    assert_eq!(found["unanswered"], json!(1199));
    let advice = "All answers that are given agree. 1199 pixels are not answered.";
    assert_eq!(found["advice"], json!(advice));
    fs::write(folder.path().join("in.csv"), hits(false, 0)).unwrap();
    check(folder.path(), &["--complete", "--kind", "hits"]).done();
    fs::write(folder.path().join("in.csv"), RIGHT_BASIS).unwrap();
    check(folder.path(), &["--complete", "--kind", "basis"]).done();
    let asked = ["--columns", "ux,wz"];
    check(folder.path(), &asked).done();
    check(folder.path(), &["--columns", "ux,t"])
        .failed(2, "in.csv: column t is missing: it is asked for");
    check(folder.path(), &["--kind", "hits"])
        .failed(2, "in.csv: these are answers of the kind basis, not hits");
}

#[test]
fn misses_alone_are_a_guess() {
    let misses: String = (0..40).map(|j| format!("14,{j},\n")).collect();
    let folder = folder(&format!("row,column,t\n{misses}"));
    let run = check(folder.path(), &[]);
    assert!(run.stdout.contains("mistake: w-as-printed\n"), "{}", run.stdout);
    assert!(run.stdout.contains("This is a guess: all wrong answers are misses"), "{}", run.stdout);
    let others = "  It may be another mistake, with the same answers here: ";
    assert!(run.stdout.contains(others), "{}", run.stdout);
    let found = json_of(&check(folder.path(), &["--json"]));
    assert!(found["advice"].as_str().unwrap().contains(others.trim()), "{found}");
    assert!(found["alternatives"].as_array().unwrap().contains(&json!(["sign-of-b"])), "{found}");
}

#[test]
fn a_viewport_of_twice_the_size_is_named() {
    let rays = "row,column,ox,oy,oz,dx,dy,dz\n0,0,0,0,0,-0.975,0.966667,-1\n\
                29,39,0,0,0,0.975,-0.966667,-1\n";
    let folder = folder(rays);
    let run = check(folder.path(), &[]);
    assert_eq!(run.status, 1);
    let told = "mistake: viewport-scaled\n  Look at a factor 2 in u and v: across the viewport, u \
                goes from -width/2 to width/2, and v from height/2 to -height/2. Or the distance is twice or \
                half of what it is.\n";
    assert!(run.stdout.ends_with(told), "{}", run.stdout);
    let found = json_of(&check(folder.path(), &["--json"]));
    assert_eq!(found["mistakes"], json!(["viewport-scaled"]));
}

#[test]
fn counted_from_one_is_right_when_said() {
    let folder = folder(&hits(false, 1));
    let run = check(folder.path(), &["--json"]);
    assert_eq!((run.status, &json_of(&run)["mistakes"]), (1, &json!(["counted-from-one"])));
    let found = json_of(&check(folder.path(), &["--json", "--count-from", "1"]));
    assert_eq!(&found["agree"], &json!(1200));
    // One that counts from 0 all the same has no place for its row 0.
    fs::write(folder.path().join("in.csv"), hits(false, 0)).unwrap();
    check(folder.path(), &["--count-from", "1"]).failed(
        2,
        "in.csv:2:1: column row is \"0\": rows are 1 to 30, as the scene's image is 40 x 30, and they are said to count from 1",
    );
}

#[test]
fn counted_from_zero_but_read_from_one_is_told_the_right_way_round() {
    // Without row 0 and column 0, nothing shows at once where they begin.
    let is_inside = |line: &&str| !line.starts_with("0,") && !line.contains(",0,");
    let text = hits(false, 0);
    let inside: Vec<&str> = text.lines().filter(is_inside).collect();
    let folder = folder(&(inside.join("\n") + "\n"));
    assert_eq!(check(folder.path(), &[]).status, 0);
    let run = check(folder.path(), &["--count-from", "1"]);
    assert_eq!(run.status, 1);
    let told = "They were read as counting from 1. They count from 0, and then all agree: leave out \
                --count-from 1";
    assert!(run.stdout.contains(told), "{}", run.stdout);
    assert!(!run.stdout.contains("say --count-from 1"), "{}", run.stdout);
    assert!(!run.stdout.contains("(j - 0.5)/W"), "{}", run.stdout);
    let found = json_of(&check(folder.path(), &["--json", "--count-from", "1"]));
    assert!(found["advice"].as_str().unwrap().starts_with(told), "{found}");
}

#[test]
fn a_map_shows_where() {
    let folder = folder(&hits(true, 0));
    assert_eq!(check(folder.path(), &["--map", "map.png"]).status, 1);
    let file = fs::File::open(folder.path().join("map.png")).unwrap();
    let mut reader = png::Decoder::new(std::io::BufReader::new(file)).read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    assert_eq!((info.width, info.height), (40, 30));
    let wrong = bytes.chunks_exact(3).filter(|pixel| **pixel == [0xd5, 0x5e, 0x00]).count();
    let right = bytes.chunks_exact(3).filter(|pixel| **pixel == [0xdf, 0xe7, 0xee]).count();
    assert_eq!((wrong, right), (160, 1040));
    fs::write(folder.path().join("in.csv"), RIGHT_BASIS).unwrap();
    check(folder.path(), &["--map", "map.png"])
        .failed(2, "--map shows where in the image answers are wrong: a basis has no place there");
    check(folder.path(), &["--map", "map.jpg"])
        .failed(2, "--map writes PNG: not map.jpg but map.png");
}

#[test]
fn large_counts_have_their_digits_in_groups_for_people_and_not_for_programs() {
    let folder = folder("");
    run_in(folder.path(), &["render", "canonical", "-o", "in.png"]).done();
    let check = ["check", "canonical", "--answers", "in.png"];
    let said = run_in(folder.path(), &check).done();
    assert!(said.starts_with("picture: 160,000 of 160,000 pixels agree"), "{said}");
    let json = run_in(folder.path(), &[&check[..], &["--json"]].concat()).done();
    assert!(json.contains("160000") && !json.contains("160,000"), "{json}");
}

#[test]
fn a_picture_is_graded_in_its_own_shading() {
    let folder = folder("");
    for shade in ["lambert", "normal", "t", "object"] {
        run_in(folder.path(), &["render", "s.toml", "-o", "in.png", "--shade", shade]).done();
        let run = run_in(folder.path(), &["check", "s.toml", "--answers", "in.png", "--json"]);
        assert_eq!(run.status, 0);
        let found = json_of(&run);
        assert_eq!((&found["kind"], &found["answers"]), (&json!("picture"), &json!(1200)));
        assert_eq!((&found["shade"], &found["tolerance"]), (&json!(shade), &json!(2.0)));
    }
    run_in(folder.path(), &["render", "s.toml", "-o", "in.png", "--width", "80"]).done();
    run_in(folder.path(), &["check", "s.toml", "--answers", "in.png"]).failed(
        2,
        "in.png: the picture has 80 x 60 pixels: it must have 40 x 30, as the scene's image has",
    );
    run_in(folder.path(), &["render", "s.toml", "-o", "in.png"]).done();
    let picture = fs::read(folder.path().join("in.png")).unwrap();
    let mut damaged = picture.clone();
    damaged[60..80].fill(0xff);
    for (bytes, message) in [
        (&picture[..picture.len() / 2], "the picture ends too early: is all of the file there?"),
        (&b"\x89PNG\r\n\x1a\nno more"[..], "the picture ends too early: is all of the file there?"),
        (&damaged, "the picture is damaged: it must be written again"),
    ] {
        fs::write(folder.path().join("in.png"), bytes).unwrap();
        let run = run_in(folder.path(), &["check", "s.toml", "--answers", "in.png"]);
        assert_eq!(run.status, 2);
        let message = format!("error: in.png: cannot be read as PNG: {message}");
        assert!(run.stderr.starts_with(&message), "{}", run.stderr);
    }
}

#[test]
fn answers_from_standard_input() {
    let folder = folder("");
    let mut child = command_in(folder.path())
        .args(["check", "s.toml", "--answers", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(RIGHT_BASIS.as_bytes()).unwrap();
    assert!(finished(child.wait_with_output().unwrap()).done().starts_with("basis: 3 of 3"));
}

#[test]
fn what_cannot_be_read_is_status_2_and_says_where() {
    let mut told = String::new();
    for (columns, rows) in [
        ("", ""),
        ("i,j,depth", "1,2,3"),
        ("row;column;t", "0;0;1,5"),
        ("row,column,t,object", "3,4,none,0"),
        ("row,column,t,object", "3,4,1e400,"),
        ("row,column,t", "3,4,1e400"),
        ("row,column,t", "3,4,-inf"),
        ("row,column,t,object", ""),
        ("row,column", "1,1"),
        ("row,column,x,y", "1,1,0,0"),
        ("row,column,objct", "1,1,0"),
        ("row,column,ox,oy,oz,dx,dy", ""),
        ("ux,uy,uz,vx,vy,vz,wx,wy,wz", "1,0,0,0,1,0,0,0,1\n1,0,0,0,1,0,0,0,1"),
        ("ux,uy,uz,vx,vy,vz,wx,wy,wz", "1,0,0,0,1,0,0,0,x"),
        ("row,column,ox,oy,oz,dx,dy,dz", "3,4,0,0,0,0,0,0"),
        ("row,column,ox,oy,oz,dx,dy,dz", "3,4,0,0,inf,0,0,1"),
        ("row,column,t,object", "3,4,5,0\n3,5,nan,0"),
        ("row,column,t,object", "3,4,5,"),
        ("row,column,t,object", "3,4,5,0\n3,4,5,0"),
        ("row,column,t,object", "-1,4,,"),
        ("row,column,t,object", "0,4.5,,"),
        ("row,column,t,object", "0,0,,\n30,4,,"),
        ("row,column,t,object", "0,0,,\n3,41,,"),
    ] {
        let folder = folder(format!("{columns}\n{rows}\n").trim_start());
        for more in [&[][..], &["--json", "--map", "m.png"]] {
            let run = check(folder.path(), more);
            assert_eq!((run.status, run.stdout.as_str()), (2, ""));
            let said = run.stderr.replace("error: in.csv", "");
            if more.is_empty() { told += &said } else { assert!(told.ends_with(&said)) }
        }
        assert_eq!(entries(folder.path()), ["in.csv", "s.toml"]);
    }
    expect![[r#"
        : the file is empty: did the program that writes it end well?
        :1:1: the first line is "i,j,depth": it must name the columns ux,uy,uz,vx,vy,vz,wx,wy,wz, or row,column,ox,oy,oz,dx,dy,dz, or row,column with t or x,y,z or object; or the file must be a picture in PNG
        :1:1: the first line has semicolons: commas must stand between cells, and a point in a number
        :2:5: column t is "none": it must be a finite number; a miss leaves its cells empty, or has inf in them
        :2:11: column object is "": a miss leaves all cells behind row and column empty, and a hit none
        :2:5: column t is "1e400": it must be a finite number; a miss leaves its cells empty, or has inf in them
        :2:5: column t is "-inf": it must be a finite number; a miss leaves its cells empty, or has inf in them
        : there is no answer: a row an answer must follow
        :1:1: nothing is answered: there must be a column t, or x,y,z, or object
        :1:1: a point needs all of the columns x,y,z
        :1:12: column "objct" is unknown: did you mean object?
        :1:1: column dz is missing: the first line must name the columns row,column,ox,oy,oz,dx,dy,dz
        :3:1: column ux is "1": a camera has one basis: there must be one row
        :2:17: column wz is "x": it must be a number
        :2:11: column dx is "0": the direction (dx, dy, dz) is zero: it must point somewhere
        :2:9: column oz is "inf": it must be a finite number
        :3:5: column t is "nan": it must be a finite number, as the row's other cells tell of a hit
        :2:7: column object is "": a miss leaves all cells behind row and column empty, and a hit none
        :3:1: column row is "3": this row and column is answered above: once is enough
        :2:1: column row is "-1": it must be a whole number, 0 or more
        :2:3: column column is "4.5": it must be a whole number, 0 or more
        :3:1: column row is "30": rows are 0 to 29, as the scene's image is 40 x 30; are rows and columns exchanged?
        :3:3: column column is "41": columns are 0 to 39, as the scene's image is 40 x 30
    "#]]
    .assert_eq(&told);
    let folder = folder(RIGHT_BASIS);
    run_in(folder.path(), &["check", "s.toml", "--answers", "no.csv"])
        .failed(2, "no.csv: cannot be read: no such file or directory");
}

#[test]
fn a_broken_scene_is_no_wrong_student() {
    let folder = folder(RIGHT_BASIS);
    fs::write(folder.path().join("s.toml"), SCENE.replace("up = [0, 1, 0]", "up = [0, 0, 1]"))
        .unwrap();
    let run = check(folder.path(), &[]);
    assert_eq!((run.status, run.stdout.as_str()), (2, ""));
    assert!(
        run.stderr.contains("s.toml:5:6: camera.up: up (0, 0, 1) is parallel to the view"),
        "{}",
        run.stderr
    );
    let run = run_in(folder.path(), &["check", "no-such", "--answers", "in.csv"]);
    assert_eq!(run.status, 2);
}
