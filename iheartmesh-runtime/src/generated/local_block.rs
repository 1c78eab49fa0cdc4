//! The symmetric block of one element, while it is put together.

use super::Part;
use super::array::Array;
use super::spectrum::{is_positive_semidefinite, replaced};

/// A block of `N` rows: `P` parts of a height `H`.
#[derive(Clone, Debug)]
pub struct LocalBlock<const P: usize, const H: usize, const N: usize> {
    /// By columns.
    entries: [[f64; N]; N],
    /// Whether all that was added is known to be positive semi-definite.
    proven: bool,
}

impl<const P: usize, const H: usize, const N: usize> Default for LocalBlock<P, H, N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const P: usize, const H: usize, const N: usize> LocalBlock<P, H, N> {
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
    pub(super) fn write(&self, places: [usize; P], part: Part, entries: &mut [f64]) {
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
            a = replaced(&a, part);
        }
        for (column, values) in entries.chunks_exact_mut(N.max(1)).zip(&a) {
            column.copy_from_slice(values);
        }
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
