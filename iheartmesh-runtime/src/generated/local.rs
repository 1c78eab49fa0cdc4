//! Values that the rows of a key share.

use std::collections::HashMap;
use std::ops::Range;

use smallvec::SmallVec;

use super::{Dense, Fallible, PlanError, Rows, Table, concatenated, in_chunks, is_missing};

/// For each key the rows, in another table, of the different elements in some columns of its own rows.
#[derive(Clone, Debug)]
pub struct Locals<const N: usize, const C: usize> {
    rows: Table<N>,
    /// For each row of the key, where among these its elements are.
    slots: Dense<C>,
}

/// So many keys are done at once.
const BATCH: usize = 32;
/// So many elements are searched one by one.
const FEW: usize = 32;

impl<const N: usize, const C: usize> Locals<N, C> {
    /// Finds the different elements in `columns` of the rows of each key.
    ///
    /// # Errors
    /// When there are more rows than `u32` can count.
    pub fn build<const K: usize>(
        table: &Table<K>,
        columns: [usize; C],
        of: &Dense<N>,
    ) -> Result<Self, PlanError> {
        let mut chunks = in_chunks(table.n_keys(), |keys| {
            let mut rows = Table::<N>::with_capacity(keys.len());
            let mut slots = Dense::<C>::with_capacity(keys.len() * 6);
            let mut around = Around::default();
            let mut elements = Vec::new();
            let mut ends = Vec::with_capacity(BATCH);
            for start in keys.clone().step_by(BATCH) {
                elements.clear();
                ends.clear();
                for key in start..keys.end.min(start + BATCH as u32) {
                    around.clear();
                    for row in table.rows_of(key as usize) {
                        slots.push(columns.map(|column| around.slot(row[column])));
                    }
                    elements.extend_from_slice(&around.elements);
                    ends.push(elements.len());
                }
                // the rows come from all over memory: nothing else stands between their reads
                let mut next = 0;
                for &end in &ends {
                    for element in &elements[next..end] {
                        rows.push(*of.row(*element as usize));
                    }
                    next = end;
                    rows.finish_key()?;
                }
            }
            Ok((rows, slots))
        })?;
        Ok(Self {
            rows: concatenated(&mut chunks, |chunk| &mut chunk.0)?,
            slots: concatenated(&mut chunks, |chunk| &mut chunk.1)?,
        })
    }

    /// The values of a function for the elements around a key.
    ///
    /// # Errors
    /// The first failure of the function.
    #[inline(always)]
    pub fn values<T>(
        &self,
        key: usize,
        value: impl Fn(&[u32; N]) -> Fallible<T>,
    ) -> Fallible<SmallVec<[T; 8]>> {
        let mut values = SmallVec::new();
        for row in self.rows.rows_of(key) {
            values.push(value(row)?);
        }
        Ok(values)
    }

    /// The slots of some rows.
    #[inline(always)]
    pub fn slots(&self, rows: Range<usize>) -> &[[u32; C]] {
        self.slots.rows(rows)
    }
}

/// The different elements met so far.
#[derive(Default)]
struct Around {
    elements: Vec<u32>,
    places: HashMap<u32, u32>,
}

impl Around {
    fn clear(&mut self) {
        self.elements.clear();
        self.places.clear();
    }

    fn slot(&mut self, element: u32) -> u32 {
        if is_missing(element) {
            return element;
        }
        let next = self.elements.len() as u32;
        if self.elements.len() < FEW {
            if let Some(slot) = self.elements.iter().position(|other| *other == element) {
                return slot as u32;
            }
        } else {
            if self.places.is_empty() {
                self.places = (0u32..)
                    .zip(&self.elements)
                    .map(|(slot, e)| (*e, slot))
                    .collect();
            }
            if let Some(slot) = self.places.get(&element) {
                return *slot;
            }
            self.places.insert(element, next);
        }
        self.elements.push(element);
        next
    }
}
