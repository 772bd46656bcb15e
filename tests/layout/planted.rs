//! The rule of the floors on small trees, with one fault planted in each.

use super::floors::{circles_of_folders, faults_of_floors};
use super::uses::{Use, uses};

/// A house without fault.
const HOUSE: [(&str, &str); 16] = [
    ("src/main.rs", "fn main() { pinhole::cli::run() }"),
    (
        "src/lib.rs",
        "pub mod cli; pub mod figures; pub mod model; pub mod platform; pub mod ui; pub mod view;",
    ),
    (
        "src/core/lib.rs",
        "mod camera; mod render; pub use camera::{Camera, Lens as Glass}; pub use render::*;",
    ),
    ("src/core/camera/mod.rs", "mod lens; pub use lens::Lens; pub struct Camera;"),
    ("src/core/camera/lens.rs", "pub struct Lens;"),
    (
        "src/core/render/mod.rs",
        "mod plan; use plan::Plan; pub fn trace(_: crate::Camera) { Plan::new() }",
    ),
    ("src/core/render/plan/mod.rs", "use super::super::camera; pub struct Plan(camera::Camera);"),
    ("src/lecture/lib.rs", "use pinhole_core::Camera;"),
    ("src/exchange/lib.rs", "use pinhole_core::Glass;"),
    ("src/model/mod.rs", "pub struct Session(pinhole_core::Camera);"),
    ("src/view/mod.rs", "pub mod plot; use crate::model::Session; pub fn derive(_: Session) {}"),
    ("src/view/plot.rs", "use super::derive;"),
    ("src/figures/mod.rs", "pub fn draw() { pinhole_core::trace() }"),
    ("src/ui/mod.rs", "use crate::{figures::draw, view::{self, plot}};"),
    ("src/cli/mod.rs", "pub fn run() { crate::figures::draw() }"),
    ("src/platform/mod.rs", "use crate::ui;"),
];

/// The uses in the house where these files are added or stand in place of its own.
fn house_with(planted: &[(&str, &str)]) -> Vec<Use> {
    let is_kept = |(path, _): &&(&str, &str)| planted.iter().all(|(other, _)| other != path);
    let files = HOUSE.iter().filter(is_kept).chain(planted);
    let files: Vec<_> = files.map(|(path, text)| ((*path).into(), (*text).into())).collect();
    uses(&files)
}

fn reaching_up(planted: &[(&str, &str)]) -> Vec<String> {
    faults_of_floors(&house_with(planted))
}

fn circles(planted: &[(&str, &str)]) -> Vec<String> {
    circles_of_folders(&house_with(planted))
}

/// Asserts that a file with this text reaches up to another one from this line, and that this is all.
#[track_caller]
fn assert_reaches_up(file: &str, line: usize, text: &str, upper: &str) {
    assert_eq!(reaching_up(&[(file, text)]), [format!("{file}:{line} reaches up to {upper}")]);
}

#[test]
fn a_house_without_fault_has_none() {
    assert_eq!(reaching_up(&[]), [""; 0]);
    assert_eq!(circles(&[]), [""; 0]);
}

#[test]
fn every_use_is_found_with_its_line() {
    let found: Vec<_> = house_with(&[])
        .iter()
        .map(|Use { from, line, to }| format!("{from}:{line} {to}").replace("src/", ""))
        .collect();
    assert_eq!(
        found,
        [
            "main.rs:1 cli/mod.rs",
            "core/lib.rs:1 core/camera/mod.rs",
            "core/lib.rs:1 core/camera/lens.rs",
            "core/lib.rs:1 core/render/mod.rs",
            "core/camera/mod.rs:1 core/camera/lens.rs",
            "core/render/mod.rs:1 core/render/plan/mod.rs",
            "core/render/mod.rs:1 core/camera/mod.rs",
            "core/render/plan/mod.rs:1 core/camera/mod.rs",
            "lecture/lib.rs:1 core/camera/mod.rs",
            "exchange/lib.rs:1 core/camera/lens.rs",
            "model/mod.rs:1 core/camera/mod.rs",
            "view/mod.rs:1 model/mod.rs",
            "view/plot.rs:1 view/mod.rs",
            "figures/mod.rs:1 core/render/mod.rs",
            "ui/mod.rs:1 figures/mod.rs",
            "ui/mod.rs:1 view/mod.rs",
            "ui/mod.rs:1 view/plot.rs",
            "cli/mod.rs:1 figures/mod.rs",
            "platform/mod.rs:1 ui/mod.rs",
        ]
    );
}

#[test]
fn a_use_of_a_higher_floor_is_found() {
    let [core, lecture, exchange] = ["src/core/a.rs", "src/lecture/a.rs", "src/exchange/a.rs"];
    let [model, view, ui] = ["src/model/a.rs", "src/view/a.rs", "src/ui/a.rs"];
    assert_reaches_up(core, 1, "use pinhole_lecture::Step;", "src/lecture/lib.rs");
    assert_reaches_up(core, 1, "use pinhole_exchange as files;", "src/exchange/lib.rs");
    assert_reaches_up(lecture, 1, "use pinhole::model::Session;", "src/model/mod.rs");
    assert_reaches_up(exchange, 1, "use pinhole::model;", "src/model/mod.rs");
    assert_reaches_up(model, 1, "use crate::view::*;", "src/view/mod.rs");
    assert_reaches_up(view, 1, "use crate::{model::Session, ui::Panel};", "src/ui/mod.rs");
    assert_reaches_up(
        view,
        1,
        "pub(crate) use crate::figures::draw as paint;",
        "src/figures/mod.rs",
    );
    assert_reaches_up(view, 1, "use crate::cli::run;", "src/cli/mod.rs");
    assert_reaches_up(ui, 1, "use crate::platform;", "src/platform/mod.rs");
}

#[test]
fn a_path_in_code_is_a_use() {
    let view = "src/view/a.rs";
    assert_reaches_up(view, 2, "fn f() {\n    crate::ui::show()\n}", "src/ui/mod.rs");
    assert_reaches_up(view, 1, "fn f() -> Vec<super::super::ui::Panel<'_>> {}", "src/ui/mod.rs");
    let inside = "mod inner {\n    fn f(x: super::super::super::ui::Panel) {}\n}";
    assert_reaches_up(view, 2, inside, "src/ui/mod.rs");
    let after = "mod inner { fn f() { if x {} } }\nuse super::super::ui;";
    assert_reaches_up(view, 2, after, "src/ui/mod.rs");
    let macro_ = "macro_rules! m { () => { $crate::ui::show() } }";
    assert_reaches_up(view, 1, macro_, "src/ui/mod.rs");
    let imported = [(view, "use crate::model;\nfn f() { model::a::g() }"), ("src/model/a.rs", "")];
    let found = house_with(&imported);
    assert!(
        found.iter().any(|one| one.from == view && one.line == 2 && one.to == "src/model/a.rs")
    );
}

#[test]
fn what_lies_on_no_floor_and_the_roof_are_found() {
    let lodger = ("src/lodger/mod.rs", "use crate::model::Session;");
    assert_eq!(reaching_up(&[lodger]), ["src/lodger/mod.rs is on no floor"]);
    let thing = ("src/lib.rs", "pub struct Thing;");
    let user = ("src/view/a.rs", "fn f(_: crate::Thing) {}");
    assert_eq!(reaching_up(&[thing, user]), ["src/view/a.rs:1 reaches up to src/lib.rs"]);
}

#[test]
fn comments_texts_and_methods_are_no_uses() {
    let text = r##"
        //! [`crate::ui`] and use crate::ui::show;
        /* use crate::ui; /* crate::ui::show() */ crate::ui::show() */
        const A: &str = "\" crate::ui::show()";
        const B: &str = r#"" crate::ui::show()"#;
        const C: (char, char, char) = ('"', '\'', 'ö');
        fn f<'a>(x: &'a X) -> impl Y + use<'a> { x.ui::<A>::new(); ui::show(); std::ui::show() }
    "##;
    assert_eq!(reaching_up(&[("src/view/a.rs", text)]), [""; 0]);
}

#[test]
fn a_circle_of_two_folders_is_found() {
    assert_eq!(
        circles(&[("src/figures/a.rs", "use crate::ui::Panel;")]),
        [
            "src/figures: src/figures/a.rs:1 uses src/ui/mod.rs, src/ui/mod.rs:1 uses src/figures/mod.rs"
        ]
    );
    assert_eq!(
        circles(&[
            ("src/lecture/lib.rs", "\nuse pinhole_exchange::A;"),
            ("src/exchange/lib.rs", "\n\nuse pinhole_lecture::B;")
        ]),
        ["src/exchange: src/exchange/lib.rs:3 uses src/lecture/lib.rs, \
          src/lecture/lib.rs:2 uses src/exchange/lib.rs"]
    );
}

#[test]
fn a_circle_of_folders_inside_a_crate_is_found() {
    // By the name that the crate's root gives it.
    assert_eq!(
        circles(&[("src/core/camera/a.rs", "fn f() { crate::trace() }")]),
        ["src/core/camera: src/core/camera/a.rs:1 uses src/core/render/mod.rs, \
          src/core/render/mod.rs:1 uses src/core/camera/mod.rs"]
    );
    // By way of a third one.
    assert_eq!(
        circles(&[
            ("src/core/scene/mod.rs", "use crate::render::plan::Plan;"),
            ("src/core/camera/a.rs", "use crate::scene::Scene;")
        ]),
        ["src/core/camera: src/core/camera/a.rs:1 uses src/core/scene/mod.rs, \
          src/core/scene/mod.rs:1 uses src/core/render/plan/mod.rs, \
          src/core/render/plan/mod.rs:1 uses src/core/camera/mod.rs"]
    );
}

#[test]
fn a_folder_names_its_parts_and_no_other_file_of_it_does() {
    let part = ("src/view/plot/axis.rs", "use super::super::derive;");
    let page = ("src/view/mod.rs", "mod plot; pub use plot::axis::Axis; pub fn derive() {}");
    assert_eq!(circles(&[part, page]), [""; 0]);
    assert_eq!(
        circles(&[
            ("src/view/plot/axis.rs", "use super::super::a::line;"),
            ("src/view/a.rs", "use super::plot::axis::Axis;"),
        ]),
        ["src/view/a.rs: src/view/a.rs:1 uses src/view/plot/axis.rs, \
          src/view/plot/axis.rs:1 uses src/view/a.rs"]
    );
}
