//! Gradient descent.

use std::ops::ControlFlow;

use super::line_search::{Point, not_negative, positive};
use super::{Error, LineSearch, Minimum, Progress, Stop};
use crate::objective::Objective;

/// How far a step of gradient descent goes.
#[derive(Clone, Debug, PartialEq)]
pub enum StepLength {
    /// Always this multiple of the gradient, wherever that leads.
    Fixed(f64),
    /// As far as the energy falls enough. Each search begins at twice the length of the last step, the first one at
    /// [`LineSearch::first`].
    Search(LineSearch),
}

/// Gradient descent: each step goes against the gradient.
#[derive(Clone, Debug, PartialEq)]
pub struct GradientDescent {
    /// How far a step goes.
    pub length: StepLength,
    /// The most steps.
    pub most_steps: usize,
    /// Ends where no entry of the gradient is greater than this, in its unit.
    pub gradient: f64,
    /// Ends where a step has lowered the energy by no more than this part of it.
    pub energy: f64,
}

impl Default for GradientDescent {
    /// With a line search, 1000 steps, until no entry of the gradient is greater than 10⁻⁸.
    fn default() -> GradientDescent {
        GradientDescent {
            length: StepLength::Search(LineSearch::default()),
            most_steps: 1000,
            gradient: 1e-8,
            energy: 0.0,
        }
    }
}

impl GradientDescent {
    /// Searches for a minimum from `start`.
    ///
    /// # Errors
    /// If the energy at the start or after a step of fixed length is not finite, the gradient is not finite or of a wrong
    /// length, no step lowers the energy, or the objective fails; each with the step.
    pub fn minimize(
        &self,
        objective: &mut impl Objective,
        start: &[f64],
    ) -> Result<Minimum, Error> {
        self.minimize_with(objective, start, |_| ControlFlow::Continue(()))
    }

    /// As [`GradientDescent::minimize`]; `report` is called at the start and after each step, and may end the search.
    ///
    /// # Errors
    /// As [`GradientDescent::minimize`].
    pub fn minimize_with(
        &self,
        objective: &mut impl Objective,
        start: &[f64],
        mut report: impl FnMut(&Progress<'_>) -> ControlFlow<()>,
    ) -> Result<Minimum, Error> {
        self.check()?;
        let mut point = Point::start(objective, start)?;
        point.differentiate(objective)?;
        let mut direction = vec![0.0; start.len()];
        let (mut rule, mut length, mut before) = (None, 0.0, None);
        let stop = loop {
            if report(&point.progress(length, f64::NAN)).is_break() {
                break Stop::Callback;
            }
            if point.slope() <= self.gradient {
                break Stop::Gradient;
            }
            let fall = before.map(|before: f64| before - point.energy);
            if self.energy > 0.0
                && fall.is_some_and(|fall| fall.abs() <= self.energy * point.energy.abs())
            {
                break Stop::Energy;
            }
            if point.step == self.most_steps {
                break Stop::Steps;
            }
            before = Some(point.energy);
            for (entry, slope) in direction.iter_mut().zip(&point.gradient) {
                *entry = -slope;
            }
            length = match &self.length {
                StepLength::Fixed(length) => {
                    point.walk(objective, &direction, *length)?;
                    *length
                }
                StepLength::Search(first) => {
                    let rule = rule.get_or_insert_with(|| first.clone());
                    let Some(length) = point.search(objective, &direction, rule)? else {
                        break Stop::Rounding;
                    };
                    rule.first = 2.0 * length;
                    length
                }
            };
            point.differentiate(objective)?;
        };
        Ok(point.minimum(stop))
    }

    fn check(&self) -> Result<(), Error> {
        not_negative("gradient", self.gradient)?;
        not_negative("energy", self.energy)?;
        match &self.length {
            StepLength::Fixed(length) => positive("length", *length),
            StepLength::Search(rule) => rule.check(),
        }
    }
}
