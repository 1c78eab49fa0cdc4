//! Factorisations, through nalgebra.

use glam::{DMat2, DMat3, DMat4};
use nalgebra::{Const, DMatrix, DimMin, SMatrix, SVector};

use super::array::{Array, Build};
use super::{Fallible, Fault};

/// A square matrix that can be factorised.
pub trait Square: Array<Item = f64> {
    /// The solution of `self x = b`, by LU with partial pivoting; `None` for a singular matrix.
    fn solution<R: Build<Item = f64>>(&self, b: &impl Array<Item = f64>) -> Option<R>;
    /// The determinant.
    fn determinant(&self) -> f64;
    /// The inverse, if there is one.
    fn inverse<R: Build<Item = f64>>(&self) -> Option<R> {
        let identity: DMatrix<f64> = super::identity(self.rows());
        self.solution(&identity)
    }
}

impl<const N: usize> Square for SMatrix<f64, N, N>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    fn solution<R: Build<Item = f64>>(&self, b: &impl Array<Item = f64>) -> Option<R> {
        let lu = self.lu();
        let mut all = R::zeros(N, b.columns());
        for j in 0..b.columns() {
            let mut column = SVector::<f64, N>::from_fn(|i, _| b.entry(i, j));
            if !lu.solve_mut(&mut column) {
                return None;
            }
            for i in 0..N {
                all.set(i, j, column[i]);
            }
        }
        Some(all)
    }

    fn determinant(&self) -> f64 {
        self.lu().determinant()
    }
}

impl Square for DMatrix<f64> {
    fn solution<R: Build<Item = f64>>(&self, b: &impl Array<Item = f64>) -> Option<R> {
        let mut right = DMatrix::from_fn(b.rows(), b.columns(), |i, j| b.entry(i, j));
        // nalgebra solves no system without equations
        if !self.is_empty() && !self.clone().lu().solve_mut(&mut right) {
            return None;
        }
        Some(R::build(self.nrows(), b.columns(), |i, j| right[(i, j)]))
    }

    fn determinant(&self) -> f64 {
        self.clone().lu().determinant()
    }
}

/// Determinants of sparse matrices are those of dense ones.
impl Square for sprs::CsMat<f64> {
    fn solution<R: Build<Item = f64>>(&self, b: &impl Array<Item = f64>) -> Option<R> {
        super::sparse_lu::solution(self, b)
    }

    fn determinant(&self) -> f64 {
        dynamic(self).determinant()
    }
}

macro_rules! small {
    ($matrix:ty, $n:literal) => {
        impl Square for $matrix {
            fn solution<R: Build<Item = f64>>(&self, b: &impl Array<Item = f64>) -> Option<R> {
                fixed::<$n>(self).solution(b)
            }

            fn determinant(&self) -> f64 {
                <$matrix>::determinant(self)
            }

            #[inline]
            fn inverse<R: Build<Item = f64>>(&self) -> Option<R> {
                if <$matrix>::determinant(self) == 0.0 {
                    return None;
                }
                let inverse = <$matrix>::inverse(self);
                Some(R::build($n, $n, |i, j| inverse.entry(i, j)))
            }
        }
    };
}

small!(DMat2, 2);
small!(DMat3, 3);
small!(DMat4, 4);

#[inline(always)]
fn fixed<const N: usize>(a: &impl Array<Item = f64>) -> SMatrix<f64, N, N> {
    SMatrix::from_fn(|i, j| a.entry(i, j))
}

pub(super) fn dynamic(a: &impl Array<Item = f64>) -> DMatrix<f64> {
    DMatrix::from_fn(a.rows(), a.columns(), |i, j| a.entry(i, j))
}

/// Whether all entries are numbers. What is not has no factorisation: the algorithms of nalgebra need not end on it.
pub(super) fn is_finite(a: &DMatrix<f64>) -> bool {
    a.iter().all(|x| x.is_finite())
}

/// An array of NaN.
pub(super) fn nans<R: Build<Item = f64>>(rows: usize, columns: usize) -> R {
    R::build(rows, columns, |_, _| f64::NAN)
}

/// The solution of `a x = b`; fails for a singular matrix.
pub fn solve<R: Build<Item = f64>>(
    a: &impl Square,
    b: &impl Array<Item = f64>,
    fault: Fault,
) -> Fallible<R> {
    a.solution(b).ok_or(fault)
}

/// The inverse; fails for a singular matrix.
#[inline]
pub fn inverse<R: Build<Item = f64>>(a: &impl Square, fault: Fault) -> Fallible<R> {
    a.inverse().ok_or(fault)
}

/// The determinant.
pub fn determinant(a: &impl Square) -> f64 {
    a.determinant()
}

/// Singular values below this part of the largest count as 0, times the larger size of the matrix.
fn tolerance(values: &nalgebra::DVector<f64>, rows: usize, columns: usize) -> f64 {
    values.max() * f64::EPSILON * rows.max(columns) as f64
}

/// The Moore–Penrose inverse.
pub fn pseudo_inverse<R: Build<Item = f64>>(a: &impl Array<Item = f64>) -> R {
    let (rows, columns) = (a.rows(), a.columns());
    if rows == 0 || columns == 0 {
        return R::zeros(columns, rows);
    }
    let matrix = dynamic(a);
    if !is_finite(&matrix) {
        return nans(columns, rows);
    }
    let svd = matrix.svd(true, true);
    let least = tolerance(&svd.singular_values, rows, columns);
    let (Some(u), Some(vt)) = (&svd.u, &svd.v_t) else {
        return R::zeros(columns, rows);
    };
    R::build(columns, rows, |i, j| {
        let terms = svd
            .singular_values
            .iter()
            .enumerate()
            .filter(|(_, s)| **s > least);
        terms.map(|(k, s)| vt[(k, i)] * u[(j, k)] / s).sum()
    })
}

/// The number of singular values above the tolerance; fails for a matrix with NaN or ∞.
pub fn rank(a: &impl Array<Item = f64>, fault: Fault) -> Fallible<i64> {
    let matrix = dynamic(a);
    if matrix.is_empty() {
        return Ok(0);
    }
    if !is_finite(&matrix) {
        return Err(fault);
    }
    let values = matrix.singular_values();
    let least = tolerance(&values, a.rows(), a.columns());
    Ok(values.iter().filter(|s| **s > least).count() as i64)
}

/// The sum of the singular values.
pub fn norm_nuclear(a: &impl Array<Item = f64>) -> f64 {
    let matrix = dynamic(a);
    match matrix.is_empty() {
        true => 0.0,
        false if !is_finite(&matrix) => f64::NAN,
        false => matrix.singular_values().sum(),
    }
}

/// The full singular value decomposition `a = U diag(σ) Vᵀ`, with σ descending.
pub fn singular_values<U, S, V>(a: &impl Array<Item = f64>) -> (U, S, V)
where
    U: Build<Item = f64>,
    S: Build<Item = f64>,
    V: Build<Item = f64>,
{
    let (rows, columns) = (a.rows(), a.columns());
    // square by zeros, so that both bases are complete
    let n = rows.max(columns);
    let mut square = DMatrix::zeros(n, n);
    for i in 0..rows {
        for j in 0..columns {
            square[(i, j)] = a.entry(i, j);
        }
    }
    if !is_finite(&square) {
        return (
            nans(rows, rows),
            nans(rows.min(columns), 1),
            nans(columns, columns),
        );
    }
    if rows == 0 || columns == 0 {
        return (
            super::identity(rows),
            S::zeros(0, 1),
            super::identity(columns),
        );
    }
    let svd = square.svd(true, true);
    let least = rows.min(columns);
    let (u, vt) = (svd.u.unwrap_or_default(), svd.v_t.unwrap_or_default());
    let left = complete(&u, rows, least);
    let right = complete(&vt.transpose(), columns, least);
    (
        super::reshape(&left),
        S::build(least, 1, |k, _| svd.singular_values[k]),
        super::reshape(&right),
    )
}

/// The first columns of a basis, cut to `n` rows, completed to an orthonormal basis.
fn complete(basis: &DMatrix<f64>, n: usize, keep: usize) -> DMatrix<f64> {
    let mut columns: Vec<nalgebra::DVector<f64>> = Vec::new();
    let given = (0..keep).map(|k| basis.column(k).rows(0, n).into_owned());
    let units =
        (0..n).map(|k| nalgebra::DVector::from_fn(n, |i, _| if i == k { 1.0 } else { 0.0 }));
    for (k, mut candidate) in given.chain(units).enumerate() {
        if columns.len() == n {
            break;
        }
        // twice is enough
        for _ in 0..2 {
            for column in &columns {
                let part = column.dot(&candidate);
                candidate -= column * part;
            }
        }
        let length = candidate.norm();
        if length > if k < keep { 1e-300 } else { 1e-6 } {
            columns.push(candidate / length);
        }
    }
    match columns.is_empty() {
        true => DMatrix::zeros(n, 0),
        false => DMatrix::from_columns(&columns),
    }
}

/// An orthonormal basis of the kernel, in columns; fails for a matrix with NaN or ∞.
pub fn null_space(a: &impl Array<Item = f64>, fault: Fault) -> Fallible<DMatrix<f64>> {
    let columns = a.columns();
    let rank = rank(a, fault)? as usize;
    let (_, _, right): (DMatrix<f64>, nalgebra::DVector<f64>, DMatrix<f64>) = singular_values(a);
    Ok(right.columns(rank, columns - rank).into_owned())
}

/// An orthonormal basis of the column space, in columns; fails for a matrix with NaN or ∞.
pub fn orthogonal_basis(a: &impl Array<Item = f64>, fault: Fault) -> Fallible<DMatrix<f64>> {
    let rank = rank(a, fault)? as usize;
    let (left, _, _): (DMatrix<f64>, nalgebra::DVector<f64>, DMatrix<f64>) = singular_values(a);
    Ok(left.columns(0, rank).into_owned())
}

/// A symmetric matrix with its eigenvalues replaced: each set of rows that hang together by itself.
pub fn with_eigenvalues<R: Build<Item = f64>>(
    a: &impl Array<Item = f64>,
    f: impl Fn(f64) -> f64,
) -> R {
    let matrix = dynamic(a);
    if matrix.is_empty() {
        return super::reshape(&matrix);
    }
    if !is_finite(&matrix) {
        return nans(matrix.nrows(), matrix.ncols());
    }
    let symmetric = (&matrix + matrix.transpose()) * 0.5;
    let n = symmetric.nrows();
    let entries = (0..n).flat_map(|j| (0..j).map(move |i| (i, j)));
    let roots = connected(n, entries.filter(|at| symmetric[*at] != 0.0));
    let mut parts = std::collections::BTreeMap::<usize, Vec<usize>>::new();
    for (k, root) in roots.into_iter().enumerate() {
        parts.entry(root).or_default().push(k);
    }
    let mut all = DMatrix::zeros(n, n);
    for rows in parts.values() {
        if let [k] = rows[..] {
            all[(k, k)] = f(symmetric[(k, k)]);
            continue;
        }
        let part = DMatrix::from_fn(rows.len(), rows.len(), |i, j| symmetric[(rows[i], rows[j])]);
        let eigen = part.symmetric_eigen();
        let values = DMatrix::from_diagonal(&eigen.eigenvalues.map(&f));
        let part = &eigen.eigenvectors * values * eigen.eigenvectors.transpose();
        for (j, column) in rows.iter().enumerate() {
            for (i, row) in rows.iter().enumerate() {
                all[(*row, *column)] = part[(i, j)];
            }
        }
    }
    super::reshape(&all)
}

/// For each row of a square matrix the first one that it hangs together with, by the places of entries.
pub(super) fn connected(n: usize, entries: impl Iterator<Item = (usize, usize)>) -> Vec<usize> {
    fn root(parent: &mut [usize], mut k: usize) -> usize {
        while parent[k] != k {
            parent[k] = parent[parent[k]];
            k = parent[k];
        }
        k
    }
    let mut parent: Vec<usize> = (0..n).collect();
    for (i, j) in entries {
        let (a, b) = (root(&mut parent, i), root(&mut parent, j));
        parent[a.max(b)] = a.min(b);
    }
    (0..n).map(|k| root(&mut parent, k)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A large diagonal matrix with a few blocks.
    #[test]
    fn parts_are_replaced_by_themselves() {
        let n = 486;
        let mut a = DMatrix::from_fn(n, n, |i, j| match i == j {
            true => i as f64 - 200.0,
            false => 0.0,
        });
        // [1 2; 2 1] at rows that are not next to each other: eigenvalues 3 and -1
        for (i, j) in [(3, 400), (40, 7)] {
            (a[(i, i)], a[(j, j)]) = (1.0, 1.0);
            (a[(i, j)], a[(j, i)]) = (2.0, 2.0);
        }
        let found: DMatrix<f64> = with_eigenvalues(&a, |x| x.max(0.0));
        for i in 0..n {
            for j in 0..n {
                let expected = match [3, 400, 40, 7].contains(&i) {
                    true if a[(i, j)] != 0.0 => 1.5,
                    _ => a[(i, j)].max(0.0),
                };
                assert!((found[(i, j)] - expected).abs() < 1e-14, "{i} {j}");
            }
        }
    }
}
