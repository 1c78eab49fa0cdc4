//! The host side of derivatives: what a program does with an energy, its gradient and its Hessian.
//!
//! - [`Objective`], [`TwiceDifferentiable`]: an energy with its derivatives, as generated modules have them and closures
//!   can give them.
//! - [`vec()`], [`inverse_vec`]: the numbers of a sequence in the order in which derivatives have them, and back.
//! - [`check_derivatives`], [`check_gradient`]: derivatives beside finite differences.
//! - `solve`, with the feature of that name: sparse Cholesky factorisation, Newton's method, gradient descent.

mod check;
mod items;
mod objective;
#[cfg(feature = "solve")]
pub mod solve;

pub use check::{
    Comparison, DerivativeCheck, DerivativeError, DerivativeReport, check_derivatives,
    check_gradient,
};
pub use items::{Item, WrongLength, inverse_vec, vec};
pub use objective::{Failure, Functions, Objective, TwiceDifferentiable};
