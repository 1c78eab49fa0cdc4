//! What Newton's method asks an objective for: gradient and Hessian at once where it needs both, no Hessian that it does not use.
#![cfg(feature = "solve")]

use std::ops::ControlFlow;

use iheartmesh_runtime::sprs::{CsMat, TriMat};
use iheartmesh_solve::solve::{Newton, Stop};
use iheartmesh_solve::{Failure, Objective, TwiceDifferentiable};
use nalgebra::{DVector, dvector};

/// `(x - 2)⁴ + y²`, with the number of times that each is asked for.
#[derive(Default)]
struct Counting {
    x: [f64; 2],
    gradients: usize,
    hessians: usize,
    both: usize,
    /// Whether both at once are computed by one method.
    at_once: bool,
}

impl Counting {
    fn slope(&self) -> DVector<f64> {
        dvector![4.0 * (self.x[0] - 2.0).powi(3), 2.0 * self.x[1]]
    }

    fn curve(&self) -> CsMat<f64> {
        let mut entries = TriMat::new((2, 2));
        entries.add_triplet(0, 0, 12.0 * (self.x[0] - 2.0).powi(2));
        entries.add_triplet(1, 1, 2.0);
        entries.to_csc()
    }
}

impl Objective for Counting {
    fn set(&mut self, x: &[f64]) -> Result<(), Failure> {
        self.x = [x[0], x[1]];
        Ok(())
    }

    fn energy(&mut self) -> Result<f64, Failure> {
        Ok((self.x[0] - 2.0).powi(4) + self.x[1].powi(2))
    }

    fn gradient(&mut self, gradient: &mut DVector<f64>) -> Result<(), Failure> {
        self.gradients += 1;
        *gradient = self.slope();
        Ok(())
    }
}

impl TwiceDifferentiable for Counting {
    fn hessian(&mut self, hessian: &mut CsMat<f64>) -> Result<(), Failure> {
        self.hessians += 1;
        *hessian = self.curve();
        Ok(())
    }

    fn derivatives(
        &mut self,
        gradient: &mut DVector<f64>,
        hessian: &mut CsMat<f64>,
    ) -> Result<(), Failure> {
        self.both += 1;
        if !self.at_once {
            self.gradient(gradient)?;
            return self.hessian(hessian);
        }
        *gradient = self.slope();
        *hessian = self.curve();
        Ok(())
    }
}

const START: [f64; 2] = [5.0, 3.0];

#[test]
fn both_at_once_wherever_a_step_follows() {
    let newton = Newton::default();
    let mut once = Counting {
        at_once: true,
        ..Counting::default()
    };
    let found = newton.minimize(&mut &mut once, &START).unwrap();
    assert_eq!(found.stop, Stop::Decrement);
    // at the start and after each step; the last decrement takes the Hessian too
    assert_eq!(
        (once.gradients, once.hessians, once.both),
        (0, 0, found.steps + 1)
    );
    let mut each = Counting::default();
    assert_eq!(newton.minimize(&mut each, &START).unwrap().x, found.x);
    assert_eq!(each.gradients, each.hessians);
}

#[test]
fn no_hessian_where_the_gradient_may_end_the_search() {
    let newton = Newton {
        gradient: 1e-3,
        decrement: 0.0,
        ..Newton::default()
    };
    let mut counts = Counting::default();
    let found = newton.minimize(&mut counts, &START).unwrap();
    assert_eq!(found.stop, Stop::Gradient);
    assert_eq!(
        (counts.gradients, counts.hessians, counts.both),
        (found.steps + 1, found.steps, 0)
    );
}

#[test]
fn no_hessian_after_the_last_step() {
    let newton = Newton {
        most_steps: 3,
        ..Newton::default()
    };
    let mut counts = Counting::default();
    let mut steps = Vec::new();
    let found = newton.minimize_with(&mut counts, &START, |progress| {
        steps.push(progress.step);
        ControlFlow::Continue(())
    });
    assert_eq!(found.unwrap().stop, Stop::Steps);
    assert_eq!(steps, [0, 1, 2, 3]);
    assert_eq!((counts.gradients, counts.hessians, counts.both), (4, 3, 3));
}

#[test]
fn a_failure_names_the_step() {
    struct Failing(Counting);
    impl Objective for Failing {
        fn set(&mut self, x: &[f64]) -> Result<(), Failure> {
            self.0.set(x)
        }
        fn energy(&mut self) -> Result<f64, Failure> {
            self.0.energy()
        }
        fn gradient(&mut self, gradient: &mut DVector<f64>) -> Result<(), Failure> {
            self.0.gradient(gradient)
        }
    }
    impl TwiceDifferentiable for Failing {
        fn hessian(&mut self, hessian: &mut CsMat<f64>) -> Result<(), Failure> {
            match self.0.hessians {
                0 => self.0.hessian(hessian),
                _ => Err("the second triangle has no area".into()),
            }
        }
    }
    let error = Newton::default()
        .minimize(&mut Failing(Counting::default()), &START)
        .unwrap_err();
    assert_eq!(
        error.to_string(),
        "step 1: there is no gradient or hessian: the second triangle has no area"
    );
}
