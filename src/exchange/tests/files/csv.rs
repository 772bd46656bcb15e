//! Tests of tables of spheres (`spheres = "file.csv"`): valid ones, and invalid ones with their exact
//! messages.

use std::fs;
use std::path::Path;

use pinhole_core::{DVec3, Sphere};
use pinhole_exchange::csv::{rays, spheres};
use pinhole_exchange::document::Item;
use pinhole_exchange::{FileError, scene_file};

fn parse(text: &str) -> Result<Vec<Item<Sphere>>, FileError> {
    let table = spheres(Path::new("balls.csv"), text.as_bytes())?;
    let item = |(index, shape): (usize, &Sphere)| {
        let (name, color) = table.look(index);
        Item { name: name.map(str::to_owned), color, shape: *shape }
    };
    Ok(table.spheres.iter().enumerate().map(item).collect())
}

fn sphere(x: f64, y: f64, z: f64, radius: f64) -> Item<Sphere> {
    Item::plain(Sphere { center: DVec3::new(x, y, z), radius })
}

#[test]
fn columns_come_in_any_order() {
    assert_eq!(parse("x,y,z,r\n1,2,3,4\n").unwrap(), [sphere(1.0, 2.0, 3.0, 4.0)]);
    let named = Item {
        name: Some("a, b".to_owned()),
        color: Some([255, 0, 0]),
        ..sphere(1.0, -2e-3, 3.0, 0.5)
    };
    let text = "\u{feff}name, r ,color,z,y,x\r\n\"a, b\",.5,#ff0000, 3 ,-2e-3,1\r\n\r\n,1,,0,0,0";
    assert_eq!(parse(text).unwrap(), [named, sphere(0.0, 0.0, 0.0, 1.0)]);
    assert_eq!(parse("x,y,z,r\n").unwrap(), []);
    let quoted = "\"x\", \"y\" , \"z\", \"r\"\n 0, \"0\", 0, 1\n";
    assert_eq!(parse(quoted).unwrap(), [sphere(0.0, 0.0, 0.0, 1.0)]);
}

#[test]
fn bad_files_are_told_line_column_and_value() {
    let cases = [
        ("", "1:1: column x is missing: the first line must name the columns x,y,z,r"),
        ("x,y,r\n", "1:1: column z is missing: the first line must name the columns x,y,z,r"),
        (
            "x,y,z,radius\n",
            "1:7: column \"radius\" is unknown: the first line must name columns out of x,y,z,r,color,name",
        ),
        ("x,y,z,r,colour\n", "1:9: column \"colour\" is unknown: did you mean color?"),
        ("x,y,z,r,x\n", "1:9: column x is there twice"),
        (
            "1,2,3,4\n",
            "1:1: the first line must be a header with columns out of x,y,z,r,color,name",
        ),
        (
            "x;y;z;r\n1;2;3;4\n",
            "1:1: the first line has semicolons: commas must stand between cells, and a point in a number",
        ),
        (
            "x,y,z,r,name\n1,2,3,4,\"5\"\" ball\"\n1,2,3,4,\"open\n5,6,7,8,b\n",
            "3:9: this quote is not closed: a second one must end its cell",
        ),
        ("x,y,z,r\n1,2,3\n", "2:1: the row has 3 cells: it must have 4, as the first line has"),
        ("x,y,z,r\n1,2,3,4,5\n", "2:1: the row has 5 cells: it must have 4, as the first line has"),
        ("x,y,z,r\n1,2,3,4\n1,two,3,4\n", "3:3: column y is \"two\": it must be a number"),
        (
            "x,y,z,r\n1,\"2,5\",3,4\n",
            "2:3: column y is \"2,5\": it must be a number with a decimal point: write 2.5",
        ),
        ("x,y,z,r\n\n\r\n1,,3,4\n", "4:3: column y is \"\": it must be a number"),
        ("x,y,z,r\n1,2,nan,4\n", "2:5: column z is \"nan\": it must be a finite number"),
        ("x,y,z,r\n1,2,3,1e999\n", "2:7: column r is \"1e999\": it must be a finite number"),
        ("x,y,z,r\n1,2,3,0\n", "2:7: column r is \"0\": it must be greater than 0"),
        ("x,y,z,r\n1,2,3,-4\n", "2:7: column r is \"-4\": it must be greater than 0"),
        (
            "name,x,y,z,r\n\"a\nb,\"\"c\",1,2,3,4\n\"é\",x,2,3,4\n",
            "4:5: column x is \"x\": it must be a number",
        ),
        (
            "x,y,z,r,color\n1,2,3,4,red\n",
            "2:9: column color is \"red\": it must be a colour such as #e69f00",
        ),
    ];
    for (text, expected) in cases {
        let message = parse(text).unwrap_err().to_string();
        assert_eq!(message, format!("balls.csv:{expected}"), "in:\n{text}");
    }
    let message = spheres(Path::new("b.csv"), &b"x,y,z,r,name\n1,2,3,4,\xff\n"[..]).unwrap_err();
    assert_eq!(
        message.to_string(),
        "b.csv:2:9: column name is \"\u{fffd}\": it must be UTF-8 text"
    );
}

/// A message about a file that is not a table does not quote it: a scene from somebody else may name
/// any file of the machine as its table.
#[test]
fn what_is_no_table_is_not_shown() {
    for text in ["root:$6$secret:20228:0:::\n", "secret\n", "secret,more\n1,2\n", "a;secret\n"] {
        let message = parse(text).unwrap_err().to_string();
        let expected =
            "balls.csv:1:1: the first line must be a header with columns out of x,y,z,r,color,name";
        assert_eq!(message, expected, "{text}");
    }
}

#[test]
fn a_row_without_an_end_is_refused_and_a_long_value_shortened() {
    let zeros = "0".repeat(70_000);
    let message = parse(&format!("x,y,z,r\n1,2,3,4\n1,2,3,{zeros}\n")).unwrap_err().to_string();
    assert_eq!(message, "balls.csv:3:1: the row is too long: at most 64 kB are read");
    let message = parse(&format!("x,y,z,r,name\n1,2,3,4,\"{}", "a\n".repeat(40_000))).unwrap_err();
    assert_eq!(
        message.to_string(),
        "balls.csv:2:9: this quote is not closed: a second one must end its cell"
    );
    let message =
        parse(&format!("x,y,z,r\n1,2,3,x{}\n", &zeros[..50_000])).unwrap_err().to_string();
    let shown = format!("x{}...", &zeros[..59]);
    assert_eq!(message, format!("balls.csv:2:7: column r is \"{shown}\": it must be a number"));
}

#[test]
fn rays_need_a_direction() {
    let parse = |text: &str| rays(Path::new("rays.csv"), text.as_bytes());
    let rays = parse("ox,oy,oz,dx,dy,dz\n0,0,0,0,0,-1\n1,2,3,4,5,6\n").unwrap();
    assert_eq!(rays.len(), 2);
    assert_eq!((rays[1].origin, rays[1].direction.z), (DVec3::new(1.0, 2.0, 3.0), 6.0));
    let message = parse("ox,oy,oz,dx,dy,dz\n0,0,0,0,-0,0.0\n").unwrap_err().to_string();
    let expected = "rays.csv:2:7: column dx is \"0\": the direction (dx, dy, dz) is zero: it must \
                    point somewhere";
    assert_eq!(message, expected);
}

const SCENE: &str = "pinhole = 1\nspheres = \"data/balls.csv\"\n[camera]\neye = [0, 0, 0]\n\
                     view = [0, 0, -1]\nup = [0, 1, 0]\n[[sphere]]\ncenter = [0, 0, -5]\n\
                     radius = 1\n[[plane]]\npoint = [0, 0, -6]\nnormal = [0, 0, 1]\n";

#[test]
fn the_path_is_relative_to_the_scene_file() {
    let folder = tempfile::tempdir().unwrap();
    let scene = folder.path().join("scene.toml");
    fs::write(&scene, SCENE).unwrap();
    let csv = folder.path().join("data").join("balls.csv");

    let message = scene_file::load(&scene).unwrap_err().to_string();
    let (scene_text, csv_text) = (scene.display(), csv.display());
    assert_eq!(
        message,
        format!(
            "{scene_text}:2:11: spheres is \"data/balls.csv\": the table of the scene's spheres must be there, \
             but {csv_text}: cannot be read: no such file or directory"
        )
    );

    fs::create_dir(folder.path().join("data")).unwrap();
    fs::write(&csv, "x,y,z,r,name\n1,2,3,4,far\n5,6,7,oops,\n").unwrap();
    let message = scene_file::load(&scene).unwrap_err().to_string();
    assert_eq!(message, format!("{csv_text}:3:7: column r is \"oops\": it must be a number"));

    fs::write(&csv, "x,y,z,r,name\n1,2,3,4,far\n5,6,7,8,\n").unwrap();
    let document = scene_file::load(&scene).unwrap();
    // Spheres, the CSV's, planes.
    assert_eq!((document.sphere_count(), document.scene().unwrap().len()), (3, 4));
    assert_eq!((document.name_of(1), document.name_of(0)), (Some("far"), None));
}

#[test]
fn the_reference_is_kept_and_follows_the_scene() {
    let folder = tempfile::tempdir().unwrap();
    let scene = folder.path().join("scene.toml");
    let (data, other) = (folder.path().join("data"), folder.path().join("other").join("deep"));
    fs::create_dir_all(&data).unwrap();
    fs::create_dir_all(&other).unwrap();
    fs::write(data.join("balls.csv"), "x,y,z,r\n1,2,3,4\n").unwrap();
    fs::write(&scene, SCENE).unwrap();
    let document = scene_file::load(&scene).unwrap();

    scene_file::save(&document, &scene, Some(SCENE)).unwrap();
    assert_eq!(fs::read_to_string(&scene).unwrap(), SCENE);

    for (path, reference) in [
        (other.join("copy.toml"), "spheres = \"../../data/balls.csv\"\n"),
        (data.join("copy.toml"), "spheres = \"balls.csv\"\n"),
    ] {
        scene_file::save(&document, &path, None).unwrap();
        let text = fs::read_to_string(&path).unwrap();
        assert!(text.contains(reference), "{text}");
        let copy = scene_file::load(&path).unwrap();
        assert_eq!(copy.csv_spheres.unwrap().items, document.csv_spheres.clone().unwrap().items);
    }
}
