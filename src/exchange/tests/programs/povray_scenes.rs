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
fn the_last_camera_is_taken_and_must_stand_by_itself() {
    let (a, b) = (camera(20), camera(80));
    for (text, degrees) in [
        (format!("{b}{a}"), 20.0),
        (format!("{a} /* {b} /* {b} */ {b} */"), 20.0),
        (format!("#debug \"/*\"\n// /*\n{a} // \" */"), 20.0),
        (format!("#declare A = {a} #declare B = {b} camera {{ A }}"), 20.0),
        (format!("#declare A = {a}#declare B = camera {{ A }} camera {{ B }}"), 20.0),
        (
            format!("#declare A = {a}#declare A = camera {{ A }} #declare B = {b} camera {{ A }}"),
            20.0,
        ),
        (format!("#ifdef (Wide)\n{a}#end\n{b}"), 80.0),
        (format!("#if (1) #if (0) #else #end #end {b}"), 80.0),
    ] {
        assert_eq!(degrees_of(&text), (degrees, Vec::new()), "{text}");
    }
    let lonely = "camera: it must stand by itself, not between #if, #while, #for, #switch or #macro and #end";
    for (text, said) in [
        (format!("#if (1) {a}#end"), lonely),
        (format!("{b}#if (clock > 1) {a}#else {b}#end"), lonely),
        (format!("{a}#switch (1) #case (1) {b} #end"), lonely),
        (format!("#if (1)\n#declare A = {a}#else\n#declare A = {b}#end camera {{ A }}"), lonely),
        (
            format!("#declare A = {a}camera {{ A angle 30 }}"),
            "camera is A: what is added to it must stand in its declaration",
        ),
        (
            format!("#declare A = {a}#declare B = camera {{ A angle 30 }} camera {{ B }}"),
            "camera is A: what is added to it must stand in its declaration",
        ),
        (
            format!("#if (1) #declare A = {a}#end #declare B = camera {{ A }} camera {{ B }}"),
            lonely,
        ),
        (
            "camera { Mine }".to_owned(),
            "camera is Mine: it must begin with a word such as location, or be a name that is declared \
             before it in this file as = camera { ... }",
        ),
        (
            format!("#declare B = camera {{ A }} #declare A = {a}camera {{ B }}"),
            "camera is A: it must begin with a word such as location, or be a name that is declared \
             before it in this file as = camera { ... }",
        ),
        (
            "camera { location 0 #if (Wide) angle 80 #end look_at z }".to_owned(),
            "camera is if: no directive must stand in it",
        ),
    ] {
        assert_eq!(read("povray", &text).unwrap_err().problem, said, "{text}");
    }
}

#[test]
fn objects_under_conditions_and_in_other_files_are_told() {
    let objects = "#include \"colors.inc\"\n#include \"room.inc\"\n#include \"lamp.pov\"\n\
                   #if (1) sphere { <1, 0, 0>, 1 } #else sphere { <2, 0, 0>, 1 } #end\n\
                   sphere { <3, 0, 0>, 1 }\n";
    let taken = read("povray", &format!("{CAMERA}{objects}")).unwrap();
    let centers: Vec<_> = taken.spheres.iter().map(|item| item.shape.center).collect();
    assert_eq!(centers, [3.0 * DVec3::X]);
    assert_eq!(
        taken.notes,
        [
            "2 of #include left out: what is in other files is not read",
            "what stands between #if, #while, #for, #switch or #macro and #end is left out"
        ]
    );
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

#[test]
fn commas_between_numbers_may_be_left_out() {
    let text = |comma: &str| {
        let vector = |numbers: [&str; 3]| format!("<{}>", numbers.join(comma));
        format!(
            "camera {{ location {} right -x up y look_at {} }}\n\
             sphere {{ {}, 2 pigment {{ color rgb {} }} }} // +W10 +H10\n",
            vector(["1", "2*(3 - 1)", "5"]),
            vector(["0.5", "x.x", "0"]),
            vector(["1", "2", "3"]),
            vector(["1", "0", "0"]),
        )
    };
    let [with, without] = [", ", " "].map(|comma| read("povray", &text(comma)).unwrap());
    assert_eq!(without.camera, with.camera);
    assert_eq!(without.camera.eye, DVec3::new(1.0, 4.0, 5.0));
    assert_eq!(without.spheres, with.spheres);
    assert_eq!(without.spheres[0].color, Some([255, 0, 0]));
    // 1 -2 is one number, as it is for POV-Ray.
    let refused = read("povray", "camera { location <1 -2 3> }").unwrap_err();
    let said = "location is <1 -2 3>: it must be a vector of numbers, as <1, 2, 3>";
    assert_eq!(refused.problem, said);
}

#[test]
fn a_look_at_without_a_direction_is_told() {
    for (camera, said) in [
        (
            "location <1, 2, 3> look_at <1, 2, 3>",
            "look_at is <1, 2, 3>: it must be another point than location",
        ),
        ("sky 0 look_at z", "look_at is z: sky must not be <0, 0, 0>"),
    ] {
        let refused = read("povray", &format!("camera {{ {camera} }}")).unwrap_err();
        assert_eq!(refused.problem, said);
    }
}

/// POV-Ray 3.7 shows +x on the right both times, and +z above and below.
#[test]
fn straight_along_sky_the_picture_goes_with_right() {
    let along = "look_at lies straight along sky: right is taken as it is given, as POV-Ray does";
    for (right, z_in_picture) in [("x", 1.0), ("-x", -1.0)] {
        let text = format!(
            "camera {{ location 9*y right {right} up y look_at 0 }}\n\
             sphere {{ 2*x, 1 }} sphere {{ 2*z, 1 }} // +W40 +H40"
        );
        let taken = read("povray", &text).unwrap();
        assert!(taken.notes.contains(&along.to_owned()), "{:?}", taken.notes);
        let camera = taken.camera.resolve().unwrap();
        let uv = |k: usize| camera.project(taken.spheres[k].shape.center).uv * 4.5;
        assert_eq!([uv(0).to_array(), uv(1).to_array()], [[1.0, 0.0], [0.0, z_in_picture]]);
    }
    // However near it is, any other has a roll.
    let near = read("povray", "camera { look_at <1e-9, 9, 0> }").unwrap();
    assert!(!near.notes.contains(&along.to_owned()));
    let refused = read("povray", "camera { look_at y right x + y }").unwrap_err().problem;
    assert!(refused.starts_with("camera is no rotation: "), "{refused}");
}
