//! The symmetric block of one term, while it is put together, where the mesh decides how many rows it has: a sum around a
//! vertex, say. Where its parts go is known beforehand, see [`super::local_rows`].

use super::array::Array;
use super::missing::element;
use super::slots::Terms;
use super::{Fallible, Fault, Part, is_positive_semidefinite, symmetric};

/// A block and its memory.
#[derive(Debug)]
pub(super) struct LocalMatrix<'a> {
    /// What is known of the parts to come.
    steps: &'a [u32],
    /// The entries, column by column, and what replacing the eigenvalues needs.
    memory: &'a mut [f64],
    n: usize,
    /// In how many pieces each column is added to the array.
    pieces: usize,
    /// What is added is multiplied by this.
    factor: f64,
    /// Whether all that was added is known to be positive semi-definite.
    proven: bool,
}

impl<'a> LocalMatrix<'a> {
    /// No block yet.
    pub(super) fn new(steps: Option<&'a [u32]>, memory: &'a mut [f64]) -> Self {
        Self {
            steps: steps.unwrap_or_default(),
            memory,
            n: 0,
            pieces: 0,
            factor: 1.0,
            proven: true,
        }
    }

    /// Passes over so many steps.
    #[inline(always)]
    pub(super) fn pass(&mut self, count: usize) -> &'a [u32] {
        let (passed, after) = self.steps.split_at(count.min(self.steps.len()));
        self.steps = after;
        passed
    }

    /// Where parts start.
    #[inline(always)]
    fn places<const N: usize>(&mut self, fault: Fault) -> Fallible<[usize; N]> {
        let mut places = [0; N];
        for (place, step) in places.iter_mut().zip(self.pass(N)) {
            *place = element(*step, fault)? as usize;
        }
        Ok(places)
    }
}

/// The symmetric part of the block in memory with its eigenvalues replaced, in `to`.
fn finish(to: &mut [f64], n: usize, is_proven: bool, part: Part, memory: &mut [f64]) {
    for i in 0..n {
        for j in 0..i {
            let mean = 0.5 * (memory[i * n + j] + memory[j * n + i]);
            to[i * n + j] = mean;
            to[j * n + i] = mean;
        }
        to[i * n + i] = memory[i * n + i];
    }
    if n > 0 && !is_proven {
        symmetric::replace(to, n, part, memory);
    }
}

impl Terms<'_> {
    /// Starts a block whose number of rows the mesh decides.
    #[inline]
    pub fn start_local(&mut self) {
        let local = &mut self.local;
        if let [n, pieces] = *local.pass(2) {
            (local.n, local.pieces) = (n as usize, pieces as usize);
        }
        (local.factor, local.proven) = (1.0, true);
        local.memory[..local.n * local.n].fill(0.0);
    }

    /// Adds a value whose rows are in `R` parts and whose columns are in `C`.
    ///
    /// # Errors
    /// When its place does not exist.
    #[inline(always)]
    pub fn add_local<const R: usize, const C: usize>(
        &mut self,
        value: &impl Array<Item = f64>,
        fault: Fault,
    ) -> Fallible<()> {
        let (height, width) = (value.rows() / R.max(1), value.columns() / C.max(1));
        let local = &mut self.local;
        let rows = local.places::<R>(fault)?;
        let columns = local.places::<C>(fault)?;
        let (n, factor) = (local.n, local.factor);
        for (c, to) in columns.into_iter().enumerate() {
            for j in 0..width {
                let column = &mut local.memory[(to + j) * n..(to + j + 1) * n];
                for (r, to) in rows.into_iter().enumerate() {
                    let entries = &mut column[to..to + height];
                    for (i, entry) in entries.iter_mut().enumerate() {
                        *entry += factor * value.entry(r * height + i, c * width + j);
                    }
                }
            }
        }
        Ok(())
    }

    /// Says that what was added last is positive semi-definite when this matrix is.
    #[inline(always)]
    pub fn with_core<const K: usize>(&mut self, core: &impl Array<Item = f64>) {
        let local = &mut self.local;
        local.proven = local.proven && local.factor >= 0.0 && is_positive_semidefinite::<K>(core);
    }

    /// Says that nothing is known of what was added last.
    #[inline(always)]
    pub fn without_core(&mut self) {
        self.local.proven = false;
    }

    /// Multiplies what is added from now on; what it was multiplied by until now.
    #[inline(always)]
    pub fn scale_local(&mut self, factor: f64) -> f64 {
        let before = self.local.factor;
        self.local.factor *= factor;
        before
    }

    /// From now on multiplies by this alone.
    #[inline(always)]
    pub fn set_local_scale(&mut self, factor: f64) {
        self.local.factor = factor;
    }

    /// Goes into a branch of a block.
    #[inline(always)]
    pub fn enter_local(&mut self) {
        self.local.pass(1);
    }

    /// Passes over a branch of a block that is not taken.
    #[inline(always)]
    pub fn pass_local(&mut self) {
        if let [count] = *self.local.pass(1) {
            self.local.pass(count as usize);
        }
    }

    /// The block with its eigenvalues replaced becomes the next values.
    #[inline]
    pub fn end_local(&mut self, part: Part) {
        let (n, pieces) = (self.local.n, self.local.pieces);
        let (values, local) = self.next(n * n, n * pieces);
        finish(values, n, local.proven, part, local.memory);
    }

    /// The next values are the product of the block with its eigenvalues replaced, and the rows of a vector or matrix.
    #[inline]
    pub fn end_local_product(&mut self, part: Part, factor: &impl Array<Item = f64>) {
        let (n, pieces, columns) = (self.local.n, self.local.pieces, factor.columns());
        let (values, local) = self.next(n * columns, pieces * columns);
        let rows = local.pass(n);
        let (memory, block) = local.memory.split_at_mut(local.memory.len() - n * n);
        finish(block, n, local.proven, part, memory);
        values.fill(0.0);
        for (j, product) in values.chunks_exact_mut(n.max(1)).enumerate() {
            for (column, row) in block.chunks_exact(n.max(1)).zip(rows) {
                let x = factor.entry(*row as usize, j);
                for (sum, entry) in product.iter_mut().zip(column) {
                    *sum += entry * x;
                }
            }
        }
    }
}
