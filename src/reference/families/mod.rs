//! The families of cases that are hard, each with a knob that makes it harder; and inputs that must be
//! refused.

mod bases;
mod draw;
mod family;
mod frames;
mod invalid;
mod planes;
mod spheres;
mod ties;
mod touching_frames;

#[cfg(test)]
pub(crate) use draw::Draw;
pub use family::{BasisCase, Family, FrameCase, Kind, RayCase};
pub use invalid::{invalid_bases, invalid_cameras, invalid_rays};

/// All families of any rays, then of bases, then of frames.
static ALL: [&[Family]; 5] =
    [&spheres::FAMILIES, &planes::FAMILIES, &ties::FAMILIES, &bases::FAMILIES, &frames::FAMILIES];

impl Family {
    /// All of them: first those of rays, then of bases, then of frames.
    pub fn all() -> impl Iterator<Item = &'static Family> {
        ALL.into_iter().flatten()
    }

    /// The family of this name.
    pub fn named(name: &str) -> Option<&'static Family> {
        Family::all().find(|family| family.name() == name)
    }
}
