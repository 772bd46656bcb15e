//! Tests that the spheres which [`Scene::certificate_of`] skips would not change the certificate.

use super::cloud;
use crate::camera::Camera;
use crate::camera::viewport::Pixel;
use crate::exact::steps::Steps;
use crate::scene::Scene;
use crate::scene::certificate::{Certificate, certificate_among};
use crate::scene::objects_from_origin::ObjectsFromOrigin;

#[test]
fn spheres_that_are_passed_by_have_the_most_to_spare() {
    let camera = Camera { eye: glam::DVec3::splat(50.0), ..Camera::CANONICAL };
    let camera = camera.resolve().unwrap();
    let mut below = 0;
    for radii in [(-5.0, -3.0), (-2.0, 0.0), (-1.0, 1.0)] {
        let scene = Scene::new(cloud(1000, radii), vec![]).unwrap();
        for k in 0..100 {
            let ray = camera.exact_ray(Pixel { row: 7 * k % 400, column: 11 * k % 400 });
            let certificate = scene.certificate_of(&ray);
            let objects = ObjectsFromOrigin::for_many_rays(&scene, ray.origin());
            let first = objects.first_hit(&ray, &mut Steps::default());
            let of_all = certificate_among(&objects, &ray, first.as_ref(), 0..1000);
            assert_eq!(certificate, of_all);
            below += usize::from(certificate.margin < Certificate::MOST);
        }
    }
    assert!((50..250).contains(&below), "{below}");
}
