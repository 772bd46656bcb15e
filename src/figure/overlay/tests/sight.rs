//! Tests that what is drawn is in sight, and that nothing else takes room.

use pinhole_core::Orientation;

use super::*;

#[test]
fn arrows_that_are_not_drawn_take_no_room() {
    let named = Observer::new(DVec3::new(0.0, 0.0, -0.5), 0.84, 0.33, 4.0);
    let low = ViewSize::new(400.0, 160.0);
    let up = DVec3::new(1.0, 1.0, 0.0);
    let orientation = Orientation::View { view: DVec3::NEG_Z, up };
    let camera = Camera { orientation, ..Camera::CANONICAL };
    let depth = |items| {
        let scene = Scene::default();
        let drawn = drawn(&camera, &scene, items, None, None, None);
        let seen = named.framing_the_same(&drawn, low);
        let seen_from = seen.camera(400, 160).resolve().expect("observers have a basis");
        (seen_from.eye() - camera.eye).dot(seen_from.basis().w)
    };
    let without = OverlayItems::NONE.with(Item::Eye, true);
    for item in [Item::Basis, Item::ViewAndUp, Item::Axes, Item::UpCrossW] {
        let [least, with] = [without, without.with(item, true)].map(depth);
        assert!(least < with, "{item:?}: {least} and {with}");
    }
}
