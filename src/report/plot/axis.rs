//! Scales: from numbers to places along a panel's edge, and the numbers written there.

use crate::model::number::{power_of_ten, short_plain as short};

/// A stretch of a panel's edge, in points; may run backwards.
pub(crate) type Stretch = [f64; 2];

/// A logarithmic scale over whole decades, with a position of its own for zero.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Decades {
    low: i32,
    high: i32,
    along: Stretch,
    zero: f64,
}

/// A number and where it is written.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tick {
    pub(crate) at: f64,
    pub(crate) text: String,
}

impl Decades {
    /// Creates a scale over all positive values; zeros stand at `zero`.
    pub(crate) fn over(values: impl Iterator<Item = f64>, along: Stretch, zero: f64) -> Decades {
        let [low, high] = range(values).unwrap_or([0.5, 1.0]);
        let (low, mut high) = (low.log10().floor() as i32, high.log10().ceil() as i32);
        if high <= low {
            high = low + 1;
        }
        Decades { low, high, along, zero }
    }

    /// Position of a value along the edge.
    pub(crate) fn position(&self, value: f64) -> f64 {
        if value <= 0.0 {
            return self.zero;
        }
        self.position_of_power(value.log10())
    }

    fn position_of_power(&self, exponent: f64) -> f64 {
        let [from, to] = self.along;
        let part = (exponent - f64::from(self.low)) / f64::from(self.high - self.low);
        from + part.clamp(0.0, 1.0) * (to - from)
    }

    /// Returns whether a value lies within.
    pub(crate) fn holds(&self, value: f64) -> bool {
        value > 0.0 && (f64::from(self.low)..=f64::from(self.high)).contains(&value.log10())
    }

    /// Powers of ten, at most `most` of them.
    pub(crate) fn ticks(&self, most: i32) -> Vec<Tick> {
        let step = ((self.high - self.low) / most.max(1) + 1).max(1);
        // Multiples of the step, so that 1 is among them wherever it is in range.
        (self.low..=self.high)
            .filter(|exponent| exponent.rem_euclid(step) == 0)
            .map(|exponent| Tick {
                at: self.position_of_power(f64::from(exponent)),
                text: power_of_ten(exponent),
            })
            .collect()
    }
}

/// A logarithmic scale over less: where the values are, and a little more on both sides.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Close {
    low: f64,
    high: f64,
    along: Stretch,
}

impl Close {
    /// Creates a scale over all positive values.
    pub(crate) fn over(values: impl Iterator<Item = f64>, along: Stretch) -> Close {
        let [low, high] = range(values).unwrap_or([1.0, 10.0]).map(f64::log10);
        let margin = (0.06 * (high - low)).max(0.12);
        Close { low: low - margin, high: high + margin, along }
    }

    /// Position of a positive value along the edge.
    pub(crate) fn position(&self, value: f64) -> f64 {
        let [from, to] = self.along;
        from + (value.log10() - self.low) / (self.high - self.low) * (to - from)
    }

    /// 1, 2 and 5 times powers of ten; where that is too many, powers of ten alone.
    pub(crate) fn ticks(&self) -> Vec<Tick> {
        let decades = self.low.floor() as i32..=self.high.ceil() as i32;
        let numbers = |digits: &'static [f64]| -> Vec<Tick> {
            decades
                .clone()
                .flat_map(|exponent| digits.iter().map(move |digit| digit * 10f64.powi(exponent)))
                .filter(|value| (self.low..=self.high).contains(&value.log10()))
                .map(|value| Tick { at: self.position(value), text: short(value) })
                .collect()
        };
        [&[1.0, 2.0, 3.0, 5.0, 7.0][..], &[1.0, 2.0, 5.0], &[1.0, 3.0]]
            .into_iter()
            .map(numbers)
            .find(|ticks| ticks.len() <= 7)
            .unwrap_or_else(|| numbers(&[1.0]))
    }
}

/// Scale of the settings of a knob: true to scale where that keeps them apart, on a logarithmic
/// scale where that does, else side by side.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Knobs {
    scale: KnobScale,
    sorted: Vec<f64>,
    along: Stretch,
}

#[derive(Clone, Debug, PartialEq)]
enum KnobScale {
    Linear,
    Logarithmic(Decades),
    SideBySide,
}

impl Knobs {
    /// Creates a scale of these settings.
    pub(crate) fn over(knobs: &[f64], along: Stretch) -> Knobs {
        let mut sorted = knobs.to_vec();
        sorted.sort_by(f64::total_cmp);
        sorted.dedup();
        let [from, to] = along;
        let mut scales = vec![KnobScale::Linear];
        if sorted.iter().all(|knob| *knob >= 0.0) {
            // Where the knob may be off, zero has a position before the scale.
            let off = sorted.first() == Some(&0.0);
            let inside = if off { from + 0.12 * (to - from) } else { from };
            let decades = Decades::over(sorted.iter().copied(), [inside, to], from);
            scales.push(KnobScale::Logarithmic(decades));
        }
        let scales = scales.into_iter().map(|scale| Knobs { scale, sorted: sorted.clone(), along });
        let apart = scales.into_iter().find(Knobs::are_apart);
        apart.unwrap_or(Knobs { scale: KnobScale::SideBySide, sorted, along })
    }

    /// Returns whether no two settings stand so close that their marks hide each other.
    fn are_apart(&self) -> bool {
        let [from, to] = self.along;
        self.gap() >= 0.05 * (to - from).abs()
    }

    /// Returns whether distances on the scale mean something.
    pub(crate) fn is_to_scale(&self) -> bool {
        self.scale != KnobScale::SideBySide
    }

    /// The distance between the two closest settings.
    pub(crate) fn gap(&self) -> f64 {
        let [from, to] = self.along;
        let gap = |pair: &[f64]| self.position(pair[1]) - self.position(pair[0]);
        self.sorted.windows(2).map(gap).fold((to - from).abs(), f64::min)
    }

    /// Position of a setting along the edge.
    pub(crate) fn position(&self, knob: f64) -> f64 {
        let [from, to] = self.along;
        let (low, high) = (self.sorted.first(), self.sorted.last());
        let part = match &self.scale {
            KnobScale::Logarithmic(decades) => return decades.position(knob),
            KnobScale::Linear => match (low, high) {
                // Halves, as the whole may be beyond the range of numbers.
                (Some(low), Some(high)) if high > low => {
                    (0.5 * knob - 0.5 * low) / (0.5 * high - 0.5 * low)
                }
                _ => 0.5,
            },
            KnobScale::SideBySide => {
                let index = self.sorted.iter().position(|other| *other == knob).unwrap_or(0);
                (index as f64 + 0.5) / self.sorted.len().max(1) as f64
            }
        };
        from + part * (to - from)
    }

    /// The numbers written there: powers of ten on a logarithmic scale, else the settings; on a linear
    /// scale none so close to the one before that they would touch. Side by side each is needed, as
    /// nothing follows from its neighbours.
    pub(crate) fn ticks(&self) -> Vec<Tick> {
        let setting = |knob: &f64| Tick { at: self.position(*knob), text: short(*knob) };
        let ticks: Vec<Tick> = match &self.scale {
            KnobScale::Logarithmic(decades) => {
                let zero = self.sorted.iter().filter(|knob| **knob == 0.0).map(setting);
                zero.chain(decades.ticks(6)).collect()
            }
            KnobScale::Linear => self.sorted.iter().map(setting).collect(),
            KnobScale::SideBySide => return self.sorted.iter().map(setting).collect(),
        };
        let mut written: Vec<Tick> = Vec::new();
        for tick in ticks {
            let width = |tick: &Tick| CHARACTER * tick.text.chars().count() as f64;
            let free =
                |last: &Tick| tick.at - last.at >= 0.5 * (width(&tick) + width(last)) + CHARACTER;
            if written.last().is_none_or(free) {
                written.push(tick);
            }
        }
        written
    }
}

/// The width of a digit at a scale, in points.
const CHARACTER: f64 = 9.2;

/// The smallest and the largest of the positive, finite values.
fn range(values: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
    values
        .filter(|value| *value > 0.0 && value.is_finite())
        .map(|value| [value, value])
        .reduce(|[low, high], [value, _]| [low.min(value), high.max(value)])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(ticks: &[Tick]) -> Vec<&str> {
        ticks.iter().map(|tick| tick.text.as_str()).collect()
    }

    #[test]
    fn decades_hold_all_values_and_keep_zero_apart() {
        let axis = Decades::over([0.0, 0.5, 3e4].into_iter(), [600.0, 0.0], 630.0);
        assert_eq!(axis.position(0.0), 630.0);
        assert_eq!(axis.position(0.1), 600.0);
        assert_eq!(axis.position(1e5), 0.0);
        assert_eq!(axis.position(100.0), 300.0);
        assert_eq!(texts(&axis.ticks(8)), ["10⁻¹", "1", "10", "10²", "10³", "10⁴", "10⁵"]);
        assert_eq!(texts(&axis.ticks(3)), ["1", "10³"]);
    }

    #[test]
    fn no_value_or_a_single_one_still_makes_a_scale() {
        for values in [vec![], vec![0.0], vec![1.0], vec![f64::MAX], vec![5e-324]] {
            let axis = Decades::over(values.iter().copied(), [0.0, 1.0], -1.0);
            assert!(axis.high > axis.low);
            assert!(values.iter().all(|value| axis.position(*value).is_finite()));
            let axis = Close::over(values.iter().copied(), [0.0, 1.0]);
            assert!(axis.position(1.0).is_finite() && axis.ticks().len() <= 700);
        }
    }

    #[test]
    fn times_have_a_few_numbers_beside_them() {
        let axis = Close::over([3.9, 41.0].into_iter(), [0.0, 100.0]);
        assert_eq!(texts(&axis.ticks()), ["3", "5", "7", "10", "20", "30", "50"]);
        let axis = Close::over([0.4, 3000.0].into_iter(), [0.0, 100.0]);
        assert_eq!(texts(&axis.ticks()), ["1", "10", "100", "1000"]);
        let axis = Close::over([9.0, 9.1].into_iter(), [0.0, 100.0]);
        assert!(axis.ticks().len() >= 2, "{:?}", axis.ticks());
    }

    #[test]
    fn knobs_that_may_be_off_or_negative_have_places() {
        let knobs = Knobs::over(&[0.0, 1e-12, 1e-6, 1.0], [0.0, 400.0]);
        assert_eq!(knobs.position(0.0), 0.0);
        assert_eq!(knobs.position(1e-12), 48.0);
        assert_eq!(knobs.position(1.0), 400.0);
        assert_eq!(texts(&knobs.ticks())[..2], ["0", "10⁻¹²"]);
        let knobs = Knobs::over(&[2.0, -1.0, 0.0], [0.0, 90.0]);
        assert_eq!([-1.0, 0.0, 2.0].map(|knob| knobs.position(knob)), [0.0, 30.0, 90.0]);
        assert_eq!(texts(&knobs.ticks()), ["-1", "0", "2"]);
        let knobs = Knobs::over(&[-1000.0, -1.0, 0.0, 1.0, 1000.0], [0.0, 50.0]);
        assert_eq!([-1000.0, -1.0, 1000.0].map(|knob| knobs.position(knob)), [5.0, 15.0, 45.0]);
        assert_eq!(texts(&knobs.ticks()).len(), 5, "no number follows from the others");
        assert!(!knobs.is_to_scale());
    }
}
