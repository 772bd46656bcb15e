//! The buffers of a frame, and the part of them that a band of rows fills.

use std::ops::Range;

use glam::DVec3;

use crate::camera::resolved::ResolvedCamera;
use crate::exact::steps::Steps;
use crate::render::frame::counts::Counts;
use crate::render::frame::depth::Depth;
use crate::render::frame::{Frame, Outputs, Raster};

/// A frame with room for what is asked for.
pub(crate) fn empty_frame<T: Depth>(
    camera: &ResolvedCamera,
    raster: &Raster,
    outputs: Outputs,
) -> Frame<T> {
    // Zeroed memory costs nothing until a band, in its own thread, fills it.
    let pixels = |asked: bool| if asked { raster.len() } else { 0 };
    Frame {
        camera: *camera,
        raster: raster.clone(),
        t: vec![T::ZERO; pixels(outputs.t)],
        object: vec![0; pixels(outputs.object)],
        normal: vec![DVec3::ZERO; pixels(outputs.normal)],
        steps: Steps::default(),
        counts: Counts::default(),
        steps_of_t: Steps::default(),
    }
}

/// A band's part of each buffer; empty where that was not asked for.
pub(crate) struct BandBuffers<'a, T> {
    pub(crate) t: &'a mut [T],
    pub(crate) object: &'a mut [u32],
    pub(crate) normal: &'a mut [DVec3],
}

/// A thread's own buffers, in place of those that were not asked for.
pub(crate) struct OwnBuffers<T> {
    pub(crate) t: Vec<T>,
    pub(crate) object: Vec<u32>,
    /// `t` as it is drawn, for a frame that keeps it in another precision.
    pub(crate) drawn: Vec<f32>,
}

impl<T> OwnBuffers<T> {
    pub(crate) fn new() -> OwnBuffers<T> {
        OwnBuffers { t: Vec::new(), object: Vec::new(), drawn: Vec::new() }
    }
}

/// The buffers of all bands, each of so many rows of so many columns, one after the other.
pub(crate) fn band_buffers<'a, T>(
    mut t: &'a mut [T],
    mut object: &'a mut [u32],
    mut normal: &'a mut [DVec3],
    (bands, width): (&[Range<usize>], usize),
) -> Vec<BandBuffers<'a, T>> {
    let next = |rows: &Range<usize>| {
        let pixels = rows.len() * width;
        let (t, object) = (first_of(&mut t, pixels), first_of(&mut object, pixels));
        BandBuffers { t, object, normal: first_of(&mut normal, pixels) }
    };
    bands.iter().map(next).collect()
}

/// Splits off the first part of a buffer; an empty one where there is none.
fn first_of<'a, T>(buffer: &mut &'a mut [T], size: usize) -> &'a mut [T] {
    buffer.split_off_mut(..size).unwrap_or_default()
}

/// A buffer's part; where that was not asked for, as much of the thread's own.
pub(crate) fn or_own<'a, T: Copy>(
    part: &'a mut [T],
    own: &'a mut Vec<T>,
    len: usize,
    zero: T,
) -> &'a mut [T] {
    if part.len() == len {
        return part;
    }
    own.resize(len.max(own.len()), zero);
    &mut own[..len]
}
