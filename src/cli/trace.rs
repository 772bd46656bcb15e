//! `pinhole trace`: intersects the rays in one CSV file with a scene, and writes the hits to another.

use std::io::{self, Write};

use pinhole_core::{Ray, Root, Scene};
use pinhole_exchange::{csv, limits};
use rayon::prelude::*;

use super::console::{CommandError, open, scene_fault};
use super::load::{deliver, files_of, load, refuse_reading_twice};
use crate::cli::arguments::TraceArguments;

/// Number of rays that are traced and written at a time: enough to keep every core busy, few enough to
/// fit in memory.
const CHUNK: usize = 1 << 16;

pub(super) fn run(arguments: &TraceArguments) -> Result<(), CommandError> {
    refuse_reading_twice(&arguments.scene, ("--rays", &arguments.rays))?;
    let document = load(&arguments.scene)?;
    let scene = document.scene().map_err(|error| scene_fault(&arguments.scene, error))?;
    // All rays are read before the first is traced, to avoid partial output if a row is invalid.
    let (path, source) = open(&arguments.rays, limits::TABLE)?;
    let rays = csv::rays(path, source)?;
    let mut inputs = files_of(&arguments.scene, &document);
    inputs.push(arguments.rays.clone());
    deliver(arguments.output.as_deref(), &inputs, |out| write_hits(&scene, &rays, out))
}

fn write_hits(scene: &Scene, rays: &[Ray], out: &mut dyn Write) -> io::Result<()> {
    // Built now, because otherwise several threads would build the index at the same time.
    scene.make_index();
    writeln!(out, "object,t,px,py,pz,nx,ny,nz")?;
    for chunk in rays.chunks(CHUNK) {
        let hits: Vec<Option<Root>> = chunk.par_iter().map(|ray| scene.first_hit(ray)).collect();
        for hit in hits {
            write_hit(out, hit)?;
        }
    }
    Ok(())
}

/// Writes a hit or a miss as a row. Numbers have the shortest form that reads back to the same `f64`.
/// All cells of a miss are empty, and so is the cell of a number beyond the range of `f64`.
fn write_hit(out: &mut dyn Write, hit: Option<Root>) -> io::Result<()> {
    let Some(Root { object, t, point: p, normal: n }) = hit else {
        return writeln!(out, ",,,,,,,");
    };
    write!(out, "{object}")?;
    for x in [t, p.x, p.y, p.z, n.x, n.y, n.z] {
        if x.is_finite() { write!(out, ",{x:?}")? } else { write!(out, ",")? }
    }
    writeln!(out)
}
