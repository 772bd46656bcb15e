//! Numbers and misses as they are written.

use super::*;

#[test]
fn digits_that_say_nothing_are_wrong() {
    let basis = "ux,uy,uz,vx,vy,vz,wx,wy,wz\n";
    let zero = ["0.000000e300"; 9].join(",");
    let rays = "row,column,ox,oy,oz,dx,dy,dz\n3,4,0,0,0,";
    for answers in [
        format!("{basis}{zero}\n"),
        format!("{rays}0.000000e300,0.000000e300,-1\n"),
        format!("{rays}0.000000,0.000000,-0.000001\n"),
        "row,column,t\n14,19,0.000000e300\n".to_owned(),
        "row,column,t\n14,19,0.0000000e8\n".to_owned(),
        "row,column,x,y,z\n14,19,0.0000000e8,0.0000000e8,0.0000000e8\n".to_owned(),
    ] {
        let folder = folder(&answers);
        assert_eq!(check(folder.path(), &[]).status, 1, "{answers}");
    }
}

#[test]
fn right_answers_of_few_digits_are_told_so() {
    let few: String = hits(false, 0)
        .lines()
        .map(|line| match line.rsplit_once(',') {
            Some((pixel, t)) if t.len() > 4 => format!("{pixel},{}\n", &t[..4]),
            _ => format!("{line}\n"),
        })
        .collect();
    // Cut off after the digit in place of rounded: off by more than half a unit, and so not right.
    let folder = folder(&few);
    assert!(check(folder.path(), &[]).stdout.ends_with("No known mistake explains this.\n"));
    fs::write(folder.path().join("in.csv"), "row,column,t\n14,19,4.003\n0,0,\n").unwrap();
    let run = check(folder.path(), &[]);
    let lines: Vec<&str> = run.stdout.lines().collect();
    assert_eq!((run.status, lines.len()), (1, 3), "{lines:?}");
    assert_eq!(lines[0], "hits: 1 of 2 hits agrees, within 0.00001 of their distance");
    assert_eq!(lines[2], "mistake: The answers are right to 4 digits; write at least six.");
    // At a sphere's edge, where the far root in single precision is as near.
    fs::write(folder.path().join("in.csv"), "row,column,t\n194,42,2.46\n0,0,3\n").unwrap();
    let run = run_in(folder.path(), &["check", "distance-two", "--answers", "in.csv"]);
    assert_eq!(run.stdout.lines().last().unwrap(), lines[2].replace('4', "3"));
}

#[test]
fn a_miss_is_written_in_many_ways() {
    for answers in [
        "row,column,t\n0,0,inf\n0,1,nan\n0,2,-nan(ind)\n0,3,\n0,4,Infinity\n",
        "Row , Column, T ,X,Y,Z\n0,0,inf,,,\n0,1,nan,nan,nan,nan\n0,2, , inf ,inf,inf\n",
        "ROW,COLUMN,T,OBJECT\n0,0,inf,-1\n0,1,0,-1\n0,2,,-1\n0,3,,\n",
        "row,column,object\n0,0,-1\n0,1,-1.0\n",
    ] {
        check(folder(answers).path(), &[]).done();
    }
    let folder = folder("row,column,t\n14,19,inf\n");
    let found = json_of(&check(folder.path(), &["--json"]));
    assert_eq!(
        (&found["worst"]["given"], &found["worst"]["error"]),
        (&json!("miss"), &json!(null))
    );
    fs::write(folder.path().join("in.csv"), "row,column,t\n0,0,3\n").unwrap();
    let found = json_of(&check(folder.path(), &["--json"]));
    assert_eq!(found["worst"]["right"], json!("miss"));
    // None of the image: nothing is right.
    fs::write(folder.path().join("in.csv"), "row,column,t\n30,40,\n").unwrap();
    let found = json_of(&check(folder.path(), &["--json"]));
    assert_eq!(found["worst"]["right"], json!(null));
}
