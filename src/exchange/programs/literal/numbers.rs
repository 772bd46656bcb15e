//! Numbers alone: eye, at and up, or a matrix from camera to world.

use pinhole_core::{Camera, Orientation, fov_of_extent};

use super::{Source, last_segment, three};
use crate::FileError;
use crate::format::affine::Affine;
use crate::format::pose::Pose;
use crate::format::text::n;
use crate::format::viewport::viewport_of_angle;
use crate::format::{Imported, Importer, Input};

pub(crate) const IMPORTER: Importer =
    Importer { name: "numbers", label: "eye at up or a matrix in numbers", read, detect };

/// Names of a matrix from camera to world whose camera looks along its own -z with y up.
const MATRICES: [&str; 6] =
    ["matrix_world", "matrixWorld", "camera_to_world", "cameraToWorld", "c2w", "cam2world"];

const RIGHT: &str = "it must be nine numbers (eye, at, up), ten (and the vertical angle in degrees), or a \
                     3 × 4 or 4 × 4 matrix from camera to world, and nothing else: a program is not run";

fn detect(text: &str) -> bool {
    let text = text.trim_start();
    let is_named = MATRICES.iter().any(|name| {
        let matches = text.match_indices(name);
        matches.into_iter().any(|(at, name)| text[at + name.len()..].trim_start().starts_with('='))
    });
    let of_numbers =
        |c: char| c.is_ascii_digit() || c.is_whitespace() || "()[],.;+-eE\u{feff}".contains(c);
    let is_numbers =
        text.chars().all(of_numbers) && text.matches(|c: char| c.is_ascii_digit()).nth(8).is_some();
    is_named || is_numbers
}

fn read(text: &Input, at_hand: &Camera) -> Result<Imported, FileError> {
    let source = Source::new(text, RIGHT)?;
    let mut numbers = Vec::new();
    for statement in &source.statements {
        let is_matrix = MATRICES.contains(&last_segment(&statement.target));
        let is_alone = is_matrix && source.statements.len() == 1;
        if !(statement.called.is_empty() && (statement.target.is_empty() || is_alone)) {
            return Err(source.refused(statement, RIGHT));
        }
        for argument in &statement.arguments {
            numbers.extend(source.numbers("this", argument)?);
        }
    }
    let Some(first) = source.statements.first() else {
        return Err(source.missing("a number", RIGHT));
    };
    let refused = |right: &str| source.refused(first, right);
    let is_named = !first.target.is_empty();
    // A rotation alone, as [[1, 0, 0], ...], is no camera.
    let mut signs = first.text.chars().filter(|c| !c.is_whitespace());
    let is_rotation = [signs.next(), signs.next()].iter().flatten().all(|c| "([{".contains(*c))
        && source.statements.len() == 1
        && first.arguments.len() == 1;
    match (numbers.len(), <[f64; 9]>::try_from(numbers.get(..9).unwrap_or_default())) {
        (9, Ok(points)) if !is_named && !is_rotation => Ok(look_at(points, None, at_hand)),
        (10, Ok(points)) if !is_named => match numbers[9] {
            degrees if degrees > 0.0 && degrees < 180.0 => {
                Ok(look_at(points, Some(degrees), at_hand))
            }
            _ => Err(refused(
                "the tenth number is the vertical angle: it must be between 0 and 180 degrees",
            )),
        },
        _ => {
            let by_rows = Affine::from_rows(&numbers).map(|affine| (affine, "columns"));
            let found =
                by_rows.or_else(|| Affine::from_columns(&numbers).map(|affine| (affine, "rows")));
            let (affine, vectors) = found.ok_or_else(|| refused(RIGHT))?;
            matrix(&affine, vectors, at_hand).map_err(|right| refused(&right))
        }
    }
}

fn look_at(points: [f64; 9], degrees: Option<f64>, at_hand: &Camera) -> Imported {
    let [eye, at, up] = three(points);
    let orientation = Orientation::At { at, up };
    let viewport = match degrees {
        Some(degrees) => viewport_of_angle(
            degrees,
            at_hand.viewport.width / at_hand.viewport.height,
            at_hand.viewport.distance,
        ),
        None => at_hand.viewport,
    };
    let mut notes = vec!["taken as eye, at and up, in this order".to_owned()];
    if degrees.is_none() {
        notes.push(unsaid(at_hand));
    }
    Imported::camera(Camera { eye, orientation, viewport, image: at_hand.image }, notes)
}

/// Takes a matrix whose `vectors`, rows or columns, are right, up, backwards and eye.
fn matrix(affine: &Affine, vectors: &str, at_hand: &Camera) -> Result<Imported, String> {
    let mut notes = vec![
        format!(
            "taken as the matrix from camera to world: its {vectors} are right, up, backwards and eye"
        ),
        unsaid(at_hand),
    ];
    if affine.scale().is_none_or(|scale| (scale - 1.0).abs() > 1e-9) {
        notes.push("its scale is left out".to_owned());
    }
    let (orientation, eye, _) = Pose::from_frame(affine)
        .right_handed(&mut notes)
        .map_err(|right| format!("it is no rotation: {right}"))?;
    Ok(Imported::camera(Camera { eye, orientation, ..*at_hand }, notes))
}

/// Note on a field of view that no number gives.
fn unsaid(at_hand: &Camera) -> String {
    let viewport = &at_hand.viewport;
    let degrees = fov_of_extent(viewport.height, viewport.distance).to_degrees();
    format!(
        "the field of view is not given: {} degrees from bottom to top kept",
        n((degrees * 1e4).round() / 1e4)
    )
}
