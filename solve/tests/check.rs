//! Derivatives that are right and derivatives that are not.

use iheartmesh_runtime::sprs::{CsMat, TriMat};
use iheartmesh_solve::{
    DerivativeCheck, Failure, Functions, Objective, TwiceDifferentiable, check_derivatives,
    check_gradient,
};
use nalgebra::{DVector, dvector};

/// The sum of sin(x_k) x_(k+1), with an error of some size in one entry of a derivative.
struct Chain {
    x: Vec<f64>,
    in_gradient: (usize, f64),
    in_hessian: (usize, usize, f64),
}

impl Chain {
    fn new() -> Chain {
        Chain {
            x: Vec::new(),
            in_gradient: (0, 0.0),
            in_hessian: (0, 0, 0.0),
        }
    }
}

impl Objective for Chain {
    fn set(&mut self, x: &[f64]) -> Result<(), Failure> {
        self.x = x.to_vec();
        Ok(())
    }

    fn energy(&mut self) -> Result<f64, Failure> {
        Ok(self.x.windows(2).map(|x| x[0].sin() * x[1]).sum())
    }

    fn gradient(&mut self, gradient: &mut DVector<f64>) -> Result<(), Failure> {
        let x = &self.x;
        *gradient = DVector::zeros(x.len());
        for k in 1..x.len() {
            gradient[k - 1] += x[k - 1].cos() * x[k];
            gradient[k] += x[k - 1].sin();
        }
        gradient[self.in_gradient.0] += self.in_gradient.1;
        Ok(())
    }
}

impl TwiceDifferentiable for Chain {
    fn hessian(&mut self, hessian: &mut CsMat<f64>) -> Result<(), Failure> {
        let x = &self.x;
        let mut entries = TriMat::new((x.len(), x.len()));
        for k in 1..x.len() {
            entries.add_triplet(k - 1, k - 1, -x[k - 1].sin() * x[k]);
            entries.add_triplet(k - 1, k, x[k - 1].cos());
            entries.add_triplet(k, k - 1, x[k - 1].cos());
        }
        let (row, column, error) = self.in_hessian;
        entries.add_triplet(row, column, error);
        *hessian = entries.to_csc();
        Ok(())
    }
}

fn place() -> Vec<f64> {
    (0..50).map(|k| 1.0 + (0.7 * f64::from(k)).sin()).collect()
}

#[test]
fn right_derivatives() {
    let mut chain = Chain::new();
    let report = check_derivatives(&mut chain, &place()).unwrap();
    assert_eq!((report.variables, report.checked), (50, 50));
    assert_eq!(report.gradient.entries, 50);
    assert_eq!(report.hessian.as_ref().unwrap().entries, 2500);
    assert!(report.is_within(1e-9), "{report}");
    // it is back where it was
    assert_eq!(chain.x, place());
}

#[test]
fn a_wrong_entry_is_found() {
    let mut chain = Chain::new();
    chain.in_gradient = (17, 1e-4);
    let report = check_gradient(&mut chain, &place()).unwrap();
    assert_eq!(report.gradient.place, Some((17, 0)));
    assert!((report.gradient.error - 1e-4).abs() < 1e-8);
    assert!(!report.is_within(1e-6) && report.hessian.is_none());
    let text = report.to_string();
    assert!(
        text.contains("50 of 50 variables") && text.contains("at entry 17: "),
        "{text}"
    );

    let mut chain = Chain::new();
    chain.in_hessian = (30, 11, 1e-3);
    let report = check_derivatives(&mut chain, &place()).unwrap();
    let hessian = report.hessian.as_ref().unwrap();
    assert_eq!(hessian.place, Some((30, 11)));
    assert!((hessian.error - 1e-3).abs() < 1e-8 && hessian.expected.abs() < 1e-9);
    assert!(report.gradient.relative_error() < 1e-9);
    let text = report.to_string();
    assert!(text.contains("at row 30, column 11: "), "{text}");
}

#[test]
fn a_selection_of_variables() {
    let check = DerivativeCheck {
        most_variables: 7,
        ..DerivativeCheck::default()
    };
    let report = check.derivatives(&mut Chain::new(), &place()).unwrap();
    assert_eq!((report.checked, report.gradient.entries), (7, 7));
    assert!(report.is_within(1e-9), "{report}");
    // 21 is the fourth of them, 20 is none
    for (entry, is_seen) in [(21, true), (20, false)] {
        let mut chain = Chain::new();
        chain.in_gradient = (entry, 1.0);
        let report = check.gradient(&mut chain, &place()).unwrap();
        assert_eq!(report.is_within(1e-6), !is_seen);
    }
}

#[test]
fn near_the_end_of_the_domain() {
    // ln(x), which is not finite a little to the left
    let mut logarithm = Functions {
        state: 0.0,
        set: |at: &mut f64, x: &[f64]| {
            *at = x[0];
            Ok(())
        },
        energy: |x: &mut f64| Ok(x.ln()),
        gradient: |x: &mut f64| Ok(dvector![1.0 / *x]),
        hessian: |x: &mut f64| {
            let mut entries = TriMat::new((1, 1));
            entries.add_triplet(0, 0, -1.0 / (*x * *x));
            Ok(entries.to_csc())
        },
    };
    let check = DerivativeCheck {
        step: 0.1,
        ..DerivativeCheck::default()
    };
    let report = check.derivatives(&mut logarithm, &[0.15]).unwrap();
    assert!(report.is_within(1e-8), "{report}");
    let error = check.gradient(&mut logarithm, &[-1.0]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the energy is not finite when variable 0 changes a little"
    );
}

#[test]
fn wrong_sizes_and_failures() {
    let mut bad = Functions {
        state: (),
        set: |_: &mut (), _: &[f64]| Ok(()),
        energy: |_: &mut ()| Ok(0.0),
        gradient: |_: &mut ()| Ok(dvector![0.0, 0.0]),
        hessian: |_: &mut ()| Ok(CsMat::zero((3, 2))),
    };
    let error = check_gradient(&mut bad, &[1.0]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the length of the gradient is 2, but there are 1 variables"
    );
    let error = check_derivatives(&mut bad, &[1.0, 1.0]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the number of rows of the hessian is 3, but there are 2 variables"
    );
    let mut failing = Functions {
        state: (),
        set: |_: &mut (), _: &[f64]| Err("no such place".into()),
        energy: |_: &mut ()| Ok(0.0),
        gradient: |_: &mut ()| Ok(dvector![0.0]),
        hessian: (),
    };
    let error = check_gradient(&mut failing, &[1.0]).unwrap_err();
    assert_eq!(error.to_string(), "there is no position: no such place");
}
