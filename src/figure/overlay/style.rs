//! The overlay's colours.
//!
//! The hues are those of Okabe and Ito (*Color Universal Design*, 2008), darkened on a light background
//! and lightened on a dark one. Nothing is distinguished by colour alone: u, v and w are thick with
//! three different arrowheads, x, y and z are thin, and all of them have labels.

use egui::Color32;

use crate::Scheme;
use crate::overlay::mix;

/// The font of a label: its size in points, and whether it is bold.
pub(super) type LabelFont = (f32, bool);

/// Large font for the labels of vectors.
pub(super) const VECTOR: LabelFont = (21.0, true);
/// Bold font for the labels of normals and of answers.
pub(super) const BOLD_POINT: LabelFont = (17.0, true);
/// Font for the labels of points, of the world's axes, and of the vectors that the user gives.
pub(super) const POINT: LabelFont = (17.0, false);
/// Font for the labels of marks.
pub(super) const MARK: LabelFont = (14.0, false);

/// Width of thin lines of lesser rank: the far part of the frustum, and grids.
pub(super) const FINE: f32 = 1.2;
/// Width of the world's axes and of the frustum. Each width is 1.4 times the one before.
pub(super) const THIN: f32 = 1.7;
/// Width of outlines, of normals, and of the vectors that the user gives.
pub(super) const MEDIUM: f32 = 2.4;
/// Width of the vectors u, v, w and of the selected ray.
pub(super) const THICK: f32 = 3.4;

pinhole_core::texts! {
    /// A set of colours for a light or a dark window. Each [`Scheme`] has a light and a dark style, in the
    /// order of [`Scheme::ALL`].
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
    pub enum Style[1];
    {
        /// Returns the style's name on the command line.
        name,
    }
    /// Dark lines on a light background.
    #[default]
    Light: "light";
    /// Light lines on a dark background.
    Dark: "dark";
    /// [`Style::Light`] in [`Scheme::ColourBlind`].
    ColourBlindLight: "colour-blind";
    /// [`Style::Dark`] in [`Scheme::ColourBlind`].
    ColourBlindDark: "colour-blind-dark";
    /// [`Style::Light`] in [`Scheme::Grey`].
    GreyLight: "grey";
    /// [`Style::Dark`] in [`Scheme::Grey`].
    GreyDark: "grey-dark";
}

/// The colours of one [`Style`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Colors {
    /// The colour where the observer's rays hit nothing. It is also that of the casing of lines and of the halo
    /// of text, which separate these from what they cross and do not show in the background.
    pub background: Color32,
    /// The eye, the frustum and the viewport's outline.
    pub ink: Color32,
    /// The u, v, w arrows.
    pub basis: [Color32; 3],
    /// Dash and gap of the u, v, w arrows, in points. Only set in styles whose greys alone do not
    /// distinguish the arrows well enough.
    pub patterns: [Option<[f32; 2]>; 3],
    /// The x, y, z axes.
    pub axes: [Color32; 3],
    /// The at point, the view direction and up.
    pub given: Color32,
    /// The selected ray and pixel.
    pub ray: Color32,
    /// The hit and its normal.
    pub hit: Color32,
    /// The marks at the image's top edge and at pixel (0, 0).
    pub mark: Color32,
}

const fn rgb(hex: u32) -> Color32 {
    Color32::from_rgb((hex >> 16) as u8, (hex >> 8) as u8, hex as u8)
}

const LIGHT: Colors = Colors {
    background: rgb(0xf4f6f9),
    ink: rgb(0x2b3038),
    basis: [rgb(0xc04509), rgb(0x00805c), rgb(0x0062a8)],
    patterns: [None; 3],
    axes: [rgb(0x8a675a), rgb(0x57746b), rgb(0x5c6e86)],
    given: rgb(0x95407a),
    ray: rgb(0xb8004e),
    hit: rgb(0x111111),
    mark: rgb(0x7a3cc2),
};

const DARK: Colors = Colors {
    background: rgb(0x171a20),
    ink: rgb(0xd9dee6),
    basis: [rgb(0xff8a4c), rgb(0x2fd3a0), rgb(0x6cbcf5)],
    patterns: [None; 3],
    axes: [rgb(0xb89a8e), rgb(0x8fb0a5), rgb(0x93a7c2)],
    given: rgb(0xe59cc8),
    ray: rgb(0xff5c98),
    hit: rgb(0xffffff),
    mark: rgb(0xc39bff),
};

const COLOUR_BLIND_LIGHT: Colors = Colors {
    ink: rgb(0x15181d),
    basis: [rgb(0x754007), rgb(0x29604b), rgb(0x1d86fb)],
    axes: [rgb(0x7d7468), rgb(0x5f6f69), rgb(0x56708c)],
    given: rgb(0x978b02),
    ray: rgb(0xf141a8),
    mark: rgb(0x5b3a8c),
    ..LIGHT
};

const COLOUR_BLIND_DARK: Colors = Colors {
    ink: rgb(0xf2f4f8),
    basis: [rgb(0xb2682f), rgb(0x00fe94), rgb(0x2e8fe5)],
    axes: [rgb(0xa89a8c), rgb(0x9db8ad), rgb(0x8ba3c0)],
    given: rgb(0xecc805),
    ray: rgb(0xef2c83),
    mark: rgb(0xc9b3ff),
    ..DARK
};

/// Dash patterns of the arrows: u solid, v with long dashes, w with short ones. Hidden lines are dashed,
/// too, but thin.
const PATTERNS: [Option<[f32; 2]>; 3] = [None, Some([13.0, 3.0]), Some([4.0, 3.0])];

const GREY_LIGHT: Colors = Colors {
    background: rgb(0xffffff),
    ink: rgb(0x2e2e2e),
    basis: [rgb(0x000000), rgb(0x454545), rgb(0x717171)],
    patterns: PATTERNS,
    axes: [rgb(0x767676), rgb(0x767676), rgb(0x767676)],
    given: rgb(0x5a5a5a),
    ray: rgb(0x000000),
    hit: rgb(0x000000),
    mark: rgb(0x3a3a3a),
};

const GREY_DARK: Colors = Colors {
    background: rgb(0x121212),
    ink: rgb(0xdddddd),
    basis: [rgb(0xffffff), rgb(0xc4c4c4), rgb(0x949494)],
    patterns: PATTERNS,
    axes: [rgb(0x9a9a9a), rgb(0x9a9a9a), rgb(0x9a9a9a)],
    given: rgb(0xb0b0b0),
    ray: rgb(0xffffff),
    hit: rgb(0xffffff),
    mark: rgb(0xd0d0d0),
};

/// Least contrast of a dimmed label with the background (WCAG 2.2, *Contrast (Minimum)*).
pub(super) const LEGIBLE: f64 = 4.5;
/// Least contrast of a dimmed mark with its casing (WCAG 2.2, *Non-text Contrast*).
pub(super) const VISIBLE: f64 = 3.0;

/// Weight of a colour that is dimmed, because another concept is highlighted, if it then still has enough
/// contrast; opacity of translucent marks.
pub(super) const DIMMED: f32 = 0.42;

impl Colors {
    /// Returns the colour of a mark or a label while another concept is highlighted: closer to the
    /// background, but only as far as it keeps this contrast. A colour that does not have it is strengthened.
    pub(super) fn dimmed(&self, color: Color32, contrast: f64) -> Color32 {
        const STEPS: u8 = 20;
        let shares = || (0..=STEPS).map(|k| f32::from(k) / f32::from(STEPS));
        let weaker = shares().map(|s| mix(self.background, color, DIMMED + s * (1.0 - DIMMED)));
        let stronger = shares().map(|s| mix(color, self.hit, s));
        let is_enough = |color: &Color32| contrast_ratio(*color, self.background) >= contrast;
        weaker.chain(stronger).find(is_enough).unwrap_or(self.hit)
    }
}

/// Returns the components of a colour in linear sRGB.
fn linear(color: Color32) -> [f64; 3] {
    [color.r(), color.g(), color.b()].map(|x| {
        let x = f64::from(x) / 255.0;
        if x <= 0.04045 { x / 12.92 } else { ((x + 0.055) / 1.055).powf(2.4) }
    })
}

fn luminance([r, g, b]: [f64; 3]) -> f64 {
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

/// Returns WCAG 2's contrast ratio of two opaque colours.
pub fn contrast_ratio(a: Color32, b: Color32) -> f64 {
    let [a, b] = [a, b].map(|color| luminance(linear(color)) + 0.05);
    a.max(b) / a.min(b)
}

impl Style {
    /// Returns the light or the dark style of a scheme.
    pub fn new(scheme: Scheme, is_dark: bool) -> Style {
        Style::ALL[2 * scheme as usize + usize::from(is_dark)]
    }

    /// Returns the style's scheme.
    pub fn scheme(self) -> Scheme {
        Scheme::ALL[self as usize / 2]
    }

    /// Returns true if the style has light lines on a dark background.
    pub fn is_dark(self) -> bool {
        self as usize % 2 == 1
    }

    /// Returns the style's colours.
    pub fn colors(self) -> &'static Colors {
        const ALL: [&Colors; 6] =
            [&LIGHT, &DARK, &COLOUR_BLIND_LIGHT, &COLOUR_BLIND_DARK, &GREY_LIGHT, &GREY_DARK];
        ALL[self as usize]
    }

    /// Applies the style to a finished picture: a grey style removes the hue of every pixel.
    pub fn finish(self, dots: &mut [Color32]) {
        if self.scheme() == Scheme::Grey {
            for dot in dots {
                *dot = grey(*dot);
            }
        }
    }
}

/// Returns the grey that is as bright as a colour (by the luma of ITU-R BT.709).
fn grey(color: Color32) -> Color32 {
    let [r, g, b, a] = color.to_array();
    let luma = 2126 * u32::from(r) + 7152 * u32::from(g) + 722 * u32::from(b);
    let luma = ((luma + 5000) / 10_000) as u8;
    Color32::from_rgba_premultiplied(luma, luma, luma, a)
}

#[cfg(test)]
#[path = "tests/style.rs"]
mod tests;
