//! An energy with its derivatives.

use iheartmesh_runtime::nalgebra::DVector;
use iheartmesh_runtime::sprs::CsMat;

/// Why an energy or a derivative has no value. `?` makes it from any error, those of generated modules among them.
pub type Failure = Box<dyn std::error::Error + Send + Sync>;

/// A function to minimise, its energy, with its gradient.
///
/// A generated module meets it with a line for each method:
///
/// ```text
/// impl Objective for Parameterization<'_> {
///     fn set(&mut self, x: &[f64]) -> Result<(), Failure> {
///         Ok(self.set_x(inverse_vec::<DVec2>(x)?)?)
///     }
///     fn energy(&mut self) -> Result<f64, Failure> {
///         Ok(self.try_e()?)
///     }
///     fn gradient(&mut self, gradient: &mut DVector<f64>) -> Result<(), Failure> {
///         Ok(self.try_G_into(gradient)?)
///     }
/// }
/// ```
///
/// [`Functions`] makes one from closures.
pub trait Objective {
    /// Moves to `x`, where energy and derivatives are asked for next; numbers in the order of [`vec()`](crate::vec()).
    ///
    /// # Errors
    /// If there is no such place. Then nothing is asked for until the next call of `set`.
    fn set(&mut self, x: &[f64]) -> Result<(), Failure>;

    /// The energy. Where it is infinite or not a number is outside of the domain: no step ends there.
    ///
    /// # Errors
    /// If it has no value.
    fn energy(&mut self) -> Result<f64, Failure>;

    /// Writes the gradient, which has as many entries as `x`. `gradient` holds the last one, or is of length 0.
    ///
    /// # Errors
    /// If it has no value.
    fn gradient(&mut self, gradient: &mut DVector<f64>) -> Result<(), Failure>;

    /// Where the domain ends on the way from `x` along `direction`, as a multiple of `direction`; infinite if it is not
    /// overridden. Steps stay below it, which saves tries that would leave the domain, such as those that flip a triangle.
    ///
    /// # Errors
    /// If it has no value.
    fn longest_step(&mut self, x: &[f64], direction: &[f64]) -> Result<f64, Failure> {
        let _ = (x, direction);
        Ok(f64::INFINITY)
    }
}

/// An [`Objective`] with second derivatives.
pub trait TwiceDifferentiable: Objective {
    /// Writes the Hessian, or what stands for it in Newton's method, such as the sum of projected blocks: a square symmetric
    /// matrix with a row for each entry of `x`. `hessian` holds the last one, or has no rows.
    ///
    /// # Errors
    /// If it has no value.
    fn hessian(&mut self, hessian: &mut CsMat<f64>) -> Result<(), Failure>;

    /// Writes the gradient and the Hessian, each as by itself. Newton's method asks for both where it knows that it needs
    /// both; a module that has them `#[together(G, H)]` computes them in one pass:
    ///
    /// ```text
    /// fn derivatives(&mut self, gradient: &mut DVector<f64>, hessian: &mut CsMat<f64>) -> Result<(), Failure> {
    ///     Ok(self.try_G_H_into(gradient, hessian)?)
    /// }
    /// ```
    ///
    /// # Errors
    /// If one of them has no value.
    fn derivatives(
        &mut self,
        gradient: &mut DVector<f64>,
        hessian: &mut CsMat<f64>,
    ) -> Result<(), Failure> {
        self.gradient(gradient)?;
        self.hessian(hessian)
    }
}

impl<O: Objective + ?Sized> Objective for &mut O {
    fn set(&mut self, x: &[f64]) -> Result<(), Failure> {
        (**self).set(x)
    }

    fn energy(&mut self) -> Result<f64, Failure> {
        (**self).energy()
    }

    fn gradient(&mut self, gradient: &mut DVector<f64>) -> Result<(), Failure> {
        (**self).gradient(gradient)
    }

    fn longest_step(&mut self, x: &[f64], direction: &[f64]) -> Result<f64, Failure> {
        (**self).longest_step(x, direction)
    }
}

impl<O: TwiceDifferentiable + ?Sized> TwiceDifferentiable for &mut O {
    fn hessian(&mut self, hessian: &mut CsMat<f64>) -> Result<(), Failure> {
        (**self).hessian(hessian)
    }

    fn derivatives(
        &mut self,
        gradient: &mut DVector<f64>,
        hessian: &mut CsMat<f64>,
    ) -> Result<(), Failure> {
        (**self).derivatives(gradient, hessian)
    }
}

/// An objective of closures around a state that they share, such as a generated module.
///
/// ```
/// use iheartmesh_runtime::{nalgebra::dvector, sprs::TriMat};
/// use iheartmesh_solve::{Functions, check_derivatives};
///
/// // ½ x² + y⁴
/// let mut functions = Functions {
///     state: [0.0; 2],
///     set: |at: &mut [f64; 2], x: &[f64]| Ok(at.copy_from_slice(x)),
///     energy: |[x, y]: &mut [f64; 2]| Ok(0.5 * x.powi(2) + y.powi(4)),
///     gradient: |[x, y]: &mut [f64; 2]| Ok(dvector![*x, 4.0 * y.powi(3)]),
///     hessian: |[_, y]: &mut [f64; 2]| {
///         let mut hessian = TriMat::new((2, 2));
///         hessian.add_triplet(0, 0, 1.0);
///         hessian.add_triplet(1, 1, 12.0 * y.powi(2));
///         Ok(hessian.to_csc())
///     },
/// };
/// assert!(check_derivatives(&mut functions, &[1.0, 2.0])?.is_within(1e-8));
/// # Ok::<(), iheartmesh_solve::DerivativeError>(())
/// ```
///
/// Without second derivatives, `hessian` is `()`.
#[derive(Clone, Debug)]
pub struct Functions<State, Set, Energy, Gradient, Hessian> {
    /// What the closures share.
    pub state: State,
    /// [`Objective::set`].
    pub set: Set,
    /// [`Objective::energy`].
    pub energy: Energy,
    /// [`Objective::gradient`].
    pub gradient: Gradient,
    /// [`TwiceDifferentiable::hessian`].
    pub hessian: Hessian,
}

impl<State, Set, Energy, Gradient, Hessian> Objective
    for Functions<State, Set, Energy, Gradient, Hessian>
where
    Set: FnMut(&mut State, &[f64]) -> Result<(), Failure>,
    Energy: FnMut(&mut State) -> Result<f64, Failure>,
    Gradient: FnMut(&mut State) -> Result<DVector<f64>, Failure>,
{
    fn set(&mut self, x: &[f64]) -> Result<(), Failure> {
        (self.set)(&mut self.state, x)
    }

    fn energy(&mut self) -> Result<f64, Failure> {
        (self.energy)(&mut self.state)
    }

    fn gradient(&mut self, gradient: &mut DVector<f64>) -> Result<(), Failure> {
        *gradient = (self.gradient)(&mut self.state)?;
        Ok(())
    }
}

impl<State, Set, Energy, Gradient, Hessian> TwiceDifferentiable
    for Functions<State, Set, Energy, Gradient, Hessian>
where
    Self: Objective,
    Hessian: FnMut(&mut State) -> Result<CsMat<f64>, Failure>,
{
    fn hessian(&mut self, hessian: &mut CsMat<f64>) -> Result<(), Failure> {
        *hessian = (self.hessian)(&mut self.state)?;
        Ok(())
    }
}
