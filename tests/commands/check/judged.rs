//! Answers of which a wrong one would pass as well, and ties.

use super::*;

const BALL: &str = "[[sphere]]\ncenter = [0, 0, -5]\nradius = 1\n";
const PLANET: &str = "[[sphere]]\ncenter = [0, -1.90000000000001e14, 0]\nradius = 1.9e14\n";
const BEHIND: &str = "[[plane]]\npoint = [0, 0, 4.0000000000000005e15]\nnormal = [0, 0, 1]\n";

#[test]
fn what_a_wrong_answer_would_pass_for_as_well_is_not_judged() {
    let sky: String = (0..426).map(|k| format!("{},{},1,0\n", k / 40, k % 40)).collect();
    let sky = format!("row,column,t,object\n{sky}");
    let middle = "row,column,t,object\n14,19,4.003484,1\n0,0,,\n";
    let ray = "row,column,ox,oy,oz,dx,dy,dz\n3,4,0,0,0,1e-7,1e-7,-1\n";
    let two = BALL.repeat(2);
    let alike = two.replacen("= 1\n", "= 1.0000000001\n", 1);
    let narrow = format!("{BALL}[viewport]\nwidth = 1e-5\nheight = 1e-5\n");
    let far = ("eye = [0, 0, 0]\nat", "eye = [0, 0, 4e15]\nview");
    let same = ("pinhole", "pinhole");
    let unsure = ("at = [0, 0", "at = [1e16, 1e16");
    for (change, camera, answers, tolerance, status, told) in [
        (PLANET, same, &*sky, "1e-5", 2, "0 of 426 hits agree, 426 not judged, within 0.00001 of"),
        (BEHIND, far, &sky, "1e-5", 2, "0 of 426 hits agree, 426 not judged"),
        (BALL, same, "", "255", 2, "0 of 1200 pixels agree, 1200 not judged"),
        (BALL, same, "", "20", 0, "1200 of 1200 pixels agree, within 20 of 255 levels"),
        (BEHIND, far, "", "2", 2, "0 of 1200 pixels agree, 1200 not judged"),
        (&narrow, same, ray, "1e-5", 2, "0 of 1 rays agree, 1 not judged"),
        (BALL, unsure, RIGHT_BASIS, "3", 2, "0 of 3 vectors agree, 3 not judged"),
        (BALL, same, &hits(false, 0), "1.5", 2, "0 of 1200 hits agree, 1200 not judged"),
        (&alike, same, middle, "1e-5", 0, "1 of 2 hits agrees, 1 not judged"),
        (&two, same, middle, "1e-5", 0, "at the same t (1 times, such as 1 and 0)"),
        (PLANET, same, &sky.replacen(",1,0", ",1,7", 1), "1e-5", 1, "0 of 426 hits agree, 425 not"),
    ] {
        let folder = folder(answers);
        let scene = SCENE.replace(BALL, change).replace(camera.0, camera.1);
        fs::write(folder.path().join("s.toml"), scene).unwrap();
        if answers.is_empty() {
            run_in(folder.path(), &["render", "s.toml", "-o", "in.png"]).done();
            fs::rename(folder.path().join("in.png"), folder.path().join("in.csv")).unwrap();
        }
        let run = check(folder.path(), &["--tolerance", tolerance]);
        let is_told = run.stdout.contains(told) && run.status == status;
        assert!(is_told, "{change}{} {}{}", run.status, run.stdout, run.stderr);
    }
    let folder = folder(&sky);
    fs::write(folder.path().join("s.toml"), SCENE.replace(BALL, PLANET)).unwrap();
    let found: Value =
        serde_json::from_str(&check(folder.path(), &["--json", "--map", "m.png"]).stdout).unwrap();
    let advice = "No answer can be judged. What is not judged: numbers of this size are rounded";
    assert!(found["not_judged"] == 426 && found["advice"].as_str().unwrap().starts_with(advice));
    fs::create_dir(folder.path().join("class")).unwrap();
    fs::rename(folder.path().join("in.csv"), folder.path().join("class/amy.csv")).unwrap();
    let run = run_in(folder.path(), &["check", "s.toml", "--answers", "class"]);
    assert!(
        run.status == 2
            && run.stdout.starts_with("amy  not judged  hits: 0 of 426, 426 not judged\n"),
        "{}",
        run.stdout
    );
}
