//! Derivatives beside finite differences.

use std::fmt;

use iheartmesh_runtime::nalgebra::DVector;
use iheartmesh_runtime::sprs::CsMat;

use crate::objective::{Failure, Objective, TwiceDifferentiable};

/// How many lengths of steps are tried, each a quarter of the one before.
const LENGTHS: usize = 8;

/// How derivatives are checked.
#[derive(Clone, Debug, PartialEq)]
pub struct DerivativeCheck {
    /// The longest step of a difference; from there steps get shorter until results settle. A tenth of the smallest length
    /// in `x` is a good choice; 0 takes 10⁻² of the mean size of the entries of `x`.
    pub step: f64,
    /// By how many variables, spread evenly, derivatives are checked at most. Each costs some 30 evaluations of the energy, and as
    /// many of the gradient for the Hessian.
    pub most_variables: usize,
}

impl Default for DerivativeCheck {
    /// Up to 60 variables.
    fn default() -> DerivativeCheck {
        DerivativeCheck {
            step: 0.0,
            most_variables: 60,
        }
    }
}

/// Compares the gradient at `x` with differences of the energy, and the Hessian with differences of the gradient, by up to
/// 60 variables; [`DerivativeCheck`] has other choices.
///
/// A sum of projected blocks, `∑ psd(∂²S/∂x²)`, is not the Hessian of the energy: compare `∂²e/∂x²`.
///
/// # Errors
/// If the energy or a derivative has no value, is not finite near `x`, or has a wrong size.
pub fn check_derivatives(
    objective: &mut impl TwiceDifferentiable,
    x: &[f64],
) -> Result<DerivativeReport, DerivativeError> {
    DerivativeCheck::default().derivatives(objective, x)
}

/// Compares the gradient at `x` with differences of the energy, by up to 60 variables.
///
/// # Errors
/// As [`check_derivatives`].
pub fn check_gradient(
    objective: &mut impl Objective,
    x: &[f64],
) -> Result<DerivativeReport, DerivativeError> {
    DerivativeCheck::default().gradient(objective, x)
}

impl DerivativeCheck {
    /// Compares the gradient and the Hessian.
    ///
    /// # Errors
    /// As [`check_derivatives`].
    pub fn derivatives(
        &self,
        objective: &mut impl TwiceDifferentiable,
        x: &[f64],
    ) -> Result<DerivativeReport, DerivativeError> {
        let mut report = self.gradient(objective, x)?;
        let n = x.len();
        let mut hessian = CsMat::zero((0, 0));
        objective.hessian(&mut hessian).map_err(failed("hessian"))?;
        for (what, found) in [("rows", hessian.rows()), ("columns", hessian.cols())] {
            if found != n {
                return Err(DerivativeError::Size {
                    what: format!("number of {what} of the hessian"),
                    found,
                    expected: n,
                });
            }
        }
        let mut comparison = Comparison::default();
        let mut gradient = DVector::zeros(0);
        for k in self.variables(n) {
            let slope = differences(self.step_of(x), |step| {
                displaced(objective, x, k, step)?;
                objective
                    .gradient(&mut gradient)
                    .map_err(failed("gradient"))?;
                if gradient.len() != n {
                    return Err(wrong_length(gradient.len(), n));
                }
                Ok(gradient.clone())
            })?
            .ok_or(DerivativeError::NotFinite {
                what: "gradient",
                variable: k,
            })?;
            for (row, (value, uncertainty)) in
                slope.value.iter().zip(&slope.uncertainty).enumerate()
            {
                let found = hessian.get(row, k).copied().unwrap_or(0.0);
                comparison.add((row, k), found, *value, *uncertainty);
            }
        }
        report.hessian = Some(comparison);
        objective.set(x).map_err(failed("position"))?;
        Ok(report)
    }

    /// Compares the gradient.
    ///
    /// # Errors
    /// As [`check_derivatives`].
    pub fn gradient(
        &self,
        objective: &mut impl Objective,
        x: &[f64],
    ) -> Result<DerivativeReport, DerivativeError> {
        let n = x.len();
        objective.set(x).map_err(failed("position"))?;
        let mut gradient = DVector::zeros(0);
        objective
            .gradient(&mut gradient)
            .map_err(failed("gradient"))?;
        if gradient.len() != n {
            return Err(wrong_length(gradient.len(), n));
        }
        let mut comparison = Comparison::default();
        let mut checked = 0;
        for k in self.variables(n) {
            let slope = differences(self.step_of(x), |step| {
                displaced(objective, x, k, step)?;
                let energy = objective.energy().map_err(failed("energy"))?;
                Ok(DVector::from_element(1, energy))
            })?
            .ok_or(DerivativeError::NotFinite {
                what: "energy",
                variable: k,
            })?;
            comparison.add((k, 0), gradient[k], slope.value[0], slope.uncertainty[0]);
            checked += 1;
        }
        objective.set(x).map_err(failed("position"))?;
        Ok(DerivativeReport {
            variables: n,
            checked,
            gradient: comparison,
            hessian: None,
        })
    }

    /// The variables that are checked.
    fn variables(&self, n: usize) -> impl Iterator<Item = usize> + use<> {
        let count = n.min(self.most_variables);
        (0..count).map(move |k| (k as u128 * n as u128 / count as u128) as usize)
    }

    fn step_of(&self, x: &[f64]) -> f64 {
        let mean = x.iter().map(|x| x.abs()).sum::<f64>() / x.len().max(1) as f64;
        match (self.step > 0.0 && self.step.is_finite(), mean > 0.0) {
            (true, _) => self.step,
            (false, true) => 1e-2 * mean,
            (false, false) => 1e-2,
        }
    }
}

/// Names what was asked for in a failure of the objective.
fn failed(what: &'static str) -> impl FnOnce(Failure) -> DerivativeError {
    move |source| DerivativeError::Objective { what, source }
}

fn wrong_length(found: usize, expected: usize) -> DerivativeError {
    DerivativeError::Size {
        what: "length of the gradient".to_owned(),
        found,
        expected,
    }
}

/// Moves the objective by one variable.
fn displaced(
    objective: &mut impl Objective,
    x: &[f64],
    variable: usize,
    step: f64,
) -> Result<(), DerivativeError> {
    let mut moved = x.to_vec();
    moved[variable] += step;
    objective.set(&moved).map_err(failed("position"))
}

/// A derivative from differences.
struct Slope {
    value: DVector<f64>,
    /// How much each entry has changed from the last length of steps, and what rounding may have done to it.
    uncertainty: DVector<f64>,
}

/// The derivative at 0 by central differences of fourth order, with the length of steps at which it changes least from one
/// length to the next, rounding included, entry by entry (after C. Ridders, 1982). Nothing where values are not finite for most lengths.
fn differences(
    longest: f64,
    mut value: impl FnMut(f64) -> Result<DVector<f64>, DerivativeError>,
) -> Result<Option<Slope>, DerivativeError> {
    let mut last: Option<DVector<f64>> = None;
    let mut best: Option<Slope> = None;
    let mut step = longest;
    for _ in 0..LENGTHS {
        let [a, b, c, d] = [
            value(step)?,
            value(-step)?,
            value(2.0 * step)?,
            value(-2.0 * step)?,
        ];
        let slope = (4.0 * (&a - &b) / (2.0 * step) - (&c - &d) / (4.0 * step)) / 3.0;
        // what rounding of the values makes of differences
        let rounding = f64::EPSILON / step * (a.abs() + b.abs());
        step *= 0.25;
        if !slope.iter().all(|entry| entry.is_finite()) {
            continue;
        }
        if let Some(last) = &last {
            let change = (&slope - last).abs() + rounding;
            match &mut best {
                None => {
                    best = Some(Slope {
                        value: slope.clone(),
                        uncertainty: change,
                    });
                }
                Some(best) => {
                    for k in 0..slope.len() {
                        if change[k] < best.uncertainty[k] {
                            best.value[k] = slope[k];
                            best.uncertainty[k] = change[k];
                        }
                    }
                }
            }
        }
        last = Some(slope);
    }
    Ok(best)
}

/// A derivative beside differences: where they are furthest apart.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Comparison {
    /// How many entries were compared.
    pub entries: usize,
    /// The largest difference.
    pub error: f64,
    /// Where it is: row and column, from 0; the column of a gradient is 0. Nothing if no entries were compared.
    pub place: Option<(usize, usize)>,
    /// The entry of the derivative there.
    pub found: f64,
    /// What the differences say there.
    pub expected: f64,
    /// How far the differences are from each other there.
    pub uncertainty: f64,
    /// The greatest absolute value in the derivative and in the differences.
    pub greatest: f64,
}

impl Default for Comparison {
    fn default() -> Comparison {
        Comparison {
            entries: 0,
            error: 0.0,
            place: None,
            found: 0.0,
            expected: 0.0,
            uncertainty: 0.0,
            greatest: 0.0,
        }
    }
}

impl Comparison {
    fn add(&mut self, place: (usize, usize), found: f64, expected: f64, uncertainty: f64) {
        let error = (found - expected).abs();
        self.entries += 1;
        self.greatest = self.greatest.max(found.abs()).max(expected.abs());
        // what is not a number is the largest error
        if self.place.is_none() || error > self.error || error.is_nan() && !self.error.is_nan() {
            self.place = Some(place);
            (self.error, self.found, self.expected) = (error, found, expected);
            self.uncertainty = uncertainty;
        }
    }

    /// The largest difference as a part of the greatest value.
    pub fn relative_error(&self) -> f64 {
        match self.error == 0.0 {
            true => 0.0,
            false => self.error / self.greatest,
        }
    }
}

/// What [`check_derivatives`] found. Prints as text.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct DerivativeReport {
    /// Number of variables.
    pub variables: usize,
    /// By how many of them derivatives were checked.
    pub checked: usize,
    /// The gradient beside differences of the energy.
    pub gradient: Comparison,
    /// The Hessian beside differences of the gradient, if it was asked for.
    pub hessian: Option<Comparison>,
}

impl DerivativeReport {
    /// Whether all relative errors are at most `tolerance`. Differences are exact to about 10⁻⁹ where the energy is smooth.
    pub fn is_within(&self, tolerance: f64) -> bool {
        let mut all = std::iter::once(&self.gradient).chain(&self.hessian);
        all.all(|comparison| comparison.relative_error() <= tolerance)
    }
}

impl fmt::Display for DerivativeReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "derivatives by {} of {} variables",
            self.checked, self.variables
        )?;
        for (name, comparison) in [
            ("gradient", Some(&self.gradient)),
            ("hessian", self.hessian.as_ref()),
        ] {
            let Some(comparison) = comparison else {
                continue;
            };
            let Some((row, column)) = comparison.place else {
                write!(f, "\n  {name}: nothing to compare")?;
                continue;
            };
            let relative = comparison.relative_error();
            write!(
                f,
                "\n  {name}: largest error {relative:.1e} of the greatest value, at "
            )?;
            match name {
                "gradient" => write!(f, "entry {row}")?,
                _ => write!(f, "row {row}, column {column}")?,
            }
            write!(
                f,
                ": {:e}, but differences say {:e} ± {:.0e}",
                comparison.found, comparison.expected, comparison.uncertainty
            )?;
        }
        Ok(())
    }
}

/// Why derivatives cannot be checked.
#[derive(Debug)]
#[non_exhaustive]
pub enum DerivativeError {
    /// The objective has no value.
    Objective {
        /// What was asked for: `position`, `energy`, `gradient`, `hessian`.
        what: &'static str,
        /// Why there is none.
        source: Failure,
    },
    /// A derivative has another size than the variables have.
    Size {
        /// Which derivative and which size of it.
        what: String,
        /// The size.
        found: usize,
        /// Number of variables.
        expected: usize,
    },
    /// The energy or the gradient is not finite near the place.
    NotFinite {
        /// `energy` or `gradient`.
        what: &'static str,
        /// The variable that was changed, from 0.
        variable: usize,
    },
}

impl fmt::Display for DerivativeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            DerivativeError::Objective { what, source } => {
                write!(f, "there is no {what}: {source}")
            }
            DerivativeError::Size {
                what,
                found,
                expected,
            } => write!(
                f,
                "the {what} is {found}, but there are {expected} variables"
            ),
            DerivativeError::NotFinite { what, variable } => write!(
                f,
                "the {what} is not finite when variable {variable} changes a little"
            ),
        }
    }
}

impl std::error::Error for DerivativeError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            DerivativeError::Objective { source, .. } => Some(&**source),
            _ => None,
        }
    }
}
