//! Values and derivatives of a function with its restrictions.
//!
//! Derivatives are central differences of fourth order, `(4 D(h) - D(2h))/3` with `D(h) = (f(x + h) - f(x - h))/2h`
//! (Richardson's extrapolation; Abramowitz and Stegun, *Handbook of Mathematical Functions*, 25.3.24 with its error
//! term), with a step that becomes smaller where the two differences disagree. Where a step would leave the bounds or
//! has no value, differences to one side take their place.

use std::cell::{Cell, RefCell};

use super::super::{Fallible, Fault};
use super::{Domain, Objective, Restrictions};

/// Steps, as parts of a coordinate or of 1.
const STEPS: [f64; 4] = [1e-3, 1e-4, 1e-5, 1e-6];

/// A function at one point: its value, then what must be 0, then what must not be above 0.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Values(pub(super) Vec<f64>);

impl Values {
    pub(super) fn objective(&self) -> f64 {
        self.0[0]
    }

    pub(super) fn are_finite(&self) -> bool {
        self.0.iter().all(|v| v.is_finite())
    }
}

/// A function with its restrictions, and how often it was asked for.
pub(super) struct Function<'a> {
    pub(super) domain: &'a Domain,
    objective: Objective<'a>,
    /// How many numbers must be 0.
    pub(super) n_equal: Cell<usize>,
    /// How many must not be above 0.
    pub(super) n_at_most: Cell<usize>,
    last: RefCell<Option<(Vec<f64>, Values)>>,
    fault: Cell<Option<Fault>>,
}

impl<'a> Function<'a> {
    pub(super) fn new(domain: &'a Domain, objective: Objective<'a>) -> Self {
        Self {
            domain,
            objective,
            n_equal: Cell::new(0),
            n_at_most: Cell::new(0),
            last: RefCell::new(None),
            fault: Cell::new(None),
        }
    }

    /// Why the function had no value at the last point where it had none.
    pub(super) fn fault(&self) -> Option<Fault> {
        self.fault.get()
    }

    fn try_at(&self, point: &[f64]) -> Fallible<Values> {
        let mut restrictions = Restrictions::default();
        let value = (self.objective)(point, &mut restrictions)?;
        self.n_equal.set(restrictions.equal.len());
        self.n_at_most.set(restrictions.at_most.len());
        let mut values = vec![value];
        values.append(&mut restrictions.equal);
        values.append(&mut restrictions.at_most);
        Ok(Values(values))
    }

    /// The values at a point; not numbers where there are none.
    pub(super) fn at(&self, point: &[f64]) -> Values {
        if let Some((known, values)) = &*self.last.borrow()
            && known == point
        {
            return values.clone();
        }
        let values = self.try_at(point).unwrap_or_else(|fault| {
            self.fault.set(Some(fault));
            Values(vec![
                f64::NAN;
                1 + self.n_equal.get() + self.n_at_most.get()
            ])
        });
        *self.last.borrow_mut() = Some((point.to_vec(), values.clone()));
        values
    }

    /// How far values miss the restrictions: the greatest single one.
    pub(super) fn violation(&self, values: &Values) -> f64 {
        let n = self.n_equal.get();
        values.0[1..].iter().enumerate().fold(0.0, |worst, (k, v)| {
            worst.max(if k < n { v.abs() } else { v.max(0.0) })
        })
    }

    /// A point moved into the bounds.
    pub(super) fn inside(&self, point: &[f64]) -> Vec<f64> {
        let bounds = self.domain.lower.iter().zip(&self.domain.upper);
        point
            .iter()
            .zip(bounds)
            .map(|(x, (low, high))| x.max(*low).min(*high))
            .collect()
    }

    /// The derivatives at a point: one row for each value, one column for each coordinate. Not numbers where the
    /// function has no values nearby.
    pub(super) fn derivatives(&self, point: &[f64], here: &Values) -> Vec<Vec<f64>> {
        let mut rows = vec![vec![0.0; point.len()]; here.0.len()];
        for k in 0..point.len() {
            let column = self.column(point, here, k);
            for (row, value) in rows.iter_mut().zip(column) {
                row[k] = value;
            }
        }
        rows
    }

    fn column(&self, point: &[f64], here: &Values, k: usize) -> Vec<f64> {
        let (low, high) = (self.domain.lower[k], self.domain.upper[k]);
        let unit = point[k].abs().max(1.0);
        let mut best: Option<(f64, Vec<f64>)> = None;
        let mut moved = point.to_vec();
        let mut at = |x: f64| {
            moved[k] = x;
            Some(self.try_at(&moved).ok()?).filter(Values::are_finite)
        };
        for step in STEPS {
            let x = point[k];
            // steps that numbers can hold
            let h = (x + step * unit) - x;
            if x - 2.0 * h < low || x + 2.0 * h > high {
                continue;
            }
            let Some((a, b, c, d)) =
                (|| Some((at(x - 2.0 * h)?, at(x - h)?, at(x + h)?, at(x + 2.0 * h)?)))()
            else {
                continue;
            };
            let (mut worst, mut column) = (0.0f64, Vec::new());
            for (i, middle) in here.0.iter().enumerate() {
                let (near, far) = ((c.0[i] - b.0[i]) / (2.0 * h), (d.0[i] - a.0[i]) / (4.0 * h));
                let value = near + (near - far) / 3.0;
                let curvature = ((c.0[i] - middle) - (middle - b.0[i])).abs() / h;
                let noise = f64::EPSILON * middle.abs() / h;
                let size = value.abs().max(curvature).max(1e3 * noise);
                worst = worst.max((near - far).abs() / size.max(f64::MIN_POSITIVE));
                column.push(value);
            }
            if best.as_ref().is_none_or(|(before, _)| worst < *before) {
                best = Some((worst, column));
            }
            if worst <= 1e-3 {
                break;
            }
        }
        best.map_or_else(|| self.one_sided(point, here, k), |(_, column)| column)
    }

    /// Differences of second order to the side where there is room.
    fn one_sided(&self, point: &[f64], here: &Values, k: usize) -> Vec<f64> {
        let (low, high) = (self.domain.lower[k], self.domain.upper[k]);
        let mut moved = point.to_vec();
        let x = point[k];
        for size in [1e-5, 1e-7, 1e-9] {
            for side in [1.0, -1.0] {
                let h = (x + side * size * x.abs().max(1.0)) - x;
                if x + 2.0 * h < low || x + 2.0 * h > high || h == 0.0 {
                    continue;
                }
                let mut at = |x: f64| {
                    moved[k] = x;
                    Some(self.try_at(&moved).ok()?).filter(Values::are_finite)
                };
                if let (Some(near), Some(far)) = (at(x + h), at(x + 2.0 * h)) {
                    return (0..here.0.len())
                        .map(|i| {
                            (4.0 * (near.0[i] - here.0[i]) - (far.0[i] - here.0[i])) / (2.0 * h)
                        })
                        .collect();
                }
            }
        }
        // a coordinate that cannot move
        let fixed = low == high;
        vec![if fixed { 0.0 } else { f64::NAN }; here.0.len()]
    }
}
