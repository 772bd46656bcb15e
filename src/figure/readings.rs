//! The numbers of the selected ray and of its camera, with their names, concepts and meanings. The
//! readouts, the strip below the views and `pinhole inspect` all show them from this one
//! list.

use pinhole_core::{DVec2, DVec3, ImageSize, Pixel, PixelOfUv, ResolvedCamera, UpAngle};
use pinhole_lecture::Rounding;

use crate::symbols::{SymbolKind, meaning};
use crate::{Concept, Inspection};

/// The format in which numbers are written.
#[derive(Clone, Copy)]
pub struct NumberStyle {
    /// Number of significant digits.
    pub digits: usize,
    /// Number of decimals, in place of that of significant digits.
    pub decimals: Option<usize>,
    /// True if rows and columns are counted from 1, as in the course.
    pub count_from_one: bool,
}

/// A named quantity of the selected ray or of its camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// The name in the window.
    pub name: &'static str,
    /// The name in the text of `pinhole inspect`.
    pub long_name: &'static str,
    /// The concept that the views highlight while the user points at the reading, if any.
    pub concept: Option<Concept>,
    /// The value.
    pub value: ReadingValue,
}

impl Reading {
    fn new(
        name: &'static str,
        long_name: &'static str,
        concept: Concept,
        value: ReadingValue,
    ) -> Reading {
        Reading { name, long_name, concept: Some(concept), value }
    }

    /// Returns the reading's meaning in one sentence.
    pub fn meaning(&self) -> &'static str {
        meaning(SymbolKind::Readout, self.name)
            .or_else(|| meaning(SymbolKind::Vector, self.name))
            .unwrap_or("")
    }
}

/// The value of a [`Reading`].
#[derive(Clone, Debug, PartialEq)]
pub enum ReadingValue {
    /// A number.
    Number(f64),
    /// A position (u, v).
    Uv(DVec2),
    /// A vector or a point.
    Vector(DVec3),
    /// The angle between up and view.
    Angle(UpAngle),
    /// The position of the ray in an image of this size; `None` outside the image.
    Pixel(Option<PixelOfUv>, ImageSize),
    /// The title of an object, or a word.
    Text(String),
}

/// Returns the readings (named quantities) of u, v and w and, if `angle` is given, those of the angle
/// between up and view.
pub fn of_basis(camera: &ResolvedCamera, angle: Option<UpAngle>) -> Vec<Reading> {
    let basis = camera.basis();
    let mut readings = vec![
        Reading::new("u", "u (right)", Concept::U, ReadingValue::Vector(basis.u)),
        Reading::new("v", "v (up in the image)", Concept::V, ReadingValue::Vector(basis.v)),
        Reading::new("w", "w (backwards)", Concept::W, ReadingValue::Vector(basis.w)),
    ];
    readings.extend(angle.into_iter().flat_map(|angle| {
        let (up, conditioning) = (Concept::Up, ReadingValue::Number(angle.conditioning));
        [
            Reading::new("angle(up, view)", "angle of up and view", up, ReadingValue::Angle(angle)),
            Reading::new("sensitivity", "conditioning", up, conditioning),
        ]
    }));
    readings
}

impl Inspection {
    /// Returns the readings (named quantities) of the ray itself, for an image of this size.
    pub fn ray_readings(&self, image: ImageSize) -> [Reading; 5] {
        let length = ReadingValue::Number(self.ray.distance_along(1.0));
        let (pixel, d) = (ReadingValue::Pixel(self.image_position, image), Concept::Direction);
        [
            Reading::new("pixel", "pixel", Concept::Pixel, pixel),
            Reading::new("(u, v)", "(u, v)", Concept::Pixel, ReadingValue::Uv(self.uv)),
            Reading::new("p", "origin p", Concept::Eye, ReadingValue::Vector(self.ray.origin)),
            Reading::new("d", "direction d", d, ReadingValue::Vector(self.ray.direction)),
            Reading::new("|d|", "length of d", d, length),
        ]
    }

    /// Returns the readings of the root with this index.
    pub fn root_readings(&self, index: usize) -> [Reading; 4] {
        let root = &self.roots[index];
        let values = [
            ("t", ReadingValue::Number(root.t)),
            ("distance", ReadingValue::Number(self.distances[index])),
            ("point", ReadingValue::Vector(root.point)),
            ("normal", ReadingValue::Vector(root.normal)),
        ];
        values.map(|(name, value)| Reading::new(name, name, self.concept_of(root), value))
    }

    /// Returns the readings (named quantities) of the first hit: its t, and its object's title. `title`
    /// maps an object's index to its title.
    pub fn hit_readings(&self, title: impl Fn(usize) -> String) -> Vec<Reading> {
        let hit = |concept, text| Reading {
            name: "hit",
            long_name: "hit",
            concept,
            value: ReadingValue::Text(text),
        };
        let Some(first) = self.first else { return vec![hit(None, "nothing".to_owned())] };
        let [t, ..] = self.root_readings(first);
        let title = title(self.roots[first].object as usize);
        let hit = hit(t.concept, title);
        vec![t, hit]
    }
}

impl NumberStyle {
    /// Returns this style with at most `digits` significant digits.
    pub fn at_most(self, digits: usize) -> NumberStyle {
        NumberStyle { digits: self.digits.min(digits), ..self }
    }

    /// Returns the rounding of numbers.
    pub fn rounding(self) -> Rounding {
        self.decimals.map_or(Rounding::Significant(self.digits), Rounding::Decimals)
    }

    /// Writes a number.
    pub fn number(self, x: f64) -> String {
        self.rounding().text(x).replace('-', "−")
    }

    /// Returns the sign to write before numbers: `=` if all of them are written exactly, otherwise `≈`.
    pub fn relation(self, shown: &[f64]) -> char {
        self.rounding().relation(shown)
    }

    /// Formats a number as the right side of an equation: `= 0.5`, but `≈ 0.33333`.
    pub fn equated(self, x: f64) -> String {
        self.equated_value(&ReadingValue::Number(x))
    }

    /// Formats a value as the right side of an equation, with `≈` before a rounded one.
    pub fn equated_value(self, value: &ReadingValue) -> String {
        let relation = match value {
            ReadingValue::Number(x) => self.relation(&[*x]),
            ReadingValue::Uv(uv) => self.relation(&uv.to_array()),
            ReadingValue::Vector(v) => self.relation(&v.to_array()),
            ReadingValue::Angle(angle) => self.relation(&[self.shown_degrees(*angle).1]),
            ReadingValue::Pixel(..) | ReadingValue::Text(_) => '=',
        };
        format!("{relation} {}", self.text(value))
    }

    /// Writes a vector.
    pub fn vector(self, v: DVec3) -> String {
        format!("({}, {}, {})", self.number(v.x), self.number(v.y), self.number(v.z))
    }

    /// Writes a position (u, v).
    pub fn uv(self, uv: DVec2) -> String {
        format!("({}, {})", self.number(uv.x), self.number(uv.y))
    }

    /// Writes the row and the column of a pixel.
    pub fn pixel(self, pixel: Pixel) -> String {
        let from = u32::from(self.count_from_one);
        let counted = if self.count_from_one { " (from 1)" } else { "" };
        format!("row {}, column {}{counted}", pixel.row + from, pixel.column + from)
    }

    /// Writes a value.
    pub fn text(self, value: &ReadingValue) -> String {
        match value {
            ReadingValue::Number(x) => self.number(*x),
            ReadingValue::Uv(uv) => self.uv(*uv),
            ReadingValue::Vector(v) => self.vector(*v),
            ReadingValue::Angle(angle) => {
                let (prefix, degrees) = self.shown_degrees(*angle);
                format!("{prefix}{}°", self.number(degrees))
            }
            ReadingValue::Text(text) => text.clone(),
            ReadingValue::Pixel(None, _) => "outside the image".to_owned(),
            ReadingValue::Pixel(Some(position), image) => match position.only_pixel() {
                Some(pixel) => self.pixel(pixel),
                None if position.touching(*image).len() == 4 => {
                    "the corner of four pixels".to_owned()
                }
                None => "on an edge between pixels".to_owned(),
            },
        }
    }

    /// Returns the number of degrees that stands for the angle between up and view, after a prefix. A valid
    /// camera's angle is below 180 degrees, so an angle that rounds to 180 is written as 180 minus the
    /// difference.
    fn shown_degrees(self, UpAngle { angle, conditioning }: UpAngle) -> (&'static str, f64) {
        let degrees = angle.to_degrees();
        if self.number(degrees) == self.number(180.0) {
            ("180° − ", (1.0 / conditioning).asin().to_degrees())
        } else {
            ("", degrees)
        }
    }
}
