//! Objects that are edited among many: the scene is changed in place, and looks as if made anew.

use std::collections::HashSet;
use std::path::PathBuf;
use std::sync::Arc;

use pinhole::model::session::{Session, Setup, Shown};
use pinhole::view::adaptive_resolution::Subsampling;
use pinhole::view::derive::{Derived, Deriver, Purpose, ViewSizes};
use pinhole_core::{Camera, DVec3, NO_OBJECT, Plane, Scene, Shade, Sphere};
use pinhole_exchange::csv;
use pinhole_exchange::document::{CsvSpheres, Document, Item};
use pinhole_figure::observer::Observer;
use pinhole_figure::overlay::Style;
use pinhole_figure::overlay_items::OverlayItems;

const SIZES: ViewSizes = ViewSizes {
    covered: [None; 4],
    world: Some([120, 90]),
    camera: Some([100, 80]),
    second: None,
    scale: 1.0,
    style: Style::Light,
    purpose: Purpose::Window,
    subsampling: Subsampling::NONE,
    under_hand: false,
};

fn ball(x: f64, y: f64, z: f64, radius: f64) -> Sphere {
    Sphere { center: DVec3::new(x, y, z), radius }
}

/// 2,000 spheres from a file in front of the camera, two by hand, and a wall behind all.
fn document() -> Document {
    let part = |i: usize, by: f64| (i as f64 * by).fract() - 0.5;
    let pebble = |i| {
        let (x, y, z) = (part(i, 0.618_034), part(i, 0.754_878), part(i, 0.569_840));
        format!("{},{},{},0.05\n", 6.0 * x, 6.0 * y, 4.0 * z - 6.0)
    };
    let table = "x,y,z,r\n".to_owned() + &(1..=2000).map(pebble).collect::<String>();
    let (path, file) = ("pebbles.csv".to_owned(), PathBuf::from("pebbles.csv"));
    let items = Arc::new(csv::spheres(&file, table.as_bytes()).unwrap());
    Document {
        camera: Camera::CANONICAL,
        spheres: vec![
            Item::plain(ball(0.0, 0.0, -3.0, 0.5)),
            Item::plain(ball(1.0, 0.0, -4.0, 0.5)),
        ]
        .into(),
        csv_spheres: Some(CsvSpheres { path, file, stamp: None, count: 2000, items }),
        planes: vec![Item::plain(Plane { point: DVec3::new(0.0, 0.0, -9.0), normal: DVec3::Z })]
            .into(),
        ..Document::default()
    }
}

fn session(shade: Shade) -> Session {
    let shown = Shown {
        observer: Some(Observer::new(DVec3::new(0.0, 0.0, -3.0), 0.5, 0.3, 12.0)),
        setup: Setup { shade, ..Setup::default() },
        ..Shown::default()
    };
    Session { shown, ..Session::default() }
}

/// What is shown, of which a picture alone is compared by its pixels.
#[track_caller]
fn assert_same(found: &Derived, expected: &Derived, what: &str) {
    let pixels = |derived: &Derived| {
        [&derived.camera_view, &derived.world_view].map(|v| v.clone().unwrap().image.pixels.clone())
    };
    assert!(pixels(found) == pixels(expected), "{what}: other pixels");
    assert_eq!(found.scene, expected.scene, "{what}");
    assert_eq!(found.inspection, expected.inspection, "{what}");
}

/// What an edit is called, and what it does.
type Edit = (&'static str, fn(&mut Document));

/// Derives each edited document from the one before, and anew, and compares.
fn follow(document: &Document, edits: &[Edit]) {
    for shade in [Shade::Lambert, Shade::Object] {
        let (mut document, mut deriver, session) =
            (document.clone(), Deriver::default(), session(shade));
        deriver.derive(&document, &session, &SIZES);
        for (what, edit) in edits {
            edit(&mut document);
            let found = deriver.derive(&document, &session, &SIZES);
            assert_same(&found, &Deriver::default().derive(&document, &session, &SIZES), what);
        }
    }
}

#[test]
fn a_scene_that_follows_edits_looks_as_if_made_anew() {
    follow(
        &document(),
        &[
            ("moved", |d| d.spheres[1].shape.center.x = -1.0),
            ("again", |d| d.spheres[1].shape.center.y = 0.7),
            ("shrunk", |d| d.spheres[0].shape.radius = 0.01),
            ("plane moved", |d| d.planes[0].shape.point.z = -5.0),
            ("plane turned", |d| d.planes[0].shape.normal.x = 0.5),
            ("named", |d| d.spheres[0].name = Some("ball".to_owned())),
            ("coloured", |d| d.spheres[1].color = Some([1, 2, 3])),
            ("plane coloured", |d| d.planes[0].color = Some([250, 9, 9])),
            ("both", |d| {
                d.spheres[0].shape.radius = 0.4;
                d.spheres[0].color = Some([200, 0, 0]);
            }),
            ("one more", |d| d.spheres.push(Item::plain(ball(0.0, 1.0, -3.0, 0.3)))),
            ("one less", |d| drop(d.spheres.remove(0))),
            ("no file", |d| d.csv_spheres = None),
        ],
    );
}

#[test]
fn spheres_around_the_camera_are_edited_unseen_by_the_observer() {
    follow(
        &document(),
        &[
            ("around", |d| d.spheres[0].shape = ball(0.1, 0.0, 0.0, 1.0)),
            ("larger", |d| d.spheres[0].shape.radius = 1.5),
            ("another moves", |d| d.spheres[1].shape.center.x = 0.5),
            ("two around", |d| d.spheres[1].shape = ball(0.0, 0.1, 0.0, 0.7)),
            ("the other one", |d| d.spheres[0].shape = ball(0.0, 0.0, -3.0, 0.5)),
            ("none", |d| d.spheres[1].shape = ball(1.0, 0.0, -4.0, 0.5)),
        ],
    );
}

#[test]
fn a_dragged_sphere_is_replaced_in_place_where_nobody_holds_the_scene() {
    let (mut document, mut deriver) = (document(), Deriver::default());
    let session = session(Shade::Lambert);
    let address = |derived: &Derived| derived.scene.as_ref().unwrap().spheres().as_ptr();
    let mut derived = deriver.derive(&document, &session, &SIZES);
    let first = address(&derived);
    for step in 1..4 {
        document.spheres[0].shape.center.x = 0.1 * f64::from(step);
        derived.scene = None;
        derived = deriver.derive(&document, &session, &SIZES);
        assert_eq!(address(&derived), first, "a million spheres would have been copied");
    }
    let held: Arc<Scene> = derived.scene.clone().unwrap();
    document.spheres[0].shape.center.x = 2.0;
    let derived = deriver.derive(&document, &session, &SIZES);
    assert_eq!(held.spheres()[0].center.x, 0.1 * 3.0, "what is held stays as it is");
    assert_eq!(derived.scene.unwrap().spheres()[0].center.x, 2.0);
}

#[test]
fn only_what_an_edit_changes_is_done_again() {
    let (mut document, mut deriver) = (document(), Deriver::default());
    let session = session(Shade::Lambert);
    let before = deriver.derive(&document, &session, &SIZES).camera_view.unwrap().image;
    let traced = deriver.traced();
    document.spheres[0].name = Some("ball".to_owned());
    let named = deriver.derive(&document, &session, &SIZES).camera_view.unwrap().image;
    assert!(Arc::ptr_eq(&named, &before), "a name is no picture's business");
    document.spheres[0].color = Some([1, 2, 3]);
    let colored = deriver.derive(&document, &session, &SIZES).camera_view.unwrap().image;
    assert_ne!(colored, before, "another colour is seen");
    assert_eq!(deriver.traced(), traced, "and nothing is traced for it");
    document.spheres[0].shape.radius = 0.6;
    deriver.derive(&document, &session, &SIZES);
    assert_eq!(deriver.traced(), traced + 2, "another shape is, in both views");
}

#[test]
fn a_fault_among_many_keeps_the_last_good_scene() {
    let (mut document, mut deriver) = (document(), Deriver::default());
    let session = session(Shade::Lambert);
    let good = deriver.derive(&document, &session, &SIZES);
    let traced = deriver.traced();
    (document.spheres[0].shape.center.x, document.spheres[1].shape.radius) = (9.0, 0.0);
    let faulty = deriver.derive(&document, &session, &SIZES);
    assert_eq!(faulty.fault.unwrap().to_string(), document.scene().unwrap_err().to_string());
    assert!(faulty.scene.is_none());
    document.spheres[0].shape.center.x = 0.0;
    document.spheres[1].shape.radius = 0.5;
    let again = deriver.derive(&document, &session, &SIZES);
    assert_same(&again, &good, "good again");
    assert_eq!(deriver.traced(), traced, "nothing has changed since");
}

#[test]
fn balls_have_smooth_borders_in_the_world_view_and_their_own_pixels_in_the_camera_view() {
    let spheres = vec![Item::plain(ball(0.0, 0.0, -5.0, 1.0))].into();
    let document = Document { spheres, ..Document::default() };
    let mut session = session(Shade::Object);
    session.shown.setup.items = OverlayItems::NONE;
    let ground = Style::Light.colors().background;
    for purpose in [Purpose::Window, Purpose::Figure { clear: false }] {
        let sizes = ViewSizes { purpose, ..SIZES };
        let shown = Deriver::default().derive(&document, &session, &sizes);
        let (frame, world) = (shown.world_frame.unwrap(), shown.world_view.unwrap());
        let beside = frame.object.iter().zip(&world.image.pixels);
        let mixed = beside.filter(|(object, dot)| **object == NO_OBJECT && **dot != ground);
        assert!(mixed.count() > 20, "{purpose:?}");
        let camera = shown.camera_view.unwrap();
        let colors: HashSet<_> = camera.image.pixels.iter().collect();
        assert_eq!(colors.len(), 2, "{purpose:?}");
    }
}
