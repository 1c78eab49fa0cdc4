//! Integrals of functions of one real number: `∫_[a, b] f(t) 𝕕t`.
//!
//! **Method.** Double exponential quadrature (H. Takahasi, M. Mori, *Double exponential formulas for numerical
//! integration*, 1974; the crate `quadrature`) after `t = a + (b - a) s³ (10 - 15s + 6s²)`, which weakens
//! singularities at the ends. An interval whose value differs from that of its parts is divided further. A bound at infinity becomes one
//! at 0 by `t = ±(1 - u)/u`.
//!
//! **Tolerance.** The value changes by less than 10⁻¹⁰ of itself (or 10⁻¹⁴ of the integral of its absolute value) when intervals are divided once more. Where that is not reached within
//! [`MOST_PARTS`] parts there is no value.

use std::cell::Cell;

use super::{Fallible, Fault};

/// Intervals are divided into no more parts than this.
const MOST_PARTS: usize = 2000;
/// Parts are no shorter than this part of the interval.
const LEAST_PART: f64 = 1e-13;
/// The tolerance, as a part of the integral.
const RELATIVE: f64 = 1e-10;
/// The tolerance, as a part of the integral of the absolute value.
const ROUNDING: f64 = 1e-14;
/// Where an interval is divided: not in its middle, where functions tend to have their kinks.
const DIVISION: f64 = 0.471;

/// The integral of a function from one bound to another; bounds may be infinite.
///
/// # Errors
/// The failure of the function where it has one; `unsettled` where the tolerance is not reached, or the function is
/// not finite inside of the interval.
pub fn integral(
    from: f64,
    to: f64,
    f: impl Fn(f64) -> Fallible<f64>,
    unsettled: Fault,
) -> Fallible<f64> {
    integrate(from, to, &f, unsettled)
}

fn integrate(
    from: f64,
    to: f64,
    f: &dyn Fn(f64) -> Fallible<f64>,
    unsettled: Fault,
) -> Fallible<f64> {
    if from.is_nan() || to.is_nan() {
        return Ok(f64::NAN);
    }
    if from == to {
        return Ok(0.0);
    }
    if from > to {
        return integrate(to, from, f, unsettled).map(|value| -value);
    }
    match (from.is_finite(), to.is_finite()) {
        (true, true) => finite(from, to, f, unsettled),
        (true, false) => above(from, f, unsettled),
        (false, true) => above(-to, &|t| f(-t), unsettled),
        (false, false) => Ok(above(0.0, f, unsettled)? + above(0.0, &|t| f(-t), unsettled)?),
    }
}

/// From a bound to infinity: one part where `t` is finite, and one where `1/t` is.
fn above(from: f64, f: &dyn Fn(f64) -> Fallible<f64>, unsettled: Fault) -> Fallible<f64> {
    let unit = from.abs().max(1.0);
    let far = |u: f64| {
        let value = f(from + unit / u)?;
        // what is 0 far out stays 0
        Ok(if value == 0.0 {
            0.0
        } else {
            value * unit / (u * u)
        })
    };
    Ok(finite(from, from + unit, f, unsettled)? + finite(0.0, 1.0, &far, unsettled)?)
}

/// A part of the interval with its value.
struct Part {
    from: f64,
    to: f64,
    value: f64,
}

fn finite(from: f64, to: f64, f: &dyn Fn(f64) -> Fallible<f64>, unsettled: Fault) -> Fallible<f64> {
    let fault: Cell<Option<Fault>> = Cell::new(None);
    let length = to - from;
    // the integrand of s, from 0 to 1
    let g = |s: f64| {
        if fault.get().is_some() {
            return 0.0;
        }
        let weight = 30.0 * s * s * (1.0 - s) * (1.0 - s) * length;
        let step = |s: f64| length * s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
        let t = match s <= 0.5 {
            true => from + step(s),
            false => to - step(1.0 - s),
        };
        match f(t) {
            Ok(value) if (value * weight).is_finite() => value * weight,
            // an end of the interval itself has no weight
            _ if t <= from || t >= to => 0.0,
            Ok(_) => {
                fault.set(Some(unsettled));
                0.0
            }
            Err(reason) => {
                fault.set(Some(reason));
                0.0
            }
        }
    };
    let part = |from: f64, to: f64, tolerance: f64| Part {
        from,
        to,
        value: quadrature::integrate(g, from, to, tolerance).integral,
    };
    let rough = part(0.0, 1.0, f64::MAX).value;
    let size = quadrature::integrate(|s| g(s).abs(), 0.0, 1.0, f64::MAX).integral;
    let tolerance = |value: f64| (RELATIVE * value.abs()).max(ROUNDING * size);
    let mut open = vec![part(0.0, 1.0, 0.1 * tolerance(rough))];
    let (mut done, mut parts) = (0.0, 1);
    let mut total = open[0].value;
    while let Some(whole) = open.pop() {
        if let Some(reason) = fault.get() {
            return Err(reason);
        }
        let allowed = tolerance(total).max(f64::MIN_POSITIVE);
        let middle = whole.from + DIVISION * (whole.to - whole.from);
        let share = 0.1 * allowed;
        let (left, right) = (
            part(whole.from, middle, share),
            part(middle, whole.to, share),
        );
        let change = left.value + right.value - whole.value;
        total += change;
        parts += 1;
        // a part may change as much as its length allows, but not less than what numbers can tell
        let own = (allowed * (whole.to - whole.from)).max(0.01 * allowed);
        if change.abs() <= own {
            done += left.value + right.value;
            continue;
        }
        if parts > MOST_PARTS || whole.to - whole.from < LEAST_PART || !change.is_finite() {
            return Err(fault.get().unwrap_or(unsettled));
        }
        open.extend([left, right]);
    }
    match fault.get() {
        Some(reason) => Err(reason),
        None => Ok(done),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    const UNSETTLED: Fault = Fault::new("unsettled");

    fn value(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
        integral(from, to, |t| Ok(f(t)), UNSETTLED).expect("an integral")
    }

    #[track_caller]
    fn close(found: f64, expected: f64) {
        assert!(
            (found - expected).abs() <= 1e-9 * expected.abs().max(1e-3),
            "{found} instead of {expected}"
        );
    }

    #[test]
    fn smooth() {
        close(value(0.0, 1.0, |t| t * t), 1.0 / 3.0);
        close(value(1.0, 0.0, |t| t * t), -1.0 / 3.0);
        close(value(0.0, PI, f64::sin), 2.0);
        close(value(-1.0, 1.0, |t| t * t * t), 0.0);
        close(
            value(0.0, 100.0, |t| (t * t).sin()),
            0.631_417_921_819_434_4,
        );
        close(value(3.0, 3.0, f64::exp), 0.0);
        close(value(0.0, 1e-6, |t| 1e-9 * t), 0.5e-21);
        close(
            value(-1.0, 1.0, |t| 1.0 / (1e-6 + t * t)),
            2.0 * 1e3 * 1e3f64.atan(),
        );
    }

    #[test]
    fn singular_at_the_ends() {
        close(value(0.0, 1.0, |t| 1.0 / t.sqrt()), 2.0);
        close(value(0.0, 1.0, f64::ln), -1.0);
        // how far from 1 a number is has an error of its own
        let found = value(-1.0, 1.0, |t| 1.0 / (1.0 - t * t).sqrt());
        assert!((found - PI).abs() < 1e-7, "{found}");
        close(value(0.0, 1.0, |t| t.powf(-0.75)), 4.0);
    }

    #[test]
    fn kinks_and_jumps() {
        close(value(0.0, 1.0, |t| (t - 0.3).abs()), 0.045 + 0.245);
        close(value(-1.0, 2.0, f64::abs), 2.5);
        close(value(0.0, 1.0, |t| if t < 0.2 { 1.0 } else { 3.0 }), 2.6);
    }

    #[test]
    fn to_infinity() {
        close(value(0.0, f64::INFINITY, |t| (-t).exp()), 1.0);
        close(
            value(f64::NEG_INFINITY, f64::INFINITY, |t| (-t * t).exp()),
            PI.sqrt(),
        );
        close(value(1.0, f64::INFINITY, |t| 1.0 / (t * t)), 1.0);
        close(
            value(f64::NEG_INFINITY, 0.0, |t| 1.0 / (1.0 + t * t)),
            PI / 2.0,
        );
        close(value(1000.0, f64::INFINITY, |t| 1.0 / (t * t)), 1e-3);
        close(value(1.0, f64::INFINITY, |t| t.powf(-1.5)), 2.0);
    }

    #[test]
    fn without_a_value() {
        let fails =
            |from, to, f: fn(f64) -> f64| integral(from, to, |t| Ok(f(t)), UNSETTLED).unwrap_err();
        assert_eq!(fails(0.0, 1.0, |t| 1.0 / t), UNSETTLED);
        assert_eq!(fails(1.0, f64::INFINITY, |t| 1.0 / t), UNSETTLED);
        assert_eq!(fails(0.0, f64::INFINITY, f64::cos), UNSETTLED);
        assert_eq!(fails(-1.0, 2.0, |t| 1.0 / (t * t)), UNSETTLED);
        assert_eq!(fails(-1.0, 2.0, f64::ln), UNSETTLED);
        let own = Fault::new("own");
        assert_eq!(integral(0.0, 1.0, |_| Err(own), UNSETTLED), Err(own));
    }
}
