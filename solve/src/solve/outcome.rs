//! What a search for a minimum tells.

/// Where a search is, after a step; for the start, with step 0.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Progress<'a> {
    /// How many steps have been taken.
    pub step: usize,
    /// Where they have led.
    pub x: &'a [f64],
    /// The energy there.
    pub energy: f64,
    /// The greatest absolute value in the gradient there.
    pub gradient: f64,
    /// The length of the last step, as a multiple of its direction: 1 for a whole step of Newton's method. 0 at the start.
    pub length: f64,
    /// How much the energy would have fallen in the last step of Newton's method if it were quadratic: half of the square of
    /// the Newton decrement. Not a number at the start and in gradient descent.
    pub decrement: f64,
}

/// Why a search ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Stop {
    /// A step of Newton's method would hardly lower the energy any more.
    Decrement,
    /// The gradient is as small as it should be.
    Gradient,
    /// The last step hardly lowered the energy any more.
    Energy,
    /// What the energy falls by along the direction is less than what it is rounded by.
    Rounding,
    /// All steps were taken.
    Steps,
    /// The callback said so.
    Callback,
}

/// Where a search ended. The objective is there, too.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Minimum {
    /// Where.
    pub x: Vec<f64>,
    /// The energy there.
    pub energy: f64,
    /// The greatest absolute value in the gradient there.
    pub gradient: f64,
    /// How many steps were taken.
    pub steps: usize,
    /// Why it ended.
    pub stop: Stop,
}

impl Minimum {
    /// Whether one of the tolerances was met, or all that rounding allows.
    pub fn converged(&self) -> bool {
        matches!(
            self.stop,
            Stop::Decrement | Stop::Gradient | Stop::Energy | Stop::Rounding
        )
    }
}
