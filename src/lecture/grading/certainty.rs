//! Finds out whether a wrong answer would have been accepted as well as the given one.
//!
//! Where a ray grazes an object or surfaces meet, several answers are acceptable. In an ordinary picture
//! this zone is far thinner than a pixel, so that all of them may be called right at the few pixels in it.
//! If it covers a whole pixel, because the rounding of large numbers or the tolerance outgrows the picture,
//! an answer for that pixel says nothing.

use pinhole_core::{DVec3, Pixel, RankedRoot, Scene};

use super::diagnosis::GradingContext;
use super::first_hits::{Finding, FirstHits, PossibleHit};
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
        let find = |camera: &PipelineCamera| {
            let direction = camera.direction(pixel.row.into(), pixel.column.into());
            (FirstHits::find(scene, camera, direction, tolerance), direction)
        };
        let (first, direction) = find(&self.right);
        if !first.may_be(truth) {
            // The numbers are beyond the range in which their errors are estimated.
            return Certainty::Doubtful;
        }
        let (given, mut others): (Vec<_>, Vec<_>) =
            first.outcomes().partition(|outcome| is_given(direction, *outcome));
        let mut own: Vec<_> = given.iter().map(|hit| object(*hit)).collect();
        if own.is_empty() {
            own.push(truth);
        }
        others.retain(|other| !own.contains(&object(*other)));
        let may_be_vague = says_t && given.iter().any(|outcome| is_vague(*outcome));
        if others.is_empty() && !may_be_vague {
            return Certainty::Sure;
        }
        let is_open = |first: &FirstHits, others: &[Finding]| {
            let is_other = others.iter().any(|other| first.may_be(object(*other)));
            first.outcomes().any(|hit| {
                own.contains(&object(hit)) && (is_other || may_be_vague && is_vague(hit))
            })
        };
        let around = self.around.iter().map(|camera| find(camera).0);
        let around: Vec<FirstHits> = around.take_while(|first| is_open(first, &others)).collect();
        let may_be_open = around.len() == self.around.len();
        // Exact ties take long to decide, and nearly all edges are far from one.
        let meets = |hit: &PossibleHit| {
            let mut given = first.hits.iter().filter(|given| own.contains(&Some(given.object)));
            given.any(|given| given.least <= hit.most && hit.least <= given.most)
        };
        if !may_be_open && !others.iter().flatten().any(|hit| meets(hit)) {
            return Certainty::Sure;
        }
        let (tie, others) = self.without_ties(scene, pixel, &own, others);
        if may_be_open && is_open(&first, &others) && around.iter().all(|one| is_open(one, &others))
        {
            return Certainty::Doubtful;
        }
        tie.map_or(Certainty::Sure, Certainty::Tie)
    }

    /// Returns two objects that are hit first at exactly the same t, the first of which is one of `own`, and
    /// those of `others` that are wrong, because they are not in such a tie.
    fn without_ties<'a>(
        &self,
        scene: &Scene,
        pixel: Pixel,
        own: &[Option<u32>],
        others: Vec<Finding<'a>>,
    ) -> (Option<[u32; 2]>, Vec<Finding<'a>>) {
        let mut roots = Vec::new();
        if others.len() <= MOST {
            roots = scene.ranked_roots_of(&self.given.resolved.exact_ray(pixel));
        }
        let rank = roots.iter().find(|one| one.root.t > 0.0).map(|one| one.rank);
        let first_of_all = roots.iter().filter(|one| Some(one.rank) == rank);
        let tied: Vec<_> = first_of_all.map(|one| Some(one.root.object)).collect();
        let own_tied = own.iter().copied().find(|own| tied.contains(own)).flatten();
        let (exact, others): (Vec<_>, Vec<_>) = others.into_iter().partition(|other| {
            // An object that the eye is exactly on is not hit there.
            let is_zero =
                |one: &RankedRoot| one.root.t == 0.0 && Some(one.root.object) == object(*other);
            own_tied.is_some() && tied.contains(&object(*other))
                || other.is_some_and(|hit| hit.least <= 0.0) && roots.iter().any(is_zero)
        });
        let other = exact.into_iter().map(object).find(|other| tied.contains(other)).flatten();
        (own_tied.zip(other).map(<[u32; 2]>::from), others)
    }
}

fn object(outcome: Finding) -> Option<u32> {
    outcome.map(|hit| hit.object)
}

/// Returns true if a t says nothing, because it may be 0, or be off by itself.
fn is_vague(outcome: Finding) -> bool {
    outcome.is_some_and(|hit| hit.least <= 0.0 || hit.most - hit.least > hit.t)
}
