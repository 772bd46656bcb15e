//! Hit test: finds the handle at a position of the picture.

use pinhole_core::DVec2;

use super::Grip;
use crate::model::session::hand::Handle;

/// The result of a hit test.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hit {
    /// The handle.
    pub handle: Handle,
    /// Number of handles that lie together there, including itself.
    pub together: usize,
}

/// Distance up to which handles lie together, as a share of the reach.
const TOGETHER: f64 = 0.4;

/// Returns the handle nearest to a position, at most `reach` away, all in dots. Among handles that
/// lie together with it, the first one is returned, or the one after the handle that was clicked
/// last.
pub fn hit(grips: &[Grip], at: DVec2, reach: f64, clicked: Option<Handle>) -> Option<Hit> {
    let near = grips.iter().filter(|grip| grip.spot.distance(at) <= reach);
    // `min_by` returns the first of equally near ones.
    let nearest = near.min_by(|a, b| a.spot.distance(at).total_cmp(&b.spot.distance(at)))?;
    let beside = |grip: &&Grip| grip.spot.distance(nearest.spot) <= TOGETHER * reach;
    let group: Vec<Handle> = grips.iter().filter(beside).map(|grip| grip.handle).collect();
    let after = clicked.and_then(|clicked| group.iter().position(|handle| *handle == clicked));
    let handle = group[after.map_or(0, |k| (k + 1) % group.len())];
    Some(Hit { handle, together: group.len() })
}

#[cfg(test)]
mod tests {
    use pinhole_core::DVec3;

    use super::*;

    fn grip(handle: Handle, x: f64, y: f64) -> Grip {
        Grip { handle, at: DVec3::ZERO, spot: DVec2::new(x, y) }
    }

    #[track_caller]
    fn assert_hit(grips: &[Grip], at: [f64; 2], clicked: Option<Handle>, expected: Option<Handle>) {
        let found = hit(grips, DVec2::from_array(at), 10.0, clicked);
        assert_eq!(found.map(|hit| hit.handle), expected);
    }

    #[test]
    fn the_nearest_within_reach() {
        let grips = [grip(Handle::Eye, 0.0, 0.0), grip(Handle::At, 12.0, 0.0)];
        assert_hit(&grips, [5.0, 0.0], None, Some(Handle::Eye));
        assert_hit(&grips, [7.0, 0.0], None, Some(Handle::At));
        assert_hit(&grips, [7.0, 0.0], Some(Handle::At), Some(Handle::At));
        assert_hit(&grips, [23.0, 0.0], None, None);
        assert_hit(&[], [0.0, 0.0], None, None);
    }

    #[test]
    fn those_that_lie_together_take_turns() {
        let grips = [
            grip(Handle::At, 1.0, 0.0),
            grip(Handle::Center(0), 0.0, 0.0),
            grip(Handle::Pixel, 0.0, 2.0),
        ];
        let mut clicked = None;
        for expected in [Handle::At, Handle::Center(0), Handle::Pixel, Handle::At] {
            assert_hit(&grips, [0.0, 1.0], clicked, Some(expected));
            clicked = Some(expected);
        }
        assert_eq!(hit(&grips, DVec2::ZERO, 10.0, None).map(|hit| hit.together), Some(3));
    }
}
