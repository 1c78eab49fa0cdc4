//! Newton's method with a line search.

use std::ops::ControlFlow;

use iheartmesh_runtime::sprs::CsMat;

use super::line_search::{Point, named, not_negative};
use super::{Cholesky, CholeskyError, Error, Factorisation, LineSearch, Minimum, Progress, Stop};
use crate::objective::TwiceDifferentiable;

/// Newton's method: each step solves `H d = -g` by sparse Cholesky factorisation and goes along `d` until the energy has
/// fallen enough. The Hessian must be positive definite, as sums of blocks projected by `psd` are but for what no term
/// sees, such as the place of the whole; `damping` is for that.
#[derive(Clone, Debug, PartialEq)]
pub struct Newton {
    /// The most steps.
    pub most_steps: usize,
    /// Ends where half of the square of the Newton decrement, `½ gᵀ H⁻¹ g`, is not greater than this: what a step would
    /// lower a quadratic energy by, in the unit of the energy.
    pub decrement: f64,
    /// Ends where no entry of the gradient is greater than this, in its unit.
    pub gradient: f64,
    /// What is added to the Hessian: its diagonal times this (Marquardt 1963). About 10⁻⁹ for energies that some
    /// movement of all variables does not change.
    pub damping: f64,
    /// Where the Hessian is not positive definite, the damping grows tenfold, at least from 10⁻⁸, up to this. With 0,
    /// such a Hessian is an error.
    pub greatest_damping: f64,
    /// How far a step goes.
    pub line_search: LineSearch,
}

impl Default for Newton {
    /// 200 steps, a decrement of 10⁻¹⁰, no damping.
    fn default() -> Newton {
        Newton {
            most_steps: 200,
            decrement: 1e-10,
            gradient: 0.0,
            damping: 0.0,
            greatest_damping: 0.0,
            line_search: LineSearch::default(),
        }
    }
}

impl Newton {
    /// Searches for a minimum from `start`.
    ///
    /// # Errors
    /// If the energy at the start is not finite, a derivative is not finite or of a wrong size, the Hessian is singular or
    /// indefinite, no step lowers the energy, or the objective fails; each with the step.
    pub fn minimize(
        &self,
        objective: &mut impl TwiceDifferentiable,
        start: &[f64],
    ) -> Result<Minimum, Error> {
        self.minimize_with(objective, start, |_| ControlFlow::Continue(()))
    }

    /// As [`Newton::minimize`]; `report` is called at the start and after each step, and may end the search.
    ///
    /// # Errors
    /// As [`Newton::minimize`].
    pub fn minimize_with(
        &self,
        objective: &mut impl TwiceDifferentiable,
        start: &[f64],
        mut report: impl FnMut(&Progress<'_>) -> ControlFlow<()>,
    ) -> Result<Minimum, Error> {
        self.check()?;
        let mut point = Point::start(objective, start)?;
        let mut system = System::new(self);
        self.differentiate(objective, &mut point, &mut system)?;
        let mut direction = vec![0.0; start.len()];
        let (mut length, mut decrement) = (0.0, f64::NAN);
        let stop = loop {
            if report(&point.progress(length, decrement)).is_break() {
                break Stop::Callback;
            }
            if point.slope() <= self.gradient {
                break Stop::Gradient;
            }
            if point.step == self.most_steps {
                break Stop::Steps;
            }
            system.solve(objective, &point, &mut direction)?;
            let along = point.gradient.iter().zip(&direction);
            decrement = -0.5 * along.map(|(g, d)| g * d).sum::<f64>();
            if decrement.abs() <= self.decrement {
                break Stop::Decrement;
            }
            match point.search(objective, &direction, &self.line_search)? {
                Some(found) => length = found,
                None => break Stop::Rounding,
            }
            self.differentiate(objective, &mut point, &mut system)?;
        };
        Ok(point.minimum(stop))
    }

    /// The gradient, and with it the Hessian where a step follows whatever the gradient is.
    fn differentiate(
        &self,
        objective: &mut impl TwiceDifferentiable,
        point: &mut Point,
        system: &mut System,
    ) -> Result<(), Error> {
        system.is_known = self.gradient == 0.0 && point.step < self.most_steps;
        match system.is_known {
            true => point.differentiate_twice(objective, &mut system.hessian),
            false => point.differentiate(objective),
        }
    }

    fn check(&self) -> Result<(), Error> {
        not_negative("decrement", self.decrement)?;
        not_negative("gradient", self.gradient)?;
        not_negative("damping", self.damping)?;
        not_negative("greatest_damping", self.greatest_damping)?;
        self.line_search.check()
    }
}

/// The system of equations of a step, with what is kept from step to step.
struct System {
    damping: f64,
    greatest_damping: f64,
    hessian: CsMat<f64>,
    /// Whether the Hessian is that of the current point.
    is_known: bool,
    diagonal: Vec<f64>,
    factors: Option<Cholesky>,
}

impl System {
    fn new(newton: &Newton) -> System {
        System {
            damping: newton.damping,
            greatest_damping: newton.greatest_damping,
            hessian: CsMat::zero((0, 0)),
            is_known: false,
            diagonal: Vec::new(),
            factors: None,
        }
    }

    /// Writes the direction of the step from a point.
    fn solve(
        &mut self,
        objective: &mut impl TwiceDifferentiable,
        point: &Point,
        direction: &mut [f64],
    ) -> Result<(), Error> {
        let step = point.step + 1;
        if !self.is_known {
            objective
                .hessian(&mut self.hessian)
                .map_err(named(step, "hessian"))?;
        }
        let expected = point.x.len();
        for (what, found) in [
            ("number of rows of the hessian", self.hessian.rows()),
            ("number of columns of the hessian", self.hessian.cols()),
        ] {
            if found != expected {
                return Err(Error::Size {
                    step,
                    what,
                    found,
                    expected,
                });
            }
        }
        for (entry, slope) in direction.iter_mut().zip(&point.gradient) {
            *entry = -slope;
        }
        self.factorise()
            .and_then(|factors| factors.solve_in_place(direction))
            .map_err(|source| Error::System { step, source })
    }

    /// The factors of the Hessian with the least damping with which it is positive definite.
    fn factorise(&mut self) -> Result<&mut Cholesky, CholeskyError> {
        let diagonal = self.hessian.diag_iter().map(|x| x.copied().unwrap_or(0.0));
        self.diagonal.clear();
        self.diagonal.extend(diagonal);
        let mut damping = self.damping;
        loop {
            if damping > 0.0 {
                for (entry, original) in self.hessian.diag_iter_mut().zip(&self.diagonal) {
                    if let Some(entry) = entry {
                        *entry = original + damping * original.abs();
                    }
                }
            }
            let result = match &mut self.factors {
                Some(factors) => factors.factorise(&self.hessian),
                none => Cholesky::new(&self.hessian, Factorisation::PositiveDefinite)
                    .map(|factors| *none = Some(factors)),
            };
            match result {
                Ok(()) => break,
                Err(CholeskyError::Singular { .. } | CholeskyError::NotPositiveDefinite { .. })
                    if damping < self.greatest_damping =>
                {
                    damping = (10.0 * damping).max(1e-8).min(self.greatest_damping);
                }
                Err(error) => return Err(error),
            }
        }
        self.factors.as_mut().ok_or(CholeskyError::NoFactors)
    }
}
