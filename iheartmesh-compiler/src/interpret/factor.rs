//! Factorisations: what each is by definition, through nalgebra.

use nalgebra::DMatrix;

/// The solution of `a x = b`; `None` for a singular matrix.
pub(super) fn solve(a: DMatrix<f64>, b: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    match a.is_empty() {
        true => Some(b.clone()),
        false => a.lu().solve(b),
    }
}

/// The inverse; `None` for a singular matrix.
pub(super) fn inverse(a: DMatrix<f64>) -> Option<DMatrix<f64>> {
    let identity = DMatrix::identity(a.nrows(), a.nrows());
    solve(a, &identity)
}

/// The singular values, descending; there are as many as the lesser size of the matrix.
pub(super) fn singular_values(a: &DMatrix<f64>) -> Vec<f64> {
    match a.is_empty() {
        true => Vec::new(),
        false => a.singular_values().iter().copied().collect(),
    }
}

/// Singular values up to this are 0.
fn tolerance(a: &DMatrix<f64>) -> f64 {
    let greatest = singular_values(a).into_iter().fold(0.0, f64::max);
    greatest * f64::EPSILON * a.nrows().max(a.ncols()) as f64
}

/// The number of singular values other than 0.
pub(super) fn rank(a: &DMatrix<f64>) -> usize {
    let least = tolerance(a);
    singular_values(a)
        .into_iter()
        .filter(|s| *s > least)
        .count()
}

/// The Moore–Penrose inverse: `∑ vₖ uₖᵀ / σₖ` over the singular values other than 0.
pub(super) fn pseudo_inverse(a: &DMatrix<f64>) -> DMatrix<f64> {
    let mut sum = DMatrix::zeros(a.ncols(), a.nrows());
    if a.is_empty() {
        return sum;
    }
    let least = tolerance(a);
    let svd = a.clone().svd(true, true);
    if let (Some(u), Some(vt)) = (svd.u, svd.v_t) {
        for (k, s) in svd.singular_values.iter().enumerate() {
            if *s > least {
                sum += vt.row(k).transpose() * u.column(k).transpose() / *s;
            }
        }
    }
    sum
}

/// `U`, the singular values, and `V` of `A = U diag(σ) Vᵀ`, of the square matrix that zeros make of `A`, without what
/// belongs to these.
pub(super) fn decomposition(a: &DMatrix<f64>) -> (DMatrix<f64>, Vec<f64>, DMatrix<f64>) {
    let (rows, columns) = a.shape();
    let n = rows.max(columns);
    let square = a.clone().resize(n, n, 0.0);
    if n == 0 {
        return (square.clone(), Vec::new(), square);
    }
    let svd = square.svd(true, true);
    let (u, vt) = (svd.u.unwrap_or_default(), svd.v_t.unwrap_or_default());
    let values = svd.singular_values.iter().take(rows.min(columns)).copied();
    (
        u.resize(rows, rows, 0.0),
        values.collect(),
        vt.transpose().resize(columns, columns, 0.0),
    )
}

/// Eigenvectors of a symmetric matrix in columns, by descending eigenvalue.
fn eigenvectors(a: DMatrix<f64>) -> DMatrix<f64> {
    let n = a.nrows();
    if n == 0 {
        return a;
    }
    let eigen = a.symmetric_eigen();
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|i, j| eigen.eigenvalues[*j].total_cmp(&eigen.eigenvalues[*i]));
    DMatrix::from_fn(n, n, |i, j| eigen.eigenvectors[(i, order[j])])
}

/// An orthonormal basis of the kernel, in columns: the eigenvectors of `AᵀA` for 0.
pub(super) fn null_space(a: &DMatrix<f64>) -> DMatrix<f64> {
    let (rank, n) = (rank(a), a.ncols());
    let vectors = eigenvectors(a.transpose() * a);
    vectors.columns(rank, n - rank).into_owned()
}

/// An orthonormal basis of the column space, in columns: the eigenvectors of `AAᵀ` for other values than 0.
pub(super) fn orthogonal_basis(a: &DMatrix<f64>) -> DMatrix<f64> {
    let rank = rank(a);
    let vectors = eigenvectors(a * a.transpose());
    vectors.columns(0, rank).into_owned()
}

/// The symmetric part of a matrix with its eigenvalues replaced.
pub(super) fn with_eigenvalues(a: &DMatrix<f64>, f: impl Fn(f64) -> f64) -> DMatrix<f64> {
    if a.is_empty() {
        return a.clone();
    }
    let eigen = ((a + a.transpose()) * 0.5).symmetric_eigen();
    let values = DMatrix::from_diagonal(&eigen.eigenvalues.map(f));
    &eigen.eigenvectors * values * eigen.eigenvectors.transpose()
}

/// A power: a product for an integer, by eigenvalues of a symmetric matrix without negative ones otherwise.
pub(super) fn power(a: &DMatrix<f64>, p: f64) -> Option<DMatrix<f64>> {
    if p.fract() == 0.0 && p.abs() <= f64::from(u32::MAX) {
        let base = match p < 0.0 {
            true => inverse(a.clone())?,
            false => a.clone(),
        };
        return Some(base.pow(p.abs() as u32));
    }
    if a.iter().any(|x| !x.is_finite()) {
        return Some(DMatrix::from_element(a.nrows(), a.ncols(), f64::NAN));
    }
    if (a - a.transpose()).amax() > 1e-12 * a.amax().max(f64::MIN_POSITIVE) {
        return Some((logarithm(a)? * p).exp());
    }
    let eigen = a.clone().symmetric_eigen();
    let negative = eigen.eigenvalues.iter().any(|value| *value < 0.0);
    (!negative).then(|| with_eigenvalues(a, |value| value.powf(p)))
}

/// The principal logarithm: `log A = 2 log √A`, by a series near the identity.
fn logarithm(a: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let n = a.nrows();
    let is_cut = |value: &nalgebra::Complex<f64>| value.re <= 0.0 && value.im.abs() < 1e-9;
    if a.complex_eigenvalues().iter().any(is_cut) {
        return None;
    }
    let identity = DMatrix::identity(n, n);
    let (mut root, mut scale) = (a.clone(), 1.0);
    while (&root - &identity).norm() > 0.25 {
        // the iteration of Denman and Beavers for the square root
        let (mut y, mut z) = (root, identity.clone());
        for _ in 0..50 {
            let (u, v) = (inverse(z.clone())?, inverse(y.clone())?);
            (y, z) = ((&y + u) * 0.5, (&z + v) * 0.5);
        }
        root = y;
        scale *= 2.0;
    }
    let rest = root - &identity;
    let (mut sum, mut power) = (DMatrix::zeros(n, n), identity);
    for k in 1..60 {
        power = -power * &rest;
        sum -= &power / f64::from(k);
    }
    Some(sum * scale)
}
