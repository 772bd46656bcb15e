//! Tests that the colours can be distinguished.

use super::*;

/// Colour transforms of viewers without one kind of cones, in linear sRGB (Machado, Oliveira and
/// Fernandes, *A Physiologically-based Model for Simulation of Color Vision Deficiency*, 2009,
/// severity 1).
const VIEWERS: [[[f64; 3]; 3]; 4] = [
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    [
        [0.152286, 1.052583, -0.204868],
        [0.114503, 0.786281, 0.099216],
        [-0.003882, -0.048116, 1.051998],
    ],
    [
        [0.367322, 0.860646, -0.227968],
        [0.280085, 0.672501, 0.047413],
        [-0.011820, 0.042940, 0.968881],
    ],
    [
        [1.255528, -0.076749, -0.178779],
        [-0.078411, 0.930809, 0.147602],
        [0.004733, 0.691367, 0.303900],
    ],
];

/// Returns the CIE L*a*b* colour that a viewer sees.
fn lab(color: Color32, viewer: &[[f64; 3]; 3]) -> [f64; 3] {
    let own = linear(color);
    let [r, g, b] =
        viewer.map(|row| row.iter().zip(own).map(|(a, x)| a * x).sum::<f64>().clamp(0.0, 1.0));
    let x = (0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505;
    let z = (0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089;
    let [x, y, z] = [x, luminance([r, g, b]), z]
        .map(|t| if t > 0.008856 { t.cbrt() } else { 7.787 * t + 16.0 / 116.0 });
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

const ALL: [Style; 6] = [
    Style::Light,
    Style::Dark,
    Style::ColourBlindLight,
    Style::ColourBlindDark,
    Style::GreyLight,
    Style::GreyDark,
];

#[test]
fn every_colour_stands_out_from_the_background() {
    for style in ALL {
        let c = style.colors();
        let [u, v, w] = c.basis;
        for color in [c.ink, u, v, w, c.given, c.ray, c.hit, c.mark] {
            let ratio = contrast_ratio(color, c.background);
            assert!(ratio >= 3.0, "{style:?}: {color:?} has {ratio:.2}");
        }
    }
}

#[test]
fn dimmed_labels_are_legible() {
    for style in ALL {
        let c = style.colors();
        let named = [c.ink, c.given, c.ray, c.hit, c.mark].into_iter().chain(c.basis).chain(c.axes);
        for color in named {
            let dimmed = c.dimmed(color, LEGIBLE);
            let ratio = contrast_ratio(dimmed, c.background);
            assert!(dimmed.is_opaque() && ratio >= 4.5, "{style:?}: {color:?} has {ratio:.2}");
            let own = contrast_ratio(color, c.background);
            assert!(own < 5.5 || ratio < own - 0.5, "{style:?}: {color:?} is dimmed");
        }
    }
}

#[test]
fn colour_blind_viewers_tell_the_safe_colours_apart() {
    for style in [Style::ColourBlindLight, Style::ColourBlindDark] {
        let c = style.colors();
        let [u, v, w] = c.basis;
        let typeset_message = [u, v, w, c.given, c.ray, c.ink];
        for viewer in &VIEWERS {
            for (k, a) in typeset_message.iter().enumerate() {
                for b in &typeset_message[..k] {
                    let apart = distance(lab(*a, viewer), lab(*b, viewer));
                    assert!(apart > 25.0, "{style:?}: {a:?} and {b:?}: {apart:.1}");
                }
            }
        }
    }
}

#[test]
fn greys_have_no_hue_and_their_vectors_differ_in_lightness() {
    for style in [Style::GreyLight, Style::GreyDark] {
        let c = style.colors();
        let [u, v, w] = c.basis;
        for color in [c.background, c.ink, u, v, w, c.given, c.ray, c.hit, c.mark] {
            assert!(color.r() == color.g() && color.g() == color.b(), "{style:?}: {color:?}");
        }
        for (a, b) in [(u, v), (v, w), (u, w)] {
            let [a, b] = [a, b].map(|color| lab(color, &VIEWERS[0])[0]);
            assert!((a - b).abs() > 15.0, "{style:?}: {a:.1} and {b:.1}");
        }
    }
    let mut dots = [rgb(0xff8a4c), rgb(0x123456)];
    Style::GreyDark.finish(&mut dots);
    assert!(dots.iter().all(|dot| dot.r() == dot.g() && dot.g() == dot.b() && dot.a() == 255));
}

#[test]
fn neighbouring_objects_differ_in_every_scheme() {
    for scheme in [Scheme::ColourBlind, Scheme::Grey] {
        for index in 0..12 {
            let own = [0x11, 0x22, 0x93];
            assert_ne!(scheme.object(index, own), scheme.object(index + 1, own));
        }
    }
    assert_eq!(Scheme::Standard.object(3, [1, 200, 3]), [1, 200, 3]);
    assert_eq!(Scheme::ColourBlind.object(3, [0x80, 0x80, 0x88]), [0x80, 0x80, 0x88]);
}
