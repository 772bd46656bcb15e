//! Molecules: what `.xyz` and `.pdb` files become, how they are refused, and what saving does.

use std::fs;
use std::path::Path;

use expect_test::expect;
use pinhole::document::Document;
use pinhole::files::OpenDocument;
use pinhole::formats::molecule::elements::{of_number, of_symbol};
use pinhole::formats::scene_argument::SceneSource;
use pinhole::formats::{builtin, color, molecule, scene_file};
use pinhole_core::{DVec3, Outputs, Raster, Sphere, trace};

const WATER: &str = "3\nWater\nO 0 0 0.1192\nH 0 0.7632 -0.477\nH 0 -0.7632 -0.477\n";

/// Columns as the Protein Data Bank has them: a peptide's beginning, an alternate location, an ion
/// without an element, and a second model.
const PEPTIDE: &str = "\
HEADER    MADE UP
TITLE     TWO RESIDUES
TITLE    2 AND AN ION
REMARK   1 ATOM IN A REMARK IS NONE
MODEL        1
ATOM      1  N   ALA A   1      11.104   6.134  -6.504  1.00  0.00           N
ATOM      2  CA AALA A   1      11.639   6.071  -5.147  0.60  0.00           C
ATOM      3  CA BALA A   1      11.700   6.000  -5.100  0.40  0.00           C
ATOM      4 HG11 VAL A   2A     10.000   7.000  -4.000
ATOM      5 1HB  VAL A   2A      9.000   7.000  -4.000
TER       6      VAL A   2
HETATM    7 CA    CA     3      12.000   7.000  -3.000  1.00  0.00
ENDMDL
MODEL        2
ATOM      1  N   ALA A   1       0.000   0.000   0.000  1.00  0.00           N
ENDMDL
END
";

fn parse(name: &str, text: &str) -> Document {
    molecule::parse(text, Path::new(name)).unwrap()
}

fn listed(document: &Document) -> String {
    let mut text = format!("{}\n", document.note);
    for item in &document.spheres {
        let Sphere { center, radius } = item.shape;
        let color = color::to_text(item.color.unwrap());
        let name = item.name.as_deref().unwrap();
        text += &format!("{name}: {center} r {radius} {color}\n");
    }
    text
}

#[test]
fn atoms_are_spheres_of_their_element() {
    expect![[r#"
        Water.
        3 atoms, H2O: spheres of van der Waals radius, in ångström.
        O1: [0, 0, 0.1192] r 1.52 #ff0d0d
        H2: [0, 0.7632, -0.477] r 1.2 #ffffff
        H3: [0, -0.7632, -0.477] r 1.2 #ffffff
    "#]]
    .assert_eq(&listed(&parse("water.xyz", WATER)));
}

#[test]
fn an_xyz_file_may_have_numbers_labels_more_columns_and_frames() {
    let text = "\u{feff}2\r\n\r\n  17 1e0 -2.5 3 0.1 0.2\r\ncl7\t4 5 6\r\n2\r\nlater\r\nH 0 0 0\r\nH 1 0 0\r\n\r\n";
    expect![[r#"
        2 atoms, Cl2: spheres of van der Waals radius, in ångström.
        The file has 2 frames: this is the first.
        Cl1: [1, -2.5, 3] r 1.75 #1ff01f
        Cl2: [4, 5, 6] r 1.75 #1ff01f
    "#]]
    .assert_eq(&listed(&parse("a.XYZ", text)));
}

#[test]
fn labels_are_of_the_element_they_begin_with_and_dummy_atoms_grey() {
    let text = "5\n\nc 0 0 0\nC_3 1 0 0\nN.ar 2 0 0\nXx 3 0 0\nDU 4 0 0\n";
    expect![[r#"
        5 atoms, C2NX2: spheres of van der Waals radius, in ångström.
        2 atoms are of no known element: grey.
        C1: [0, 0, 0] r 1.7 #909090
        C2: [1, 0, 0] r 1.7 #909090
        N3: [2, 0, 0] r 1.55 #3050f8
        X4: [3, 0, 0] r 2 #808080
        X5: [4, 0, 0] r 2 #808080
    "#]]
    .assert_eq(&listed(&parse("a.xyz", text)));
    assert_eq!(parse("peptide.ent", PEPTIDE), parse("peptide.pdb", PEPTIDE));
}

#[test]
fn a_pdb_file_gives_the_first_model_and_the_first_of_alternate_locations() {
    expect![[r#"
        TWO RESIDUES AND AN ION.
        5 atoms, CH2CaN: spheres of van der Waals radius, in ångström.
        The file has 2 models: this is the first. Of atoms with alternate locations, the first is shown; 1 other left out.
        N ALA A1: [11.104, 6.134, -6.504] r 1.55 #3050f8
        CA ALA A1: [11.639, 6.071, -5.147] r 1.7 #909090
        HG11 VAL A2A: [10, 7, -4] r 1.2 #ffffff
        1HB VAL A2A: [9, 7, -4] r 1.2 #ffffff
        CA CA 3: [12, 7, -3] r 2.62 #3dff00
    "#]]
    .assert_eq(&listed(&parse("peptide.pdb", PEPTIDE)));
}

#[test]
fn the_table_of_elements() {
    for (symbol, number, radius) in
        [("H", 1, 1.2), ("C", 6, 1.7), ("O", 8, 1.52), ("Fe", 26, 2.44), ("Xe", 54, 2.16)]
    {
        let element = of_symbol(symbol).unwrap();
        assert_eq!((element.radius, of_number(number)), (radius, Some(element)));
    }
    assert_eq!(of_number(109).unwrap().symbol, "Mt");
    assert_eq!((of_number(0), of_number(110), of_symbol("Xx")), (None, None, None));
    let symbols: std::collections::BTreeSet<_> =
        (1..=109).map(|number| of_number(number).unwrap().symbol).collect();
    assert_eq!(symbols.len(), 109);
    assert!((1..=109).all(|n| (1.0..3.6).contains(&of_number(n).unwrap().radius)));
}

#[test]
fn what_is_wrong_is_told_at_its_place() {
    let pdb = |from: &str, to: &str| ("m.pdb", PEPTIDE.replacen(from, to, 1));
    let xyz = |text: &str| ("m.xyz", text.to_owned());
    let cases = [
        xyz(""),
        xyz("three\n"),
        xyz("0\nnothing\n"),
        xyz("-1\n\n"),
        xyz("2\nwater\nO 0 0 0\n"),
        xyz("2\nwater\nO 0 0 0\n\nH 1 1 1\n"),
        xyz("1\n\n?? 0 0 0\n"),
        xyz("1\n\n0 0 0 0\n"),
        xyz("1\n\nC 0 0\n"),
        xyz("1\n\nC 0 1,5 0\n"),
        xyz("1\n\nC 1.0 C 2\n"),
        xyz("1\n\nC 0 0 nan\n"),
        xyz("1\n\nC 0 0 1e9\n"),
        xyz("1\n\nC 0 0 0\nC 1 1 1\n"),
        xyz("1\nProperties=pos:R:3:species:S:1 x\n0 0 0 C\n"),
        pdb("6.134", "6,134"),
        pdb("  -6.504  1.00  0.00           N", ""),
        pdb("           N\n", "           ?\n"),
        pdb("HG11", "??  "),
        ("m.pdb", "REMARK\nEND\n".to_owned()),
    ];
    let messages: Vec<String> = cases
        .iter()
        .map(|(name, text)| molecule::parse(text, Path::new(name)).unwrap_err().to_string())
        .collect();
    expect![[r#"
        m.xyz:1:1: the number of atoms is "": it must be the number of atoms, a whole number
        m.xyz:1:1: the number of atoms is "three": it must be the number of atoms, a whole number
        m.xyz: there is no atom in it: there must be one at least
        m.xyz:1:1: the number of atoms is "-1": it must be the number of atoms, a whole number
        m.xyz:4:1: atom 2 of 2 is missing: there must be a line an atom: element, x, y, z
        m.xyz:4:1: atom 2 of 2 is missing: there must be a line an atom: element, x, y, z
        m.xyz:3:1: atom 1's element is "??": it must be a symbol such as C or Cl, or an atomic number
        m.xyz:3:1: atom 1's element is "0": it must be a symbol such as C or Cl, or an atomic number
        m.xyz:3:6: atom 1 has no z: a line must be element, x, y, z
        m.xyz:3:5: atom 1's y is "1,5": it must be a number of ångström
        m.xyz:3:7: atom 1's y is "C": it must be a number of ångström
        m.xyz:3:7: atom 1's z is "nan": it must be a finite number of ångström
        m.xyz:3:7: atom 1's z is "1e9": it must be at most a million ångström
        m.xyz:4:1: "C 1 1 1" follows the last atom: after atom 1, the last one by the first line, the file must end, or another frame begin with its number of atoms
        m.xyz:2:12: Properties is pos:R:3:species:S:1: the columns must begin with species:S:1:pos:R:3
        m.pdb:6:39: y in columns 39-46 is "6,134": it must be a number of ångström
        m.pdb:6:47: z in columns 47-54 is "": it must be a number of ångström
        m.pdb:6:77: the element in columns 77-78 is "?": it must be a symbol such as C or CL
        m.pdb:9:13: the atom's name in columns 13-16 is "??  ", which begins with no element, and columns 77-78 name none: it must be a symbol such as C or CL
        m.pdb: there is no atom in it: there must be one at least
    "#]].assert_eq(&format!("{}\n", messages.join("\n")));
}

#[test]
fn no_text_makes_it_panic() {
    use proptest::prelude::*;
    let lines = ["ATOM", "1", "é", " ", "\t", "\n", "\r\n", "C 0 0 0", "2\n\n", "MODEL", "1e400"];
    let texts = prop::collection::vec(prop::sample::select(lines.to_vec()), 0..30);
    proptest!(|(words in texts, garbage in ".{0,90}")| {
        for name in ["a.xyz", "a.pdb"] {
            for text in [words.concat(), format!("ATOM  {garbage}"), format!("1\n\n{garbage}")] {
                let _ = molecule::parse(&text, Path::new(name));
            }
        }
    });
}

/// The camera sees every atom, and some of them near the picture's border.
fn assert_framed(document: &Document) {
    let camera = document.camera.resolve().unwrap();
    let [width, height] = [camera.image().width(), camera.image().height()].map(|n| n as usize);
    let frame = trace(
        &document.scene().unwrap(),
        &camera,
        &Raster::full(camera.image()),
        Outputs::default(),
    );
    let (mut low, mut high) = ((height, width), (0, 0));
    for (row, column) in (0..height).flat_map(|row| (0..width).map(move |column| (row, column))) {
        if frame.at(row, column).object.is_some() {
            low = (low.0.min(row), low.1.min(column));
            high = (high.0.max(row), high.1.max(column));
        }
    }
    let margins = [low.0, low.1, height - 1 - high.0, width - 1 - high.1];
    assert!(margins.iter().all(|margin| *margin > 4), "{margins:?}");
    let (rows, columns) = (margins[0] + margins[2], margins[1] + margins[3]);
    assert!(rows < height / 5 || columns < width / 5, "{margins:?}");
}

#[test]
fn the_camera_frames_the_molecule() {
    assert_framed(&builtin::find("caffeine").unwrap().load().unwrap());
    assert_framed(&parse("water.xyz", WATER));
    assert_framed(&parse("peptide.pdb", PEPTIDE));
    assert_framed(&parse("argon.xyz", "1\nArgon\nAr 1000 -2000 3000\n"));
    // A rod along each axis, and one that is large.
    for (x, y, z) in [(30, 0, 0), (0, 30, 0), (0, 0, 30), (400, 300, 200)] {
        assert_framed(&parse("rod.xyz", &format!("2\n\nC 0 0 0\nC {x} {y} {z}\n")));
    }
    // In numbers that can be read out.
    let water = parse("water.xyz", WATER).camera;
    assert_eq!(water.resolve().unwrap().basis().w, DVec3::X);
    assert_eq!((water.viewport.width, water.viewport.height), (1.6, 1.2));
}

#[test]
fn caffeine_is_caffeine() {
    let document = builtin::find("caffeine").unwrap().load().unwrap();
    assert!(document.note.contains("24 atoms, C8H10N4O2"), "{}", document.note);
    let atoms: Vec<(&str, DVec3)> = document
        .spheres
        .iter()
        .map(|item| (&item.name.as_deref().unwrap()[..1], item.shape.center))
        .collect();
    let mut bonds = 0;
    for (i, (a, p)) in atoms.iter().enumerate() {
        let mut own = 0;
        for (b, q) in &atoms[..i] {
            let length = p.distance(*q);
            assert!(length > 1.05, "{a} and {b} are {length} apart");
            let with_hydrogen = *a == "H" || *b == "H";
            let longest = if with_hydrogen { 1.15 } else { 1.55 };
            if length < longest {
                assert!(with_hydrogen || length > 1.2, "{a}-{b}: {length}");
                own += 1;
            }
        }
        bonds += own;
        // Hydrogens come last in the file: each has one bond.
        assert!(*a != "H" || own == 1, "hydrogen {i} has {own} bonds");
    }
    // Two rings that share a bond: one bond more than atoms.
    assert_eq!(bonds, 25);
}

#[test]
fn a_molecule_is_saved_as_a_scene_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("water.xyz");
    fs::write(&path, WATER).unwrap();
    let source = SceneSource::of(&path).unwrap();
    let mut open = OpenDocument::new(source.load().unwrap(), source);
    assert_eq!((open.scene_file(), open.file()), (None, Some(path.as_path())));
    assert_eq!(open.file_name(), "water.toml");
    open.document.camera.eye.x = 9.5;
    let message = open.save_to(&path).unwrap_err();
    let scene = folder.path().join("water.toml");
    assert_eq!(
        message,
        format!(
            "{}: a scene is no molecule: save it as a scene, such as {}",
            path.display(),
            scene.display()
        )
    );
    assert_eq!(fs::read_to_string(&path).unwrap(), WATER);
    open.save_to(&scene).unwrap();
    assert_eq!(open.scene_file(), Some(scene.as_path()));
    assert_eq!(scene_file::load(&scene).unwrap(), open.document);
}

#[test]
fn a_large_molecule_stays_in_its_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("crystal.xyz");
    let atoms: String =
        (0..729).map(|i| format!("Na {} {} {}\n", i % 9 * 4, i / 9 % 9 * 4, i / 81 * 4)).collect();
    fs::write(&path, format!("729\nA crystal\n{atoms}")).unwrap();
    let source = SceneSource::of(&path).unwrap();
    let mut open = OpenDocument::new(source.load().unwrap(), source);
    assert_eq!((open.document.spheres.len(), open.document.sphere_count()), (0, 729));
    assert_eq!(open.document.name_of(728), Some("Na729"));
    assert_framed(&open.document);
    let scene = folder.path().join("crystal.toml");
    open.save_to(&scene).unwrap();
    assert!(fs::read_to_string(&scene).unwrap().contains("spheres = \"crystal.xyz\"\n"));
    assert_eq!(scene_file::load(&scene).unwrap(), open.document);
}
