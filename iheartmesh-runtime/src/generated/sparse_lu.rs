//! Sparse systems of equations, through the sparse LU of faer: fill-reducing order of the columns, partial pivoting.

use faer::linalg::solvers::Solve;
use faer::prelude::ReborrowMut;
use faer::sparse::linalg::solvers::{Lu, SymbolicLu};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Mat, MatMut};
use sprs::CsMat;

use super::array::{Array, Build};

/// A matrix whose condition number is estimated to be greater than this has no inverse in `f64`: less than two digits
/// of a solution would be right. Rounding leaves a pivot of this part of the entries where an exact one would be 0.
const GREATEST_CONDITION: f64 = 1.0 / (64.0 * f64::EPSILON);

/// The solution of `a x = b`; `None` for a matrix that is singular, exactly or in `f64`.
pub(super) fn solution<R: Build<Item = f64>>(
    a: &CsMat<f64>,
    b: &impl Array<Item = f64>,
) -> Option<R> {
    let n = a.rows();
    if n == 0 {
        return Some(R::zeros(0, b.columns()));
    }
    let factors = Factors::new(a)?;
    let mut right = Mat::from_fn(n, b.columns(), |i, j| b.entry(i, j));
    factors.solve(right.as_mut());
    Some(R::build(n, b.columns(), |i, j| right[(i, j)]))
}

/// The factors of `diag(rows) a diag(columns)`, whose rows and columns have greatest entries near 1, so that units of
/// measurement do not matter for pivots or for what counts as singular.
struct Factors {
    rows: Vec<f64>,
    columns: Vec<f64>,
    lu: Lu<usize, f64>,
}

impl Factors {
    fn new(a: &CsMat<f64>) -> Option<Self> {
        let mut a = a.to_csc();
        let n = a.rows();
        if a.data().iter().any(|entry| !entry.is_finite()) {
            return None;
        }
        let mut rows = vec![0.0f64; n];
        for (entry, (i, _)) in &a {
            rows[i] = rows[i].max(entry.abs());
        }
        let rows: Vec<f64> = rows.into_iter().map(scale).collect::<Option<_>>()?;
        let mut columns = Vec::with_capacity(n);
        for mut column in a.outer_iterator_mut() {
            let mut greatest = 0.0f64;
            for (i, entry) in column.iter_mut() {
                *entry *= rows[i];
                greatest = greatest.max(entry.abs());
            }
            let scale = scale(greatest)?;
            column.iter_mut().for_each(|(_, entry)| *entry *= scale);
            columns.push(scale);
        }
        let starts = a.proper_indptr();
        let pattern = SymbolicSparseColMatRef::new_checked(n, n, &starts, None, a.indices());
        let symbolic = SymbolicLu::try_new(pattern).ok()?;
        let matrix = SparseColMatRef::new(pattern, a.data());
        let lu = Lu::try_new_with_symbolic(symbolic, matrix).ok()?;
        let factors = Self { rows, columns, lu };
        (factors.condition(&a) <= GREATEST_CONDITION).then_some(factors)
    }

    /// An estimate from below of the condition number of the scaled matrix: how much longer a solution can be than its
    /// right side, tried with a right side that favours no direction. Not a number where a pivot is 0.
    fn condition(&self, scaled: &CsMat<f64>) -> f64 {
        let n = self.rows.len();
        let mut state = 0x9E37_79B9_7F4A_7C15u64;
        let mut right = Mat::from_fn(n, 1, |_, _| {
            // xorshift: always the same numbers, all different
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            1.0 + (state >> 12) as f64 / (1u64 << 52) as f64
        });
        let mut sign = 1.0;
        for i in 0..n {
            sign = if right[(i, 0)] > 1.5 { -sign } else { sign };
            right[(i, 0)] *= sign;
        }
        self.lu.solve_in_place(right.as_mut());
        let mut sums = vec![0.0; n];
        for (entry, (i, _)) in scaled {
            sums[i] += f64::abs(*entry);
        }
        let norm = sums.into_iter().fold(0.0, f64::max);
        // a sum and not a maximum, which would lose what is not a number
        let length: f64 = (0..n).map(|i| right[(i, 0)].powi(2)).sum();
        norm * (length / n as f64).sqrt() / 2.0
    }

    /// Puts the solution in the place of its right side.
    fn solve(&self, mut right: MatMut<'_, f64>) {
        for j in 0..right.ncols() {
            for (i, scale) in self.rows.iter().enumerate() {
                right[(i, j)] *= scale;
            }
        }
        self.lu.solve_in_place(right.rb_mut());
        for j in 0..right.ncols() {
            for (i, scale) in self.columns.iter().enumerate() {
                right[(i, j)] *= scale;
            }
        }
    }
}

/// The power of 2 that brings a number to between 1 and 2, so that nothing is rounded; nothing for 0.
fn scale(greatest: f64) -> Option<f64> {
    if greatest == 0.0 {
        return None;
    }
    let exponent = greatest.log2().floor().clamp(-1000.0, 1000.0);
    Some((-exponent).exp2())
}

#[cfg(test)]
mod tests {
    use nalgebra::{DMatrix, DVector};
    use sprs::{CsMat, TriMat};

    use super::super::sparse;
    use super::solution;

    fn matrix(n: usize, rows: &[f64]) -> DMatrix<f64> {
        DMatrix::from_row_slice(n, n, rows)
    }

    fn vector(entries: &[f64]) -> DVector<f64> {
        DVector::from_column_slice(entries)
    }

    fn solved(a: &DMatrix<f64>, b: &DVector<f64>) -> Option<DVector<f64>> {
        let by_columns = sparse(a);
        let x = solution(&by_columns, b);
        // the other storage is the same matrix
        assert_eq!(solution::<DVector<f64>>(&by_columns.to_csr(), b), x);
        x
    }

    #[test]
    fn solves_what_is_neither_symmetric_nor_definite() {
        let a = matrix(3, &[0.0, 2.0, 1.0, 3.0, 0.0, -1.0, 0.0, -4.0, 0.0]);
        let x = vector(&[1.0, -2.0, 3.0]);
        let found = solved(&a, &(&a * &x)).expect("regular");
        assert!((found - x).norm() < 1e-14);
    }

    #[test]
    fn scales_do_not_matter() {
        let a = DMatrix::from_diagonal(&vector(&[1e-300, 1e300, 1.0, 1e-30]));
        let x = solved(&a, &vector(&[1e-300, 1e300, 2.0, 3e-30])).expect("regular");
        assert!((x - vector(&[1.0, 1.0, 2.0, 3.0])).norm() < 1e-14);
    }

    #[test]
    fn refuses_what_is_singular() {
        let b = vector(&[1.0, 2.0]);
        assert_eq!(solved(&matrix(2, &[1.0, 2.0, 2.0, 4.0]), &b), None);
        assert_eq!(solved(&matrix(2, &[1.0, 2.0, 0.0, 0.0]), &b), None);
        assert_eq!(solved(&matrix(2, &[0.0, 1.0, 0.0, 2.0]), &b), None);
        assert_eq!(solved(&matrix(2, &[f64::NAN, 1.0, 1.0, 2.0]), &b), None);
        assert_eq!(solved(&matrix(2, &[0.1, 0.3, 0.2, 0.6]), &b), None);
        // regular in structure only where rows are taken out of order, or not at all
        let three = matrix(3, &[1.0, 1.0, 0.0, 2.0, 2.0, 0.0, 0.0, 0.0, 1.0]);
        assert_eq!(solved(&three, &vector(&[1.0, 2.0, 3.0])), None);
    }

    #[test]
    fn nothing_has_a_solution() {
        let a = DMatrix::<f64>::zeros(0, 0);
        assert_eq!(solved(&a, &DVector::zeros(0)), Some(DVector::zeros(0)));
    }

    fn laplacian(n: usize, shift: f64) -> CsMat<f64> {
        let mut entries = TriMat::new((n * n, n * n));
        for i in 0..n {
            for j in 0..n {
                let here = i * n + j;
                entries.add_triplet(here, here, shift);
                for other in [(i + 1, j), (i, j + 1)] {
                    if other.0 < n && other.1 < n {
                        let there = other.0 * n + other.1;
                        entries.add_triplet(here, here, 1.0);
                        entries.add_triplet(there, there, 1.0);
                        entries.add_triplet(here, there, -1.0);
                        entries.add_triplet(there, here, -1.0);
                    }
                }
            }
        }
        entries.to_csc()
    }

    #[test]
    fn the_laplacian_of_a_grid() {
        for n in [2, 5, 30, 70] {
            let a = laplacian(n, 1e-6);
            let x = DVector::from_fn(n * n, |i, _| (i % 7) as f64 - 3.0);
            let b: DVector<f64> = super::super::sparse_product(&a, &x);
            let found: DVector<f64> = solution(&a, &b).expect("regular");
            assert!((found - x).amax() < 1e-6, "{n}");
            // constants are in the kernel of this one, whatever rounding makes of its last pivot
            assert_eq!(
                solution::<DVector<f64>>(&laplacian(n, 0.0), &b),
                None,
                "{n}"
            );
        }
    }
}
