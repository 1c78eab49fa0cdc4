//! Searches for minima of functions with known ones, and of functions without.

use std::ops::ControlFlow;

use iheartmesh_runtime::sprs::{CsMat, TriMat};
use iheartmesh_solve::solve::{
    CholeskyError, Error, GradientDescent, LineSearch, Newton, StepLength, Stop,
};
use iheartmesh_solve::{Failure, Functions, Objective, TwiceDifferentiable};
use nalgebra::{DVector, dvector};

fn symmetric(n: usize, rows: &[f64]) -> CsMat<f64> {
    let mut entries = TriMat::new((n, n));
    for (k, entry) in rows.iter().enumerate() {
        entries.add_triplet(k / n, k % n, *entry);
    }
    entries.to_csc()
}

/// A function of vectors with its derivatives.
type Of<T> = fn(&[f64]) -> T;

fn objective(
    energy: Of<f64>,
    gradient: Of<Vec<f64>>,
    hessian: Of<Vec<f64>>,
) -> impl TwiceDifferentiable {
    Functions {
        state: Vec::new(),
        set: |at: &mut Vec<f64>, x: &[f64]| {
            *at = x.to_vec();
            Ok(())
        },
        energy: move |x: &mut Vec<f64>| Ok(energy(x)),
        gradient: move |x: &mut Vec<f64>| Ok(DVector::from_vec(gradient(x))),
        hessian: move |x: &mut Vec<f64>| {
            let entries = hessian(x);
            Ok(symmetric(entries.len().isqrt(), &entries))
        },
    }
}

/// The function of H. H. Rosenbrock (1960), with its minimum 0 at (1, 1).
fn rosenbrock() -> impl TwiceDifferentiable {
    objective(
        |x| (1.0 - x[0]).powi(2) + 100.0 * (x[1] - x[0] * x[0]).powi(2),
        |x| {
            let fall = x[1] - x[0] * x[0];
            vec![-2.0 * (1.0 - x[0]) - 400.0 * x[0] * fall, 200.0 * fall]
        },
        |x| {
            let mixed = -400.0 * x[0];
            vec![
                2.0 - 400.0 * (x[1] - 3.0 * x[0] * x[0]),
                mixed,
                mixed,
                200.0,
            ]
        },
    )
}

/// ½ (x - (1, 2))ᵀ A (x - (1, 2)) with A = [3 1; 1 2].
fn quadratic() -> impl TwiceDifferentiable {
    objective(
        |x| {
            let d = [x[0] - 1.0, x[1] - 2.0];
            1.5 * d[0] * d[0] + d[0] * d[1] + d[1] * d[1]
        },
        |x| {
            let d = [x[0] - 1.0, x[1] - 2.0];
            vec![3.0 * d[0] + d[1], d[0] + 2.0 * d[1]]
        },
        |_| vec![3.0, 1.0, 1.0, 2.0],
    )
}

/// x² - y²
fn saddle() -> impl TwiceDifferentiable {
    objective(
        |x| x[0] * x[0] - x[1] * x[1],
        |x| vec![2.0 * x[0], -2.0 * x[1]],
        |_| vec![2.0, 0.0, 0.0, -2.0],
    )
}

/// (x - y)², which no movement of both changes.
fn valley() -> impl TwiceDifferentiable {
    objective(
        |x| (x[0] - x[1]).powi(2),
        |x| vec![2.0 * (x[0] - x[1]), 2.0 * (x[1] - x[0])],
        |_| vec![2.0, -2.0, -2.0, 2.0],
    )
}

/// x - ln(x), infinite for x ≤ 0.
fn barrier() -> impl TwiceDifferentiable {
    objective(
        |x| match x[0] > 0.0 {
            true => x[0] - x[0].ln(),
            false => f64::INFINITY,
        },
        |x| vec![1.0 - 1.0 / x[0]],
        |x| vec![1.0 / (x[0] * x[0])],
    )
}

#[track_caller]
fn close(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() <= tolerance, "{found:?} is not {expected:?}");
    }
}

#[test]
fn a_quadratic_energy_takes_one_step() {
    let found = Newton::default()
        .minimize(&mut quadratic(), &[10.0, -7.0])
        .unwrap();
    assert_eq!((found.steps, found.stop), (1, Stop::Decrement));
    close(&found.x, &[1.0, 2.0], 1e-14);
    assert!(found.energy.abs() < 1e-28 && found.converged());
}

#[test]
fn rosenbrock_by_newton() {
    let newton = Newton {
        decrement: 1e-24,
        ..Newton::default()
    };
    let mut objective = rosenbrock();
    let mut energies = Vec::new();
    let found = newton
        .minimize_with(&mut objective, &[-1.2, 1.0], |progress| {
            assert_eq!(progress.step, energies.len());
            energies.push(progress.energy);
            ControlFlow::Continue(())
        })
        .unwrap();
    close(&found.x, &[1.0, 1.0], 1e-12);
    assert!(found.converged() && found.steps < 30, "{found:?}");
    assert_eq!(energies.len(), found.steps + 1);
    assert!(energies.windows(2).all(|pair| pair[1] < pair[0]));
    // the objective is where the search has ended
    assert_eq!(objective.energy().unwrap(), found.energy);
}

#[test]
fn rosenbrock_by_gradient_descent() {
    let descent = GradientDescent {
        most_steps: 100_000,
        gradient: 1e-6,
        ..GradientDescent::default()
    };
    let found = descent.minimize(&mut rosenbrock(), &[-1.2, 1.0]).unwrap();
    assert_eq!(found.stop, Stop::Gradient);
    assert!(found.gradient <= 1e-6);
    close(&found.x, &[1.0, 1.0], 1e-5);
}

#[test]
fn fixed_steps() {
    let descent = |length: f64| GradientDescent {
        length: StepLength::Fixed(length),
        most_steps: 2000,
        gradient: 1e-12,
        energy: 0.0,
    };
    let found = descent(0.2)
        .minimize(&mut quadratic(), &[10.0, -7.0])
        .unwrap();
    assert_eq!(found.stop, Stop::Gradient);
    close(&found.x, &[1.0, 2.0], 1e-11);
    // one step is x - 0.2 g
    let one = GradientDescent {
        most_steps: 1,
        ..descent(0.2)
    };
    let found = one.minimize(&mut quadratic(), &[2.0, 2.0]).unwrap();
    assert_eq!((found.steps, found.stop), (1, Stop::Steps));
    close(&found.x, &[2.0 - 0.2 * 3.0, 2.0 - 0.2], 1e-15);
    assert!(!found.converged());
    // too long ones diverge, and the step at which the energy overflows is named
    let error = descent(10.0)
        .minimize(&mut quadratic(), &[2.0, 2.0])
        .unwrap_err();
    let Error::Energy { step, energy } = error else {
        panic!("{error}");
    };
    assert!(step > 10 && !energy.is_finite());
    let settled = GradientDescent {
        energy: 1e-3,
        gradient: 0.0,
        ..descent(0.01)
    };
    let shifted = || objective(|x| 1.0 + x[0] * x[0], |x| vec![2.0 * x[0]], |_| vec![2.0]);
    assert_eq!(
        settled.minimize(&mut shifted(), &[1.0]).unwrap().stop,
        Stop::Energy
    );
}

#[test]
fn infinite_energies_are_passed_over() {
    // the first whole step leads to -3
    let found = Newton::default().minimize(&mut barrier(), &[3.0]).unwrap();
    close(&found.x, &[1.0], 1e-5);
    let found = GradientDescent::default()
        .minimize(&mut barrier(), &[1e-3])
        .unwrap();
    close(&found.x, &[1.0], 1e-7);
}

/// The barrier, with how far away it is.
struct Careful<O>(O, usize);

impl<O: Objective> Objective for Careful<O> {
    fn set(&mut self, x: &[f64]) -> Result<(), Failure> {
        assert!(x[0] > 0.0, "outside of the domain");
        self.0.set(x)
    }

    fn energy(&mut self) -> Result<f64, Failure> {
        self.0.energy()
    }

    fn gradient(&mut self, gradient: &mut DVector<f64>) -> Result<(), Failure> {
        self.0.gradient(gradient)
    }

    fn longest_step(&mut self, x: &[f64], direction: &[f64]) -> Result<f64, Failure> {
        self.1 += 1;
        Ok(match direction[0] < 0.0 {
            true => -x[0] / direction[0],
            false => f64::INFINITY,
        })
    }
}

impl<O: TwiceDifferentiable> TwiceDifferentiable for Careful<O> {
    fn hessian(&mut self, hessian: &mut CsMat<f64>) -> Result<(), Failure> {
        self.0.hessian(hessian)
    }
}

#[test]
fn steps_stay_inside_of_the_domain() {
    let mut careful = Careful(barrier(), 0);
    let found = Newton::default().minimize(&mut careful, &[300.0]).unwrap();
    close(&found.x, &[1.0], 1e-5);
    assert_eq!(careful.1, found.steps);
}

#[test]
fn a_callback_ends_the_search() {
    let stop = |progress: &iheartmesh_solve::solve::Progress<'_>| match progress.step {
        3 => ControlFlow::Break(()),
        _ => ControlFlow::Continue(()),
    };
    let start = [-1.2, 1.0];
    let a = Newton::default()
        .minimize_with(&mut rosenbrock(), &start, stop)
        .unwrap();
    let b = GradientDescent::default()
        .minimize_with(&mut rosenbrock(), &start, stop)
        .unwrap();
    for found in [a, b] {
        assert_eq!((found.steps, found.stop), (3, Stop::Callback));
        assert!(!found.converged());
    }
}

#[test]
fn steps_come_to_an_end() {
    let newton = Newton {
        most_steps: 4,
        ..Newton::default()
    };
    let found = newton.minimize(&mut rosenbrock(), &[-1.2, 1.0]).unwrap();
    assert_eq!((found.steps, found.stop), (4, Stop::Steps));
    // a start at the minimum
    let found = newton.minimize(&mut rosenbrock(), &[1.0, 1.0]).unwrap();
    assert_eq!((found.steps, found.stop), (0, Stop::Gradient));
}

#[test]
fn hessians_that_are_singular_or_indefinite() {
    let error = Newton::default()
        .minimize(&mut saddle(), &[1.0, 1.0])
        .unwrap_err();
    assert!(matches!(
        error,
        Error::System {
            step: 1,
            source: CholeskyError::NotPositiveDefinite { variable: 1 }
        }
    ));
    assert_eq!(
        error.to_string(),
        "step 1: the hessian: the matrix is not positive definite: the pivot of row 1 is negative"
    );
    let error = Newton::default()
        .minimize(&mut valley(), &[1.0, 3.0])
        .unwrap_err();
    assert!(matches!(
        error,
        Error::System {
            step: 1,
            source: CholeskyError::Singular { .. }
        }
    ));
    let damped = Newton {
        damping: 1e-9,
        ..Newton::default()
    };
    let found = damped.minimize(&mut valley(), &[1.0, 3.0]).unwrap();
    close(&found.x, &[2.0, 2.0], 1e-7);
}

#[test]
fn damping_grows_where_it_must() {
    // the double well (x² - 1)², whose Hessian at 0.1 is negative
    let well = || {
        objective(
            |x| (x[0] * x[0] - 1.0).powi(2),
            |x| vec![4.0 * x[0] * (x[0] * x[0] - 1.0)],
            |x| vec![12.0 * x[0] * x[0] - 4.0],
        )
    };
    assert!(matches!(
        Newton::default().minimize(&mut well(), &[0.1]),
        Err(Error::System { step: 1, .. })
    ));
    let newton = Newton {
        greatest_damping: 10.0,
        ..Newton::default()
    };
    let found = newton.minimize(&mut well(), &[0.1]).unwrap();
    close(&found.x, &[1.0], 1e-5);
    // not enough
    let newton = Newton {
        greatest_damping: 0.5,
        ..newton
    };
    assert!(newton.minimize(&mut well(), &[0.1]).is_err());
}

#[test]
fn energies_without_a_value() {
    let error = Newton::default()
        .minimize(&mut barrier(), &[-1.0])
        .unwrap_err();
    assert_eq!(error.to_string(), "the energy at the start is inf");
    let error = GradientDescent::default()
        .minimize(&mut barrier(), &[f64::NAN])
        .unwrap_err();
    assert_eq!(error.to_string(), "the energy at the start is inf");
    let mut bad = objective(|x| x[0] * x[0], |_| vec![f64::NAN], |_| vec![2.0]);
    let error = Newton::default().minimize(&mut bad, &[1.0]).unwrap_err();
    assert_eq!(error.to_string(), "step 0: entry 0 of the gradient is NaN");
    let mut bad = objective(
        |x| x[0] * x[0],
        |x| vec![2.0 * x[0]],
        |_| vec![f64::INFINITY],
    );
    let error = Newton::default().minimize(&mut bad, &[1.0]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "step 1: the hessian: the entry in row 0, column 0 is inf"
    );
    let mut failing = Functions {
        state: 0,
        set: |_: &mut i32, _: &[f64]| Ok(()),
        energy: |calls: &mut i32| {
            *calls += 1;
            match *calls {
                1 => Ok(1.0),
                _ => Err("a vertex has no neighbours".into()),
            }
        },
        gradient: |_: &mut i32| Ok(dvector![1.0]),
        hessian: |_: &mut i32| Ok(symmetric(1, &[1.0])),
    };
    let error = Newton::default()
        .minimize(&mut failing, &[1.0])
        .unwrap_err();
    assert_eq!(
        error.to_string(),
        "step 1: there is no energy: a vertex has no neighbours"
    );
    assert!(std::error::Error::source(&error).is_some());
}

#[test]
fn wrong_derivatives() {
    // the gradient has the wrong sign
    let mut bad = objective(|x| x[0] * x[0], |x| vec![-2.0 * x[0]], |_| vec![2.0]);
    let error = Newton::default().minimize(&mut bad, &[1.0]).unwrap_err();
    let Error::NoDescent {
        step,
        slope,
        trials,
        shortest,
    } = error
    else {
        panic!("{error}");
    };
    assert_eq!((step, trials), (1, 60));
    assert!(slope < 0.0 && shortest > 0.0 && shortest < 1e-17);
    // the objective is back at the start
    assert_eq!(bad.energy().unwrap(), 1.0);

    let mut bad = objective(|x| x[0] * x[0], |x| vec![2.0 * x[0]; 2], |_| vec![2.0]);
    for error in [
        Newton::default().minimize(&mut bad, &[1.0]).unwrap_err(),
        GradientDescent::default()
            .minimize(&mut bad, &[1.0])
            .unwrap_err(),
    ] {
        assert_eq!(
            error.to_string(),
            "step 0: the length of the gradient is 2, but there are 1 variables"
        );
    }
    let mut bad = objective(
        |x| x[0] * x[0],
        |x| vec![2.0 * x[0]],
        |_| vec![2.0, 0.0, 0.0, 2.0],
    );
    let error = Newton::default().minimize(&mut bad, &[1.0]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "step 1: the number of rows of the hessian is 2, but there are 1 variables"
    );
}

#[test]
fn parameters_that_make_no_sense() {
    let search = |rule: LineSearch| Newton {
        line_search: rule,
        ..Newton::default()
    };
    let rule = LineSearch::default();
    for newton in [
        Newton {
            decrement: f64::NAN,
            ..Newton::default()
        },
        Newton {
            gradient: -1.0,
            ..Newton::default()
        },
        Newton {
            damping: -1.0,
            ..Newton::default()
        },
        search(LineSearch {
            first: 0.0,
            ..rule.clone()
        }),
        search(LineSearch {
            shrink: 1.0,
            ..rule.clone()
        }),
        search(LineSearch {
            sufficient: 0.0,
            ..rule
        }),
    ] {
        let error = newton.minimize(&mut quadratic(), &[0.0, 0.0]).unwrap_err();
        assert!(matches!(error, Error::Parameter { .. }), "{error}");
    }
    let descent = GradientDescent {
        length: StepLength::Fixed(f64::INFINITY),
        ..GradientDescent::default()
    };
    let error = descent.minimize(&mut quadratic(), &[0.0, 0.0]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "`length` is inf but must be greater than 0 and finite"
    );
}

#[test]
fn nothing_to_vary() {
    let nothing = || objective(|_| 3.0, |_| Vec::new(), |_| Vec::new());
    let found = Newton::default().minimize(&mut nothing(), &[]).unwrap();
    assert_eq!((found.energy, found.steps), (3.0, 0));
    assert!(found.converged());
}
