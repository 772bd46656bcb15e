//! `pinhole inspect`

use std::fs;

use expect_test::expect;
use pinhole_exchange::BuiltinScene;
use serde_json::Value;

use super::{Run, finished, run, run_in};

fn json(line: &str) -> Value {
    serde_json::from_str(&run(line).done()).unwrap()
}

/// Asserts that numbers at a path are these, to 2 ulp.
fn close(value: &Value, pointer: &str, expected: &[f64]) {
    let found = value.pointer(pointer).unwrap_or_else(|| panic!("no {pointer} in {value}"));
    let numbers: Vec<f64> = match found {
        Value::Array(numbers) => numbers.iter().map(|x| x.as_f64().unwrap()).collect(),
        number => vec![number.as_f64().unwrap()],
    };
    assert_eq!(numbers.len(), expected.len(), "{pointer}");
    for (number, expected) in numbers.iter().zip(expected) {
        let ulp = (expected.abs().next_up() - expected.abs()).max(f64::MIN_POSITIVE);
        assert!((number - expected).abs() <= 2.0 * ulp, "{pointer}: {number} is not {expected}");
    }
}

#[test]
fn the_warm_up() {
    for uv in ["--uv 0.2,-0.1", "--uv=0.2,-0.1"] {
        let inspect = json(&format!("inspect canonical {uv} --json"));
        close(&inspect, "/camera/eye", &[0.0, 0.0, 0.0]);
        close(&inspect, "/camera/u", &[1.0, 0.0, 0.0]);
        close(&inspect, "/camera/v", &[0.0, 1.0, 0.0]);
        close(&inspect, "/camera/w", &[0.0, 0.0, 1.0]);
        close(&inspect, "/camera/up_view_angle_deg", &[90.0]);
        close(&inspect, "/camera/conditioning", &[1.0]);
        // The corner of four pixels is in none.
        assert_eq!(inspect["pixel"], Value::Null);
        close(&inspect, "/uv", &[0.2, -0.1]);
        close(&inspect, "/ray/origin", &[0.0, 0.0, 0.0]);
        close(&inspect, "/ray/direction", &[0.2, -0.1, -1.0]);
        assert_eq!(inspect["hits"].as_array().unwrap().len(), 1);
        assert_eq!(inspect["first"], 0);
        assert_eq!(inspect["hits"][0]["object"], "plane");
        assert_eq!(inspect["hits"][0]["index"], 2);
        assert_eq!(inspect["hits"][0]["name"], "back wall");
        close(&inspect, "/hits/0/t", &[6.0]);
        close(&inspect, "/hits/0/distance", &[6.0 * 1.05f64.sqrt()]);
        close(&inspect, "/hits/0/point", &[1.2, -0.6, -6.0]);
        close(&inspect, "/hits/0/normal", &[0.0, 0.0, 1.0]);
    }
}

#[test]
fn forty_five_degrees() {
    let s = 0.5f64.sqrt();
    let inspect = json("inspect forty-five --uv 0.2,-0.1 --json");
    close(&inspect, "/camera/u", &[s, 0.0, -s]);
    close(&inspect, "/camera/v", &[0.0, 1.0, 0.0]);
    close(&inspect, "/camera/w", &[s, 0.0, s]);
    close(&inspect, "/ray/direction", &[-0.8 * s, -0.1, -1.2 * s]);
    let first = inspect["first"].as_u64().unwrap();
    close(&inspect, &format!("/hits/{first}/t"), &[5.0 * 2f64.sqrt()]);
    close(&inspect, &format!("/hits/{first}/point"), &[-4.0, -s, -6.0]);
    assert_eq!(inspect["hits"][first as usize]["name"], "back wall");
}

#[test]
fn a_pixel_is_its_centre() {
    let inspect = json("inspect canonical --pixel 99,199 --json");
    assert_eq!(inspect["pixel"], serde_json::json!({ "row": 99, "column": 199 }));
    close(&inspect, "/uv", &[-1.0 / 800.0, 201.0 / 800.0]);
    let same = json("inspect canonical --uv -0.00125,0.25125 --json");
    assert_eq!(same["pixel"], inspect["pixel"]);
}

#[test]
fn all_roots_with_the_negative_ones() {
    let inspect = json("inspect inside --uv 0,0 --json");
    close(&inspect, "/hits/0/t", &[-3.0]);
    close(&inspect, "/hits/0/distance", &[-3.0]);
    close(&inspect, "/hits/1/t", &[5.0]);
    assert_eq!(inspect["first"], 1);

    let nothing = json("inspect tiny-far --uv 0,0.4 --json");
    assert_eq!((&nothing["hits"], &nothing["first"]), (&serde_json::json!([]), &Value::Null));

    let outside = json("inspect canonical --uv 3,0 --json");
    assert_eq!(outside["pixel"], Value::Null);
}

#[test]
fn the_shape_is_the_contract_s() {
    let text = run("inspect grazing --pixel 200,200 --json").done();
    let keys: Vec<&str> = text.split('"').skip(1).step_by(2).collect();
    let hit = "object sphere index name NAME t distance point normal ";
    let hits = hit.replace("NAME", "upper ball")
        + &hit.replace("NAME", "lower ball")
        + &hit.replace("sphere", "plane").replace("NAME", "back wall");
    let camera = "camera eye u v w up_view_angle_deg conditioning pixel row column uv ray origin direction hits ";
    assert_eq!(keys.join(" "), format!("{camera}{hits}first"));
    assert!(!text.contains("-0.0"), "{text}");
}

#[test]
fn numbers_beyond_the_range_are_null_or_refused() {
    let folder = tempfile::tempdir().unwrap();
    let inspect = |up: &str, uv: &str| {
        let camera = format!("[camera]\neye = [0, 0, 0]\nview = [0, 0, -1e300]\nup = {up}\n");
        let objects = "[[plane]]\npoint = [0, 1, 0]\nnormal = [1e-300, 1e-300, 0]\n";
        fs::write(folder.path().join("wild.toml"), format!("pinhole = 1\n{camera}{objects}"))
            .unwrap();
        run_in(folder.path(), &["inspect", "wild.toml", "--json", "--uv", uv])
    };
    let text = inspect("[1e-310, 0, 1]", "1e-309,0").done();
    let value: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(value["camera"]["conditioning"], f64::MAX, "as far as the range goes");
    // The line is all but parallel to the plane: they meet, behind the eye, where no number tells.
    assert_eq!(value["hits"].as_array().map(Vec::len), Some(1), "{text}");
    assert_eq!((&value["hits"][0]["t"], &value["first"]), (&Value::Null, &Value::Null));
    inspect("[1, 1, 0]", "1.7e308,1.7e308").failed(
        1,
        "wild.toml: the ray's direction is beyond the range of numbers: make the viewport, its \
         distance or (u, v) smaller",
    );
}

/// Runs `inspect` on a scene of this canonical viewport, image and these spheres.
fn inspect_spheres(viewport: [f64; 3], image: [u32; 2], spheres: &[(f64, f64)], line: &str) -> Run {
    let folder = tempfile::tempdir().unwrap();
    let [width, height, distance] = viewport;
    let mut text = format!(
        "pinhole = 1\n[camera]\neye = [0, 0, 0]\nview = [0, 0, -1]\nup = [0, 1, 0]\n[viewport]\n\
         width = {width:e}\nheight = {height:e}\ndistance = {distance:e}\n[image]\nwidth = {}\n\
         height = {}\n",
        image[0], image[1]
    );
    for (z, radius) in spheres {
        text += &format!("[[sphere]]\ncenter = [0, 0, {z:?}]\nradius = {radius:?}\n");
    }
    fs::write(folder.path().join("s.toml"), text).unwrap();
    let line = format!("inspect s.toml {line}");
    run_in(folder.path(), &line.split_whitespace().collect::<Vec<_>>())
}

#[test]
fn a_pixel_s_ray_is_the_exact_one() {
    let roots = |width: u32, sphere, pixel| {
        let line = format!("--pixel {pixel} --json");
        let height = 2.0 / f64::from(width);
        let text = inspect_spheres([2.0, height, 1.0], [width, 1], &[sphere], &line).done();
        let value: Value = serde_json::from_str(&text).unwrap();
        let hits = value["hits"].as_array().unwrap().clone();
        hits.into_iter().map(|hit| hit["t"].as_f64().unwrap()).collect::<Vec<_>>()
    };
    assert_eq!(roots(45, (-53.0, 28.0), "0,36"), [2025.0 / 53.0], "a tangent");
    assert_eq!(roots(15, (-17.0, 8.0), "0,11"), [225.0 / 17.0], "a tangent");
}

#[test]
fn a_hit_beyond_the_range_of_t_is_a_hit() {
    let viewport = [1e-310; 3];
    let text = inspect_spheres(viewport, [1, 1], &[(-5.0, 1.0)], "--pixel 0,0").done();
    let hits: String = text.split_once("hits\n").unwrap().1.replace("\n  ", "\n");
    expect![[r#"
        object    t           distance  point       normal
        sphere 0  beyond f64  4         (0, 0, -4)  (0, 0, 1)
        sphere 0  beyond f64  6         (0, 0, -6)  (0, 0, -1)
        first: sphere 0 at t = beyond f64, the smallest t above 0
    "#]]
    .assert_eq(hits.trim_start());
    let far = [(-5.0, 1.0), (-5000.0, 1.0)];
    let text = inspect_spheres(viewport, [1, 1], &far, "--pixel 0,0").done();
    let why = "the smallest t above 0 (another is farther; t is beyond f64's range)";
    assert!(text.contains(why), "{text}");
}

#[test]
fn a_reason_is_of_the_numbers_that_decided() {
    let first = |spheres: &[(f64, f64)]| {
        let text = inspect_spheres([1.0; 3], [1, 1], spheres, "--pixel 0,0").done();
        text.lines().last().unwrap().trim().to_owned()
    };
    let beyond = 1.0 + f64::EPSILON;
    assert_eq!(
        first(&[(-1e6, 1.0), (-1e6, beyond)]),
        "first: sphere 1 at t = 999999, the smallest t above 0 (another is farther by less than the \
         digits of t show)"
    );
    assert_eq!(
        first(&[(-1e6, 1.0), (-1e6, 1.0)]),
        "first: sphere 0 at t = 999999, the smallest t above 0 (of equal ones, the object listed \
         first)"
    );
    assert_eq!(first(&[(-5.0, 1.0)]), "first: sphere 0 at t = 4, the smallest t above 0");
}

#[test]
fn a_distance_is_rounded_once() {
    // t = 4 / |d|, whose product with |d| by f64 is 3.9999999999999996.
    let text = inspect_spheres([1.0, 1.0, 1.29], [1, 1], &[(-5.0, 1.0)], "--pixel 0,0 --json");
    let value: Value = serde_json::from_str(&text.done()).unwrap();
    assert_eq!(
        (&value["hits"][0]["distance"], &value["hits"][1]["distance"]),
        (&4.0.into(), &6.0.into())
    );
}

#[test]
fn the_readout() {
    expect![[r#"
        camera
          eye                   (0, 0, 0)
          at                    (0, 0, -5)
          up                    (0, 1, 0)
          u (right)             (1, 0, 0)
          v (up in the image)   (0, 1, 0)
          w (backwards)         (0, 0, 1)
          angle of up and view  90 degrees
          conditioning          1 (degrees of roll for each degree that up is tipped sideways)
          viewport              1 x 1 at distance 1, field of view 53.13 x 53.13 degrees
          image                 400 x 400 pixels
        ray
          (u, v)                (0.2, -0.1)
          pixel                 none: the corner of row,column 239,279  239,280  240,279  240,280
          origin p              (0, 0, 0)
          direction d           (0.2, -0.1, -1)
          length of d           1.02469507659596
        hits
          object               t  distance           point                                          normal
          plane 2 "back wall"  6  6.148170459575759  (1.2000000000000002, -0.6000000000000001, -6)  (0, 0, 1)
          first: plane 2 "back wall" at t = 6, the smallest t above 0
    "#]].assert_eq(&run("inspect canonical --uv 0.2,-0.1").done());
    expect![[r#"
        camera
          eye                   (0, 0, 0)
          at                    (0, 0, -1)
          up                    (0, 1, 0)
          u (right)             (1, 0, 0)
          v (up in the image)   (0, 1, 0)
          w (backwards)         (0, 0, 1)
          angle of up and view  90 degrees
          conditioning          1 (degrees of roll for each degree that up is tipped sideways)
          viewport              1 x 1 at distance 1, field of view 53.13 x 53.13 degrees
          image                 400 x 400 pixels
        ray
          (u, v)                (-0.24875, 0.00125)
          pixel                 row 199, column 100 (counted from 0)
          origin p              (0, 0, 0)
          direction d           (-0.24875, 0.00125, -1)
          length of d           1.0304747085688226
        hits
          object           t                   distance             point                                                              normal
          sphere 0 "room"  -2.932903402384796  -3.0222827788329814  (0.7295597213432181, -0.0036661292529809953, 2.932903402384796)    (0.18238993033580453, -0.0009165323132452488, 0.983225850596199)
          sphere 1 "left"  2.6785116467038628  2.76013850853536     (-0.6662797721175858, 0.0033481395583798146, -2.6785116467038623)  (0.4674404557648284, 0.6066962791167596, 0.6429767065922749)
          sphere 1 "left"  3.392806566014758   3.4962013573444457   (-0.8439606332961711, 0.0042410082075184374, -3.392806566014758)   (0.11207873340765791, 0.6084820164150369, -0.7856131320295161)
          sphere 0 "room"  4.8163587188788615  4.963135847199603    (-1.198069231321117, 0.006020448398598577, -4.8163587188788615)    (-0.29951730783027924, 0.0015051120996496443, -0.9540896797197155)
          first: sphere 1 "left" at t = 2.6785116467038628, the smallest t above 0
    "#]].assert_eq(&run("inspect inside --pixel 199,100").done());
}

#[test]
fn errors_say_what_is_wrong() {
    run("inspect canonicl --uv 0,0")
        .failed(1, "canonicl: neither a file nor a built-in scene: did you mean canonical?");
    run("inspect no/such.toml --uv 0,0")
        .failed(1, "no/such.toml: cannot be read: no such file or directory");
    run("inspect canonical --pixel 400,0").failed(
        1,
        "canonical: pixel 400,0 is outside the image of 400 rows and 400 columns: rows are 0 to \
         399, columns 0 to 399",
    );
    let folder = tempfile::tempdir().unwrap();
    let write = |text: &str| fs::write(folder.path().join("s.toml"), text).unwrap();
    let inspect = || run_in(folder.path(), &["inspect", "s.toml", "--uv", "0,0", "--json"]);
    write("pinhole = 1\n[camera]\neye = [1, 2, 3]\nat = [1, 2, 3]\nup = [0, 1, 0]\n");
    inspect().failed(
        1,
        "s.toml:4:6: camera.at: eye and at are the same point (1, 2, 3): move one of them",
    );
    write("pinhole = 1\n[camera]\neye = [1, 2, x]\n");
    inspect().failed(1, "s.toml:3:14: x is no value: write a number, or text in quotes");
}

#[test]
fn a_camera_without_a_basis_is_told_at_the_field_at_fault() {
    let cases = [
        (
            "at = [1, 2, 3]\nup = [0, 1, 0]",
            "4:6: camera.at: eye and at are the same point (1, 2, 3): move one of them",
        ),
        (
            "view = [0, 0, 0]\nup = [0, 1, 0]",
            "4:8: camera.view: view is (0, 0, 0): it must point somewhere",
        ),
        (
            "view = [0, 0, -1]\nup = [0, 0, 0]",
            "5:6: camera.up: up is (0, 0, 0): it must point somewhere",
        ),
        (
            "view = [0, 2, 0]\nup =   [0, 1, 0]",
            "5:8: camera.up: up (0, 1, 0) is parallel to the view direction (0, 2, 0): turn one of them",
        ),
        (
            "basis = { u = [1, 0, 0], v = [0, 2, 0], w = [0, 0, 1] }",
            "4:30: camera.basis.v: v has length 2: it must be 1 within 1e-9",
        ),
        (
            "[camera.basis]\nu = [1, 0, 0]\nv = [0, 1, 0]\nw = [0, 0, -1]",
            "4:1: camera.basis: the basis is left-handed: u x v is -w and must be w, which points backwards",
        ),
        (
            "basis = { u = [1, 0, 0], v = [1, 0, 0], w = [0, 0, 1] }",
            "4:9: camera.basis: u . v is 1: it must be 0 within 1e-9",
        ),
    ];
    let folder = tempfile::tempdir().unwrap();
    for (camera, message) in cases {
        let text = format!("pinhole = 1\n[camera]\neye = [1, 2, 3]\n{camera}\n");
        fs::write(folder.path().join("s.toml"), text).unwrap();
        for line in ["inspect s.toml --uv 0,0", "render s.toml -o out.png"] {
            run_in(folder.path(), &line.split(' ').collect::<Vec<_>>())
                .failed(1, &format!("s.toml:{message}"));
        }
    }
}

#[test]
fn an_observer_of_the_scene_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let plain = BuiltinScene::find("canonical").unwrap().text;
    let table =
        "[observer]\ntarget = [0, 0.5, -3]\nazimuth = 40\nelevation = -20.25\ndistance = 12\n";
    fs::write(folder.path().join("seen.toml"), format!("{plain}\n{table}")).unwrap();
    fs::write(folder.path().join("plain.toml"), plain).unwrap();
    let inspect = |line: &str| {
        let line = format!("inspect {line}");
        run_in(folder.path(), &line.split(' ').collect::<Vec<_>>()).done()
    };
    let [seen, other] = ["seen", "plain"].map(|name| inspect(&format!("{name}.toml --uv 0,0")));
    let row = |name: &str, value: &str| format!("  {name:<20}  {value}\n");
    let rows = [
        row("target", "(0, 0.5, -3)"),
        row("azimuth", "40 degrees"),
        row("elevation", "-20.25 degrees"),
        row("distance", "12"),
    ];
    let lines = format!("observer\n{}", rows.concat());
    assert_eq!(seen.replace(&lines, ""), other);
    assert_ne!(seen, other);
    let [seen, other] =
        ["seen", "plain"].map(|name| inspect(&format!("{name}.toml --uv 0,0 --json")));
    let [mut seen, other]: [Value; 2] =
        [seen, other].map(|text| serde_json::from_str(&text).unwrap());
    let observer = seen.as_object_mut().unwrap().remove("observer").unwrap();
    close(&observer, "/target", &[0.0, 0.5, -3.0]);
    close(&observer, "/elevation", &[-20.25]);
    assert_eq!(seen, other);
}

/// The limit is on memory that is not a file's. 300,000 spheres take 9.6 MB.
#[cfg(target_os = "linux")]
#[test]
fn a_table_takes_at_most_three_times_its_spheres_memory() {
    let folder = tempfile::tempdir().unwrap();
    let scene = "pinhole = 1\nspheres = \"balls.csv\"\n[camera]\neye = [0, 0, 0]\nat = [0, 0, -1]\n\
                 up = [0, 1, 0]\n";
    fs::write(folder.path().join("s.toml"), scene).unwrap();
    for (megabytes, last, told) in [
        (28, "1,2,3,bad", "error: balls.csv:300002:7: column r is \"bad\": it must be a number\n"),
        (22, "", "there is too little memory: the index of the table's spheres takes 15 MB\n"),
        (7, "", ":1: there is too little memory: the table up to this row takes "),
    ] {
        let table = format!("x,y,z,r\n{}{last}\n", "0,0,-9,1\n".repeat(300_000));
        fs::write(folder.path().join("balls.csv"), table).unwrap();
        let script = format!("ulimit -d {megabytes}000; exec \"$0\" inspect s.toml --pixel 0,0");
        let command = ["-c", &script, env!("CARGO_BIN_EXE_pinhole")];
        let mut shell = std::process::Command::new("sh");
        let run = finished(shell.args(command).current_dir(folder.path()).output().unwrap());
        assert_eq!((run.status, run.stdout.as_str()), (1, ""), "{}", run.stderr);
        assert!(run.stderr.contains(told), "{}", run.stderr);
    }
}
