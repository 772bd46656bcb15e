//! The spheres and planes of a POV-Ray scene that stand by themselves.

use pinhole_core::{DVec3, Plane, Sphere};

use super::blocks::Blocks;
use super::source::{Code, words};
use super::values::{Value, Values, vector};
use crate::FileError;
use crate::document::Item;
use crate::format::affine::Affine;
use crate::format::left_out::readable;
use crate::format::text::byte_of_light;
use crate::format::viewport::settled;
use crate::programs::pieces::{Piece, is_of_word};

/// Reader of a scene's objects.
struct Objects<'c, 't> {
    code: &'c Code<'c>,
    values: &'c Values<'t>,
    /// Colours that are there and could not be read.
    unpainted: usize,
}

/// The spheres and planes among a scene's blocks.
pub(super) fn objects(
    code: &Code,
    values: &Values,
    blocks: &Blocks,
    notes: &mut Vec<String>,
) -> (Vec<Item<Sphere>>, Vec<Item<Plane>>) {
    let mut objects = Objects { code, values, unpainted: 0 };
    let spheres = blocks.spheres.iter().map(|block| objects.sphere(*block));
    let spheres = readable(spheres, "sphere", notes);
    let planes = blocks.planes.iter().map(|block| objects.plane(*block));
    let planes = readable(planes, "plane", notes);
    if objects.unpainted > 0 {
        notes.push(format!(
            "{} of pigment or texture left out: a colour must be rgb <1, 0.5, 0> or a name such as Red",
            objects.unpainted
        ));
    }
    (spheres, planes)
}

impl Objects<'_, '_> {
    fn sphere(&mut self, block: Piece) -> Result<Item<Sphere>, FileError> {
        let (center, rest) = self.beginning("sphere", "sphere centre", block)?;
        let right = "it must have a radius greater than 0, as sphere { <0, 0, 0>, 1 }";
        let (radius, modifiers) = self
            .number(rest)
            .filter(|(radius, _)| *radius > 0.0)
            .ok_or_else(|| self.code.fault("sphere", block, right))?;
        let placed = self.steps(modifiers)?;
        let right = "it must not be scaled to an ellipsoid";
        let scale = placed.scale().ok_or_else(|| self.code.fault("sphere", block, right))?;
        let (center, radius) = match placed == Affine::IDENTITY {
            true => (center, radius),
            false => {
                (plain(placed.point(center)), settled(radius * scale, 4.0 * f64::EPSILON * scale))
            }
        };
        if !(center.is_finite() && radius.is_finite()) {
            return Err(self.code.fault("sphere", block, "its numbers must be finite"));
        }
        Ok(Item { name: None, color: self.color(block), shape: Sphere { center, radius } })
    }

    fn plane(&mut self, block: Piece) -> Result<Item<Plane>, FileError> {
        let (normal, rest) = self.beginning("plane", "plane's normal", block)?;
        let right = "it must have a normal and a distance, as plane { <0, 1, 0>, -1 }";
        let (distance, modifiers) = self
            .number(rest)
            .filter(|_| normal.try_normalize().is_some())
            .ok_or_else(|| self.code.fault("plane", block, right))?;
        let mut shape = Plane { point: normal.normalize() * distance + DVec3::ZERO, normal };
        let placed = self.steps(modifiers)?;
        if placed != Affine::IDENTITY {
            // A normal goes by the inverse transposed: here times the determinant.
            let Affine { x, y, z, .. } = placed;
            let turned = normal.x * y.cross(z) + normal.y * z.cross(x) + normal.z * x.cross(y);
            let turned = turned * x.dot(y.cross(z)).signum();
            let right = "it must not be scaled to nothing";
            let turned =
                turned.try_normalize().ok_or_else(|| self.code.fault("plane", block, right))?;
            shape = Plane { point: plain(placed.point(shape.point)), normal: plain(turned) };
        }
        if !shape.point.is_finite() {
            return Err(self.code.fault("plane", block, "its numbers must be finite"));
        }
        Ok(Item { name: None, color: self.color(block), shape })
    }

    /// The vector with which an object begins, and what follows it and its comma.
    fn beginning<'p>(
        &self,
        name: &str,
        field: &str,
        block: Piece<'p>,
    ) -> Result<(DVec3, Piece<'p>), FileError> {
        let code = self.code;
        if let Some(piece) = words(block, "clipped_by").first() {
            let piece = Piece { text: "clipped_by", at: block.at + piece };
            return Err(code.fault(name, piece, "Pinhole has whole spheres and planes"));
        }
        let found =
            self.values.prefix(block).and_then(|(value, rest)| Some((vector(&value)?, rest)));
        let Some((value, rest)) = found else {
            let right = "it must be a vector of numbers, as <1, 2, 3>";
            return Err(code.fault(field, given(code, block.trimmed()), right));
        };
        let rest = rest.after_spaces();
        Ok((value, if rest.text.starts_with(',') { rest.from(1) } else { rest }))
    }

    /// The number with which a piece begins, and what follows.
    fn number<'p>(&self, piece: Piece<'p>) -> Option<(f64, Piece<'p>)> {
        match self.values.prefix(piece)? {
            (value, rest) if value.len() == 1 => Some((value[0], rest)),
            _ => None,
        }
    }

    /// Returns the map that an object's modifiers make, one step after the other.
    fn steps(&self, modifiers: Piece) -> Result<Affine, FileError> {
        let code = self.code;
        let mut placed = Affine::IDENTITY;
        let mut rest = modifiers;
        while let Some(c) = rest.text.chars().next() {
            if c == '#' {
                let right = "no directive must stand in it";
                return Err(code.fault("object", rest.from(1).word(), right));
            }
            if !is_of_word(c) {
                // What is in the braces of a texture moves the texture.
                let inside = code.bracketed(rest).filter(|_| c == '{');
                rest = rest.from(inside.map_or(c.len_utf8(), |inside| inside.text.len() + 2));
                continue;
            }
            let word = rest.word();
            rest = rest.from(word.text.len()).after_spaces();
            let right = match word.text {
                "translate" | "scale" | "rotate" => "it must be a vector of numbers, as <1, 2, 3>",
                "matrix" => "it must be twelve numbers",
                "transform" => {
                    let right =
                        "it must be taken apart: translate, scale, rotate or matrix by itself";
                    return Err(code.fault("transform", given(code, rest), right));
                }
                _ => continue,
            };
            let step = self.values.prefix(rest);
            let step = step.and_then(|(value, after)| Some((step_of(word.text, &value)?, after)));
            let (step, after) =
                step.ok_or_else(|| code.fault(word.text, given(code, rest), right))?;
            placed = step.after(&placed);
            rest = after;
        }
        Ok(placed)
    }

    /// The colour of the first pigment.
    fn color(&mut self, block: Piece) -> Option<[u8; 3]> {
        let pigment = words(block, "pigment").first().map(|at| at + "pigment".len());
        if pigment.is_none() && words(block, "texture").is_empty() {
            return None;
        }
        let pigment = pigment.map(|at| block.from(at).after_spaces());
        let inside = pigment.and_then(|open| self.code.bracketed(open));
        let light = inside
            .and_then(|inside| self.values.prefix(inside))
            .and_then(|(value, _)| light(&value));
        self.unpainted += usize::from(light.is_none());
        light.map(|light| light.map(byte_of_light))
    }
}

fn light(value: &Value) -> Option<[f64; 3]> {
    match value[..] {
        [grey] => Some([grey; 3]),
        [r, g, b, ..] if value.len() <= 5 => Some([r, g, b]),
        _ => None,
    }
}

/// Returns the text behind a word, up to the next one.
fn given<'p>(code: &Code, open: Piece<'p>) -> Piece<'p> {
    let end = match code.bracketed(open) {
        Some(inside) => inside.text.len() + 2,
        None => open.text.find([',', '{', '}', '\n']).unwrap_or(open.text.len()),
    };
    open.until(end)
}

fn step_of(word: &str, value: &Value) -> Option<Affine> {
    match word {
        "matrix" => matrix(value),
        "translate" => vector(value).map(Affine::translation),
        "scale" => vector(value).map(Affine::scaling),
        _ => vector(value).map(rotation),
    }
}

/// About x, then y, then z.
fn rotation(degrees: DVec3) -> Affine {
    [(degrees.x, DVec3::X), (degrees.y, DVec3::Y), (degrees.z, DVec3::Z)]
        .into_iter()
        .filter_map(|(degrees, axis)| Affine::rotation(degrees, axis))
        .fold(Affine::IDENTITY, |before, turn| turn.after(&before))
}

/// Returns the map that takes x, y, z and the origin to these places.
fn matrix(m: &[f64]) -> Option<Affine> {
    let row = |k: usize| DVec3::new(m[k], m[k + 1], m[k + 2]);
    (m.len() == 12).then(|| Affine { x: row(0), y: row(3), z: row(6), at: row(9) })
}

/// A vector without the digits that the sines and cosines of right angles leave.
fn plain(v: DVec3) -> DVec3 {
    let roundings = 4.0 * f64::EPSILON * v.length();
    DVec3::from_array(v.to_array().map(|x| settled(x, roundings)))
}
