//! Finds out whether a wrong answer would have been accepted as well as the given one.
//!
//! Where a ray grazes an object or surfaces meet, several answers are acceptable. In an ordinary picture
//! this zone is far thinner than a pixel, so that all of them may be called right at the few pixels in it.
//! If it covers a whole pixel, because the rounding of large numbers or the tolerance outgrows the picture,
//! an answer for that pixel says nothing.

use pinhole_core::{DVec3, Pixel, RankedRoot, Scene};

use super::diagnosis::GradingContext;
use super::first_hits::{Finding, FirstHits};
use crate::mistakes::PipelineCamera;

/// Whether an accepted answer is known to be right.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Certainty {
    /// A wrong answer would have been refused.
    Sure,
    /// These two objects are hit at exactly the same t, so that either is right.
    Tie([u32; 2]),
    /// A wrong answer would have been accepted, too.
    Doubtful,
}

/// Maximum number of other objects among which exact ties, which are decided slowly, are looked for.
const MOST: usize = 16;

impl GradingContext<'_> {
    /// Returns whether an accepted answer about a pixel's first hit is known to be right: it is not if
    /// another one is as acceptable there and half a pixel away on all sides. `truth` is the object that is
    /// hit. `is_given` is true if the answer is a certain outcome, `says_t` if it depends on t.
    pub(super) fn certainty(
        &self,
        scene: &Scene,
        (pixel, truth): (Pixel, Option<u32>),
        tolerance: f64,
        says_t: bool,
        is_given: impl Fn(DVec3, Finding) -> bool,
    ) -> Certainty {
        let direction =
            |camera: &PipelineCamera| camera.direction(pixel.row.into(), pixel.column.into());
        let find = |camera| FirstHits::find(scene, camera, direction(camera), tolerance);
        let (first, direction) = (find(&self.right), direction(&self.right));
        if !first.may_be(truth) {
            // The numbers are beyond the range in which their errors are estimated.
            return Certainty::Doubtful;
        }
        let object = |outcome: Finding| outcome.map(|hit| hit.object);
        // A t says nothing if it may be 0, or if it may be off by itself.
        let is_vague =
            |hit: &Finding| says_t && hit.is_some_and(|h| h.least <= 0.0 || h.most - h.least > h.t);
        let (given, mut others): (Vec<_>, Vec<_>) =
            first.outcomes().partition(|outcome| is_given(direction, *outcome));
        let mut own: Vec<_> = given.iter().map(|hit| object(*hit)).collect();
        if own.is_empty() {
            own.push(truth);
        }
        others.retain(|other| !own.contains(&object(*other)));
        let may_be_vague = given.iter().any(is_vague);
        if others.is_empty() && !may_be_vague {
            return Certainty::Sure;
        }
        let mut roots = Vec::new();
        if others.len() <= MOST {
            roots = scene.ranked_roots_of(&self.given.resolved.exact_ray(pixel));
        }
        let rank = roots.iter().find(|one| one.root.t > 0.0).map(|one| one.rank);
        let first_of_all = roots.iter().filter(|one| Some(one.rank) == rank);
        let tied: Vec<_> = first_of_all.map(|one| Some(one.root.object)).collect();
        let own_tied = own.iter().find(|own| tied.contains(own));
        let (exact, others): (Vec<_>, Vec<_>) = others.into_iter().partition(|other| {
            // An object that the eye is exactly on is not hit there.
            let is_zero =
                |one: &RankedRoot| one.root.t == 0.0 && Some(one.root.object) == object(*other);
            own_tied.is_some() && tied.contains(&object(*other))
                || other.is_some_and(|hit| hit.least <= 0.0) && roots.iter().any(is_zero)
        });
        let is_open = |first: &FirstHits| {
            let is_own = |outcome: &Finding| own.contains(&object(*outcome));
            first.outcomes().any(|hit| is_own(&hit))
                && others.iter().any(|other| first.may_be(object(*other)))
                || may_be_vague && first.outcomes().any(|hit| is_own(&hit) && is_vague(&hit))
        };
        if is_open(&first) && self.around.iter().all(|camera| is_open(&find(camera))) {
            return Certainty::Doubtful;
        }
        let other = exact.into_iter().map(object).find(|other| tied.contains(other));
        match (own_tied, other) {
            (Some(Some(own)), Some(Some(other))) => Certainty::Tie([*own, other]),
            _ => Certainty::Sure,
        }
    }
}
