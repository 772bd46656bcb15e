//! The boundaries between the window's areas.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

use serde::{Deserialize, Serialize};

/// A boundary between two areas.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Split {
    /// The world view's share of the width, beside the camera view.
    Views,
    /// The world view's share of the height, above the camera view.
    Stack,
    /// The world view's share of the width, where the ghost's picture is beside the camera's.
    CompareViews,
    /// The same in practice.
    PracticeViews,
    /// The views' share of the width, beside the derivation or the translator.
    Derivation,
    /// The readouts' height, in points. All that follow are heights, too.
    Readouts,
    /// Plot and table in the accuracy view.
    Accuracy,
    /// The plot of f(p + t d).
    Plot,
    /// The text about a wrong camera.
    Mistakes,
    /// Both cameras in numbers.
    Compare,
    /// The text about a student's answers.
    Answers,
}

const SHARE: RangeInclusive<f32> = 0.0..=1.0;
const HEIGHT: RangeInclusive<f32> = 0.0..=10_000.0;

/// Default and range of each boundary, in the enum's order.
const TABLE: [(Split, f32, RangeInclusive<f32>); 11] = [
    (Split::Views, 0.54, SHARE),
    (Split::Stack, 0.55, SHARE),
    (Split::CompareViews, 0.42, SHARE),
    (Split::PracticeViews, 0.38, SHARE),
    (Split::Derivation, 0.5, SHARE),
    (Split::Readouts, 200.0, HEIGHT),
    (Split::Accuracy, 370.0, HEIGHT),
    (Split::Plot, 300.0, HEIGHT),
    (Split::Mistakes, 330.0, HEIGHT),
    (Split::Compare, 230.0, HEIGHT),
    (Split::Answers, 230.0, HEIGHT),
];

/// The positions of all boundaries, each within its range.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(from = "BTreeMap<Split, f32>", into = "BTreeMap<Split, f32>")]
pub struct Splits([f32; TABLE.len()]);

impl Splits {
    /// Returns the position of a boundary.
    pub fn get(&self, split: Split) -> f32 {
        self.0[split as usize]
    }

    /// Returns true if a boundary is where it is by default.
    pub fn is_default(&self, split: Split) -> bool {
        self.get(split) == TABLE[split as usize].1
    }

    /// Moves a boundary, clamped to its range; to its default if `to` is not finite.
    pub fn set(&mut self, split: Split, to: f32) {
        let (_, first, range) = &TABLE[split as usize];
        let to = if to.is_finite() { to } else { *first };
        self.0[split as usize] = to.clamp(*range.start(), *range.end());
    }
}

impl Default for Splits {
    fn default() -> Splits {
        Splits(TABLE.map(|(_, first, _)| first))
    }
}

impl From<BTreeMap<Split, f32>> for Splits {
    fn from(known: BTreeMap<Split, f32>) -> Splits {
        let mut splits = Splits::default();
        for (split, to) in known {
            splits.set(split, to);
        }
        splits
    }
}

impl From<Splits> for BTreeMap<Split, f32> {
    fn from(splits: Splits) -> BTreeMap<Split, f32> {
        TABLE.iter().map(|(split, ..)| (*split, splits.get(*split))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_in_the_enums_order_and_its_values_are_in_range() {
        for (k, (split, first, range)) in TABLE.iter().enumerate() {
            assert_eq!(*split as usize, k);
            assert!(range.contains(first), "{split:?}");
        }
    }
}
