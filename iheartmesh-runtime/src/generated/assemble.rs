//! Adds blocks to vectors and matrices.

use nalgebra::DMatrix;
use sprs::CsMat;

use super::array::{Array, Build};
use super::{Fallible, Fault};

/// What numbers can be added to.
pub trait Accumulate {
    /// Rows and columns.
    fn sizes(&self) -> (usize, usize);
    /// Adds to an entry; it must be in range.
    fn add(&mut self, row: usize, column: usize, value: f64);
}

impl<B: Build<Item = f64>> Accumulate for B {
    #[inline(always)]
    fn sizes(&self) -> (usize, usize) {
        (self.rows(), self.columns())
    }
    #[inline(always)]
    fn add(&mut self, row: usize, column: usize, value: f64) {
        let sum = self.entry(row, column) + value;
        self.set(row, column, sum);
    }
}

/// A sparse matrix while its entries are collected, in any order and several at a place.
#[derive(Clone, Debug)]
pub struct Triplets {
    rows: usize,
    columns: usize,
    entries: Vec<(u32, u32, f64)>,
}

impl Triplets {
    /// Without entries.
    pub fn new(rows: usize, columns: usize) -> Self {
        Self {
            rows,
            columns,
            entries: Vec::new(),
        }
    }

    /// The matrix in compressed columns, rows ascending. Each place to which something was added has an entry, though
    /// it may be 0: the pattern depends on the places alone.
    pub fn into_matrix(self) -> CsMat<f64> {
        // by column, then each column by row: a sort by counting
        let mut starts = vec![0usize; self.columns + 1];
        for (_, column, _) in &self.entries {
            starts[*column as usize + 1] += 1;
        }
        for k in 0..self.columns {
            starts[k + 1] += starts[k];
        }
        let mut next = starts.clone();
        let mut sorted = vec![(0u32, 0.0f64); self.entries.len()];
        for (row, column, value) in &self.entries {
            let place = &mut next[*column as usize];
            sorted[*place] = (*row, *value);
            *place += 1;
        }
        let mut pointers = Vec::with_capacity(self.columns + 1);
        let mut indices = Vec::new();
        let mut data: Vec<f64> = Vec::new();
        pointers.push(0);
        for k in 0..self.columns {
            let column = &mut sorted[starts[k]..starts[k + 1]];
            // stable, so that sums are formed in the order of the additions
            column.sort_by_key(|(row, _)| *row);
            let first = indices.len();
            for (row, value) in column {
                let row = *row as usize;
                match indices[first..].last() {
                    Some(last) if *last == row => {
                        if let Some(sum) = data.last_mut() {
                            *sum += *value;
                        }
                    }
                    _ => {
                        indices.push(row);
                        data.push(*value);
                    }
                }
            }
            pointers.push(indices.len());
        }
        CsMat::new_csc((self.rows, self.columns), pointers, indices, data)
    }

    /// The rows and columns in which something stands, and the matrix of these.
    fn into_dense(self) -> (Vec<u32>, DMatrix<f64>) {
        let mut places: Vec<u32> = Vec::with_capacity(2 * self.entries.len());
        places.extend(self.entries.iter().flat_map(|(i, j, _)| [*i, *j]));
        places.sort_unstable();
        places.dedup();
        let place = |k: u32| places.binary_search(&k).unwrap_or(0);
        let mut dense = DMatrix::zeros(places.len(), places.len());
        for (i, j, value) in &self.entries {
            dense[(place(*i), place(*j))] += *value;
        }
        (places, dense)
    }
}

impl Accumulate for Triplets {
    #[inline(always)]
    fn sizes(&self) -> (usize, usize) {
        (self.rows, self.columns)
    }
    #[inline(always)]
    fn add(&mut self, row: usize, column: usize, value: f64) {
        self.entries.push((row as u32, column as u32, value));
    }
}

/// Adds a whole array; both of one size.
pub fn add_all(all: &mut impl Accumulate, value: &impl Array<Item = f64>) {
    value.each(|i, j, entry| all.add(i, j, entry));
}

/// Adds `k` times a block.
pub fn add_scaled(all: &mut impl Accumulate, k: f64, block: Triplets) {
    for (row, column, value) in block.entries {
        all.add(row as usize, column as usize, k * value);
    }
}

/// Adds a symmetric block with each of its eigenvalues replaced.
pub fn add_with_eigenvalues(
    all: &mut impl Accumulate,
    block: Triplets,
    replace: impl Fn(f64) -> f64,
) {
    let (places, dense) = block.into_dense();
    let dense = with_eigenvalues_replaced(dense, replace);
    for (j, column) in places.iter().enumerate() {
        for (i, row) in places.iter().enumerate() {
            all.add(*row as usize, *column as usize, dense[(i, j)]);
        }
    }
}

/// Adds the product of a symmetric block, with each of its eigenvalues replaced, and a vector or matrix of as many rows.
pub fn add_product_with_eigenvalues(
    all: &mut impl Accumulate,
    block: Triplets,
    replace: impl Fn(f64) -> f64,
    factor: &impl Array<Item = f64>,
) {
    let (places, dense) = block.into_dense();
    let dense = with_eigenvalues_replaced(dense, replace);
    for j in 0..factor.columns() {
        for (k, column) in places.iter().enumerate() {
            let x = factor.entry(*column as usize, j);
            for (i, row) in places.iter().enumerate() {
                all.add(*row as usize, j, dense[(i, k)] * x);
            }
        }
    }
}

/// A symmetric matrix with its eigenvalues replaced; one that is positive definite stays as it is, since what replaces
/// positive eigenvalues are they themselves.
fn with_eigenvalues_replaced(matrix: DMatrix<f64>, replace: impl Fn(f64) -> f64) -> DMatrix<f64> {
    let symmetric = (&matrix + matrix.transpose()) * 0.5;
    if nalgebra::Cholesky::new(symmetric.clone()).is_some() {
        return symmetric;
    }
    super::with_eigenvalues::<DMatrix<f64>>(&symmetric, replace)
}

/// A symmetric sparse matrix with its eigenvalues replaced: each set of rows that hang together by itself.
pub fn sparse_with_eigenvalues(matrix: &CsMat<f64>, replace: impl Fn(f64) -> f64) -> CsMat<f64> {
    let n = matrix.rows();
    let roots = super::linear::connected(n, matrix.iter().map(|(_, at)| at));
    let mut parts: std::collections::BTreeMap<usize, Triplets> = std::collections::BTreeMap::new();
    for (value, (i, j)) in matrix {
        let part = parts.entry(roots[i]);
        let part = part.or_insert_with(|| Triplets::new(n, n));
        part.add(i, j, *value);
    }
    let mut all = Triplets::new(n, n);
    for part in parts.into_values() {
        add_with_eigenvalues(&mut all, part, &replace);
    }
    all.into_matrix()
}

/// Adds the entries of a value, column by column, in equal parts: part `k` starts where `places[k]` such parts end.
#[inline(always)]
pub fn add_entries<const N: usize>(
    all: &mut impl Accumulate,
    places: [usize; N],
    value: &impl Array<Item = f64>,
    fault: Fault,
) -> Fallible<()> {
    let (rows, columns) = (value.rows(), value.columns());
    let height = rows * columns / N.max(1);
    let starts = starts(places, height, all.sizes().0, fault)?;
    for (part, start) in starts.into_iter().enumerate() {
        for k in 0..height {
            let entry = part * height + k;
            all.add(start + k, 0, value.entry(entry % rows, entry / rows));
        }
    }
    Ok(())
}

/// Adds a block: its rows in equal parts to these places, its columns likewise.
#[inline(always)]
pub fn add_block<const N: usize, const M: usize>(
    all: &mut impl Accumulate,
    rows: [usize; N],
    columns: [usize; M],
    value: &impl Array<Item = f64>,
    fault: Fault,
) -> Fallible<()> {
    let (height, width) = (value.rows() / N.max(1), value.columns() / M.max(1));
    let (most_rows, most_columns) = all.sizes();
    let rows = starts(rows, height, most_rows, fault)?;
    let columns = starts(columns, width, most_columns, fault)?;
    for (c, column) in columns.into_iter().enumerate() {
        for j in 0..width {
            for (r, row) in rows.into_iter().enumerate() {
                for i in 0..height {
                    let entry = value.entry(r * height + i, c * width + j);
                    all.add(row + i, column + j, entry);
                }
            }
        }
    }
    Ok(())
}

/// Where parts of a height start, if all of them are within a size.
#[inline(always)]
fn starts<const N: usize>(
    places: [usize; N],
    height: usize,
    size: usize,
    fault: Fault,
) -> Fallible<[usize; N]> {
    let mut starts = places;
    for start in &mut starts {
        *start = start.checked_mul(height).ok_or(fault)?;
        if start.checked_add(height).is_none_or(|end| end > size) {
            return Err(fault);
        }
    }
    Ok(starts)
}
