//! `pinhole trace`

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::Stdio;

use super::{command_in, entries, finished, run_in};

const SCENE: &str = "pinhole = 1\n[camera]\neye = [0, 0, 0]\nview = [0, 0, -1]\nup = [0, 1, 0]\n\
                     [[sphere]]\ncenter = [0, 0, -5]\nradius = 1\n[[plane]]\npoint = [0, 0, -6]\n\
                     normal = [0, 0, 2]\n";
const HEADER: &str = "ox,oy,oz,dx,dy,dz\n";
const ANSWER: &str = "object,t,px,py,pz,nx,ny,nz\n";

fn folder(rays: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("s.toml"), SCENE).unwrap();
    fs::write(folder.path().join("in.csv"), rays).unwrap();
    folder
}

fn trace(folder: &Path, more: &[&str]) -> super::Run {
    run_in(folder, &[&["trace", "s.toml", "--rays", "in.csv"], more].concat())
}

const RAYS: &str =
    "ox,oy,oz,dx,dy,dz\n0,0,0,0,0,-2\n0,0,0,0,0,1\n5,0,0,0.1,0,-1\n0,0,-5,1,0,0\n0,1,0,0,0,-1\n";
const HITS: &str = "object,t,px,py,pz,nx,ny,nz\n\
                    0,2.0,0.0,0.0,-4.0,0.0,0.0,1.0\n\
                    ,,,,,,,\n\
                    1,6.0,5.6,0.0,-6.0,0.0,0.0,1.0\n\
                    0,1.0,1.0,0.0,-5.0,1.0,0.0,0.0\n\
                    0,5.0,0.0,1.0,-5.0,0.0,1.0,0.0\n";

#[test]
fn a_row_a_ray_with_nothing_for_a_miss() {
    let folder = folder(RAYS);
    assert_eq!(trace(folder.path(), &[]).done(), HITS);
    assert_eq!(trace(folder.path(), &["-o", "out.csv"]).done(), "");
    assert_eq!(fs::read_to_string(folder.path().join("out.csv")).unwrap(), HITS);
}

#[test]
fn rays_from_standard_input() {
    let folder = folder("");
    let mut child = command_in(folder.path())
        .args(["trace", "s.toml", "--rays", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(RAYS.as_bytes()).unwrap();
    assert_eq!(finished(child.wait_with_output().unwrap()).done(), HITS);
}

#[test]
fn many_rays_keep_their_order() {
    // More than are traced at a time.
    const COUNT: usize = 70_000;
    let rays = (0..COUNT).map(|k| format!("{k},0,0,0,0,-1\n")).collect::<String>();
    let folder = folder(&format!("{HEADER}{rays}"));
    let answer = trace(folder.path(), &[]).done();
    let rows: Vec<&str> = answer.lines().skip(1).collect();
    assert_eq!(rows.len(), COUNT);
    for (k, row) in rows.iter().enumerate().skip(2) {
        assert_eq!(*row, format!("1,6.0,{k}.0,0.0,-6.0,0.0,0.0,1.0"));
    }
}

/// The ray meets the wall, at a t that no number can hold.
#[test]
fn a_number_beyond_f64_leaves_its_cell_empty() {
    let folder = folder(&format!("{HEADER}0,0,0,0,0,-1e-320\n"));
    let answer = trace(folder.path(), &[]).done();
    let row = answer.lines().nth(1).unwrap();
    assert!(row.starts_with("0,,0.0,0.0,") && !answer.contains("inf"), "{answer}");
}

#[test]
fn a_bad_row_is_named_and_nothing_is_written() {
    let cases = [
        (
            "0,0,0,0,0,-1\n0,0,0,0,0,0\n",
            "in.csv:3:7: column dx is \"0\": the direction (dx, dy, dz) is zero: it must point somewhere",
        ),
        ("0,0,0,nan,0,1\n", "in.csv:2:7: column dx is \"nan\": it must be a finite number"),
        ("0,inf,0,0,0,1\n", "in.csv:2:3: column oy is \"inf\": it must be a finite number"),
        ("0,0,0,0,0,one\n", "in.csv:2:11: column dz is \"one\": it must be a number"),
        ("0,0,0,0,0\n", "in.csv:2:1: the row has 5 cells: it must have 6, as the first line has"),
    ];
    for (rows, message) in cases {
        let folder = folder(&format!("{HEADER}{rows}"));
        trace(folder.path(), &[]).failed(1, message);
        trace(folder.path(), &["-o", "out.csv"]).failed(1, message);
        assert_eq!(entries(folder.path()), ["in.csv", "s.toml"]);
        fs::write(folder.path().join("out.csv"), "old").unwrap();
        trace(folder.path(), &["-o", "out.csv"]).failed(1, message);
        assert_eq!(fs::read_to_string(folder.path().join("out.csv")).unwrap(), "old");
    }
}

#[test]
fn files_that_are_not_what_they_should_be() {
    let empty = folder("");
    trace(empty.path(), &[]).failed(
        1,
        "in.csv:1:1: column ox is missing: the first line must name the columns ox,oy,oz,dx,dy,dz",
    );
    let none = folder(HEADER);
    assert_eq!(trace(none.path(), &[]).done(), ANSWER);
    trace(none.path(), &["-o", "no/out.csv"])
        .failed(1, "no/out.csv: cannot be written: no such file or directory");
    run_in(none.path(), &["trace", "s.toml", "--rays", "no.csv"])
        .failed(1, "no.csv: cannot be read: no such file or directory");
}
