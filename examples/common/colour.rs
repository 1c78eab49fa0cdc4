//! From numbers to colours, the same for pictures and for files.

use colorous::Gradient;

/// The colour of values that are not finite: darker than any shadow on the pale middle of a scale.
pub const NOT_FINITE: [u8; 3] = [88, 88, 92];

/// How many of the values, as a fraction, lie within the limits of a scale. A few extreme vertices would
/// otherwise make all the others look alike.
const WITHIN_LIMITS: f64 = 0.96;

/// Where a diverging scale ends in its gradient: the colours beyond are too dark to show any shading.
const BRIGHT_END: f64 = 0.93;

/// Which colour stands for which value.
#[derive(Clone, Copy, Debug)]
pub struct ColourScale {
    /// The value of the first colour; smaller values have it too.
    pub low: f64,
    /// The value of the last colour; larger values have it too.
    pub high: f64,
    gradient: Gradient,
    reversed: bool,
}

impl ColourScale {
    /// Blue for negative, near white for 0, red for positive values, with limits ±l: 96 % of the values lie
    /// within them.
    pub fn diverging(values: &[f64]) -> ColourScale {
        let sizes = sorted_finite(values.iter().map(|value| value.abs()));
        ColourScale::diverging_within(percentile(&sizes, WITHIN_LIMITS).unwrap_or(0.0))
    }

    /// As [`ColourScale::diverging`], with the limits ±`limit`.
    pub fn diverging_within(limit: f64) -> ColourScale {
        let high = if limit > 0.0 { limit } else { 1.0 };
        ColourScale {
            low: -high,
            high,
            gradient: colorous::RED_BLUE,
            reversed: true,
        }
    }

    /// Dark for small, bright for large values, from the smallest finite value to the largest; for
    /// distances and other values of one sign.
    pub fn sequential(values: &[f64]) -> ColourScale {
        let finite = sorted_finite(values.iter().copied());
        let low = finite.first().copied().unwrap_or(0.0);
        let high = finite
            .last()
            .copied()
            .filter(|&high| high > low)
            .unwrap_or(low + 1.0);
        ColourScale {
            low,
            high,
            gradient: colorous::VIRIDIS,
            reversed: false,
        }
    }

    /// The colour of `value` as red, green and blue; grey if it is not finite.
    pub fn colour(&self, value: f64) -> [u8; 3] {
        if !value.is_finite() {
            return NOT_FINITE;
        }
        let place = ((value - self.low) / (self.high - self.low)).clamp(0.0, 1.0);
        let place = if self.reversed {
            BRIGHT_END - place * (2.0 * BRIGHT_END - 1.0)
        } else {
            place
        };
        self.gradient.eval_continuous(place).as_array()
    }

    /// The value in the middle of the scale.
    pub fn middle(&self) -> f64 {
        0.5 * (self.low + self.high)
    }
}

/// One colour for each value, on the diverging scale of these values.
pub fn colours(values: &[f64]) -> Vec<[u8; 3]> {
    let scale = ColourScale::diverging(values);
    values.iter().map(|&value| scale.colour(value)).collect()
}

fn sorted_finite(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut finite: Vec<f64> = values.filter(|value| value.is_finite()).collect();
    finite.sort_unstable_by(f64::total_cmp);
    finite
}

/// The value below which the given fraction of the sorted values lies; `None` if there are none.
fn percentile(sorted: &[f64], fraction: f64) -> Option<f64> {
    let last = sorted.len().checked_sub(1)?;
    Some(sorted[(fraction * last as f64).round() as usize])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_are_symmetric_and_ignore_extremes_and_values_that_are_not_finite() {
        let mut values: Vec<f64> = (0..=100).map(|i| f64::from(i) / 100.0).collect();
        values[100] = -1e9;
        values.extend([f64::NAN, f64::INFINITY]);
        let scale = ColourScale::diverging(&values);
        assert_eq!((scale.low, scale.middle(), scale.high), (-0.96, 0.0, 0.96));
        assert_eq!(scale.colour(f64::NAN), NOT_FINITE);
        assert_eq!(scale.colour(-5.0), scale.colour(scale.low));
    }

    #[test]
    fn constant_and_empty_fields_have_a_scale() {
        for values in [&[][..], &[0.0, 0.0], &[f64::NAN]] {
            let scale = ColourScale::diverging(values);
            assert_eq!((scale.low, scale.high), (-1.0, 1.0));
            assert!(ColourScale::sequential(values).high > ColourScale::sequential(values).low);
        }
    }

    #[test]
    fn positive_is_red_and_negative_is_blue() {
        let [red, blue] = [1.0, -1.0].map(|value| ColourScale::diverging_within(1.0).colour(value));
        assert!(red[0] > red[2] && blue[2] > blue[0]);
    }
}
