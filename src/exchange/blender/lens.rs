//! What a Blender program gives its camera's lens.

use pinhole_core::{ImageSize, Viewport};

use super::passed::is_only_read;
use super::things::{Chosen, Deed, Things};
use crate::exchange::back::{extent, in_ratio, shortest_where};
use crate::exchange::code::{Code, Piece};
use crate::exchange::python::{Block, Verb};
use crate::formats::FileError;

/// How the focal length is given.
#[derive(Clone, Copy)]
enum Length {
    Millimetres(f64),
    /// The angle across so many millimetres of the sensor.
    Angle(f64, f64),
}

/// Blender's camera as it is made.
pub(super) struct Lens {
    length: Length,
    width: f64,
    height: f64,
    fit: String,
    pub(super) is_given: bool,
}

/// As the statements leave it.
pub(super) fn lens(
    code: &Code,
    things: &Things,
    chosen: &Chosen,
    notes: &mut Vec<String>,
) -> Result<Lens, FileError> {
    let mut lens = Lens {
        length: Length::Millimetres(50.0),
        width: 36.0,
        height: 24.0,
        fit: "AUTO".to_owned(),
        is_given: false,
    };
    for deed in &things.deeds {
        let own = chosen.data.iter().find_map(|name| deed.path.strip_prefix(name.as_str()));
        let Some(property) = own.and_then(|path| path.strip_prefix('.')) else { continue };
        if let Some(place) = property.strip_prefix("passed") {
            if !is_only_read(code, deed.value, place.trim_matches(['[', ']'])) {
                let right = "it may change the lens that it is given: it must be given by numbers";
                return Err(code.fault("the call", deed.value, right));
            }
        } else if property.starts_with("keyframe_insert") || property.starts_with("driver_add") {
            let right =
                "the lens changes with the frames: it must be given once, without keyframes";
            return Err(code.fault("the lens's motion", deed.value, right));
        }
        lens.take(code, property, deed, notes)?;
    }
    Ok(lens)
}

const PROPERTIES: [&str; 10] = [
    "lens",
    "angle",
    "angle_x",
    "angle_y",
    "sensor_width",
    "sensor_height",
    "sensor_fit",
    "shift_x",
    "shift_y",
    "type",
];

impl Lens {
    fn take(
        &mut self,
        code: &Code,
        property: &str,
        deed: &Deed,
        notes: &mut Vec<String>,
    ) -> Result<(), FileError> {
        if !PROPERTIES.contains(&property) || matches!(deed.verb, Verb::Say | Verb::Return) {
            return Ok(());
        }
        let value = deed.value;
        if deed.verb != Verb::Give || deed.block == Block::Often {
            let right = "it must be given once, by a number";
            return Err(code.fault(property, value, right));
        }
        let word = value.text.trim_matches(['\'', '"']);
        match property {
            "type" if word != "PERSP" => {
                return Err(code.fault("the camera's type", value, "it must be PERSP"));
            }
            "type" => return Ok(()),
            "sensor_fit" => {
                let is_fit = ["AUTO", "HORIZONTAL", "VERTICAL"].contains(&word);
                word.clone_into(&mut self.fit);
                let right = "it must be AUTO, HORIZONTAL or VERTICAL";
                return is_fit.then_some(()).ok_or_else(|| code.fault(property, value, right));
            }
            _ => (),
        }
        let number = code.number(property, value)?;
        match property {
            "shift_x" | "shift_y" => {
                if number != 0.0 {
                    notes.push(format!("{property} is left out: the middle is the middle here"));
                }
                return Ok(());
            }
            "lens" => self.length = Length::Millimetres(positive(code, property, value, number)?),
            "sensor_width" => self.width = positive(code, property, value, number)?,
            "sensor_height" => self.height = positive(code, property, value, number)?,
            _ => {
                if !(number > 0.0 && number < std::f64::consts::PI) {
                    let right = "it must be between 0 and pi, in radians";
                    return Err(code.fault(property, value, right));
                }
                // Blender makes a focal length of it at once.
                let across = match property {
                    "angle_x" => self.width,
                    "angle_y" => self.height,
                    _ => self.sensor(),
                };
                self.length = Length::Angle(number, across);
            }
        }
        self.is_given |= !property.starts_with("sensor");
        Ok(())
    }

    fn sensor(&self) -> f64 {
        if self.fit == "VERTICAL" { self.height } else { self.width }
    }

    /// What is seen at this distance, on an image whose pixels have this shape.
    pub(super) fn viewport(&self, image: ImageSize, pixel_shape: f64, distance: f64) -> Viewport {
        let frame = image.aspect() * pixel_shape;
        let by_width = match self.fit.as_str() {
            "HORIZONTAL" => true,
            "VERTICAL" => false,
            _ => frame >= 1.0,
        };
        let sensor = self.sensor();
        let seen = |length: f64| {
            let degrees = 2.0 * (0.5 * sensor / length).atan().to_degrees();
            extent(degrees, distance)
        };
        let across = match self.length {
            Length::Angle(angle, across) if across == sensor => {
                let near = pinhole_core::extent_of_fov(angle, distance);
                shortest_where(near, |x| pinhole_core::fov_of_extent(x, distance) == angle)
            }
            Length::Angle(angle, across) => seen(0.5 * across / (0.5 * angle).tan()),
            Length::Millimetres(length) => seen(length),
        };
        match by_width {
            true => Viewport { width: across, height: in_ratio(across, 1.0 / frame), distance },
            false => Viewport { width: in_ratio(across, frame), height: across, distance },
        }
    }
}

fn positive(code: &Code, name: &str, value: Piece, number: f64) -> Result<f64, FileError> {
    let right = "it must be greater than 0";
    (number > 0.0).then_some(number).ok_or_else(|| code.fault(name, value, right))
}
