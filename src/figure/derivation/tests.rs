use expect_test::{Expect, expect};
use pinhole_core::{DVec2, DVec3, Orientation, Pixel};
use pinhole_exchange::scenes::SceneSource;
use pinhole_lecture::numbers::Rounding;

use super::*;

/// Returns the document of a built-in scene.
fn document(scene: &str) -> Document {
    SceneSource::from_argument(scene.as_ref()).expect("a scene").load().expect("a document")
}

fn derive(document: &Document, selection: Selection, digits: usize, from_one: bool) -> Derivation {
    let rounding = Rounding::Significant(digits);
    derive_as(document, selection, (rounding, true), from_one)
}

/// Returns the derivation with exact forms or without them.
fn derive_as(
    document: &Document,
    selection: Selection,
    (rounding, exact): (Rounding, bool),
    from_one: bool,
) -> Derivation {
    let resolved = document.camera.resolve();
    let scene = document.scene();
    let inspection = resolved.as_ref().ok().zip(scene.as_ref().ok());
    let inspection =
        inspection.map(|(resolved, scene)| Inspection::new(resolved, scene, selection));
    let fault = match (&resolved, &scene) {
        (Err(e), _) => Some(Fault::Camera(*e)),
        (_, Err(e)) => Some(Fault::Scene(*e)),
        _ => None,
    };
    derivation(&DerivationInputs {
        document,
        resolved: resolved.as_ref().ok(),
        scene: scene.as_ref().ok(),
        inspection: inspection.as_ref(),
        settings: DerivationSettings {
            selection,
            sections: DerivationSections::default(),
            numbers: NumberFormat { rounding, exact, from_one },
            fault,
            t: None,
            by_coordinate: false,
        },
    })
}

const WARM_UP: Selection = Selection::Uv(DVec2::new(0.2, -0.1));

fn check(document: &Document, selection: Selection, expected: Expect) {
    expected.assert_eq(&derive(document, selection, 5, false).to_string());
}

#[test]
fn the_canonical_camera() {
    check(
        &document("canonical"),
        WARM_UP,
        expect![[r#"
            Basis
              eye = (0, 0, 0)
              at = (0, 0, −5)
              up = (0, 1, 0)
              view = at − eye = (0, 0, −5) − (0, 0, 0) = (0, 0, −5)
              −view = (0, 0, 5)
              𝐰 = normalize(−view) = (0, 0, 5)/5 = (0, 0, 1)
              up × 𝐰 = (0, 1, 0) × (0, 0, 1) = (1, 0, 0)
              |up × 𝐰| = |up| sin(angle) = 1 · sin(90°) = 1
              𝐮 = normalize(up × 𝐰) = (1, 0, 0)/1 = (1, 0, 0)
              𝐯 = 𝐰 × 𝐮 = (0, 0, 1) × (1, 0, 0) = (0, 1, 0)

            Pixel to ray
              distance = 1
              (u, v) = (0.2, −0.1); the corner of four pixels, no pixel's centre
              u 𝐮 = 0.2 (1, 0, 0) = (0.2, 0, 0)
              v 𝐯 = −0.1 (0, 1, 0) = (0, −0.1, 0)
              −distance 𝐰 = −1 (0, 0, 1) = (0, 0, −1)
              𝐝 = u 𝐮 + v 𝐯 − distance 𝐰 = (0.2, 0, 0) + (0, −0.1, 0) + (0, 0, −1) = (0.2, −0.1, −1)
              |𝐝| = √105/10; the distance per unit of t
              𝐩 + t 𝐝 = (0, 0, 0) + t (0.2, −0.1, −1); 𝐩 = eye; t = 1 is on the viewport

            ball
              centre = (0, 0, −5)
              r = 1
              |𝐱 − centre|² = r²; implicit: 𝐱 is on the sphere
              |𝐩 + t 𝐝 − centre|² = r²; the ray put in
              |(0, 0, 0) + t (0.2, −0.1, −1) − (0, 0, −5)|² = 1²
              t² 𝐝 · 𝐝 + 2 t 𝐝 · (𝐩 − centre) + |𝐩 − centre|² = r²; multiplied out
              a t² + 2 b t + c = 0; sorted by t
              𝐩 − centre = (0, 0, 0) − (0, 0, −5) = (0, 0, 5)
              a = 𝐝 · 𝐝 = (0.2, −0.1, −1) · (0.2, −0.1, −1) = 1.05
              b = 𝐝 · (𝐩 − centre) = (0.2, −0.1, −1) · (0, 0, 5) = −5
              c = |𝐩 − centre|² − r² = |(0, 0, 5)|² − 1² = 24
              1.05 t² − 10 t + 24 = 0
              t = (−2 b ∓ √((2 b)² − 4 a c))/(2 a) = (−b ∓ √D)/a; every factor 2 cancels: b is half the coefficient of t
              D = b² − a c = (−5)² − 1.05 · 24 = −0.2; D < 0: the line passes by

            marble
              centre = (−1.2, 0.9, −4)
              r = 0.5
              |𝐱 − centre|² = r²; implicit: 𝐱 is on the sphere
              |𝐩 + t 𝐝 − centre|² = r²; the ray put in
              |(0, 0, 0) + t (0.2, −0.1, −1) − (−1.2, 0.9, −4)|² = 0.5²
              t² 𝐝 · 𝐝 + 2 t 𝐝 · (𝐩 − centre) + |𝐩 − centre|² = r²; multiplied out
              a t² + 2 b t + c = 0; sorted by t
              𝐩 − centre = (0, 0, 0) − (−1.2, 0.9, −4) = (1.2, −0.9, 4)
              a = 𝐝 · 𝐝 = (0.2, −0.1, −1) · (0.2, −0.1, −1) = 1.05
              b = 𝐝 · (𝐩 − centre) = (0.2, −0.1, −1) · (1.2, −0.9, 4) = −3.67
              c = |𝐩 − centre|² − r² = |(1.2, −0.9, 4)|² − 0.5² = 18
              1.05 t² − 7.34 t + 18 = 0
              t = (−2 b ∓ √((2 b)² − 4 a c))/(2 a) = (−b ∓ √D)/a; every factor 2 cancels: b is half the coefficient of t
              D = b² − a c = (−3.67)² − 1.05 · 18 = −5.4311; D < 0: the line passes by

            back wall
              point = (0, 0, −6)
              𝐧 = (0, 0, 1)
              𝐧 · (𝐱 − point) = 0; implicit: 𝐱 is on the plane
              𝐧 · (𝐩 + t 𝐝 − point) = 0; the ray put in
              (0, 0, 1) · ((0, 0, 0) + t (0.2, −0.1, −1) − (0, 0, −6)) = 0
              t (𝐧 · 𝐝) = 𝐧 · (point − 𝐩); multiplied out
              𝐧 · 𝐝 = (0, 0, 1) · (0.2, −0.1, −1) = −1
              𝐧 · (point − 𝐩) = (0, 0, 1) · ((0, 0, −6) − (0, 0, 0)) = −6
              t = (𝐧 · (point − 𝐩))/(𝐧 · 𝐝) = −6/(−1) = 6; first hit (smallest t > 0)
              hit = 𝐩 + t 𝐝 = (0, 0, 0) + 6 (0.2, −0.1, −1) = (1.2, −0.6, −6)
              normal = 𝐧/|𝐧| = (0, 0, 1)
        "#]],
    );
}

#[test]
fn a_pixel_of_the_look_at_camera() {
    check(
        &document("look-at"),
        Selection::Pixel(Pixel { row: 99, column: 199 }),
        expect![[r#"
            Basis
              eye = (20, 4, 10)
              at = (−1, 0, −5)
              up = (0, 1, 0)
              view = at − eye = (−1, 0, −5) − (20, 4, 10) = (−21, −4, −15)
              −view = (21, 4, 15)
              𝐰 = normalize(−view) = (21, 4, 15)/√682
              up × 𝐰 = (0, 1, 0) × (21, 4, 15)/√682 = (15, 0, −21)/√682
              |up × 𝐰| = |up| sin(angle) ≈ 1 · sin(81.189°) ≈ 0.9882
              𝐮 = normalize(up × 𝐰) = (5, 0, −7)/√74
              𝐯 = 𝐰 × 𝐮 = (21, 4, 15)/√682 × (5, 0, −7)/√74 ≈ (−0.12464, 0.9882, −0.089027)

            Pixel to ray
              width = 1, height = 1
              W = 400, H = 400; pixels
              distance = 1
              row i = 99, column j = 199; counted from 0
              u = width ((j + 0.5)/W − 0.5) = 1 ((199 + 0.5)/400 − 0.5) = −0.00125
              v = height (0.5 − (i + 0.5)/H) = 1 (0.5 − (99 + 0.5)/400) = 0.25125
              u 𝐮 = −0.00125 (5, 0, −7)/√74 ≈ (−0.00072655, 0, 0.0010172)
              v 𝐯 ≈ 0.25125 (−0.12464, 0.9882, −0.089027) ≈ (−0.031315, 0.24829, −0.022368)
              −distance 𝐰 = −1 (21, 4, 15)/√682 = (−21, −4, −15)/√682
              𝐝 = u 𝐮 + v 𝐯 − distance 𝐰 ≈ (−0.00072655, 0, 0.0010172) + (−0.031315, 0.24829, −0.022368) + (−21, −4, −15)/√682 ≈ (−0.83617, 0.095117, −0.59573)
              |𝐝| ≈ 1.0311; the distance per unit of t
              𝐩 + t 𝐝 ≈ (20, 4, 10) + t (−0.83617, 0.095117, −0.59573); 𝐩 = eye; t = 1 is on the viewport

            target
              centre = (−1, 0, −5)
              r = 3
              |𝐱 − centre|² = r²; implicit: 𝐱 is on the sphere
              |𝐩 + t 𝐝 − centre|² = r²; the ray put in
              |(20, 4, 10) + t (−0.83617, 0.095117, −0.59573) − (−1, 0, −5)|² ≈ 3²
              t² 𝐝 · 𝐝 + 2 t 𝐝 · (𝐩 − centre) + |𝐩 − centre|² = r²; multiplied out
              a t² + 2 b t + c = 0; sorted by t
              𝐩 − centre = (20, 4, 10) − (−1, 0, −5) = (21, 4, 15)
              a = 𝐝 · 𝐝 ≈ (−0.83617, 0.095117, −0.59573) · (−0.83617, 0.095117, −0.59573) ≈ 1.0631
              b = 𝐝 · (𝐩 − centre) ≈ (−0.83617, 0.095117, −0.59573) · (21, 4, 15) ≈ −√682
              c = |𝐩 − centre|² − r² = |(21, 4, 15)|² − 3² = 673
              1.0631 t² − 2 √682 t + 673 ≈ 0
              t = (−2 b ∓ √((2 b)² − 4 a c))/(2 a) = (−b ∓ √D)/a; every factor 2 cancels: b is half the coefficient of t
              D = b² − a c ≈ (−√682)² − 1.0631 · 673 ≈ −33.485; D < 0: the line passes by

            left
              centre = (−9, −1, 3)
              r = 2
              |𝐱 − centre|² = r²; implicit: 𝐱 is on the sphere
              |𝐩 + t 𝐝 − centre|² = r²; the ray put in
              |(20, 4, 10) + t (−0.83617, 0.095117, −0.59573) − (−9, −1, 3)|² ≈ 2²
              t² 𝐝 · 𝐝 + 2 t 𝐝 · (𝐩 − centre) + |𝐩 − centre|² = r²; multiplied out
              a t² + 2 b t + c = 0; sorted by t
              𝐩 − centre = (20, 4, 10) − (−9, −1, 3) = (29, 5, 7)
              a = 𝐝 · 𝐝 ≈ (−0.83617, 0.095117, −0.59573) · (−0.83617, 0.095117, −0.59573) ≈ 1.0631
              b = 𝐝 · (𝐩 − centre) ≈ (−0.83617, 0.095117, −0.59573) · (29, 5, 7) ≈ −27.944
              c = |𝐩 − centre|² − r² = |(29, 5, 7)|² − 2² = 911
              1.0631 t² − 55.887 t + 911 ≈ 0
              t = (−2 b ∓ √((2 b)² − 4 a c))/(2 a) = (−b ∓ √D)/a; every factor 2 cancels: b is half the coefficient of t
              D = b² − a c ≈ (−27.944)² − 1.0631 · 911 ≈ −187.67; D < 0: the line passes by

            right
              centre = (4, −1.5, −12)
              r = 1.5
              |𝐱 − centre|² = r²; implicit: 𝐱 is on the sphere
              |𝐩 + t 𝐝 − centre|² = r²; the ray put in
              |(20, 4, 10) + t (−0.83617, 0.095117, −0.59573) − (4, −1.5, −12)|² ≈ 1.5²
              t² 𝐝 · 𝐝 + 2 t 𝐝 · (𝐩 − centre) + |𝐩 − centre|² = r²; multiplied out
              a t² + 2 b t + c = 0; sorted by t
              𝐩 − centre = (20, 4, 10) − (4, −1.5, −12) = (16, 5.5, 22)
              a = 𝐝 · 𝐝 ≈ (−0.83617, 0.095117, −0.59573) · (−0.83617, 0.095117, −0.59573) ≈ 1.0631
              b = 𝐝 · (𝐩 − centre) ≈ (−0.83617, 0.095117, −0.59573) · (16, 5.5, 22) ≈ −25.962
              c = |𝐩 − centre|² − r² = |(16, 5.5, 22)|² − 1.5² = 768
              1.0631 t² − 51.923 t + 768 ≈ 0
              t = (−2 b ∓ √((2 b)² − 4 a c))/(2 a) = (−b ∓ √D)/a; every factor 2 cancels: b is half the coefficient of t
              D = b² − a c ≈ (−25.962)² − 1.0631 · 768 ≈ −142.47; D < 0: the line passes by

            near
              centre = (9, −2, 3)
              r = 1
              |𝐱 − centre|² = r²; implicit: 𝐱 is on the sphere
              |𝐩 + t 𝐝 − centre|² = r²; the ray put in
              |(20, 4, 10) + t (−0.83617, 0.095117, −0.59573) − (9, −2, 3)|² ≈ 1²
              t² 𝐝 · 𝐝 + 2 t 𝐝 · (𝐩 − centre) + |𝐩 − centre|² = r²; multiplied out
              a t² + 2 b t + c = 0; sorted by t
              𝐩 − centre = (20, 4, 10) − (9, −2, 3) = (11, 6, 7)
              a = 𝐝 · 𝐝 ≈ (−0.83617, 0.095117, −0.59573) · (−0.83617, 0.095117, −0.59573) ≈ 1.0631
              b = 𝐝 · (𝐩 − centre) ≈ (−0.83617, 0.095117, −0.59573) · (11, 6, 7) ≈ −12.797
              c = |𝐩 − centre|² − r² = |(11, 6, 7)|² − 1² = 205
              1.0631 t² − 25.595 t + 205 ≈ 0
              t = (−2 b ∓ √((2 b)² − 4 a c))/(2 a) = (−b ∓ √D)/a; every factor 2 cancels: b is half the coefficient of t
              D = b² − a c ≈ (−12.797)² − 1.0631 · 205 ≈ −54.17; D < 0: the line passes by

            floor
              point = (0, −3, 0)
              𝐧 = (0, 1, 0)
              𝐧 · (𝐱 − point) = 0; implicit: 𝐱 is on the plane
              𝐧 · (𝐩 + t 𝐝 − point) = 0; the ray put in
              (0, 1, 0) · ((20, 4, 10) + t (−0.83617, 0.095117, −0.59573) − (0, −3, 0)) ≈ 0
              t (𝐧 · 𝐝) = 𝐧 · (point − 𝐩); multiplied out
              𝐧 · 𝐝 ≈ (0, 1, 0) · (−0.83617, 0.095117, −0.59573) ≈ 0.095117
              𝐧 · (point − 𝐩) = (0, 1, 0) · ((0, −3, 0) − (20, 4, 10)) = −7
              t = (𝐧 · (point − 𝐩))/(𝐧 · 𝐝) ≈ −7/0.095117 ≈ −73.593; behind the eye: no hit
        "#]],
    );
}

#[test]
fn the_lectures_forty_five_degrees() {
    check(
        &document("forty-five"),
        WARM_UP,
        expect![[r#"
            Basis
              eye = (0, 0, 0)
              𝐮 = (1/√2, 0, −1/√2); set by hand
              𝐯 = (0, 1, 0); set by hand
              𝐰 = (1/√2, 0, 1/√2); set by hand
              |𝐮| = |𝐯| = |𝐰| = 1; of length 1
              𝐮 · 𝐯 = 𝐯 · 𝐰 = 𝐰 · 𝐮 = 0; perpendicular
              (𝐮 × 𝐯) · 𝐰 = 1; right-handed

            Pixel to ray
              distance = 1
              (u, v) = (0.2, −0.1); the corner of four pixels, no pixel's centre
              u 𝐮 = 0.2 (1/√2, 0, −1/√2) = (√2/10, 0, −√2/10)
              v 𝐯 = −0.1 (0, 1, 0) = (0, −0.1, 0)
              −distance 𝐰 = −1 (1/√2, 0, 1/√2) = (−1/√2, 0, −1/√2)
              𝐝 = u 𝐮 + v 𝐯 − distance 𝐰 = (√2/10, 0, −√2/10) + (0, −0.1, 0) + (−1/√2, 0, −1/√2) = (−2 √2/5, −0.1, −3 √2/5)
              |𝐝| = √105/10; the distance per unit of t
              𝐩 + t 𝐝 = (0, 0, 0) + t (−2 √2/5, −0.1, −3 √2/5); 𝐩 = eye; t = 1 is on the viewport

            ball
              centre = (−4, 0, −4)
              r = 1
              |𝐱 − centre|² = r²; implicit: 𝐱 is on the sphere
              |𝐩 + t 𝐝 − centre|² = r²; the ray put in
              |(0, 0, 0) + t (−2 √2/5, −0.1, −3 √2/5) − (−4, 0, −4)|² = 1²
              t² 𝐝 · 𝐝 + 2 t 𝐝 · (𝐩 − centre) + |𝐩 − centre|² = r²; multiplied out
              a t² + 2 b t + c = 0; sorted by t
              𝐩 − centre = (0, 0, 0) − (−4, 0, −4) = (4, 0, 4)
              a = 𝐝 · 𝐝 = (−2 √2/5, −0.1, −3 √2/5) · (−2 √2/5, −0.1, −3 √2/5) = 1.05
              b = 𝐝 · (𝐩 − centre) = (−2 √2/5, −0.1, −3 √2/5) · (4, 0, 4) = −4 √2
              c = |𝐩 − centre|² − r² = |(4, 0, 4)|² − 1² = 31
              1.05 t² − 8 √2 t + 31 = 0
              t = (−2 b ∓ √((2 b)² − 4 a c))/(2 a) = (−b ∓ √D)/a; every factor 2 cancels: b is half the coefficient of t
              D = b² − a c = (−4 √2)² − 1.05 · 31 = −0.55; D < 0: the line passes by

            marble
              centre = (−4.5, 0.9, −2)
              r = 0.5
              |𝐱 − centre|² = r²; implicit: 𝐱 is on the sphere
              |𝐩 + t 𝐝 − centre|² = r²; the ray put in
              |(0, 0, 0) + t (−2 √2/5, −0.1, −3 √2/5) − (−4.5, 0.9, −2)|² = 0.5²
              t² 𝐝 · 𝐝 + 2 t 𝐝 · (𝐩 − centre) + |𝐩 − centre|² = r²; multiplied out
              a t² + 2 b t + c = 0; sorted by t
              𝐩 − centre = (0, 0, 0) − (−4.5, 0.9, −2) = (4.5, −0.9, 2)
              a = 𝐝 · 𝐝 = (−2 √2/5, −0.1, −3 √2/5) · (−2 √2/5, −0.1, −3 √2/5) = 1.05
              b = 𝐝 · (𝐩 − centre) = (−2 √2/5, −0.1, −3 √2/5) · (4.5, −0.9, 2) ≈ −4.1526
              c = |𝐩 − centre|² − r² = |(4.5, −0.9, 2)|² − 0.5² = 24.81
              1.05 t² − 8.3053 t + 24.81 ≈ 0
              t = (−2 b ∓ √((2 b)² − 4 a c))/(2 a) = (−b ∓ √D)/a; every factor 2 cancels: b is half the coefficient of t
              D = b² − a c ≈ (−4.1526)² − 1.05 · 24.81 ≈ −8.8061; D < 0: the line passes by

            back wall
              point = (0, 0, −6)
              𝐧 = (0, 0, 1)
              𝐧 · (𝐱 − point) = 0; implicit: 𝐱 is on the plane
              𝐧 · (𝐩 + t 𝐝 − point) = 0; the ray put in
              (0, 0, 1) · ((0, 0, 0) + t (−2 √2/5, −0.1, −3 √2/5) − (0, 0, −6)) = 0
              t (𝐧 · 𝐝) = 𝐧 · (point − 𝐩); multiplied out
              𝐧 · 𝐝 = (0, 0, 1) · (−2 √2/5, −0.1, −3 √2/5) = −3 √2/5
              𝐧 · (point − 𝐩) = (0, 0, 1) · ((0, 0, −6) − (0, 0, 0)) = −6
              t = (𝐧 · (point − 𝐩))/(𝐧 · 𝐝) = −6/(−3 √2/5) = 5 √2; first hit (smallest t > 0)
              hit = 𝐩 + t 𝐝 = (0, 0, 0) + 5 √2 (−2 √2/5, −0.1, −3 √2/5) = (−4, −1/√2, −6)
              normal = 𝐧/|𝐧| = (0, 0, 1)
        "#]],
    );
}

#[test]
fn rows_and_columns_counted_from_one() {
    let pixel = Selection::Pixel(Pixel { row: 99, column: 199 });
    let derivation = derive(&document("canonical"), pixel, 5, true);
    let lines = derivation.sections[1].lines.iter().take(3).map(|line| format!("{line}\n"));
    expect![[r#"
        width = 1, height = 1
        W = 400, H = 400; pixels
        distance = 1
    "#]]
    .assert_eq(&lines.collect::<String>());
}

#[test]
fn a_camera_without_a_basis_is_derived_up_to_the_line_that_fails() {
    let mut document = document("canonical");
    for (at, up) in [
        (DVec3::ZERO, DVec3::Y),
        (DVec3::new(0.0, 0.0, -1.0), DVec3::ZERO),
        (DVec3::new(0.0, 0.0, -1.0), DVec3::new(0.0, 0.0, 2.0)),
    ] {
        document.camera.orientation = Orientation::At { at, up };
        let derivation = derive(&document, WARM_UP, 5, false);
        let last = derivation.sections[0].lines.last().expect("lines");
        assert!(last.is_fault && !last.note.is_empty(), "{derivation}");
        let lines = &derivation.sections[1].lines;
        let faults = lines.iter().filter(|line| line.is_fault);
        assert_eq!((lines.len(), faults.count()), (3, 1), "the given numbers stay");
    }
    expect![[r#"
        Basis
          eye = (0, 0, 0)
          at = (0, 0, −1)
          up = (0, 0, 2)
          view = at − eye = (0, 0, −1) − (0, 0, 0) = (0, 0, −1)
          −view = (0, 0, 1)
          𝐰 = normalize(−view) = (0, 0, 1)/1 = (0, 0, 1)
          up × 𝐰 = (0, 0, 2) × (0, 0, 1) = (0, 0, 0)
          |up × 𝐰| = |up| sin(angle) = 2 · sin(0°) = 0
          𝐮 = normalize(up × 𝐰); up (0, 0, 2) is parallel to the view direction (0, 0, −1): turn one of them

        Pixel to ray
          distance = 1
          (u, v) = (0.2, −0.1)
          no ray

        ball
          centre = (0, 0, −5)
          r = 1

        marble
          centre = (−1.2, 0.9, −4)
          r = 0.5

        back wall
          point = (0, 0, −6)
          𝐧 = (0, 0, 1)
    "#]].assert_eq(&derive(&document, WARM_UP, 5, false).to_string());
}

#[test]
fn nothing_that_is_rounded_stands_behind_an_equals_sign() {
    let selections = [WARM_UP, Selection::Pixel(Pixel { row: 99, column: 198 })];
    for scene in ["look-at", "almost-parallel-up", "roll", "tiny-far", "canonical"] {
        let document = document(scene);
        for (selection, exact) in selections.into_iter().flat_map(|s| [(s, true), (s, false)]) {
            let rounding = Rounding::Significant(17);
            let text = derive_as(&document, selection, (rounding, exact), false).to_string();
            // A given number is exactly its digits, however many.
            let is_given = |line: &&str| line.trim_start().starts_with("up = ");
            for line in text.lines().filter(|line| !is_given(line)) {
                let terms = line.split_inclusive(['=', '≈', ';']);
                let relations = terms.clone().map(|term| term.chars().last());
                for (term, relation) in terms.skip(1).zip(relations) {
                    let numbers = term.split(|c: char| !(c.is_ascii_digit() || c == '.'));
                    let digits = |number: &str| {
                        let digits = number.chars().filter(char::is_ascii_digit);
                        digits.collect::<String>().trim_matches('0').len()
                    };
                    let longest = numbers.map(digits).max().unwrap_or(0);
                    assert!(relation != Some('=') || longest <= 12, "{scene}: {line}");
                }
            }
        }
    }
}

#[test]
fn no_equals_sign_follows_a_rounded_side() {
    for scene in ["look-at", "forty-five", "almost-parallel-up", "roll", "tiny-far"] {
        for exact in [true, false] {
            let rounding = Rounding::Significant(5);
            let derivation = derive_as(&document(scene), WARM_UP, (rounding, exact), false);
            for line in derivation.to_string().lines() {
                let formula = line.split(';').next().unwrap_or_default();
                let after = formula.split_once('≈').map_or("", |(_, after)| after);
                assert!(!after.contains('='), "{scene}: {line}");
            }
        }
    }
}

#[test]
fn decimals_alone_have_no_roots() {
    let rounding = Rounding::Decimals(3);
    let of_ray = |exact| {
        let document = document("forty-five");
        derive_as(&document, WARM_UP, (rounding, exact), false).to_string()
    };
    assert!(of_ray(true).contains("𝐝 = ") && of_ray(true).contains("√2"));
    let decimals = of_ray(false);
    let is_number = |after: &str| after.starts_with(|c: char| c.is_ascii_digit());
    assert!(!decimals.split('√').skip(1).any(is_number), "{decimals}");
    assert!(decimals.contains("𝐮 ≈ (0.707, 0, −0.707); set by hand"), "{decimals}");
}

#[test]
fn an_object_that_is_none_keeps_its_numbers() {
    let mut document = document("canonical");
    document.spheres[0].shape.radius = -1.0;
    let derivation = derive(&document, WARM_UP, 5, false);
    assert_eq!(derivation.sections.len(), 5);
    let lines: Vec<String> =
        derivation.sections[2].lines.iter().map(DerivedLine::to_string).collect();
    assert_eq!(lines[..2], ["centre = (0, 0, −5)", "r = −1"]);
    assert!(lines[2].starts_with("no picture; radius is −1"), "{lines:?}");
}

#[test]
fn nothing_is_no_number() {
    for scene in pinhole_exchange::scenes::BuiltinScene::all() {
        let document = document(scene.name);
        for selection in [WARM_UP, Selection::Pixel(Pixel { row: 0, column: 0 })] {
            let text = derive(&document, selection, 17, false).to_string();
            assert!(!text.contains("NaN") && !text.contains("inf"), "{}: {text}", scene.name);
        }
    }
}

#[test]
fn digits_follow_the_setting() {
    let mut document = document("canonical");
    document.camera.orientation =
        Orientation::View { view: DVec3::new(0.3, -0.77, -1.9), up: DVec3::new(0.1, 1.0, 0.2) };
    let text = |digits| derive(&document, WARM_UP, digits, false).to_string();
    assert!(text(3).contains("≈") && text(3).len() < text(9).len());
    expect![[r#"
        Basis
          eye = (0, 0, 0)
          up = (0.1, 1, 0.2)
          view = (0.3, −0.77, −1.9)
          −view = (−0.3, 0.77, 1.9)
          𝐰 = normalize(−view) ≈ (−0.3, 0.77, 1.9)/2.07 ≈ (−0.145, 0.372, 0.917)
          up × 𝐰 ≈ (0.1, 1, 0.2) × (−0.145, 0.372, 0.917) ≈ (0.843, −0.121, 0.182)
          |up × 𝐰| = |up| sin(angle) ≈ √105/10 · sin(58.2°) ≈ 0.871
          𝐮 = normalize(up × 𝐰) ≈ (0.843, −0.121, 0.182)/0.871 ≈ (0.968, −0.139, 0.209)
    "#]]
    .assert_eq(&text(3).lines().take(9).map(|line| format!("{line}\n")).collect::<String>());
}

/// Returns true if every LaTeX group that is opened is closed.
fn is_balanced(latex: &str) -> bool {
    let count = |part: &str| latex.matches(part).count();
    let escaped = |brace: &str| count(&format!("\\{brace}"));
    count("{") - escaped("{") == count("}") - escaped("}")
        && count(r"\left") == count(r"\right")
        && count(r"\begin") == count(r"\end")
        && latex.replace(r"\$", "").matches('$').count().is_multiple_of(2)
}

#[test]
fn as_latex_and_as_markdown() {
    let derivation = derive(&document("forty-five"), WARM_UP, 5, false);
    let sections =
        derivation.sections.iter().filter(|s| s.section != DerivationSection::Objects).cloned();
    let derivation = Derivation { sections: sections.collect(), left_out: 1 };
    expect![[r#"
        % needs \usepackage{amsmath}
        \subsection*{Basis}
        \begin{align*}
          \mathbf{eye} &= \left( 0, 0, 0 \right) \\
          \mathbf{u} &= \left( \frac{1}{\sqrt{2}}, 0, -\frac{1}{\sqrt{2}} \right) \quad \text{set by hand} \\
          \mathbf{v} &= \left( 0, 1, 0 \right) \quad \text{set by hand} \\
          \mathbf{w} &= \left( \frac{1}{\sqrt{2}}, 0, \frac{1}{\sqrt{2}} \right) \quad \text{set by hand} \\
          \left| \mathbf{u} \right| &= \left| \mathbf{v} \right| = \left| \mathbf{w} \right| = 1 \quad \text{of length 1} \\
          \mathbf{u} \cdot \mathbf{v} &= \mathbf{v} \cdot \mathbf{w} = \mathbf{w} \cdot \mathbf{u} = 0 \quad \text{perpendicular} \\
          \left( \mathbf{u} \times \mathbf{v} \right) \cdot \mathbf{w} &= 1 \quad \text{right-handed}
        \end{align*}
        \subsection*{Pixel to ray}
        \begin{align*}
          \mathit{distance} &= 1 \\
          \left( u, v \right) &= \left( 0.2, -0.1 \right) \\
          &\quad \text{the corner of four pixels, no pixel's centre} \\
          u \mathbf{u} &= 0.2 \left( \frac{1}{\sqrt{2}}, 0, -\frac{1}{\sqrt{2}} \right) = \left( \frac{\sqrt{2}}{10}, 0, -\frac{\sqrt{2}}{10} \right) \\
          v \mathbf{v} &= -0.1 \left( 0, 1, 0 \right) = \left( 0, -0.1, 0 \right) \\
          -\mathit{distance} \mathbf{w} &= -1 \left( \frac{1}{\sqrt{2}}, 0, \frac{1}{\sqrt{2}} \right) = \left( -\frac{1}{\sqrt{2}}, 0, -\frac{1}{\sqrt{2}} \right) \\
          \mathbf{d} &= u \mathbf{u} + v \mathbf{v} - \mathit{distance} \mathbf{w} \\
          &= \left( \frac{\sqrt{2}}{10}, 0, -\frac{\sqrt{2}}{10} \right) + \left( 0, -0.1, 0 \right) + \left( -\frac{1}{\sqrt{2}}, 0, -\frac{1}{\sqrt{2}} \right) \\
          &= \left( -\frac{2 \sqrt{2}}{5}, -0.1, -\frac{3 \sqrt{2}}{5} \right) \\
          \left| \mathbf{d} \right| &= \frac{\sqrt{105}}{10} \quad \text{the distance per unit of $t$} \\
          \mathbf{p} + t \mathbf{d} &= \left( 0, 0, 0 \right) + t \left( -\frac{2 \sqrt{2}}{5}, -0.1, -\frac{3 \sqrt{2}}{5} \right) \\
          &\quad \text{$\mathbf{p}$ = eye; $t$ = 1 is on the viewport}
        \end{align*}
        1 more object is not listed
    "#]].assert_eq(&derivation.written_in(Markup::Latex));
    expect![[r#"
        ### Basis

        - $\mathbf{eye} = \left( 0, 0, 0 \right)$
        - $\mathbf{u} = \left( \frac{1}{\sqrt{2}}, 0, -\frac{1}{\sqrt{2}} \right)$; set by hand
        - $\mathbf{v} = \left( 0, 1, 0 \right)$; set by hand
        - $\mathbf{w} = \left( \frac{1}{\sqrt{2}}, 0, \frac{1}{\sqrt{2}} \right)$; set by hand
        - $\left| \mathbf{u} \right| = \left| \mathbf{v} \right| = \left| \mathbf{w} \right| = 1$; of length 1
        - $\mathbf{u} \cdot \mathbf{v} = \mathbf{v} \cdot \mathbf{w} = \mathbf{w} \cdot \mathbf{u} = 0$; perpendicular
        - $\left( \mathbf{u} \times \mathbf{v} \right) \cdot \mathbf{w} = 1$; right-handed

        ### Pixel to ray

        - $\mathit{distance} = 1$
        - $\left( u, v \right) = \left( 0.2, -0.1 \right)$; the corner of four pixels, no pixel's centre
        - $u \mathbf{u} = 0.2 \left( \frac{1}{\sqrt{2}}, 0, -\frac{1}{\sqrt{2}} \right) = \left( \frac{\sqrt{2}}{10}, 0, -\frac{\sqrt{2}}{10} \right)$
        - $v \mathbf{v} = -0.1 \left( 0, 1, 0 \right) = \left( 0, -0.1, 0 \right)$
        - $-\mathit{distance} \mathbf{w} = -1 \left( \frac{1}{\sqrt{2}}, 0, \frac{1}{\sqrt{2}} \right) = \left( -\frac{1}{\sqrt{2}}, 0, -\frac{1}{\sqrt{2}} \right)$
        - $\mathbf{d} = u \mathbf{u} + v \mathbf{v} - \mathit{distance} \mathbf{w} = \left( \frac{\sqrt{2}}{10}, 0, -\frac{\sqrt{2}}{10} \right) + \left( 0, -0.1, 0 \right) + \left( -\frac{1}{\sqrt{2}}, 0, -\frac{1}{\sqrt{2}} \right) = \left( -\frac{2 \sqrt{2}}{5}, -0.1, -\frac{3 \sqrt{2}}{5} \right)$
        - $\left| \mathbf{d} \right| = \frac{\sqrt{105}}{10}$; the distance per unit of 𝑡
        - $\mathbf{p} + t \mathbf{d} = \left( 0, 0, 0 \right) + t \left( -\frac{2 \sqrt{2}}{5}, -0.1, -\frac{3 \sqrt{2}}{5} \right)$; 𝐩 = eye; 𝑡 = 1 is on the viewport

        1 more object is not listed
    "#]].assert_eq(&derivation.written_in(Markup::Markdown));
}

#[test]
fn every_derivation_is_balanced_and_has_all_its_lines() {
    for scene in ["canonical", "look-at", "almost-parallel-up", "inside", "tiny-far", "grazing"] {
        let derivation = derive(&document(scene), WARM_UP, 17, true);
        let lines: usize = derivation.sections.iter().map(|section| section.lines.len()).sum();
        let latex = derivation.written_in(Markup::Latex);
        assert!(is_balanced(&latex), "{scene}: {latex}");
        let breaks = latex.matches(" \\\\\n").count();
        assert!(breaks + latex.matches(r"\begin{align*}").count() >= lines, "{scene}: {latex}");
        assert!(latex.is_ascii(), "{scene}: {latex}");
        let markdown = derivation.written_in(Markup::Markdown);
        assert!(is_balanced(&markdown), "{scene}: {markdown}");
        assert_eq!(markdown.matches("\n- $").count(), lines, "{scene}: {markdown}");
    }
}
