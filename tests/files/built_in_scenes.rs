//! The built-in scenes show what their notes say.

use pinhole_core::{Basis, DVec2, DVec3, Orientation, Selection};
use pinhole_exchange::document::Document;
use pinhole_exchange::scenes::BuiltinScene;
use pinhole_figure::inspection::Inspection;

fn inspect(name: &str, uv: [f64; 2]) -> (Document, Inspection) {
    let document = BuiltinScene::find(name).unwrap().load().unwrap();
    let camera = document.camera.resolve().unwrap();
    let inspection =
        Inspection::new(&camera, &document.scene().unwrap(), Selection::Uv(DVec2::from_array(uv)));
    (document, inspection)
}

#[test]
fn built_in_scenes_show_what_their_notes_say() {
    let first = |name, uv| {
        let (document, inspection) = inspect(name, uv);
        inspection.first_hit().map(|hit| (document.name_of(hit.object).map(str::to_owned), hit.t))
    };
    let hit = |name: &str, t: f64| Some((Some(name.to_owned()), t));
    assert_eq!(first("canonical", [0.2, -0.1]), hit("back wall", 6.0));
    assert_eq!(first("canonical", [0.0, 0.0]), hit("ball", 4.0));
    assert_eq!(first("distance-two", [0.2, -0.1]), hit("back wall", 3.0));
    assert_eq!(first("grazing", [0.0, 0.0]), hit("upper ball", 5.0));
    assert_eq!(first("inside", [0.0, 0.0]), hit("room", 5.0));
    assert_eq!(first("tiny-far", [0.0, 0.0]), hit("missed speck", 999.0));
    assert_eq!(first("look-at", [0.0, 0.0]).unwrap().0.as_deref(), Some("target"));

    let (_, grazing) = inspect("grazing", [0.0, 0.0]);
    let touches: Vec<(u32, f64)> = grazing.roots.iter().map(|r| (r.object, r.t)).collect();
    assert_eq!(touches, [(0, 5.0), (1, 5.0), (2, 8.0)]);

    let (_, inside) = inspect("inside", [0.0, 0.0]);
    assert_eq!(inside.roots[0].t, -3.0);

    let basis = inspect("look-at", [0.0, 0.0]).0.camera.basis().unwrap();
    let (u, w) =
        (DVec3::new(5.0, 0.0, -7.0) / 74f64.sqrt(), DVec3::new(21.0, 4.0, 15.0) / 682f64.sqrt());
    assert!(basis.u.distance(u) < 1e-15 && basis.w.distance(w) < 1e-15);

    let angle = inspect("almost-parallel-up", [0.0, 0.0]).0.camera.up_angle().unwrap();
    assert!(angle.conditioning > 100.0, "{angle:?}");

    let (forty_five, _) = inspect("forty-five", [0.0, 0.0]);
    let s = 0.5f64.sqrt();
    let Orientation::Basis(Basis { u, w, .. }) = forty_five.camera.orientation else {
        panic!("{:?}", forty_five.camera.orientation);
    };
    assert_eq!((u, w), (DVec3::new(s, 0.0, -s), DVec3::new(s, 0.0, s)));
}
