//! POV-Ray scenes as people have them: names, conditions, other files, and no size of the image.

use pinhole_core::DVec3;

use super::read;

/// A right-handed camera, so that no z is turned.
const CAMERA: &str = "camera { location <0, 0, 9> right <1, 0, 0> up <0, 1, 0> direction <0, 0, -1> } \
                      // +W10 +H10\n";

fn degrees_of(text: &str) -> (f64, Vec<String>) {
    let taken = read("povray", &format!("// +W40 +H40\n{text}")).unwrap();
    (taken.camera.viewport.horizontal_fov().to_degrees().round(), taken.notes)
}

fn camera(angle: u32) -> String {
    format!("camera {{ location <0, 0, 5> right -x up y look_at 0 angle {angle} }}\n")
}

#[test]
fn names_of_one_value_are_that_value() {
    let text = "#declare Far = 5;\n#local CamPos = <1, 2, -Far*2>;\n#declare Aim = CamPos + 3*z;\n\
                #declare Ratio = image_width/image_height;\n#declare Paint = rgb <1, 0.5, 0>*2;\n\
                camera { location CamPos right -x*Ratio up y look_at <Aim.x, 2, 0> }\n\
                sphere { CamPos + <0, 0, 4>, Far/5 translate Far*x pigment { color Paint } }\n// +W40 +H20";
    let taken = read("povray", text).unwrap();
    assert_eq!(taken.camera.eye, DVec3::new(1.0, 2.0, -10.0));
    assert_eq!(taken.camera.viewport.width, 2.0);
    let sphere = &taken.spheres[0];
    assert_eq!((sphere.shape.center, sphere.shape.radius), (DVec3::new(6.0, 2.0, -6.0), 1.0));
    assert_eq!(sphere.color, Some([255, 255, 0]));
    assert_eq!(taken.notes, [""; 0]);
    for more in [
        "#declare P = <1, 2, 3>;\n#declare P = P*2;",
        "#if (clock > 0)\n#declare P = <1, 2, 3>;\n#end",
        "#declare P = <1, 2, Q>;\n#declare Q = P;",
        "#for (P, 1, 3)\n#end\n#declare P = 1;",
    ] {
        let refused = read("povray", &format!("{more}\ncamera {{ location P look_at 0 }}"));
        assert!(refused.unwrap_err().problem.starts_with("location is P: "), "{more}");
    }
}

#[test]
fn the_camera_of_the_branch_that_is_taken_is_taken() {
    let (a, b) = (camera(20), camera(80));
    for (text, degrees) in [
        (format!("#if (1) {a} #else {b} #end"), 20.0),
        (format!("#if (0) {a} #else {b} #end"), 80.0),
        (format!("#declare Wide = 0;\n#if (Wide) {a} #elseif (1) {b} #else {a} #end"), 80.0),
        (format!("{a} #if (0) {b} #if (1) {b} #end #else #end"), 20.0),
        (format!("{a} /* {b} /* {b} */ {b} */"), 20.0),
        (format!("#debug \"/*\"\n// /*\n{a} // \" */"), 20.0),
        (format!("#declare A = {a} #declare B = {b} camera {{ A }}"), 20.0),
    ] {
        assert_eq!(degrees_of(&text), (degrees, Vec::new()), "{text}");
    }
    let told = |which: &str, line: u32| {
        vec![format!(
            "1 of camera under a condition that is not worked out: {which} is taken, line {line}"
        )]
    };
    assert_eq!(degrees_of(&format!("#if (clock > 1)\n{a}#end")), (20.0, told("it", 3)));
    let after = format!("{b}#ifdef (Wide)\n{a}#end");
    assert_eq!(degrees_of(&after), (80.0, told("the last that stands under none", 2)));
    assert_eq!(degrees_of(&format!("#ifdef (Wide)\n{a}#end\n{b}")), (80.0, Vec::new()));
    for (text, said) in [
        (
            format!("#declare A = {a}camera {{ A angle 30 }}"),
            "camera is A: what is added to it must stand in its declaration",
        ),
        (
            "camera { Mine }".to_owned(),
            "camera is Mine: it must begin with a word such as location, or be declared in this file",
        ),
        (
            "camera { location 0 #if (Wide) angle 80 #end look_at z }".to_owned(),
            "camera is if: no directive must stand in it",
        ),
    ] {
        assert_eq!(read("povray", &text).unwrap_err().problem, said);
    }
}

#[test]
fn conditions_of_plain_numbers_and_names_are_worked_out() {
    let (a, b) = (camera(20), camera(80));
    for (condition, holds) in [
        ("Cam = 1", true),
        ("Cam = 2", false),
        ("Cam != 1", false),
        ("Cam < 2", true),
        ("Cam > 1", false),
        ("Cam <= 1", true),
        ("2*Cam >= 3", false),
        ("Top", false),
    ] {
        let text =
            format!("#declare Cam = 1;\n#declare Top = no;\n#if ({condition}) {a} #else {b} #end");
        let degrees = if holds { 20.0 } else { 80.0 };
        assert_eq!(degrees_of(&text), (degrees, Vec::new()), "{text}");
    }
    for (switch, degrees) in [
        (format!("#case (1) {a} #break #case (2) {b} #break"), 20.0),
        (format!("#case (0) {a} #break #case (1) {b} #break #default {a}"), 80.0),
        (format!("#case (0) {a} #break #range (2, 3) {a} #break #default {b}"), 80.0),
        (format!("#range (0, 1) {a} #break #else {b}"), 20.0),
        (format!("#case (1) {a} #case (2) {b} #break"), 80.0),
    ] {
        let text = format!("#declare Cam = 1;\n#switch (Cam) {switch} #end");
        assert_eq!(degrees_of(&text), (degrees, Vec::new()), "{text}");
    }
}

#[test]
fn cameras_under_conditions_that_are_not_worked_out_are_refused() {
    let (a, b) = (camera(20), camera(80));
    for (text, place) in [
        (format!("#if (clock > 1)\n{a}#else\n{b}#end"), "in:1:6: the condition is clock > 1"),
        (
            format!("{a}#switch (clock)\n#case (1) {a} #case (2) {b} #end"),
            "in:2:10: the condition is clock",
        ),
        (
            format!("#declare A = 1;#if (A = 2)\n{a}#elseif (B)\n{b}#else\n{a}#end"),
            "in:3:10: the condition is B",
        ),
        (
            format!("#switch (1) #case (1) #if (clock) {a} #break #end {b} #end"),
            "in:1:28: the condition is clock",
        ),
    ] {
        let error = read("povray", &text).unwrap_err().to_string();
        let right =
            "it is not worked out, and 2 of camera stand under such conditions: leave in one";
        assert_eq!(error, format!("{place}: {right}"), "{text}");
    }
    let declared =
        format!("#if (clock)\n#declare A = {a}#else\n#declare A = {b}#end camera {{ A }}");
    let error = read("povray", &declared).unwrap_err().to_string();
    assert_eq!(
        error,
        "in:1:6: the condition is clock: it is not worked out, and camera A depends on it"
    );
}

#[test]
fn objects_of_branches_and_other_files_are_taken_or_told() {
    let objects = "#include \"colors.inc\"\n#include \"room.inc\"\n#include \"lamp.pov\"\n\
                   #if (1) sphere { <1, 0, 0>, 1 } #else sphere { <2, 0, 0>, 1 } #end\n\
                   #if (0) #include \"none.inc\" sphere { <3, 0, 0>, 1 } box { 0, 1 } #end\n";
    let taken = read("povray", &format!("{CAMERA}{objects}")).unwrap();
    let centers: Vec<_> = taken.spheres.iter().map(|item| item.shape.center).collect();
    assert_eq!(centers, [DVec3::X]);
    assert_eq!(taken.notes, ["2 of #include left out: what is in other files is not read"]);
}

#[test]
fn only_a_pigment_s_one_colour_is_a_colour() {
    let color = |texture: &str| {
        let taken = read("povray", &format!("{CAMERA}sphere {{ 0, 1 {texture} }}")).unwrap();
        (taken.spheres[0].color, taken.notes.len())
    };
    assert_eq!(color("finish { ambient rgb <0, 1, 0> }"), (None, 0));
    assert_eq!(color("pigment { checker color White, color Black }"), (None, 1));
    assert_eq!(
        color("texture { pigment { colour Red } finish { ambient 1 } }"),
        (Some([255, 0, 0]), 0)
    );
    assert_eq!(color("texture { Stone }"), (None, 1));
}

/// POV-Ray's own pixels are square where +W and +H go with right and up.
#[test]
fn an_image_without_a_size_goes_with_right_and_up() {
    let size = |camera: &str| {
        let text = format!("camera {{ location <0, 0, -5> {camera} look_at 0 }}");
        let taken = read("povray", &text).unwrap();
        let (image, viewport) = (taken.camera.image, taken.camera.viewport);
        assert!((viewport.width / viewport.height - image.aspect()).abs() < 1e-9, "{camera}");
        let (w, h) = (image.width(), image.height());
        let note = format!("the scene does not say how many pixels there are: {w} × {h} taken");
        assert_eq!(taken.notes[0], note);
        (w, h)
    };
    assert_eq!(size("right x*4/3"), (400, 300));
    assert_eq!(size("right x*image_width/image_height"), (400, 400));
    assert_eq!(size("right <3, 0, 0> up <0, 2, 0> angle 60"), (600, 400));
}
