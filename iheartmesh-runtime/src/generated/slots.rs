//! Sums of blocks whose places depend on the mesh alone: the pattern and the place of each entry are found once,
//! then values are added without sorting, searching or allocating.

use std::ops::Range;
use std::sync::{Arc, Mutex, PoisonError};

use super::array::Array;
use super::in_order::in_order;
use super::local_block::LocalBlock;
use super::local_matrix::LocalMatrix;
use super::local_rows::LocalRows;
use super::missing::{element, named};
use super::pattern::Pattern;
use super::pending::Pending;
use super::{Fallible, Fault};
use crate::element::ElementKind;

/// Fewer chunks than this are done before another thread has woken up.
const FEW: usize = 16;

/// So many chunks are computed together where there are several threads. Entries that neighbouring terms share are added to
/// by one of them, then: the more, the less often they go from one core to another.
const GROUP: usize = 4;

/// Where the entries of a sum of blocks go, or of several that are computed together.
#[derive(Debug)]
pub struct Slots {
    pub(super) arrays: Vec<ArraySlots>,
    /// One for each sum: the rounds of its chunks.
    pub(super) parts: Vec<Vec<Range<usize>>>,
    /// Memory for the values of chunks.
    pub(super) scratch: Mutex<Vec<Vec<f64>>>,
}

/// Where the blocks of one array go. They come in the order of the loops; of each the columns, of each column the pieces that
/// stay together.
#[derive(Debug)]
pub(super) struct ArraySlots {
    pub(super) pattern: Pattern,
    /// Where pieces start in the entries of the array.
    pub(super) slots: Vec<u32>,
    pub(super) heights: Heights,
    /// What is passed over where branches are not taken, in the order of the loops.
    pub(super) jumps: Vec<Jump>,
    /// Matrices that are added whole.
    pub(super) wholes: Vec<Whole>,
    /// The blocks whose size the mesh decides, see [`super::local_rows`].
    pub(super) locals: LocalRows,
    /// One for each sum: its chunks.
    pub(super) parts: Vec<Vec<Chunk>>,
}

/// How many entries are in each piece.
#[derive(Debug)]
pub(super) enum Heights {
    All(usize),
    Each(Vec<u32>),
}

/// A sparse matrix that is added whole.
#[derive(Debug, Default)]
pub(super) struct Whole {
    /// Where its entries go.
    pub(super) slots: Vec<u32>,
    /// Its entries, where they do not depend on values.
    pub(super) values: Vec<f64>,
}

/// What is in a branch that depends on values.
#[derive(Clone, Copy, Debug)]
pub(super) struct Jump {
    pub(super) values: u32,
    pub(super) pieces: u32,
    /// The branches inside of it.
    pub(super) jumps: u32,
    /// What is known beforehand of blocks whose size the mesh decides.
    pub(super) locals: u32,
}

/// What consecutive rounds of a loop add to an array.
#[derive(Clone, Debug)]
pub(super) struct Chunk {
    pub(super) pieces: Range<usize>,
    /// Where its branches start.
    pub(super) jumps: usize,
    /// Where its blocks start whose size the mesh decides.
    pub(super) locals: usize,
    pub(super) values: usize,
    /// Whether some of its places do not exist.
    pub(super) missing: bool,
}

impl Slots {
    /// What an array looks like.
    pub fn pattern(&self, array: usize) -> &Pattern {
        &self.arrays[array].pattern
    }

    /// Adds the values of a sum, by its number, to the entries of arrays and to numbers beside them. `values` computes
    /// those of consecutive rounds.
    ///
    /// Whatever the number of threads, the entries get their terms in the order of the rounds.
    ///
    /// # Errors
    /// The first in the order of the rounds.
    pub fn add<const N: usize, const M: usize>(
        &self,
        kind: Option<ElementKind>,
        part: usize,
        data: &mut [&mut [f64]; N],
        totals: &mut [f64; M],
        values: impl Fn(Range<usize>, &mut [Terms<'_>; N], &mut [f64; M]) -> Fallible<()> + Sync,
    ) -> Fallible<()> {
        let chunks = self.parts.get(part).map_or(&[][..], Vec::as_slice);
        let chunk = |array: usize, k: usize| &self.arrays[array].parts[part][k];
        // the values for one array after the other, then the numbers
        let count = |k: usize| (0..N).map(|array| chunk(array, k).values).sum::<usize>() + M;
        // what blocks are put together in, whose size the mesh decides
        let beside: usize = self.arrays.iter().map(|array| array.locals.memory).sum();
        let compute = |k: usize, rounds: Range<usize>, room: &mut [f64]| {
            let (mut rest, mut beside) = room.split_at_mut(count(k));
            let mut terms: [Terms<'_>; N] = std::array::from_fn(|array| {
                let (chunk, slots) = (chunk(array, k), &self.arrays[array]);
                let (values, after) = std::mem::take(&mut rest).split_at_mut(chunk.values);
                rest = after;
                let memory = slots.locals.memory;
                let (memory, after) = std::mem::take(&mut beside).split_at_mut(memory);
                beside = after;
                Terms {
                    values,
                    slots: match chunk.missing {
                        true => &slots.slots[chunk.pieces.clone()],
                        false => &[],
                    },
                    next: 0,
                    piece: 0,
                    jumps: slots.jumps.get(chunk.jumps..).unwrap_or_default(),
                    local: LocalMatrix::new(slots.locals.steps.get(chunk.locals..), memory),
                    pending: Pending::default(),
                }
            });
            let mut sums = [0.0; M];
            values(rounds, &mut terms, &mut sums)?;
            terms.iter_mut().for_each(Terms::finish);
            rest.copy_from_slice(&sums);
            Ok(())
        };
        let evaluate = |k: usize, room: &mut [f64]| {
            let rounds = chunks[k].clone();
            compute(k, rounds.clone(), room).map_err(|fault| {
                named(kind, rounds, fault, |rounds| compute(k, rounds, room).err())
            })
        };
        let mut scatter = |k: usize, values: &[f64]| {
            let mut rest = values;
            for (array, entries) in data.iter_mut().enumerate() {
                let chunk = chunk(array, k);
                let (own, after) = rest.split_at(chunk.values);
                self.arrays[array].scatter(chunk, own, entries);
                rest = after;
            }
            for (total, sum) in totals.iter_mut().zip(rest) {
                *total += sum;
            }
        };
        let mut memory = std::mem::take(&mut *self.memory());
        let done = if chunks.len() < FEW || rayon::current_num_threads() == 1 {
            let mut values = memory.pop().unwrap_or_default();
            let done = (0..chunks.len()).try_for_each(|k| {
                let values = room(&mut values, count(k) + beside);
                evaluate(k, values)?;
                scatter(k, values);
                Ok(())
            });
            memory.push(values);
            done
        } else {
            let groups = chunks.len().div_ceil(GROUP);
            let group = |k: usize| GROUP * k..chunks.len().min(GROUP * (k + 1));
            let compute_group = |k: usize, values: &mut Vec<f64>| {
                let all = group(k).map(count).sum::<usize>();
                let mut rest = room(values, all + beside);
                group(k).try_for_each(|k| {
                    // what is beside one is overwritten by the next
                    evaluate(k, rest)?;
                    rest = &mut std::mem::take(&mut rest)[count(k)..];
                    Ok(())
                })
            };
            in_order(groups, &mut memory, compute_group, |k, values| {
                let mut rest = values;
                for k in group(k) {
                    let (first, after) = rest.split_at(count(k));
                    scatter(k, first);
                    rest = after;
                }
            })
        };
        *self.memory() = memory;
        done
    }

    /// Adds a multiple of a matrix that is added whole, by its number and its entries in the order of its pattern.
    pub fn add_entries(&self, whole: usize, data: &mut [f64], factor: f64, entries: &[f64]) {
        let Some(whole) = self.arrays.first().and_then(|a| a.wholes.get(whole)) else {
            return;
        };
        for (slot, value) in whole.slots.iter().zip(entries) {
            if let Some(entry) = data.get_mut(*slot as usize) {
                *entry += factor * value;
            }
        }
    }

    /// The same of a matrix whose entries are kept here.
    pub fn add_kept(&self, whole: usize, data: &mut [f64], factor: f64) {
        let array = self.arrays.first();
        if let Some(Whole { values, .. }) = array.and_then(|a| a.wholes.get(whole)) {
            self.add_entries(whole, data, factor, values);
        }
    }

    fn memory(&self) -> std::sync::MutexGuard<'_, Vec<Vec<f64>>> {
        self.scratch.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl ArraySlots {
    fn scatter(&self, chunk: &Chunk, values: &[f64], data: &mut [f64]) {
        let slots = &self.slots[chunk.pieces.clone()];
        match &self.heights {
            Heights::All(1) => scatter_pieces::<1>(slots, values, data),
            Heights::All(2) => scatter_pieces::<2>(slots, values, data),
            Heights::All(3) => scatter_pieces::<3>(slots, values, data),
            Heights::All(4) => scatter_pieces::<4>(slots, values, data),
            Heights::All(height) => {
                for (slot, piece) in slots.iter().zip(values.chunks_exact((*height).max(1))) {
                    add_piece(data, *slot, piece);
                }
            }
            Heights::Each(heights) => {
                let mut rest = values;
                for (slot, height) in slots.iter().zip(&heights[chunk.pieces.clone()]) {
                    let (piece, after) = rest.split_at(*height as usize);
                    add_piece(data, *slot, piece);
                    rest = after;
                }
            }
        }
    }
}

/// Memory for so many numbers.
fn room(memory: &mut Vec<f64>, count: usize) -> &mut [f64] {
    if memory.len() < count {
        memory.resize(count, 0.0);
    }
    &mut memory[..count]
}

#[inline(always)]
fn scatter_pieces<const H: usize>(slots: &[u32], values: &[f64], data: &mut [f64]) {
    for (slot, piece) in slots.iter().zip(values.as_chunks::<H>().0) {
        let start = *slot as usize;
        // places that do not exist have no values, see `Terms`
        if let Some(entries) = data.get_mut(start..start + H) {
            for (entry, value) in entries.iter_mut().zip(piece) {
                *entry += value;
            }
        }
    }
}

#[inline(always)]
fn add_piece(data: &mut [f64], slot: u32, piece: &[f64]) {
    let start = slot as usize;
    if let Some(entries) = data.get_mut(start..start + piece.len()) {
        for (entry, value) in entries.iter_mut().zip(piece) {
            *entry += value;
        }
    }
}

/// The values of a chunk while they are computed.
#[derive(Debug)]
pub struct Terms<'a> {
    values: &'a mut [f64],
    /// Where some of them do not exist.
    slots: &'a [u32],
    next: usize,
    piece: usize,
    /// The branches to come.
    jumps: &'a [Jump],
    /// The block that is put together, where its size is known from the mesh.
    pub(super) local: LocalMatrix<'a>,
    /// Blocks among the values whose eigenvalues are to be replaced.
    pending: Pending,
}

impl<'a> Terms<'a> {
    /// A block whose columns are in so many pieces.
    ///
    /// # Errors
    /// When its place does not exist.
    #[inline(always)]
    pub fn block(
        &mut self,
        value: &impl Array<Item = f64>,
        pieces: usize,
        fault: Fault,
    ) -> Fallible<()> {
        let (rows, columns) = (value.rows(), value.columns());
        let entries = self.room(rows * columns, pieces, fault)?;
        for (j, column) in entries.chunks_exact_mut(rows.max(1)).enumerate() {
            for (i, entry) in column.iter_mut().enumerate() {
                *entry = value.entry(i, j);
            }
        }
        Ok(())
    }

    /// A symmetric block with its eigenvalues replaced.
    ///
    /// # Errors
    /// When its place does not exist.
    #[inline(always)]
    pub fn symmetric<const P: usize, const H: usize, const N: usize, const M: usize>(
        &mut self,
        block: LocalBlock<P, H, N, M>,
        places: [usize; P],
        part: super::Part,
        fault: Fault,
    ) -> Fallible<()> {
        let place = self.next;
        let entries = self.room(N * N, P * N, fault)?;
        if let Some(kind) = block.store(places, part, entries) {
            self.pending.push(self.values, place, kind);
        }
        Ok(())
    }

    /// The product of a symmetric block with its eigenvalues replaced, and the rows of a vector or matrix at its places.
    ///
    /// # Errors
    /// When its place does not exist.
    #[inline(always)]
    pub fn symmetric_product<const P: usize, const H: usize, const N: usize, const M: usize>(
        &mut self,
        block: LocalBlock<P, H, N, M>,
        places: [usize; P],
        part: super::Part,
        factor: &impl Array<Item = f64>,
        fault: Fault,
    ) -> Fallible<()> {
        let columns = factor.columns();
        let values = self.room(N * columns, P * columns, fault)?;
        let block = block.finished(places, part);
        for (j, values) in values.chunks_exact_mut(N.max(1)).enumerate() {
            // of parts at one place the block has only the first
            let x: [f64; N] = std::array::from_fn(|k| factor.entry(places[k / H] * H + k % H, j));
            let mut product = [0.0; N];
            for (column, x) in block.iter().zip(&x) {
                for (sum, entry) in product.iter_mut().zip(column) {
                    *sum += entry * x;
                }
            }
            values.copy_from_slice(&product);
        }
        Ok(())
    }

    /// Zeros for a branch that is not taken.
    #[inline(always)]
    pub fn skip(&mut self, values: usize, pieces: usize) {
        self.values[self.next..self.next + values].fill(0.0);
        self.next += values;
        self.piece += pieces;
    }

    /// Goes into a branch whose number of values the plan knows.
    #[inline(always)]
    pub fn enter(&mut self) {
        self.jumps = self.jumps.get(1..).unwrap_or_default();
    }

    /// Zeros for such a branch that is not taken.
    #[inline(always)]
    pub fn pass(&mut self) {
        if let Some(jump) = self.jumps.first() {
            self.jumps = self
                .jumps
                .get(1 + jump.jumps as usize..)
                .unwrap_or_default();
            self.local.pass(jump.locals as usize);
            self.skip(jump.values as usize, jump.pieces as usize);
        }
    }

    /// How many values there are so far.
    #[inline(always)]
    pub fn position(&self) -> usize {
        self.next
    }

    /// Multiplies all values from a position on.
    #[inline(always)]
    pub fn scale(&mut self, from: usize, factor: f64) {
        self.finish();
        for value in &mut self.values[from..self.next] {
            *value *= factor;
        }
    }

    /// Divides all values from a position on.
    #[inline(always)]
    pub fn divide(&mut self, from: usize, divisor: f64) {
        self.finish();
        for value in &mut self.values[from..self.next] {
            *value /= divisor;
        }
    }

    /// Replaces the eigenvalues of blocks that wait for others.
    #[inline(always)]
    fn finish(&mut self) {
        self.pending.flush(self.values);
    }

    #[inline(always)]
    fn room(&mut self, values: usize, pieces: usize, fault: Fault) -> Fallible<&mut [f64]> {
        if !self.slots.is_empty() {
            let slots = &self.slots[self.piece..self.piece + pieces];
            slots
                .iter()
                .try_for_each(|slot| element(*slot, fault).map(|_| ()))?;
        }
        Ok(self.next(values, pieces).0)
    }

    /// The next values, and the block that is put together for them.
    pub(super) fn next(
        &mut self,
        values: usize,
        pieces: usize,
    ) -> (&mut [f64], &mut LocalMatrix<'a>) {
        self.piece += pieces;
        let start = self.next;
        self.next += values;
        (&mut self.values[start..start + values], &mut self.local)
    }
}

/// Slots as they are kept: for the sizes that they were made for.
#[derive(Debug)]
pub struct Planned<const N: usize>(Mutex<Option<([i64; N], Arc<Slots>)>>);

impl<const N: usize> Default for Planned<N> {
    fn default() -> Self {
        Self(Mutex::new(None))
    }
}

impl<const N: usize> Planned<N> {
    /// The slots for these sizes; made when there are none yet.
    pub fn get(
        &self,
        sizes: [i64; N],
        make: impl FnOnce() -> Fallible<Slots>,
    ) -> Fallible<Arc<Slots>> {
        let mut kept = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((known, slots)) = &*kept
            && *known == sizes
        {
            return Ok(Arc::clone(slots));
        }
        let slots = Arc::new(make()?);
        *kept = Some((sizes, Arc::clone(&slots)));
        Ok(slots)
    }
}
