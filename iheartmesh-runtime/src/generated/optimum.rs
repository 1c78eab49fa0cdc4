//! The least value of a function of real numbers, and where it is taken: `min_(x ∈ ℝ^n) f(x) s.t. g(x) ≤ 0`.
//!
//! **Method.** Sequential least-squares programming (D. Kraft, *A software package for sequential quadratic
//! programming*, DFVLR-FB 88-28, 1988; the crate `basin`) with derivatives by central differences of fourth order
//! ([`slope`]), repeated from the point that it found until a run finds nothing better. Points around a stationary one
//! are tried, so that a maximum or a saddle is left again. Where a function has no derivatives, the simplex of Nelder
//! and Mead goes on. The minimum is a local one, reached from the start values.
//!
//! **Tolerance.** At the point that is given, the gradient of the Lagrange function is below 10⁻⁶ of the slopes around
//! it, or no method finds a better point; restrictions hold up to 10⁻⁸ of their own slopes. Smooth problems come
//! out far more exact than this. Otherwise there is no value: [`Reasons`] says which of them there are.

mod simplex;
mod slope;
mod sqp;
#[cfg(test)]
mod tests;

use glam::{DMat2, DMat3, DMat4, DVec2, DVec3, DVec4};
use nalgebra::{DMatrix, DVector, SMatrix};

use super::{Array, Build, Fallible, Fault};

/// Values that are made of real numbers.
pub trait Coordinates {
    /// Adds the numbers of a value, column by column.
    fn put(&self, to: &mut Vec<f64>);
    /// A value of the same sizes with the numbers that come next.
    fn like(&self, from: &mut std::slice::Iter<'_, f64>) -> Self;
}

fn put_array<A: Array<Item = f64>>(array: &A, to: &mut Vec<f64>) {
    for column in 0..array.columns() {
        to.extend((0..array.rows()).map(|row| array.entry(row, column)));
    }
}

fn like_array<A: Build<Item = f64>>(array: &A, from: &mut std::slice::Iter<'_, f64>) -> A {
    let mut value = A::zeros(array.rows(), array.columns());
    for column in 0..array.columns() {
        for row in 0..array.rows() {
            value.set(row, column, from.next().copied().unwrap_or(0.0));
        }
    }
    value
}

macro_rules! coordinates {
    ($type:ty $(, $parameter:ident)*) => {
        impl<$(const $parameter: usize),*> Coordinates for $type {
            fn put(&self, to: &mut Vec<f64>) {
                put_array(self, to);
            }

            fn like(&self, from: &mut std::slice::Iter<'_, f64>) -> Self {
                like_array(self, from)
            }
        }
    };
}

coordinates!(f64);
coordinates!(DVec2);
coordinates!(DVec3);
coordinates!(DVec4);
coordinates!(DMat2);
coordinates!(DMat3);
coordinates!(DMat4);
coordinates!(DVector<f64>);
coordinates!(DMatrix<f64>);
coordinates!(SMatrix<f64, R, C>, R, C);

impl<T: Coordinates> Coordinates for Vec<T> {
    fn put(&self, to: &mut Vec<f64>) {
        self.iter().for_each(|item| item.put(to));
    }

    fn like(&self, from: &mut std::slice::Iter<'_, f64>) -> Self {
        self.iter().map(|item| item.like(from)).collect()
    }
}

/// Why there may be no optimum.
#[derive(Clone, Copy, Debug)]
pub struct Reasons {
    /// The function goes on without a bound.
    pub unbounded: Fault,
    /// No point was found that satisfies all restrictions.
    pub infeasible: Fault,
    /// No point was found at which the function stops to decrease.
    pub unsettled: Fault,
}

/// An optimum.
#[derive(Clone, Debug, PartialEq)]
pub struct Optimum {
    /// The value.
    pub value: f64,
    /// Where it is taken.
    pub at: Vec<f64>,
}

/// What restricts the points, at one of them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Restrictions {
    /// Numbers that must be 0.
    pub equal: Vec<f64>,
    /// Numbers that must not be above 0.
    pub at_most: Vec<f64>,
}

/// A function with its restrictions.
type Objective<'a> = &'a dyn Fn(&[f64], &mut Restrictions) -> Fallible<f64>;

/// Where an optimum is looked for.
#[derive(Clone, Debug, Default)]
pub struct Domain {
    start: Vec<f64>,
    lower: Vec<f64>,
    upper: Vec<f64>,
    /// Where the numbers of each variable begin.
    firsts: Vec<usize>,
    contradicts: bool,
}

impl Domain {
    /// Without variables.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a variable by its start value.
    pub fn variable(&mut self, start: &impl Coordinates) {
        self.firsts.push(self.start.len());
        start.put(&mut self.start);
        self.lower.resize(self.start.len(), f64::NEG_INFINITY);
        self.upper.resize(self.start.len(), f64::INFINITY);
    }

    /// A lower bound of a variable: one number, or one for each of its own.
    pub fn at_least(&mut self, variable: usize, bound: &impl Coordinates) {
        for (place, value) in self.places(variable, bound) {
            self.lower[place] = self.lower[place].max(value);
        }
    }

    /// An upper bound of a variable: one number, or one for each of its own.
    pub fn at_most(&mut self, variable: usize, bound: &impl Coordinates) {
        for (place, value) in self.places(variable, bound) {
            self.upper[place] = self.upper[place].min(value);
        }
    }

    fn places(&mut self, variable: usize, bound: &impl Coordinates) -> Vec<(usize, f64)> {
        let first = self.firsts[variable];
        let last = self.firsts.get(variable + 1).copied();
        let mut values = Vec::new();
        bound.put(&mut values);
        let places = first..last.unwrap_or(self.start.len());
        self.contradicts |= values.iter().any(|v| v.is_nan());
        places
            .enumerate()
            .filter_map(|(k, place)| {
                let value = if values.len() == 1 {
                    values.first()
                } else {
                    values.get(k)
                };
                value.map(|v| (place, *v))
            })
            .collect()
    }

    /// The least value of `objective`, or the greatest.
    ///
    /// # Errors
    /// What [`Reasons`] lists; the failure of the objective where it has no value at any of the points to start from.
    pub fn optimum(
        &self,
        greatest: bool,
        reasons: Reasons,
        objective: impl Fn(&[f64], &mut Restrictions) -> Fallible<f64>,
    ) -> Fallible<Optimum> {
        let sign = if greatest { -1.0 } else { 1.0 };
        let signed = |point: &[f64], restrictions: &mut Restrictions| {
            objective(point, restrictions).map(|value| sign * value)
        };
        let mut found = sqp::solve(self, reasons, &signed)?;
        found.value *= sign;
        Ok(found)
    }
}
