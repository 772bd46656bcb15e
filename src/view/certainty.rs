//! The map of which step of the ladder decided each pixel, and with how much margin: in colours and
//! in words. This module is pure.

use egui::Color32;
use pinhole_core::{Certificate, Hardest, Question, Raster, ResolvedCamera, Scene, Step};
use pinhole_exchange::document::Document;

use crate::view::accuracy::mark;

/// The certificates of the shown pixels.
#[derive(Clone, Debug, PartialEq)]
pub struct Certainty {
    /// That of every pixel of the raster, row by row.
    pub certificates: Vec<Certificate>,
}

/// The steps with their names and colours, in the map and in its legend. The colours differ for
/// colour-blind viewers, too (Okabe and Ito, *Color Universal Design*, 2008).
pub(crate) const STEPS: [(Step, &str, Color32); 3] = [
    (Step::F64, "f64", Color32::from_rgb(0x56, 0xb4, 0xe9)),
    (Step::DoubleDouble, "double-double", Color32::from_rgb(0xe6, 0x9f, 0x00)),
    (Step::Exact, "exact", Color32::from_rgb(0xff, 0x5f, 0xb8)),
];

impl Certainty {
    /// Asks how surely each pixel of the raster is decided.
    pub fn new(scene: &Scene, camera: &ResolvedCamera, raster: &Raster) -> Certainty {
        Certainty {
            certificates: scene.certificates(camera, raster.rows(), raster.columns(), |_| ()),
        }
    }

    /// Number of pixels that this step decided.
    pub fn count(&self, step: Step) -> usize {
        self.certificates.iter().filter(|pixel| pixel.step == step).count()
    }

    /// The least margin in `f64`; `None` where it decided no pixel.
    pub fn least_in_f64(&self) -> Option<f64> {
        let in_f64 = self.certificates.iter().filter(|pixel| pixel.step == Step::F64);
        in_f64.map(|pixel| pixel.margin).reduce(f64::min)
    }
}

/// Returns the colour of a step at this margin in bits: bright where little is to spare.
pub(crate) fn color(step: Step, margin: f64) -> Color32 {
    /// Share of the colour that stays where most is to spare.
    const DARKEST: f64 = 0.25;
    let spent = (1.0 - margin / Certificate::MOST).clamp(0.0, 1.0);
    // Most pixels have nearly the most to spare: the root tells them apart.
    let share = DARKEST + (1.0 - DARKEST) * spent.sqrt();
    let (.., color) = STEPS.into_iter().find(|(of, ..)| *of == step).unwrap_or(STEPS[2]);
    let [r, g, b] = [color.r(), color.g(), color.b()].map(|x| (share * f64::from(x)).round() as u8);
    Color32::from_rgb(r, g, b)
}

/// Returns the map's colours, one for each pixel of the raster.
pub(crate) fn colors(certainty: &Certainty) -> Vec<Color32> {
    certainty.certificates.iter().map(|pixel| color(pixel.step, pixel.margin)).collect()
}

/// Marks the pixels that `f64` did not decide, as wrong ones are marked in an error map.
pub(crate) fn mark_hard(
    certainty: &Certainty,
    raster: &Raster,
    width: usize,
    scale: f32,
    dots: &mut [Color32],
) {
    // The exact ones last, over the others.
    for step in [Step::DoubleDouble, Step::Exact] {
        let pixels = certainty.certificates.iter().enumerate();
        let of_step = pixels.filter(|(_, pixel)| pixel.step == step);
        let of_step: Vec<(usize, Color32)> =
            of_step.map(|(index, pixel)| (index, color(step, pixel.margin))).collect();
        mark(&of_step, raster, (width, scale), dots);
    }
}

/// Returns `decided in f64, 31 bits to spare; hardest: whether the ray meets Ball`.
pub(crate) fn words(certificate: &Certificate, document: &Document) -> String {
    let Certificate { step, margin, hardest, .. } = certificate;
    let (_, name, _) = STEPS.into_iter().find(|(of, ..)| of == step).unwrap_or(STEPS[2]);
    let bits = margin.floor();
    let mut text = match step {
        Step::Exact => "decided exactly, nothing to spare".to_owned(),
        _ if *margin >= Certificate::MOST => {
            format!("decided in {name}, {bits} bits or more to spare")
        }
        _ if bits == 1.0 => format!("decided in {name}, 1 bit to spare"),
        _ => format!("decided in {name}, {bits} bits to spare"),
    };
    if let Some(Hardest { question, object, .. }) = hardest {
        let object = document.title_of(*object as usize);
        let question = match question {
            Question::Side => format!("on which side of {object} the eye is"),
            Question::Meets => format!("whether the line meets {object}"),
            Question::Ahead => format!("whether {object} is ahead"),
            Question::Order => format!("whether {object} comes later"),
        };
        text.push_str(&format!("; hardest: {question}"));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn less_to_spare_is_brighter_and_the_steps_differ() {
        for (step, _, full) in STEPS {
            let light = |margin: f64| {
                u32::from(color(step, margin).r()) + u32::from(color(step, margin).g())
            };
            assert!([44.0, 40.0, 30.0, 10.0, 0.0].map(light).is_sorted_by(|a, b| a < b));
            assert_eq!(color(step, 0.0), full);
            assert_eq!(color(step, 100.0), color(step, Certificate::MOST));
        }
        for margin in [0.0, 44.0] {
            let [a, b, c] = STEPS.map(|(step, ..)| color(step, margin));
            assert!(a != b && b != c && a != c);
        }
    }
}
