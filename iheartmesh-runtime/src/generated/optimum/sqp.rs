//! Sequential least-squares programming, repeated until nothing better is found.

use std::cell::RefCell;

use basin::{
    BoxBounds, ConstraintDescription, ConstraintJacobian, ConstraintSet, ConstraintSolveError,
    Constraints, CostFunction, DenseMatrix, Executor, Gradient, NoLinearConstraints,
    NonlinearBlock, NonlinearBlocks, NonlinearEqualityValues, NonlinearInequalityValues,
    SelectedFirstOrderState, Slsqp, State,
};

use super::super::{Fallible, Fault};
use super::slope::{Function, Values};
use super::{Domain, Objective, Optimum, Reasons, simplex};

/// Most runs from one start.
const RUNS: usize = 25;
/// Most steps of a run.
const STEPS: u64 = 300;
/// The gradient of the Lagrange function, in parts of the slopes around a point.
const STATIONARY: f64 = 1e-6;
/// Violations of restrictions, in parts of their slopes.
const FEASIBLE: f64 = 1e-8;

type Solved<T> = Result<T, ConstraintSolveError<Fault>>;

/// A point with rows of derivatives.
type Known = (Vec<f64>, Vec<Vec<f64>>);

/// The function in units in which its slopes are about 1.
struct Scaled<'f, 'a> {
    function: &'f Function<'a>,
    unit: f64,
    /// The last point with the derivatives there.
    derivatives: RefCell<Option<Known>>,
}

impl Scaled<'_, '_> {
    fn derivatives(&self, point: &[f64]) -> Vec<Vec<f64>> {
        if let Some((known, rows)) = &*self.derivatives.borrow()
            && known == point
        {
            return rows.clone();
        }
        let rows = self.function.derivatives(point, &self.function.at(point));
        *self.derivatives.borrow_mut() = Some((point.to_vec(), rows.clone()));
        rows
    }
}

impl CostFunction for Scaled<'_, '_> {
    type Param = Vec<f64>;
    type Output = f64;
    type Error = Fault;

    fn cost(&self, point: &Vec<f64>) -> Fallible<f64> {
        Ok(self.function.at(point).objective() / self.unit)
    }
}

impl Gradient for Scaled<'_, '_> {
    type Gradient = Vec<f64>;

    fn gradient(&self, point: &Vec<f64>) -> Fallible<Vec<f64>> {
        let rows = self.derivatives(point);
        Ok(rows[0].iter().map(|slope| slope / self.unit).collect())
    }
}

impl Constraints for Scaled<'_, '_> {
    type Set = ConstraintSet<
        BoxBounds<Vec<f64>>,
        NoLinearConstraints,
        NonlinearBlocks<NonlinearBlock, NonlinearBlock>,
    >;

    fn constraints(&self) -> <Self::Set as ConstraintDescription>::Borrowed<'_> {
        let domain = self.function.domain;
        ConstraintSet::new()
            .with_bounds(BoxBounds::new(Some(&domain.lower), Some(&domain.upper)))
            .with_nonlinear_equalities(self.function.n_equal.get())
            .with_nonlinear_inequalities(self.function.n_at_most.get())
    }
}

impl NonlinearEqualityValues for Scaled<'_, '_> {
    type Param = Vec<f64>;
    type Values = Vec<f64>;
    type Error = Fault;

    fn nonlinear_equalities(&self, point: &Vec<f64>) -> Solved<Vec<f64>> {
        Ok(self.function.at(point).0[1..][..self.function.n_equal.get()].to_vec())
    }
}

impl NonlinearInequalityValues for Scaled<'_, '_> {
    type Param = Vec<f64>;
    type Values = Vec<f64>;
    type Error = Fault;

    fn nonlinear_inequalities(&self, point: &Vec<f64>) -> Solved<Vec<f64>> {
        Ok(self.function.at(point).0[1..][self.function.n_equal.get()..].to_vec())
    }
}

impl ConstraintJacobian for Scaled<'_, '_> {
    type Param = Vec<f64>;
    type Jacobian = DenseMatrix;
    type Error = Fault;

    fn constraint_jacobian(&self, point: &Vec<f64>) -> Solved<DenseMatrix> {
        let rows = self.derivatives(point);
        let entries: Vec<f64> = rows[1..].iter().flatten().copied().collect();
        Ok(DenseMatrix::from_row_slice(
            rows.len() - 1,
            point.len(),
            &entries,
        ))
    }
}

/// A point with what is known of it.
#[derive(Clone, Debug)]
struct Candidate {
    point: Vec<f64>,
    values: Values,
    is_stationary: bool,
}

/// The least value of a function.
pub(super) fn solve(
    domain: &Domain,
    reasons: Reasons,
    objective: Objective<'_>,
) -> Fallible<Optimum> {
    let mut bounds = domain.lower.iter().zip(&domain.upper);
    if domain.contradicts
        || !bounds
            .all(|(low, high)| low <= high && *low < f64::INFINITY && *high > f64::NEG_INFINITY)
    {
        return Err(reasons.infeasible);
    }
    let search = Search {
        function: Function::new(domain, objective),
        reasons,
    };
    let mut last = None;
    let starts = search.starts();
    if starts.is_empty() {
        return Err(search.function.fault().unwrap_or(reasons.unsettled));
    }
    for start in starts {
        match search.from(start) {
            Ok(found) => {
                return Ok(Optimum {
                    value: found.values.objective(),
                    at: found.point,
                });
            }
            Err(fault) if fault == reasons.infeasible => last = last.or(Some(fault)),
            Err(fault) => return Err(fault),
        }
    }
    Err(last.unwrap_or(reasons.unsettled))
}

struct Search<'a> {
    function: Function<'a>,
    reasons: Reasons,
}

impl Search<'_> {
    /// Points to start from: the given one, and others for where it has no value or leads to none.
    fn starts(&self) -> Vec<Vec<f64>> {
        let start = &self.function.domain.start;
        let mut starts = vec![self.function.inside(start)];
        for (k, size) in [1.0, -1.0, 0.1, -0.1, 10.0].into_iter().enumerate() {
            let moved: Vec<f64> = start.iter().map(|x| x + size * x.abs().max(1.0)).collect();
            starts.push(self.function.inside(&moved));
            let noise = direction(start.len(), k as u64);
            let moved: Vec<f64> = start
                .iter()
                .zip(noise)
                .map(|(x, d)| x + size * d * x.abs().max(1.0))
                .collect();
            starts.push(self.function.inside(&moved));
        }
        starts.retain(|point| {
            point.iter().all(|x| x.is_finite()) && self.function.at(point).are_finite()
        });
        starts
    }

    fn candidate(&self, point: Vec<f64>, is_stationary: bool) -> Option<Candidate> {
        let values = self.function.at(&point);
        values.are_finite().then_some(Candidate {
            point,
            values,
            is_stationary,
        })
    }

    fn from(&self, start: Vec<f64>) -> Fallible<Candidate> {
        let mut best = self
            .candidate(start.clone(), false)
            .ok_or(self.reasons.unsettled)?;
        if best.point.is_empty() {
            return match self.is_feasible(&best) {
                true => Ok(best),
                false => Err(self.reasons.infeasible),
            };
        }
        let mut simplex_size = 0.1;
        for _ in 0..RUNS {
            let unit = self.unit(&best);
            let before = best.clone();
            if let Some(found) = self.run(&best.point, unit)
                && !self.is_better(&best, &found, 0.0, unit)
            {
                best = found;
            }
            if self.is_unbounded(&start, &best) {
                return Err(self.reasons.unbounded);
            }
            if self.is_better(&best, &before, 1e-12, unit) && !best.is_stationary {
                continue;
            }
            if best.is_stationary && !self.is_feasible(&best) {
                return Err(self.reasons.infeasible);
            }
            let around = self.around(&best, unit);
            if let Some(better) = around {
                best = better;
                continue;
            }
            if best.is_stationary {
                return Ok(best);
            }
            // no derivatives, or a run that stopped early
            let found = simplex::better(&self.function, &best.point, simplex_size, 1e3 * unit);
            let found = found.and_then(|point| self.candidate(point, false));
            match found {
                Some(found) if self.is_better(&found, &best, 1e-11, unit) => best = found,
                Some(found) if simplex_size < 1e-3 => {
                    if self.is_better(&found, &best, 0.0, unit) {
                        best = found;
                    }
                    return match self.is_feasible(&best) {
                        true => Ok(best),
                        false => Err(self.reasons.infeasible),
                    };
                }
                Some(_) => simplex_size *= 0.05,
                None => break,
            }
        }
        match self.is_feasible(&best) {
            true => Err(self.reasons.unsettled),
            false => Err(self.reasons.infeasible),
        }
    }

    /// The slopes of the function around a point: its unit.
    fn unit(&self, at: &Candidate) -> f64 {
        let here = at.values.objective();
        let mut unit = 0.0f64;
        for moved in self.moved(&at.point, &[1.0]) {
            let values = self.function.at(&moved);
            let length: f64 = moved
                .iter()
                .zip(&at.point)
                .map(|(a, b)| (a - b).abs())
                .fold(0.0, f64::max);
            let slope = ((values.objective() - here) / length).abs();
            if slope.is_finite() {
                unit = unit.max(slope);
            }
        }
        let gradient = &self.function.derivatives(&at.point, &at.values)[0];
        let gradient = gradient
            .iter()
            .filter(|g| g.is_finite())
            .fold(0.0f64, |a, b| a.max(b.abs()));
        match unit.max(gradient) {
            unit if unit > f64::MIN_POSITIVE * 1e10 && unit.is_finite() => unit,
            _ => 1.0,
        }
    }

    fn run(&self, point: &[f64], unit: f64) -> Option<Candidate> {
        let scaled = Scaled {
            function: &self.function,
            unit,
            derivatives: RefCell::new(None),
        };
        let solver = Slsqp::new().with_absolute_accuracy_tolerance(1e-21);
        let state = SelectedFirstOrderState::new(point.to_vec());
        let found = Executor::new(scaled, solver, state)
            .max_iter(STEPS)
            .run_with_solver()
            .ok()?;
        let is_stationary = found.solver.stationarity().is_some_and(|s| s <= STATIONARY)
            && found
                .solver
                .complementarity()
                .is_some_and(|c| c <= STATIONARY);
        self.candidate(found.state.param().clone(), is_stationary)
    }

    /// How far a point misses the restrictions, in units of their slopes.
    fn miss(&self, at: &Candidate) -> f64 {
        if at.values.0.len() == 1 {
            return 0.0;
        }
        let violation = self.function.violation(&at.values);
        if violation == 0.0 {
            return 0.0;
        }
        let rows = self.function.derivatives(&at.point, &at.values);
        let size = at.point.iter().fold(1.0f64, |a, b| a.max(b.abs()));
        let n = self.function.n_equal.get();
        rows[1..]
            .iter()
            .zip(&at.values.0[1..])
            .enumerate()
            .fold(0.0f64, |worst, (k, (row, v))| {
                let slope = row
                    .iter()
                    .filter(|s| s.is_finite())
                    .fold(0.0f64, |a, b| a.max(b.abs()));
                let miss = if k < n { v.abs() } else { v.max(0.0) };
                worst.max(miss / (slope * size).max(1e-3))
            })
    }

    fn is_feasible(&self, at: &Candidate) -> bool {
        self.miss(at) <= FEASIBLE
    }

    /// Whether one point is better than another by a part of the unit: it satisfies the restrictions and has a lesser
    /// value, or satisfies them better.
    fn is_better(&self, a: &Candidate, b: &Candidate, part: f64, unit: f64) -> bool {
        let (miss_a, miss_b) = (self.miss(a), self.miss(b));
        if miss_a <= FEASIBLE && miss_b <= FEASIBLE {
            let margin = part * (unit + b.values.objective().abs());
            return a.values.objective() < b.values.objective() - margin;
        }
        miss_a < miss_b * (1.0 - 1e-3)
    }

    /// Points around one: along each coordinate, and in a few directions that favour none.
    fn moved(&self, point: &[f64], sizes: &[f64]) -> Vec<Vec<f64>> {
        let n = point.len();
        let mut directions: Vec<Vec<f64>> = (0..n.min(64))
            .map(|k| (0..n).map(|j| f64::from(u8::from(j == k))).collect())
            .collect();
        directions.extend((0..4).map(|seed| direction(n, 100 + seed)));
        let mut moved = Vec::new();
        for size in sizes {
            for d in &directions {
                for side in [*size, -*size] {
                    let to: Vec<f64> = point
                        .iter()
                        .zip(d)
                        .map(|(x, d)| x + side * d * x.abs().max(1.0))
                        .collect();
                    let to = self.function.inside(&to);
                    if to != point {
                        moved.push(to);
                    }
                }
            }
        }
        moved
    }

    /// A better point near a stationary one, if there is one: then that is no minimum.
    fn around(&self, at: &Candidate, unit: f64) -> Option<Candidate> {
        let mut best = None;
        for moved in self.moved(&at.point, &[1e-3, 0.1, 1.0]) {
            let Some(moved) = self.candidate(moved, false) else {
                continue;
            };
            let against = best.as_ref().unwrap_or(at);
            if self.is_feasible(&moved) && self.is_better(&moved, against, 1e-10, unit) {
                best = Some(moved);
            }
        }
        best
    }

    /// Whether the function goes on to decrease along the way from the start, or down its gradient.
    fn is_unbounded(&self, start: &[f64], at: &Candidate) -> bool {
        if !self.is_feasible(at) || at.is_stationary {
            return false;
        }
        let gradient = &self.function.derivatives(&at.point, &at.values)[0];
        let down: Vec<f64> = gradient.iter().map(|g| -g).collect();
        let way: Vec<f64> = at.point.iter().zip(start).map(|(a, b)| a - b).collect();
        [way, down].iter().any(|d| self.falls(&at.point, d))
    }

    fn falls(&self, point: &[f64], d: &[f64]) -> bool {
        let length = d.iter().fold(0.0f64, |a, b| a.max(b.abs()));
        if length == 0.0 || !length.is_finite() {
            return false;
        }
        let size = point.iter().fold(1.0f64, |a, b| a.max(b.abs()));
        let mut last: Option<(f64, f64)> = None;
        for power in 1..12 {
            let step = size * 10f64.powi(power) / length;
            let to: Vec<f64> = point.iter().zip(d).map(|(x, d)| x + step * d).collect();
            let to = self.function.inside(&to);
            let values = self.function.at(&to);
            let value = values.objective();
            let holds = values.0[1..].iter().all(|v| !v.is_nan());
            let miss = self.function.violation(&values) / (size * 10f64.powi(power));
            if value.is_nan() || !holds || miss > 1e-9 {
                return false;
            }
            if value == f64::NEG_INFINITY {
                return true;
            }
            let (before, fall) = match last {
                None => {
                    last = Some((value, 0.0));
                    continue;
                }
                Some(last) => last,
            };
            let next = before - value;
            if next <= 0.0 || next < 0.5 * fall {
                return false;
            }
            last = Some((value, next));
        }
        true
    }
}

/// A direction with entries between -1 and 1, the same for the same seed.
fn direction(n: usize, seed: u64) -> Vec<f64> {
    let mut state = seed
        .wrapping_mul(0x9e37_79b9_7f4a_7c15)
        .wrapping_add(0x2545_f491_4f6c_dd1d);
    (0..n)
        .map(|_| {
            // D. Knuth's generator of MMIX
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        })
        .collect()
}
