//! Many spheres from a CSV file: header `x,y,z,r`, and `color`, `name` where wanted, in any order.

use std::path::Path;

use pinhole_core::{DVec3, Sphere};

use super::table::CsvTable;
use crate::document::Item;
use crate::images::color;
use crate::{FileError, limits};

const COLUMNS: &[&str] = &["x", "y", "z", "r", "color", "name"];
const REQUIRED: usize = 4;
const X: usize = 0;
const Y: usize = 1;
const Z: usize = 2;
const R: usize = 3;
const COLOR: usize = 4;
const NAME: usize = 5;

/// Reads the spheres of a file.
///
/// # Errors
/// Returns an error if the file cannot be read, or the first row at fault with its line, column and
/// value.
pub fn load(path: &Path) -> Result<Vec<Item<Sphere>>, FileError> {
    parse(path, &limits::read(path, limits::TABLE)?)
}

/// Reads the spheres of a file's content; `path` is for the messages.
///
/// # Errors
/// Returns the first row at fault with its line, column and value.
pub fn parse(path: &Path, bytes: &[u8]) -> Result<Vec<Item<Sphere>>, FileError> {
    let mut spheres = Vec::new();
    CsvTable::new(path, bytes, COLUMNS, REQUIRED)?.for_each(|row| {
        let center = DVec3::new(row.number(X)?, row.number(Y)?, row.number(Z)?);
        let radius = row.number(R)?;
        if radius <= 0.0 {
            return Err(row.error(R, "it must be greater than 0"));
        }
        let color = match row.text(COLOR)? {
            None => None,
            Some(text) => Some(
                color::parse(text)
                    .ok_or_else(|| row.error(COLOR, "it must be a colour such as #e69f00"))?,
            ),
        };
        let name = row.text(NAME)?.map(str::to_owned);
        spheres.push(Item { name, color, shape: Sphere { center, radius } });
        Ok(())
    })?;
    spheres.shrink_to_fit();
    Ok(spheres)
}
