//! The symmetric block of one element, while it is put together.

use super::Part;
use super::array::Array;
use super::lanes::Lanes;
use super::pending::{FEW, Kind, LANES};
use super::spectrum::{Replacements, is_positive_semidefinite};

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
        let mut a = [[0.0; N]; N];
        if let Some(kind) = self.store(places, part, a.as_flattened_mut()) {
            (kind.replace)(a.as_flattened_mut(), &[0], part);
        }
        a
    }

    /// Writes the entries by columns. What is still to be done to replace the eigenvalues, if there is something.
    #[inline(always)]
    pub(super) fn store(
        &self,
        places: [usize; P],
        part: Part,
        entries: &mut [f64],
    ) -> Option<Kind> {
        let a = block_at::<N>(entries, 0)?;
        for (i, row) in self.entries.iter().enumerate() {
            a[i][i] = row[i];
            for j in 0..i {
                let mean = 0.5 * (row[j] + self.entries[j][i]);
                a[i][j] = mean;
                a[j][i] = mean;
            }
        }
        for k in 1..P {
            if places[..k].contains(&places[k]) {
                *a = merged::<P, H, N>(a, places);
                break;
            }
        }
        if self.proven {
            return None;
        }
        if N == 1 {
            a[0][0] = part.replace(a[0][0]);
            return None;
        }
        Some(Kind {
            sizes: [P, H],
            part,
            replace: replace_eigenvalues::<P, H, N, M>,
        })
    }
}

/// Rows and columns of parts at the same place, added to those of the first of them.
#[cold]
fn merged<const P: usize, const H: usize, const N: usize>(
    a: &[[f64; N]; N],
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

/// Replaces the eigenvalues of blocks that begin at these places, many together or each by itself.
fn replace_eigenvalues<const P: usize, const H: usize, const N: usize, const M: usize>(
    values: &mut [f64],
    places: &[usize],
    part: Part,
) {
    if places.len() > FEW {
        return replace_together::<P, H, N, M, LANES>(values, places, part);
    }
    for place in places {
        replace_together::<P, H, N, M, 1>(values, std::slice::from_ref(place), part);
    }
}

/// The same of at most `L` blocks: of those that do not change when all parts move together in an orthonormal basis of the
/// differences, which is smaller. The other eigenvalues are 0.
fn replace_together<
    const P: usize,
    const H: usize,
    const N: usize,
    const M: usize,
    const L: usize,
>(
    values: &mut [f64],
    places: &[usize],
    part: Part,
) {
    let mut of_differences = [0; L];
    let mut others = [0; L];
    let mut counts = [0; 2];
    let mut narrow = [[Lanes::<L>::splat(0.0); N]; M];
    for place in places {
        let Some(block) = block_at::<N>(values, *place) else {
            continue;
        };
        let (rows, is_of_differences) = differences::<P, H, N, M>(block);
        let (count, list) = match is_of_differences {
            true => (&mut counts[0], &mut of_differences),
            false => (&mut counts[1], &mut others),
        };
        let lane = *count;
        list[lane] = *place;
        *count += 1;
        if is_of_differences {
            for (i, (all, row)) in narrow.iter_mut().zip(&rows).enumerate() {
                // up to the diagonal
                let used = (i / H + 2) * H;
                for (x, entry) in all[..used].iter_mut().zip(row) {
                    x[lane] = *entry;
                }
            }
        }
    }
    if counts[0] > 0 {
        let mut changes = Replacements::<M, L>::new(part);
        for (i, (to, row)) in changes.rows().iter_mut().zip(&narrow).enumerate() {
            for j in 0..H {
                let mut sum = row[j];
                for k in 1..i / H + 2 {
                    let x = row[k * H + j];
                    to[(k - 1) * H + j] = (sum - x * k as f64) * weight(k);
                    sum += x;
                }
            }
        }
        let places = &of_differences[..counts[0]];
        apply::<N, M, L>(changes, values, places, parts::<P, H, N, M, L>);
    }
    if counts[1] > 0 {
        let mut changes = Replacements::<N, L>::new(part);
        let places = &others[..counts[1]];
        for (lane, place) in places.iter().enumerate() {
            if let Some(block) = block_at::<N>(values, *place) {
                for (to, row) in changes.rows().iter_mut().zip(block) {
                    for (x, entry) in to.iter_mut().zip(row) {
                        x[lane] = *entry;
                    }
                }
            }
        }
        apply::<N, N, L>(changes, values, places, |vectors| *vectors);
    }
}

/// Changes blocks; vectors become longer if those are of a larger space.
#[inline(always)]
fn apply<const N: usize, const M: usize, const L: usize>(
    mut changes: Replacements<M, L>,
    values: &mut [f64],
    places: &[usize],
    wide: impl Fn(&[Lanes<L>; M]) -> [Lanes<L>; N],
) {
    let factors = changes.factors();
    for (factor, place) in factors.0.iter().zip(places) {
        if *factor != 1.0
            && let Some(block) = block_at::<N>(values, *place)
        {
            for entry in block.as_flattened_mut() {
                *entry *= factor;
            }
        }
    }
    changes.for_each_vector(|used, vectors| {
        let vectors = wide(vectors);
        for (lane, place) in places.iter().enumerate() {
            if used[lane]
                && let Some(block) = block_at::<N>(values, *place)
            {
                let vector = vectors.map(|x| x[lane]);
                for (row, x) in block.iter_mut().zip(&vector) {
                    for (entry, y) in row.iter_mut().zip(&vector) {
                        *entry += x * y;
                    }
                }
            }
        }
    });
}

#[inline(always)]
fn block_at<const N: usize>(values: &mut [f64], place: usize) -> Option<&mut [[f64; N]; N]> {
    let (columns, _) = values.get_mut(place..)?.as_chunks_mut::<N>();
    columns.first_chunk_mut::<N>()
}

/// `1/√(k (k + 1))`: column `k` of the basis, after F. R. Helmert 1876, is this `k` times, then `-k` times it.
#[inline(always)]
fn weight(k: usize) -> f64 {
    1.0 / ((k * (k + 1)) as f64).sqrt()
}

/// The rows of a symmetric matrix in the basis of differences, and whether it does not change when all parts move together, up
/// to rounding: the parts of each column add up to 0. Blocks of what depends on differences of items alone are such.
#[inline(always)]
fn differences<const P: usize, const H: usize, const N: usize, const M: usize>(
    rows: &[[f64; N]; N],
) -> ([[f64; N]; M], bool) {
    let mut all = [[0.0; N]; M];
    let (mut rest, mut size) = ([0.0f64; N], [0.0f64; N]);
    for i in 0..H {
        let mut sum = rows[i];
        for k in 1..P {
            let weight = weight(k);
            let row = &rows[k * H + i];
            let to = &mut all[(k - 1) * H + i];
            for (j, x) in row.iter().enumerate() {
                to[j] = weight * (sum[j] - k as f64 * x);
                sum[j] += x;
            }
        }
        for j in 0..N {
            // NaN stays
            let sum = sum[j].abs();
            rest[j] = if sum <= rest[j] { rest[j] } else { sum };
            // rows of a part, and the diagonal, are large where others are
            let x = rows[i][j].abs();
            size[j] = if x > size[j] { x } else { size[j] };
        }
    }
    for (j, size) in size.iter_mut().enumerate() {
        let x = rows[j][j].abs();
        *size = if x > *size { x } else { *size };
    }
    let size = size
        .iter()
        .fold(0.0, |most, x| if *x > most { *x } else { most });
    let small = 16.0 * N as f64 * f64::EPSILON * size;
    let is_of_differences = P > 1 && rest.iter().all(|rest| *rest <= small);
    (all, is_of_differences)
}

/// Vectors in the basis of differences as some of the parts.
#[inline(always)]
fn parts<const P: usize, const H: usize, const N: usize, const M: usize, const L: usize>(
    vectors: &[Lanes<L>; M],
) -> [Lanes<L>; N] {
    let mut all = [Lanes::splat(0.0); N];
    for i in 0..H {
        let mut sum = Lanes::splat(0.0);
        for k in (1..P).rev() {
            let x = vectors[(k - 1) * H + i] * weight(k);
            all[k * H + i] = sum - x * k as f64;
            sum += x;
        }
        all[i] = sum;
    }
    all
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

    /// Blocks that wait together, of differences or not, have the same bits as each by itself.
    fn check_together<const P: usize, const H: usize, const N: usize, const M: usize>() {
        let mut state = 2463534242u64;
        let mut next = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        };
        for round in 0..60 {
            let count = round % LANES + 1;
            let mut values = vec![0.0; count * N * N];
            for block in values.chunks_exact_mut(N * N) {
                let mut x = SMatrix::<f64, N, N>::from_fn(|_, _| next());
                if next() > -0.5 {
                    // what the parts have in common is taken away
                    let join = SMatrix::<f64, N, N>::from_fn(|i, j| {
                        f64::from(i == j) - f64::from(i % H == j % H) / P as f64
                    });
                    x = join * (x + x.transpose()) * join;
                }
                let scale = if next() > 0.9 { f64::NAN } else { next() };
                block.copy_from_slice(((x + x.transpose()) * scale).as_slice());
            }
            let part = [Part::Positive, Part::Absolute][round % 2];
            let places: Vec<usize> = (0..count).map(|k| k * N * N).collect();
            let mut alone = values.clone();
            for place in &places {
                replace_eigenvalues::<P, H, N, M>(&mut alone, &[*place], part);
            }
            let mut reversed = values.clone();
            let backwards: Vec<usize> = places.iter().rev().copied().collect();
            replace_eigenvalues::<P, H, N, M>(&mut reversed, &backwards, part);
            replace_eigenvalues::<P, H, N, M>(&mut values, &places, part);
            let bits = |values: &[f64]| values.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
            assert_eq!(bits(&values), bits(&alone));
            assert_eq!(bits(&values), bits(&reversed));
        }
    }

    #[test]
    fn blocks_that_wait_together() {
        check_together::<1, 3, 3, 0>();
        check_together::<2, 1, 2, 1>();
        check_together::<3, 2, 6, 4>();
        check_together::<4, 3, 12, 9>();
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
