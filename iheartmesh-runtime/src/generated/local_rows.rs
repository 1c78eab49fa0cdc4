//! Which rows the block of one term has, where the mesh decides how many: found once, before there are values.
//!
//! Of each such block [`LocalRows`] lists in the order of its evaluation
//!
//! 1. `n`, the number of its rows, and in how many pieces each of its columns is added to the array,
//! 2. for each part of it that is added, where its rows and its columns start among the `n`: as many numbers as it has
//!    places; where there is no such place the reason, see [`super::missing`]; before a branch that depends on values, how
//!    many numbers are in it,
//! 3. if it is only multiplied: its rows in the array.
//!
//! The rows are all those that some part has, ascending, so that those of a part, which follow one another in the array, do so in the
//! block as well. A row that several parts have is there once.

use super::symmetric;

/// All such blocks of an array, one after the other.
#[derive(Debug, Default)]
pub(super) struct LocalRows {
    pub(super) steps: Vec<u32>,
    /// How many numbers of memory the evaluation needs beside the values.
    pub(super) memory: usize,
}

/// The same while they are collected.
#[derive(Debug, Default)]
pub(super) struct LocalPlaces {
    pub(super) all: LocalRows,
    /// How many steps there were before the current round.
    pub(super) before: usize,
    open: Option<Open>,
}

/// A block that is collected.
#[derive(Debug)]
struct Open {
    /// Where it starts in the steps.
    start: usize,
    /// Its rows so far.
    rows: Vec<u32>,
    /// Which steps are rows of the array, to become rows of the block.
    places: Vec<usize>,
    /// Where the branches around the next part start.
    branches: Vec<usize>,
}

/// What a block has become.
pub(super) struct Rows {
    /// Its rows in the array, ascending.
    pub(super) rows: Vec<u32>,
    /// Where runs of rows start in the array, and how many each has.
    pub(super) runs: Vec<[u32; 2]>,
}

impl LocalPlaces {
    /// Whether a block is being collected.
    pub(super) fn is_open(&self) -> bool {
        self.open.is_some()
    }

    pub(super) fn start(&mut self) {
        self.open = Some(Open {
            start: self.all.steps.len(),
            rows: Vec::new(),
            places: Vec::new(),
            branches: Vec::new(),
        });
        self.all.steps.extend([0, 0]);
    }

    /// Parts of a height that start at these rows of the array.
    pub(super) fn parts<const N: usize>(&mut self, starts: [usize; N], height: usize) {
        if let Some(open) = &mut self.open {
            for start in starts {
                let start = start as u32;
                open.places.push(self.all.steps.len());
                self.all.steps.push(start);
                open.rows.extend(start..start + height as u32);
            }
        }
    }

    /// So many places that do not exist, for a reason.
    pub(super) fn missing(&mut self, count: usize, why: u32) {
        self.all.steps.extend(std::iter::repeat_n(why, count));
    }

    /// Starts a branch that depends on values.
    pub(super) fn enter(&mut self) {
        if let Some(open) = &mut self.open {
            open.branches.push(self.all.steps.len());
            self.all.steps.push(0);
        }
    }

    /// Ends a branch.
    pub(super) fn leave(&mut self) {
        if let Some(start) = self.open.as_mut().and_then(|open| open.branches.pop()) {
            self.all.steps[start] = (self.all.steps.len() - start - 1) as u32;
        }
    }

    /// Ends a block. Its rows are in pieces of at most a height, as the items of what it is differentiated by.
    pub(super) fn end(&mut self, height: usize, is_multiplied: bool) -> Option<Rows> {
        let Open {
            start,
            mut rows,
            places,
            ..
        } = self.open.take()?;
        rows.sort_unstable();
        rows.dedup();
        for place in places {
            let step = &mut self.all.steps[place];
            *step = rows.binary_search(step).unwrap_or(0) as u32;
        }
        let n = rows.len();
        let mut runs: Vec<[u32; 2]> = Vec::new();
        for row in &rows {
            match runs.last_mut() {
                Some([first, count])
                    if *first + *count == *row && !(*row as usize).is_multiple_of(height) =>
                {
                    *count += 1;
                }
                _ => runs.push([*row, 1]),
            }
        }
        self.all.steps[start..start + 2].copy_from_slice(&[n as u32, runs.len() as u32]);
        let mut memory = symmetric::memory(n);
        if is_multiplied {
            self.all.steps.extend(&rows);
            memory += n * n;
        }
        self.all.memory = self.all.memory.max(memory);
        Some(Rows { rows, runs })
    }
}
