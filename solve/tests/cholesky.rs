//! Factorisations against systems with known solutions, and everything that has none.

use iheartmesh_runtime::sprs::{CsMat, TriMat};
use iheartmesh_solve::solve::{Cholesky, CholeskyError, Factorisation};

use Factorisation::{Indefinite, PositiveDefinite};

fn matrix(n: usize, rows: &[f64]) -> CsMat<f64> {
    let mut entries = TriMat::new((n, n));
    for (k, entry) in rows.iter().enumerate() {
        if *entry != 0.0 {
            entries.add_triplet(k / n, k % n, *entry);
        }
    }
    entries.to_csc()
}

/// The Laplacian of a grid of `size` points to the power of `dimensions`, plus a multiple of the identity.
fn laplacian(size: usize, dimensions: u32, shift: f64) -> CsMat<f64> {
    let n = size.pow(dimensions);
    let mut entries = TriMat::new((n, n));
    for here in 0..n {
        entries.add_triplet(here, here, shift);
        for axis in 0..dimensions {
            let stride = size.pow(axis);
            if here / stride % size + 1 < size {
                let there = here + stride;
                for (i, j, entry) in [
                    (here, here, 1.0),
                    (there, there, 1.0),
                    (here, there, -1.0),
                    (there, here, -1.0),
                ] {
                    entries.add_triplet(i, j, entry);
                }
            }
        }
    }
    entries.to_csc()
}

fn product(a: &CsMat<f64>, x: &[f64]) -> Vec<f64> {
    let mut y = vec![0.0; x.len()];
    for (entry, (i, j)) in a {
        y[i] += entry * x[j];
    }
    y
}

fn some_vector(n: usize) -> Vec<f64> {
    (0..n).map(|k| (1.3 * k as f64).sin() + 0.1).collect()
}

#[track_caller]
fn check_solution(factors: &mut Cholesky, a: &CsMat<f64>, tolerance: f64) {
    let x = some_vector(a.rows());
    let b = product(a, &x);
    let mut found = vec![f64::NAN; x.len()];
    factors.solve_into(&b, &mut found).unwrap();
    for (a, b) in found.iter().zip(&x) {
        assert!((a - b).abs() < tolerance, "{a} is not {b}");
    }
}

#[test]
fn grids_of_all_sizes() {
    // small ones are factorised entry by entry, large ones by blocks of columns
    for (size, dimensions) in [(1, 1), (2, 2), (30, 2), (120, 2), (5, 3), (12, 3)] {
        let a = laplacian(size, dimensions, 0.01);
        for factorisation in [PositiveDefinite, Indefinite] {
            let mut factors = Cholesky::new(&a, factorisation).unwrap();
            check_solution(&mut factors, &a, 1e-9);
        }
    }
}

#[test]
fn other_values_and_other_patterns() {
    for factorisation in [PositiveDefinite, Indefinite] {
        let a = laplacian(20, 2, 0.5);
        let mut factors = Cholesky::new(&a, factorisation).unwrap();
        for scale in [2.0, 1e-200, 1e200] {
            let b = a.map(|entry| scale * entry);
            factors.factorise(&b).unwrap();
            check_solution(&mut factors, &b, 1e-10);
        }
        let c = laplacian(12, 3, 0.5);
        factors.factorise(&c).unwrap();
        assert_eq!(factors.n(), 12 * 12 * 12);
        check_solution(&mut factors, &c, 1e-10);
        // by rows
        factors.factorise(&c.to_csr()).unwrap();
        check_solution(&mut factors, &c, 1e-10);
    }
}

#[test]
fn quasi_definite_systems() {
    // [A Bᵀ; B -C] with positive definite A and C
    let a = matrix(
        4,
        &[
            2.0, 0.5, 1.0, 0.0, 0.5, 3.0, 0.0, -1.0, 1.0, 0.0, -1.0, 0.2, 0.0, -1.0, 0.2, -4.0,
        ],
    );
    check_solution(&mut Cholesky::new(&a, Indefinite).unwrap(), &a, 1e-12);
    let error = Cholesky::new(&a, PositiveDefinite).unwrap_err();
    assert!(
        matches!(
            error,
            CholeskyError::NotPositiveDefinite { variable: 2 | 3 }
        ),
        "{error}"
    );
    // large and with blocks
    let b = laplacian(10, 3, 0.1);
    let n = b.rows();
    let mut entries = TriMat::new((2 * n, 2 * n));
    for (entry, (i, j)) in &b {
        entries.add_triplet(i, j, *entry);
        entries.add_triplet(n + i, n + j, -*entry);
    }
    for i in 0..n {
        entries.add_triplet(i, n + i, 1.0);
        entries.add_triplet(n + i, i, 1.0);
    }
    let c: CsMat<f64> = entries.to_csc();
    check_solution(&mut Cholesky::new(&c, Indefinite).unwrap(), &c, 1e-9);
    assert!(matches!(
        Cholesky::new(&c, PositiveDefinite),
        Err(CholeskyError::NotPositiveDefinite { variable }) if variable >= n
    ));
}

#[test]
fn singular_matrices() {
    let singular = [
        matrix(2, &[1.0, 2.0, 2.0, 4.0]),
        matrix(2, &[0.1, 0.3, 0.3, 0.9]),
        matrix(2, &[1.0, 0.0, 0.0, 0.0]),
        matrix(3, &[0.0; 9]),
        laplacian(2, 1, 0.0),
        laplacian(70, 2, 0.0),
        laplacian(12, 3, 0.0),
        // what is small in all is not singular, what is small beside the rest is
        laplacian(30, 2, 0.0).map(|entry| 1e-150 * entry),
    ];
    for a in singular {
        for factorisation in [PositiveDefinite, Indefinite] {
            let error = Cholesky::new(&a, factorisation).unwrap_err();
            assert!(
                matches!(error, CholeskyError::Singular { variable } if variable < a.rows()),
                "{factorisation:?} {error}"
            );
        }
    }
    // regular, but not without pivoting
    let swap = matrix(2, &[0.0, 1.0, 1.0, 0.0]);
    assert!(matches!(
        Cholesky::new(&swap, Indefinite),
        Err(CholeskyError::Singular { .. })
    ));
    // units do not make a matrix singular
    let units = matrix(3, &[1e-300, 0.0, 0.0, 0.0, 1e300, 0.0, 0.0, 0.0, 1e-30]);
    let mut x = [1e-300, 2e300, 3e-30];
    let mut factors = Cholesky::new(&units, PositiveDefinite).unwrap();
    factors.solve_in_place(&mut x).unwrap();
    for (found, expected) in x.iter().zip([1.0, 2.0, 3.0]) {
        assert!((found - expected).abs() < 1e-12);
    }
}

#[test]
fn indefinite_matrices() {
    for a in [
        matrix(1, &[-1.0]),
        matrix(2, &[1.0, 2.0, 2.0, 1.0]),
        laplacian(40, 2, -0.1),
        laplacian(12, 3, -0.1),
    ] {
        let error = Cholesky::new(&a, PositiveDefinite).unwrap_err();
        assert!(
            matches!(error, CholeskyError::NotPositiveDefinite { .. }),
            "{error}"
        );
    }
}

#[test]
fn after_a_failure() {
    let a = laplacian(5, 2, 1.0);
    let mut factors = Cholesky::new(&a, PositiveDefinite).unwrap();
    let b = laplacian(5, 2, -1.0);
    assert!(factors.factorise(&b).is_err());
    let mut x = some_vector(25);
    assert_eq!(
        factors.solve_in_place(&mut x),
        Err(CholeskyError::NoFactors)
    );
    factors.factorise(&a).unwrap();
    check_solution(&mut factors, &a, 1e-12);
}

#[test]
fn what_is_no_symmetric_matrix() {
    let refused = |a: &CsMat<f64>| Cholesky::new(a, PositiveDefinite).unwrap_err();
    assert_eq!(
        refused(&CsMat::zero((2, 3))),
        CholeskyError::NotSquare {
            rows: 2,
            columns: 3
        }
    );
    let upper = matrix(2, &[1.0, 0.5, 0.0, 1.0]);
    assert_eq!(
        refused(&upper),
        CholeskyError::NotSymmetric {
            row: 0,
            column: 1,
            entry: 0.5,
            mirrored: 0.0
        }
    );
    assert_eq!(
        refused(&matrix(3, &[2.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.5, 0.0, 2.0])),
        CholeskyError::NotSymmetric {
            row: 2,
            column: 0,
            entry: 0.5,
            mirrored: 0.0
        }
    );
    assert_eq!(
        refused(&matrix(2, &[1.0, 0.5, 0.4, 1.0])).to_string(),
        "the matrix is not symmetric: in row 1, column 0 it has 0.4, in row 0, column 1 0.5"
    );
    // rounding is allowed
    let mut factors = Cholesky::new(&matrix(2, &[1.0, 0.5, 0.5 + 1e-12, 1.0]), Indefinite).unwrap();
    assert_eq!(
        factors.factorise(&matrix(2, &[1.0, 0.5, 0.25, 1.0])),
        Err(CholeskyError::NotSymmetric {
            row: 1,
            column: 0,
            entry: 0.25,
            mirrored: 0.5
        })
    );
    let error = refused(&matrix(2, &[1.0, f64::NAN, f64::NAN, 1.0]));
    assert!(matches!(error, CholeskyError::NotFinite { .. }), "{error}");
}

#[test]
fn wrong_lengths_and_no_rows() {
    let mut factors = Cholesky::new(&laplacian(3, 1, 1.0), PositiveDefinite).unwrap();
    let expected = CholeskyError::Length {
        found: 2,
        expected: 3,
    };
    assert_eq!(factors.solve_in_place(&mut [0.0; 2]), Err(expected.clone()));
    assert_eq!(
        factors.solve_into(&[0.0; 2], &mut [0.0; 3]),
        Err(expected.clone())
    );
    assert_eq!(factors.solve_into(&[0.0; 3], &mut [0.0; 2]), Err(expected));
    let mut nothing = Cholesky::new(&CsMat::zero((0, 0)), PositiveDefinite).unwrap();
    assert_eq!(nothing.solve_in_place(&mut []), Ok(()));
}
