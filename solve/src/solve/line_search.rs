//! How far to go along a direction, and what both methods share.

use iheartmesh_runtime::nalgebra::DVector;
use iheartmesh_runtime::sprs::CsMat;

use super::{Error, Minimum, Progress, Stop};
use crate::objective::{Failure, Objective, TwiceDifferentiable};

/// What an energy falls by cannot be told from rounding where it is less than this part of the energy.
const ROUNDING: f64 = 1e-13;

/// Backtracking: the first of `first`, `shrink · first`, `shrink² · first`, … at which the energy has fallen by at least
/// the part `sufficient` of what its slope promises (Armijo 1966). Places where the energy is not finite are passed over.
#[derive(Clone, Debug, PartialEq)]
pub struct LineSearch {
    /// The first length that is tried, as a multiple of the direction, if the objective has no limit below it: greater
    /// than 0. Where it has one, `shrink` times the limit is tried first.
    pub first: f64,
    /// The ratio of one length to the one before, between 0 and 1.
    pub shrink: f64,
    /// The part of the promised fall that suffices, between 0 and 1.
    pub sufficient: f64,
    /// How many lengths are tried at most.
    pub most_trials: usize,
}

impl Default for LineSearch {
    /// Whole steps, halved up to 60 times; a fall of 10⁻⁴ of what is promised.
    fn default() -> LineSearch {
        LineSearch {
            first: 1.0,
            shrink: 0.5,
            sufficient: 1e-4,
            most_trials: 60,
        }
    }
}

impl LineSearch {
    pub(super) fn check(&self) -> Result<(), Error> {
        positive("first", self.first)?;
        for (name, value) in [("shrink", self.shrink), ("sufficient", self.sufficient)] {
            if !(value > 0.0 && value < 1.0) {
                return Err(Error::Parameter {
                    name,
                    value,
                    expected: "between 0 and 1",
                });
            }
        }
        Ok(())
    }
}

/// A place with its energy and gradient, and room for the next one.
pub(super) struct Point {
    /// How many steps have led here.
    pub step: usize,
    pub x: Vec<f64>,
    pub energy: f64,
    pub gradient: DVector<f64>,
    next: Vec<f64>,
}

/// Names the step and what was asked for in a failure of the objective.
pub(super) fn named(step: usize, what: &'static str) -> impl FnOnce(Failure) -> Error {
    move |source| Error::Objective { step, what, source }
}

impl Point {
    /// The start, not yet differentiated.
    pub fn start(objective: &mut impl Objective, x: &[f64]) -> Result<Point, Error> {
        objective.set(x).map_err(named(0, "position"))?;
        let energy = objective.energy().map_err(named(0, "energy"))?;
        if !energy.is_finite() {
            return Err(Error::Energy { step: 0, energy });
        }
        Ok(Point {
            step: 0,
            x: x.to_vec(),
            energy,
            gradient: DVector::zeros(0),
            next: x.to_vec(),
        })
    }

    /// The greatest absolute value in the gradient.
    pub fn slope(&self) -> f64 {
        self.gradient.amax()
    }

    /// What is reported of it. `length` and `decrement` are those of the step that led here.
    pub fn progress(&self, length: f64, decrement: f64) -> Progress<'_> {
        Progress {
            step: self.step,
            x: &self.x,
            energy: self.energy,
            gradient: self.slope(),
            length,
            decrement,
        }
    }

    /// The result of a search that ends here.
    pub fn minimum(self, stop: Stop) -> Minimum {
        Minimum {
            energy: self.energy,
            gradient: self.slope(),
            steps: self.step,
            x: self.x,
            stop,
        }
    }

    /// Asks for the gradient.
    pub fn differentiate(&mut self, objective: &mut impl Objective) -> Result<(), Error> {
        objective
            .gradient(&mut self.gradient)
            .map_err(named(self.step, "gradient"))?;
        self.check()
    }

    /// Asks for the gradient and the Hessian.
    pub fn differentiate_twice(
        &mut self,
        objective: &mut impl TwiceDifferentiable,
        hessian: &mut CsMat<f64>,
    ) -> Result<(), Error> {
        objective
            .derivatives(&mut self.gradient, hessian)
            .map_err(named(self.step, "gradient or hessian"))?;
        self.check()
    }

    fn check(&self) -> Result<(), Error> {
        let step = self.step;
        let (found, expected) = (self.gradient.len(), self.x.len());
        if found != expected {
            return Err(Error::Size {
                step,
                what: "length of the gradient",
                found,
                expected,
            });
        }
        let entry = self.gradient.iter().position(|entry| !entry.is_finite());
        entry.map_or(Ok(()), |entry| {
            Err(Error::Gradient {
                step,
                entry,
                value: self.gradient[entry],
            })
        })
    }

    /// The energy at a place along a direction, where the objective is then.
    fn try_step(
        &mut self,
        objective: &mut impl Objective,
        direction: &[f64],
        length: f64,
    ) -> Result<f64, Error> {
        for ((next, x), d) in self.next.iter_mut().zip(&self.x).zip(direction) {
            *next = x + length * d;
        }
        let step = self.step + 1;
        objective.set(&self.next).map_err(named(step, "position"))?;
        objective.energy().map_err(named(step, "energy"))
    }

    /// Goes where [`Point::try_step`] has been.
    fn accept(&mut self, energy: f64) {
        std::mem::swap(&mut self.x, &mut self.next);
        self.energy = energy;
        self.step += 1;
    }

    /// A step of a given length, wherever it leads; not yet differentiated there.
    pub fn walk(
        &mut self,
        objective: &mut impl Objective,
        direction: &[f64],
        length: f64,
    ) -> Result<(), Error> {
        let energy = self.try_step(objective, direction, length)?;
        if !energy.is_finite() {
            return Err(Error::Energy {
                step: self.step + 1,
                energy,
            });
        }
        self.accept(energy);
        Ok(())
    }

    /// A step to where the energy is lower, not yet differentiated there, and how long it was; nothing where the energy would fall by less than it is
    /// rounded. Where there is no such step the objective stays in place.
    pub fn search(
        &mut self,
        objective: &mut impl Objective,
        direction: &[f64],
        rule: &LineSearch,
    ) -> Result<Option<f64>, Error> {
        let step = self.step + 1;
        let slope: f64 = self
            .gradient
            .iter()
            .zip(direction)
            .map(|(g, d)| g * d)
            .sum();
        let none = |shortest: f64, trials: usize| Error::NoDescent {
            step,
            slope,
            shortest,
            trials,
        };
        if slope.is_nan() || slope >= 0.0 {
            return Err(none(0.0, 0));
        }
        let limit = objective
            .longest_step(&self.x, direction)
            .map_err(named(step, "longest step"))?;
        if limit.is_nan() || limit <= 0.0 {
            return Err(Error::Parameter {
                name: "longest_step",
                value: limit,
                expected: "greater than 0",
            });
        }
        let mut length = rule.first.min(rule.shrink * limit);
        let promised = -length * slope;
        let mut trials = 0;
        while trials < rule.most_trials {
            let energy = self.try_step(objective, direction, length)?;
            trials += 1;
            let sufficient = self.energy + rule.sufficient * length * slope;
            // where rounding makes the two sides equal nothing has moved
            if energy.is_finite() && energy <= sufficient && energy < self.energy {
                self.accept(energy);
                return Ok(Some(length));
            }
            length *= rule.shrink;
        }
        objective.set(&self.x).map_err(named(step, "position"))?;
        match promised <= ROUNDING * self.energy.abs() {
            true => Ok(None),
            false => Err(none(length / rule.shrink, trials)),
        }
    }
}

pub(super) fn positive(name: &'static str, value: f64) -> Result<(), Error> {
    match value > 0.0 && value.is_finite() {
        true => Ok(()),
        false => Err(Error::Parameter {
            name,
            value,
            expected: "greater than 0 and finite",
        }),
    }
}

pub(super) fn not_negative(name: &'static str, value: f64) -> Result<(), Error> {
    match value >= 0.0 {
        true => Ok(()),
        false => Err(Error::Parameter {
            name,
            value,
            expected: "0 or greater",
        }),
    }
}
