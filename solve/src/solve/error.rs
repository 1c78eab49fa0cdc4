//! What can go wrong while an energy is minimised.

use std::fmt;

use super::CholeskyError;
use crate::objective::Failure;

/// Why a search for a minimum ended without one. Steps count from 1; step 0 is the start.
#[derive(Debug)]
#[non_exhaustive]
pub enum Error {
    /// The objective has no value.
    Objective {
        /// The step.
        step: usize,
        /// What was asked for: `position`, `energy`, `gradient`, `hessian`, `gradient or hessian`, `longest step`.
        what: &'static str,
        /// Why there is none.
        source: Failure,
    },
    /// The energy where a step is to begin is infinite or not a number.
    Energy {
        /// The step.
        step: usize,
        /// The energy.
        energy: f64,
    },
    /// An entry of the gradient is infinite or not a number.
    Gradient {
        /// The step.
        step: usize,
        /// The entry, from 0.
        entry: usize,
        /// What it is.
        value: f64,
    },
    /// A derivative has another size than the variables have.
    Size {
        /// The step.
        step: usize,
        /// Which derivative and which size of it.
        what: &'static str,
        /// The size.
        found: usize,
        /// Number of variables.
        expected: usize,
    },
    /// The system of equations for a step of Newton's method has no solution, or not the one of a minimum.
    System {
        /// The step.
        step: usize,
        /// What is wrong with the Hessian.
        source: CholeskyError,
    },
    /// A parameter of the method makes no sense.
    Parameter {
        /// The parameter.
        name: &'static str,
        /// What it is.
        value: f64,
        /// What it should be.
        expected: &'static str,
    },
    /// The energy does not fall along the direction of a step.
    NoDescent {
        /// The step.
        step: usize,
        /// The slope of the energy along the direction.
        slope: f64,
        /// The shortest step that was tried, as a multiple of the direction.
        shortest: f64,
        /// How many were tried.
        trials: usize,
    },
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Objective { step, what, source } => {
                write!(f, "step {step}: there is no {what}: {source}")
            }
            Error::Energy { step: 0, energy } => write!(f, "the energy at the start is {energy}"),
            Error::Energy { step, energy } => write!(f, "step {step}: the energy is {energy}"),
            Error::Gradient { step, entry, value } => {
                write!(f, "step {step}: entry {entry} of the gradient is {value}")
            }
            Error::Size {
                step,
                what,
                found,
                expected,
            } => write!(
                f,
                "step {step}: the {what} is {found}, but there are {expected} variables"
            ),
            Error::System { step, source } => write!(f, "step {step}: the hessian: {source}"),
            Error::Parameter {
                name,
                value,
                expected,
            } => write!(f, "`{name}` is {value} but must be {expected}"),
            Error::NoDescent {
                step,
                slope,
                shortest,
                trials,
            } => {
                write!(
                    f,
                    "step {step}: the energy does not fall along the direction: "
                )?;
                match *trials {
                    0 => write!(f, "its slope there is {slope:e}"),
                    _ => write!(
                        f,
                        "its slope there is {slope:e}, and {trials} lengths down to {shortest:e} were tried"
                    ),
                }
            }
        }
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Error::Objective { source, .. } => Some(&**source),
            Error::System { source, .. } => Some(source),
            _ => None,
        }
    }
}
