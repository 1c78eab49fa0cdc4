//! The tables of a plan: rows of element numbers.

use std::hint::black_box;

use rayon::prelude::*;

use super::PlanError;

/// So many keys are read at once where they are not in the order of memory.
const BATCH: usize = 32;

/// A table that can be filled in parts.
pub trait Rows: Sized {
    /// An empty table with room for so many rows.
    fn with_capacity(rows: usize) -> Self;

    /// The rows of all parts, one after the other.
    ///
    /// # Errors
    /// When there are more rows than `u32` can count.
    fn concatenated(parts: &[&Self]) -> Result<Self, PlanError>;

    /// The same without room for more.
    fn fitted(self) -> Self;

    /// For each key the rows that another key has here.
    fn taken(&self, from: &[u32]) -> Self;
}

/// One row for each element.
#[derive(Clone, Debug, Default)]
pub struct Dense<const N: usize> {
    rows: Vec<[u32; N]>,
}

impl<const N: usize> Dense<N> {
    /// Adds the row of the next element.
    #[inline]
    pub fn push(&mut self, row: [u32; N]) {
        self.rows.push(row);
    }

    /// The row of an element.
    #[inline(always)]
    pub fn row(&self, element: usize) -> &[u32; N] {
        &self.rows[element]
    }

    /// The rows of consecutive elements.
    #[inline(always)]
    pub fn rows(&self, elements: std::ops::Range<usize>) -> &[[u32; N]] {
        &self.rows[elements]
    }

    /// All elements with their rows.
    #[inline]
    pub fn enumerate(&self) -> impl Iterator<Item = (u32, &[u32; N])> {
        (0u32..).zip(&self.rows)
    }

    /// Consecutive elements with their rows.
    #[inline]
    pub fn enumerate_some(
        &self,
        elements: std::ops::Range<usize>,
    ) -> impl Iterator<Item = (u32, &[u32; N])> {
        (elements.start as u32..).zip(&self.rows[elements])
    }
}

impl<const N: usize> Rows for Dense<N> {
    fn with_capacity(rows: usize) -> Self {
        Self {
            rows: Vec::with_capacity(rows),
        }
    }

    fn concatenated(parts: &[&Self]) -> Result<Self, PlanError> {
        let rows = concatenate(&parts.iter().map(|p| p.rows.as_slice()).collect::<Vec<_>>());
        Ok(Self { rows })
    }

    fn fitted(mut self) -> Self {
        self.rows.shrink_to_fit();
        self
    }

    fn taken(&self, from: &[u32]) -> Self {
        let rows = from.iter().map(|key| self.rows[*key as usize]);
        Self {
            rows: rows.collect(),
        }
    }
}

/// Several rows for each key, in the order of the keys.
#[derive(Clone, Debug)]
pub struct Table<const N: usize> {
    starts: Vec<u32>,
    rows: Vec<[u32; N]>,
}

impl<const N: usize> Table<N> {
    /// Adds a row to the current key.
    #[inline]
    pub fn push(&mut self, row: [u32; N]) {
        self.rows.push(row);
    }

    /// Goes on to the next key.
    ///
    /// # Errors
    /// When there are more rows than `u32` can count.
    #[inline]
    pub fn finish_key(&mut self) -> Result<(), PlanError> {
        match u32::try_from(self.rows.len()) {
            Ok(end) => {
                self.starts.push(end);
                Ok(())
            }
            Err(_) => Err(PlanError::TooLarge),
        }
    }

    /// Number of rows.
    #[inline]
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether there are no rows.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Number of keys.
    pub fn n_keys(&self) -> usize {
        self.starts.len() - 1
    }

    /// The numbers of the rows of a key.
    #[inline(always)]
    pub fn range(&self, key: usize) -> std::ops::Range<usize> {
        self.starts[key] as usize..self.starts[key + 1] as usize
    }

    /// The rows of a key.
    #[inline(always)]
    pub fn rows_of(&self, key: usize) -> &[[u32; N]] {
        &self.rows[self.range(key)]
    }

    /// The rows of a key, in a table that has none for most meshes.
    #[inline(always)]
    pub fn few_rows_of(&self, key: usize) -> &[[u32; N]] {
        match self.rows.is_empty() {
            true => &[],
            false => self.rows_of(key),
        }
    }

    /// The rows of a key with their numbers.
    #[inline]
    pub fn enumerate_rows_of(&self, key: usize) -> impl Iterator<Item = (usize, &[u32; N])> {
        let range = self.range(key);
        range.clone().zip(&self.rows[range])
    }

    /// Reads the ends of the rows of some keys all at once, where they are not in the order of memory: the reads do not wait
    /// for each other.
    fn read_ahead(&self, keys: &[u32]) -> u32 {
        let ends = |key: &u32| {
            let rows = self.rows_of(*key as usize);
            rows.first()
                .map_or(0, |row| row.first().copied().unwrap_or(0))
                ^ rows
                    .last()
                    .map_or(0, |row| row.last().copied().unwrap_or(0))
        };
        keys.iter().fold(0, |all, key| all ^ ends(key))
    }

    /// All rows.
    pub fn rows(&self) -> &[[u32; N]] {
        &self.rows
    }
}

impl<const N: usize> Rows for Table<N> {
    fn with_capacity(keys: usize) -> Self {
        let mut starts = Vec::with_capacity(keys + 1);
        starts.push(0);
        Self {
            starts,
            // valence 6 is the average on closed triangle meshes
            rows: Vec::with_capacity(keys.saturating_mul(6)),
        }
    }

    fn concatenated(parts: &[&Self]) -> Result<Self, PlanError> {
        let total: usize = parts.iter().map(|p| p.rows.len()).sum();
        if u32::try_from(total).is_err() {
            return Err(PlanError::TooLarge);
        }
        let rows = concatenate(&parts.iter().map(|p| p.rows.as_slice()).collect::<Vec<_>>());
        let mut starts = Vec::with_capacity(1 + parts.iter().map(|p| p.n_keys()).sum::<usize>());
        starts.push(0);
        let mut before = 0;
        for part in parts {
            starts.extend(part.starts[1..].iter().map(|end| before + end));
            before += part.rows.len() as u32;
        }
        Ok(Self { starts, rows })
    }

    fn fitted(mut self) -> Self {
        self.starts.shrink_to_fit();
        self.rows.shrink_to_fit();
        self
    }

    fn taken(&self, from: &[u32]) -> Self {
        let mut starts = Vec::with_capacity(self.starts.len());
        starts.push(0);
        let mut rows = Vec::with_capacity(self.rows.len());
        for keys in from.chunks(BATCH) {
            black_box(self.read_ahead(keys));
            for key in keys {
                rows.extend_from_slice(self.rows_of(*key as usize));
                starts.push(rows.len() as u32);
            }
        }
        Self { starts, rows }
    }
}

fn concatenate<const N: usize>(parts: &[&[[u32; N]]]) -> Vec<[u32; N]> {
    let total = parts.iter().map(|p| p.len()).sum();
    let mut all = vec![[0; N]; total];
    let mut rest = all.as_mut_slice();
    let mut pieces = Vec::with_capacity(parts.len());
    for part in parts {
        let (piece, after) = rest.split_at_mut(part.len());
        pieces.push((piece, *part));
        rest = after;
    }
    pieces
        .into_par_iter()
        .for_each(|(piece, part)| piece.copy_from_slice(part));
    all
}

/// One table of each chunk, put together. A single one is moved.
///
/// # Errors
/// When there are more rows than `u32` can count.
pub fn concatenated<C, T: Rows>(
    chunks: &mut [C],
    table: impl Fn(&mut C) -> &mut T,
) -> Result<T, PlanError> {
    let mut parts: Vec<&mut T> = chunks.iter_mut().map(table).collect();
    if let [single] = parts.as_mut_slice() {
        return Ok(std::mem::replace(*single, T::with_capacity(0)).fitted());
    }
    let parts: Vec<&T> = parts.iter().map(|part| &**part).collect();
    T::concatenated(&parts)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Key k has k rows.
    fn table(keys: std::ops::Range<u32>) -> Table<2> {
        let mut table = Table::with_capacity(keys.len());
        for key in keys {
            (0..key).for_each(|k| table.push([key, k]));
            table.finish_key().unwrap();
        }
        table
    }

    fn shown(table: &Table<2>) -> Vec<Vec<[u32; 2]>> {
        let keys = 0..table.n_keys();
        keys.map(|key| table.rows_of(key).to_vec()).collect()
    }

    #[test]
    fn one_chunk_and_several_are_the_same_table() {
        let whole = concatenated(&mut [table(0..100)], |chunk| chunk).unwrap();
        let mut parts = [table(0..3), table(3..3), table(3..100)];
        let parts = concatenated(&mut parts, |chunk| chunk).unwrap();
        assert_eq!(shown(&whole), shown(&table(0..100)));
        assert_eq!(shown(&parts), shown(&whole));
        assert_eq!(whole.rows.capacity(), whole.len());
    }

    #[test]
    fn rows_go_with_their_keys() {
        let from: Vec<u32> = (0..100).map(|k| k * 37 % 100).collect();
        let rows = shown(&table(0..100).taken(&from));
        for (key, rows) in from.iter().zip(rows) {
            assert_eq!(rows, (0..*key).map(|k| [*key, k]).collect::<Vec<_>>());
        }
    }
}
