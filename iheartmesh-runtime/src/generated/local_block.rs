//! The symmetric block of one element, while it is put together.

use super::Part;
use super::array::Array;
use super::spectrum::{
    has_positive_pivots, is_positive_semidefinite, largest, replaced, replacement,
};

/// A block of `N` rows: `P` parts of a height `H`. `M` is the number of rows without one part.
#[derive(Clone, Debug)]
pub struct LocalBlock<const P: usize, const H: usize, const N: usize, const M: usize> {
    /// By columns.
    entries: [[f64; N]; N],
    /// Whether all that was added is known to be positive semi-definite.
    proven: bool,
}

impl<const P: usize, const H: usize, const N: usize, const M: usize> Default
    for LocalBlock<P, H, N, M>
{
    fn default() -> Self {
        Self::new()
    }
}

impl<const P: usize, const H: usize, const N: usize, const M: usize> LocalBlock<P, H, N, M> {
    /// Zeros.
    #[inline(always)]
    pub fn new() -> Self {
        Self {
            entries: [[0.0; N]; N],
            proven: true,
        }
    }

    /// Adds a value to these parts of the rows and of the columns.
    #[inline(always)]
    pub fn add<const R: usize, const C: usize>(
        &mut self,
        rows: [usize; R],
        columns: [usize; C],
        value: &impl Array<Item = f64>,
    ) {
        for (c, to) in columns.into_iter().enumerate() {
            for j in 0..H {
                let column = &mut self.entries[to * H + j];
                for (r, to) in rows.into_iter().enumerate() {
                    for i in 0..H {
                        column[to * H + i] += value.entry(r * H + i, c * H + j);
                    }
                }
            }
        }
    }

    /// Says that what was added is positive semi-definite when this matrix is.
    #[inline(always)]
    pub fn with_core<const K: usize>(&mut self, core: &impl Array<Item = f64>) {
        self.proven = self.proven && is_positive_semidefinite::<K>(core);
    }

    /// Says that nothing is known of what was added.
    #[inline(always)]
    pub fn without_core(&mut self) {
        self.proven = false;
    }

    /// Multiplies all that was added.
    #[inline(always)]
    pub fn scale(&mut self, factor: f64) {
        self.proven &= factor >= 0.0;
        for entry in self.entries.iter_mut().flatten() {
            *entry *= factor;
        }
    }

    /// Adds another one.
    #[inline(always)]
    pub fn merge(&mut self, other: &Self) {
        self.proven &= other.proven;
        for (a, b) in self
            .entries
            .iter_mut()
            .flatten()
            .zip(other.entries.iter().flatten())
        {
            *a += b;
        }
    }

    /// The entries by columns, with the eigenvalues replaced. Parts at the same place are one: the entries of all but the first
    /// of them are 0.
    #[inline(always)]
    pub(super) fn finished(&self, places: [usize; P], part: Part) -> [[f64; N]; N] {
        let mut a = self.entries;
        #[expect(
            clippy::needless_range_loop,
            reason = "two entries at a time, across the diagonal"
        )]
        for i in 0..N {
            for j in 0..i {
                let mean = 0.5 * (a[i][j] + a[j][i]);
                a[i][j] = mean;
                a[j][i] = mean;
            }
        }
        for k in 1..P {
            if places[..k].contains(&places[k]) {
                a = merged::<P, H, N>(a, places);
                break;
            }
        }
        if !self.proven {
            a = match is_of_differences::<P, H, N>(&a) {
                true => replaced_in_differences::<P, H, N, M>(&a, part),
                false => replaced(&a, part),
            };
        }
        a
    }
}

/// Rows and columns of parts at the same place, added to those of the first of them.
#[cold]
fn merged<const P: usize, const H: usize, const N: usize>(
    a: [[f64; N]; N],
    places: [usize; P],
) -> [[f64; N]; N] {
    let first = |k: usize| {
        let part = places.iter().position(|p| *p == places[k / H]);
        part.unwrap_or(k / H) * H + k % H
    };
    let mut all = [[0.0; N]; N];
    for i in 0..N {
        for j in 0..N {
            all[first(i)][first(j)] += a[i][j];
        }
    }
    all
}

/// Whether a symmetric matrix does not change when all parts move together, up to rounding: the parts of each column add up to
/// 0. Blocks of what depends on differences of items alone are such.
fn is_of_differences<const P: usize, const H: usize, const N: usize>(a: &[[f64; N]; N]) -> bool {
    let Some(largest) = largest(a) else {
        return false;
    };
    let small = 16.0 * N as f64 * f64::EPSILON * largest;
    P > 1
        && (0..H).all(|i| {
            let mut sums = [0.0; N];
            for part in 0..P {
                for (sum, x) in sums.iter_mut().zip(&a[part * H + i]) {
                    *sum += x;
                }
            }
            sums.iter().all(|sum| sum.abs() <= small)
        })
}

/// A matrix that does not change when all parts move together, with its eigenvalues replaced: in an orthonormal basis of the
/// differences, which is smaller. The others are 0.
fn replaced_in_differences<const P: usize, const H: usize, const N: usize, const M: usize>(
    a: &[[f64; N]; N],
    part: Part,
) -> [[f64; N]; N] {
    let narrow = differences::<P, H, N, M, N>(a);
    let small = differences::<P, H, N, M, M>(&transposed(&narrow));
    if has_positive_pivots(small) {
        return *a;
    }
    let Some(change) = replacement(&small, part) else {
        return [[f64::NAN; N]; N];
    };
    let mut all = *a;
    change.apply(&mut all, parts::<P, H, N, M>);
    all
}

/// `1/√(k (k + 1))`: column `k` of the basis, after F. R. Helmert 1876, is this `k` times, then `-k` times it.
#[inline(always)]
fn weight(k: usize) -> f64 {
    1.0 / ((k * (k + 1)) as f64).sqrt()
}

/// The rows in the basis of differences.
#[inline(always)]
fn differences<const P: usize, const H: usize, const N: usize, const M: usize, const W: usize>(
    rows: &[[f64; W]; N],
) -> [[f64; W]; M] {
    let mut all = [[0.0; W]; M];
    for i in 0..H {
        let mut sum = rows[i];
        for k in 1..P {
            let weight = weight(k);
            let row = &rows[k * H + i];
            for ((entry, sum), x) in all[(k - 1) * H + i].iter_mut().zip(&mut sum).zip(row) {
                *entry = weight * (*sum - k as f64 * x);
                *sum += x;
            }
        }
    }
    all
}

/// A vector in the basis of differences as one of the parts.
#[inline(always)]
fn parts<const P: usize, const H: usize, const N: usize, const M: usize>(
    vector: &[f64; M],
) -> [f64; N] {
    let mut all = [0.0; N];
    for i in 0..H {
        let mut sum = 0.0;
        for k in (1..P).rev() {
            let x = weight(k) * vector[(k - 1) * H + i];
            all[k * H + i] = sum - k as f64 * x;
            sum += x;
        }
        all[i] = sum;
    }
    all
}

#[inline(always)]
fn transposed<const R: usize, const C: usize>(a: &[[f64; C]; R]) -> [[f64; R]; C] {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, SMatrix};

    fn check<const P: usize, const H: usize, const N: usize, const M: usize>(
        matrix: &SMatrix<f64, N, N>,
        places: [usize; P],
    ) {
        let dense = DMatrix::from_fn(N, N, |i, j| matrix[(i, j)]);
        // parts at one place are one
        let first = |k: usize| places.iter().position(|p| *p == places[k / H]).unwrap() * H + k % H;
        let join = DMatrix::from_fn(N, N, |i, j| f64::from(i == first(j)));
        let eigen = (&join * dense * join.transpose()).symmetric_eigen();
        for part in [Part::Positive, Part::Absolute] {
            let mut block = LocalBlock::<P, H, N, M>::new();
            block.add(
                std::array::from_fn::<_, P, _>(|k| k),
                std::array::from_fn::<_, P, _>(|k| k),
                matrix,
            );
            block.without_core();
            let entries = block.finished(places, part).concat();
            let values = DMatrix::from_diagonal(&eigen.eigenvalues.map(|x| part.replace(x)));
            let expected = &eigen.eigenvectors * values * eigen.eigenvectors.transpose();
            let difference = DMatrix::from_vec(N, N, entries) - expected;
            assert!(difference.amax() < 1e-13 * N as f64 * matrix.amax().max(1e-200));
        }
    }

    fn check_parts<const P: usize, const H: usize, const N: usize, const M: usize>() {
        let mut state = 88172645463325252u64;
        let mut next = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        };
        for round in 0..40 {
            let core = SMatrix::<f64, M, M>::from_fn(|_, _| next());
            let core = core + core.transpose();
            // of differences to the first part
            let differences = SMatrix::<f64, M, N>::from_fn(|i, j| match (i / H + 1, j / H) {
                _ if i % H != j % H => 0.0,
                (_, 0) => -1.0,
                (k, part) => f64::from(k == part),
            });
            let matrix = differences.transpose() * core * differences;
            let mut places: [usize; P] = std::array::from_fn(|k| 7 * k % 5 + 5 * k);
            check::<P, H, N, M>(&(matrix * 10f64.powi(20 * (round % 5) - 40)), places);
            // of anything
            let any = SMatrix::<f64, N, N>::from_fn(|_, _| next());
            check::<P, H, N, M>(&(any + any.transpose()), places);
            places[P - 1] = places[0];
            check::<P, H, N, M>(&matrix, places);
            check::<P, H, N, M>(&(any + any.transpose()), places);
        }
    }

    #[test]
    fn blocks_of_differences() {
        check_parts::<2, 1, 2, 1>();
        check_parts::<2, 3, 6, 3>();
        check_parts::<3, 2, 6, 4>();
        check_parts::<3, 3, 9, 6>();
        check_parts::<4, 3, 12, 9>();
    }
}
