//! Powers of matrices.

use nalgebra::linalg::Schur;
use nalgebra::{Complex, DMatrix};

use super::array::Build;
use super::linear::{Square, dynamic, inverse, is_finite, nans};
use super::{Fallible, Fault};

/// Steps of the QR algorithm after which it is given up.
const STEPS: usize = 10_000;

/// The principal power: by repeated products for an integer, from the eigenvalues of a symmetric matrix, by square roots
/// otherwise (N. Higham, L. Lin, A Schur–Padé algorithm for fractional powers of a matrix, with a series in place of the
/// Padé approximant); fails where it is not real.
pub fn power<R: Build<Item = f64>>(a: &impl Square, p: f64, fault: Fault) -> Fallible<R> {
    let matrix = dynamic(a);
    let whole = p.fract() == 0.0 && p.abs() <= f64::from(u32::MAX);
    if !whole && matrix.is_empty() {
        return Ok(super::reshape(&matrix));
    }
    if !(whole || p.is_finite() && is_finite(&matrix)) {
        return Ok(nans(matrix.nrows(), matrix.ncols()));
    }
    let power = match whole {
        true => whole_power(a, matrix, p, fault)?,
        false if is_symmetric(&matrix) => symmetric_power(matrix, p).ok_or(fault)?,
        false => {
            let part = general_power(&matrix, p - p.floor()).ok_or(fault)?;
            whole_power(a, matrix, p.floor(), fault)? * part
        }
    };
    Ok(super::reshape(&power))
}

fn whole_power(
    a: &impl Square,
    matrix: DMatrix<f64>,
    p: f64,
    fault: Fault,
) -> Fallible<DMatrix<f64>> {
    let n = matrix.nrows();
    let base = match p < 0.0 {
        true => inverse::<DMatrix<f64>>(a, fault)?,
        false => matrix,
    };
    let mut exponent = p.abs() as u32;
    let (mut square, mut result) = (base, DMatrix::identity(n, n));
    while exponent > 0 {
        if exponent & 1 == 1 {
            result = &result * &square;
        }
        exponent >>= 1;
        if exponent > 0 {
            square = &square * &square;
        }
    }
    Ok(result)
}

fn is_symmetric(matrix: &DMatrix<f64>) -> bool {
    let scale = matrix.amax().max(f64::MIN_POSITIVE);
    (matrix - matrix.transpose()).amax() <= 1e-12 * scale
}

fn symmetric_power(matrix: DMatrix<f64>, p: f64) -> Option<DMatrix<f64>> {
    let eigen = matrix.symmetric_eigen();
    if eigen.eigenvalues.iter().any(|value| *value < 0.0) {
        return None;
    }
    let powers = DMatrix::from_diagonal(&eigen.eigenvalues.map(|value| value.powf(p)));
    Some(&eigen.eigenvectors * powers * eigen.eigenvectors.transpose())
}

/// A power between 0 and 1 of a matrix without eigenvalues that are 0 or negative.
fn general_power(matrix: &DMatrix<f64>, p: f64) -> Option<DMatrix<f64>> {
    let n = matrix.nrows();
    let complex = matrix.map(|x| Complex::new(x, 0.0));
    let (basis, mut root) = Schur::try_new(complex, f64::EPSILON, STEPS)?.unpack();
    let least = matrix.amax() * f64::EPSILON * n as f64;
    let on_branch_cut = |value: &Complex<f64>| value.re <= 0.0 && value.im.abs() <= least;
    if root.diagonal().iter().any(on_branch_cut) {
        return None;
    }
    let identity = DMatrix::identity(n, n);
    let mut roots = 0;
    while (&root - &identity).norm() > 0.25 {
        if roots == 100 {
            return None;
        }
        root = triangular_root(&root);
        roots += 1;
    }
    // (I + X)^p = ∑ (p over k) X^k
    let rest = root - &identity;
    let (mut sum, mut term) = (identity.clone(), identity);
    for k in 0..40 {
        let k = f64::from(k);
        term = &term * &rest * Complex::new((p - k) / (k + 1.0), 0.0);
        sum += &term;
    }
    for _ in 0..roots {
        sum = &sum * &sum;
    }
    Some((&basis * sum * basis.adjoint()).map(|x| x.re))
}

/// The principal square root of an upper triangular matrix (Å. Björck, S. Hammarling, A Schur method for the square
/// root of a matrix).
fn triangular_root(matrix: &DMatrix<Complex<f64>>) -> DMatrix<Complex<f64>> {
    let n = matrix.nrows();
    let mut root = DMatrix::zeros(n, n);
    for j in 0..n {
        root[(j, j)] = matrix[(j, j)].sqrt();
        for i in (0..j).rev() {
            let inner: Complex<f64> = (i + 1..j).map(|k| root[(i, k)] * root[(k, j)]).sum();
            root[(i, j)] = (matrix[(i, j)] - inner) / (root[(i, i)] + root[(j, j)]);
        }
    }
    root
}
