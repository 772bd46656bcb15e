//! Rays from a CSV file: header `ox,oy,oz,dx,dy,dz`, a row a ray.

use std::path::Path;

use pinhole_core::{DVec3, Ray};

use super::table::CsvTable;
use crate::FileError;

const COLUMNS: &[&str] = &["ox", "oy", "oz", "dx", "dy", "dz"];

/// Reads the rays of a file's content; `path` is for the messages.
///
/// # Errors
/// Returns the first row at fault with its line, column and value: a text that is no finite number,
/// or a direction of zero.
pub fn parse(path: &Path, bytes: &[u8]) -> Result<Vec<Ray>, FileError> {
    let mut rays = Vec::new();
    CsvTable::new(path, bytes, COLUMNS, COLUMNS.len())?.for_each(|row| {
        let vector = |x: usize| {
            Ok::<_, FileError>(DVec3::new(row.number(x)?, row.number(x + 1)?, row.number(x + 2)?))
        };
        let (origin, direction) = (vector(0)?, vector(3)?);
        if direction == DVec3::ZERO {
            return Err(row.error(3, "the direction (dx, dy, dz) is zero: it must point somewhere"));
        }
        rays.push(Ray { origin, direction });
        Ok(())
    })?;
    Ok(rays)
}
