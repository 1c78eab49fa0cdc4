//! Sparse matrices, through sprs.

use sprs::{CsMat, TriMat};

use super::array::{Array, Build};
use super::{Fallible, Fault};
use crate::Set;

/// The sparse matrix with these numbers on its diagonal.
pub fn sparse_diagonal(entries: &[f64]) -> CsMat<f64> {
    let n = entries.len();
    let mut triplets = TriMat::new((n, n));
    for (i, entry) in entries.iter().enumerate() {
        triplets.add_triplet(i, i, *entry);
    }
    triplets.to_csc()
}

/// The matrix without entries.
pub fn sparse_zeros(rows: usize, columns: usize) -> CsMat<f64> {
    TriMat::new((rows, columns)).to_csc()
}

/// A matrix with the entries other than 0 stored.
pub fn sparse(a: &impl Array<Item = f64>) -> CsMat<f64> {
    let mut triplets = TriMat::new((a.rows(), a.columns()));
    put_sparse(&mut triplets, 0, 0, a);
    triplets.to_csc()
}

/// The product of a sparse matrix and a dense one.
pub fn sparse_product<R: Build<Item = f64>>(a: &CsMat<f64>, b: &impl Array<Item = f64>) -> R {
    let mut all = R::zeros(a.rows(), b.columns());
    for (value, (i, k)) in a {
        for j in 0..b.columns() {
            let entry = all.entry(i, j) + value * b.entry(k, j);
            all.set(i, j, entry);
        }
    }
    all
}

/// The transpose in compressed columns.
pub fn sparse_transpose(a: &CsMat<f64>) -> CsMat<f64> {
    a.transpose_view().to_csc()
}

/// A matrix to which blocks are added by [`put_sparse`].
pub fn sparse_blocks(rows: usize, columns: usize) -> TriMat<f64> {
    TriMat::new((rows, columns))
}

/// Adds the entries of a block that are not 0; the matrix is large enough.
pub fn put_sparse(
    matrix: &mut TriMat<f64>,
    row: usize,
    column: usize,
    block: &impl Array<Item = f64>,
) {
    block.each(|i, j, entry| {
        if entry != 0.0 {
            matrix.add_triplet(row + i, column + j, entry);
        }
    });
}

/// Adds a number at a place, by its numbers from 1.
#[inline]
pub fn add_at(
    matrix: &mut TriMat<f64>,
    row: i64,
    column: i64,
    value: f64,
    fault: Fault,
) -> Fallible<()> {
    let row = super::index(row, matrix.rows(), fault)?;
    let column = super::index(column, matrix.cols(), fault)?;
    matrix.add_triplet(row, column, value);
    Ok(())
}

/// The numbers, from 1, of the entries that a row, by its number from 1, of a matrix in compressed rows has, or a column
/// of one in compressed columns.
pub fn stored(matrix: &CsMat<f64>, number: i64, fault: Fault) -> Fallible<Set<i64>> {
    let outer = super::index(number, matrix.outer_dims(), fault)?;
    let entries = matrix.outer_view(outer);
    let numbers = entries.iter().flat_map(|entries| entries.indices());
    Ok(numbers.map(|k| *k as i64 + 1).collect())
}

/// The identity.
pub fn sparse_identity(n: usize) -> CsMat<f64> {
    CsMat::eye_csc(n)
}

/// The product of a dense matrix and a sparse one.
pub fn product_sparse<R: Build<Item = f64>>(a: &impl Array<Item = f64>, b: &CsMat<f64>) -> R {
    let mut all = R::zeros(a.rows(), b.cols());
    for (value, (k, j)) in b {
        for i in 0..a.rows() {
            let entry = all.entry(i, j) + a.entry(i, k) * value;
            all.set(i, j, entry);
        }
    }
    all
}

/// The product of two matrices of one size, entry by entry, at the stored entries of the first.
pub fn sparse_hadamard(a: &CsMat<f64>, b: &impl Array<Item = f64>) -> CsMat<f64> {
    let mut triplets = TriMat::new((a.rows(), a.cols()));
    for (x, (i, j)) in a {
        let product = x * b.entry(i, j);
        if product != 0.0 {
            triplets.add_triplet(i, j, product);
        }
    }
    triplets.to_csc()
}

/// The Kronecker product, where one is sparse at least.
pub fn sparse_kronecker(a: &impl Array<Item = f64>, b: &impl Array<Item = f64>) -> CsMat<f64> {
    let (p, q) = (b.rows(), b.columns());
    let mut triplets = TriMat::new((a.rows() * p, a.columns() * q));
    a.each(|i, j, x| {
        if x != 0.0 {
            b.each(|k, l, y| {
                if y != 0.0 {
                    triplets.add_triplet(i * p + k, j * q + l, x * y);
                }
            });
        }
    });
    triplets.to_csc()
}
