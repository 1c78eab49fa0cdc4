//! Minimising an energy: sparse Cholesky factorisation, Newton's method, gradient descent.
//!
//! ```
//! use iheartmesh_runtime::{nalgebra::dvector, sprs::TriMat};
//! use iheartmesh_solve::Functions;
//! use iheartmesh_solve::solve::Newton;
//!
//! // (x - 1)² + (y + 2)⁴ + y²
//! let mut functions = Functions {
//!     state: [0.0; 2],
//!     set: |at: &mut [f64; 2], x: &[f64]| Ok(at.copy_from_slice(x)),
//!     energy: |[x, y]: &mut [f64; 2]| Ok((*x - 1.0).powi(2) + (*y + 2.0).powi(4) + y.powi(2)),
//!     gradient: |[x, y]: &mut [f64; 2]| Ok(dvector![2.0 * (*x - 1.0), 4.0 * (*y + 2.0).powi(3) + 2.0 * *y]),
//!     hessian: |[_, y]: &mut [f64; 2]| {
//!         let mut hessian = TriMat::new((2, 2));
//!         hessian.add_triplet(0, 0, 2.0);
//!         hessian.add_triplet(1, 1, 12.0 * (*y + 2.0).powi(2) + 2.0);
//!         Ok(hessian.to_csc())
//!     },
//! };
//! let found = Newton::default().minimize(&mut functions, &[0.0, 0.0])?;
//! assert!(found.converged());
//! assert!((found.x[0] - 1.0).abs() < 1e-9);
//! # Ok::<(), iheartmesh_solve::solve::Error>(())
//! ```

mod cholesky;
mod descent;
mod error;
mod line_search;
mod newton;
mod outcome;

pub use cholesky::{Cholesky, CholeskyError, Factorisation};
pub use descent::{GradientDescent, StepLength};
pub use error::Error;
pub use line_search::LineSearch;
pub use newton::Newton;
pub use outcome::{Minimum, Progress, Stop};
