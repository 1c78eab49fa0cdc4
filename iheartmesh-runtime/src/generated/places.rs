//! The places of a sum of blocks, before it has values: its pattern is made of them.

use std::ops::Range;
use std::sync::Mutex;

use rayon::prelude::*;
use sprs::CsMat;

use super::local_rows::{LocalPlaces, Rows};
use super::missing::{FIRST_MISSING, NO_ELEMENT, is_missing, missing};
use super::pattern::Pattern;
use super::slots::{ArraySlots, Chunk, Heights, Jump, Slots, Whole};
use super::{Fallible, Fault};

/// About as many numbers are evaluated before they are added: they stay in the nearest cache.
const CHUNK: usize = 2048;

/// The size of an array that blocks are added to.
#[derive(Clone, Copy, Debug)]
pub struct Layout {
    /// Whether only places that blocks go to have entries.
    pub sparse: bool,
    /// Number of rows.
    pub rows: usize,
    /// Number of columns.
    pub columns: usize,
}

/// The places of blocks while they are collected.
#[derive(Debug)]
pub struct Places {
    arrays: Vec<ArrayPlaces>,
    /// How many numbers are added up beside the arrays.
    totals: usize,
    /// The array that the next block goes to.
    array: usize,
    /// The rounds of each chunk, sum by sum.
    parts: Vec<Vec<Range<usize>>>,
    /// How many values the last chunk has.
    last: usize,
}

/// The same in one array.
#[derive(Debug)]
struct ArrayPlaces {
    layout: Layout,
    /// Row, column and height.
    pieces: Vec<[u32; 3]>,
    /// Of matrices that are added whole: row and column of each entry, and the entries if they are kept.
    wholes: Vec<(Vec<[u32; 2]>, Vec<f64>)>,
    jumps: Vec<Jump>,
    /// How many of these there were before the current round.
    jumps_before: usize,
    /// The branches around the next block.
    branches: Vec<Branch>,
    parts: Vec<Vec<Chunk>>,
    /// The blocks whose size the mesh decides.
    locals: LocalPlaces,
    /// Whether there are more entries than can be counted.
    too_many: bool,
    /// How many values the current round has, and whether some of its places do not exist.
    values: usize,
    missing: bool,
}

/// Where a branch started.
#[derive(Clone, Copy, Debug)]
struct Branch {
    jump: usize,
    values: usize,
    pieces: usize,
    locals: usize,
}

impl Places {
    /// Of these arrays, with so many numbers beside them.
    pub fn new(arrays: &[Layout], totals: usize) -> Self {
        let empty = |layout: &Layout| ArrayPlaces {
            layout: *layout,
            pieces: Vec::new(),
            wholes: Vec::new(),
            jumps: Vec::new(),
            jumps_before: 0,
            branches: Vec::new(),
            parts: Vec::new(),
            locals: LocalPlaces::default(),
            too_many: false,
            values: 0,
            missing: false,
        };
        Self {
            arrays: arrays.iter().map(empty).collect(),
            totals,
            array: 0,
            parts: Vec::new(),
            last: 0,
        }
    }

    /// Starts the next sum.
    pub fn part(&mut self) {
        self.parts.push(Vec::new());
        for array in &mut self.arrays {
            array.parts.push(Vec::new());
            (array.values, array.missing) = (0, false);
        }
    }

    /// The array that the next blocks go to.
    #[inline(always)]
    pub fn array(&mut self, array: usize) {
        self.array = array;
    }

    /// Ends a round of the loop of the current sum.
    #[inline]
    pub fn end_round(&mut self) {
        let Some(part) = self.parts.last_mut() else {
            return;
        };
        let values: usize = self.arrays.iter().map(|array| array.values).sum();
        let is_new = match part.last_mut() {
            Some(rounds) if self.last < CHUNK => {
                rounds.end += 1;
                self.last += values + self.totals;
                false
            }
            last => {
                let round = last.map_or(0, |rounds| rounds.end);
                part.push(round..round + 1);
                self.last = values + self.totals;
                true
            }
        };
        for array in &mut self.arrays {
            array.end_round(is_new);
        }
    }

    /// A sparse matrix of the pattern of other slots that is added whole.
    pub fn pattern(&mut self, slots: &Slots) {
        let pattern = slots.pattern(0);
        let mut places = Vec::with_capacity(pattern.entries);
        for (column, range) in pattern.pointers.windows(2).enumerate() {
            let rows = pattern.indices.get(range[0]..range[1]).unwrap_or_default();
            places.extend(rows.iter().map(|row| [*row as u32, column as u32]));
        }
        self.arrays[self.array].wholes.push((places, Vec::new()));
    }

    /// A sparse matrix that is added whole, and does not depend on values.
    pub fn matrix(&mut self, matrix: &CsMat<f64>) {
        let entries = matrix.iter();
        let entries = entries.map(|(value, (row, column))| ([row as u32, column as u32], *value));
        self.arrays[self.array].wholes.push(entries.unzip());
    }

    /// Starts a branch that depends on values; one of a block, while one is put together.
    pub fn enter(&mut self) {
        match self.arrays.get_mut(self.array) {
            Some(array) if array.locals.is_open() => array.locals.enter(),
            _ => self.arrays.iter_mut().for_each(ArrayPlaces::enter),
        }
    }

    /// Ends a branch: notes what is in it.
    pub fn leave(&mut self) {
        match self.arrays.get_mut(self.array) {
            Some(array) if array.locals.is_open() => array.locals.leave(),
            _ => self.arrays.iter_mut().for_each(ArrayPlaces::leave),
        }
    }

    /// Starts a block of the array of [`Places::array`] that is put together from those that follow.
    pub fn start_local(&mut self) {
        self.arrays[self.array].locals.start();
    }

    /// Ends such a block. Its rows are in pieces of at most a height.
    pub fn end_local(&mut self, height: usize) {
        self.arrays[self.array].end_local(height, None);
    }

    /// Ends such a block, of which only the product with so many columns is added.
    pub fn end_local_product(&mut self, height: usize, columns: usize) {
        self.arrays[self.array].end_local(height, Some(columns));
    }

    /// A block of the array of [`Places::array`], see [`ArrayPlaces::block`].
    pub fn block<const N: usize, const M: usize>(
        &mut self,
        places: Fallible<([usize; N], [usize; M])>,
        height: usize,
        width: usize,
    ) {
        self.arrays[self.array].block(places, height, width);
    }

    /// The patterns and the places in them.
    ///
    /// # Errors
    /// When there are more entries than `u32` can count.
    pub fn finish(self, fault: Fault) -> Fallible<Slots> {
        let arrays = self.arrays.into_iter().map(|array| array.finish(fault));
        Ok(Slots {
            arrays: arrays.collect::<Fallible<_>>()?,
            parts: self.parts,
            scratch: Mutex::default(),
        })
    }
}

impl ArrayPlaces {
    fn end_round(&mut self, is_new: bool) {
        let start = self.before_round();
        let Some(part) = self.parts.last_mut() else {
            return;
        };
        if is_new {
            part.push(Chunk {
                pieces: start..start,
                jumps: self.jumps_before,
                locals: self.locals.before,
                values: 0,
                missing: false,
            });
        }
        if let Some(chunk) = part.last_mut() {
            chunk.pieces.end = self.pieces.len();
            chunk.values += self.values;
            chunk.missing |= self.missing;
        }
        (self.values, self.missing) = (0, false);
        self.jumps_before = self.jumps.len();
        self.locals.before = self.locals.all.steps.len();
    }

    fn enter(&mut self) {
        self.branches.push(Branch {
            jump: self.jumps.len(),
            values: self.values,
            pieces: self.pieces.len(),
            locals: self.locals.all.steps.len(),
        });
        self.jumps.push(Jump {
            values: 0,
            pieces: 0,
            jumps: 0,
            locals: 0,
        });
    }

    fn leave(&mut self) {
        let Some(branch) = self.branches.pop() else {
            return;
        };
        let inside = self.jumps.len() - branch.jump - 1;
        if let Some(jump) = self.jumps.get_mut(branch.jump) {
            // more than that fails in the end
            *jump = Jump {
                values: u32::try_from(self.values - branch.values).unwrap_or(u32::MAX),
                pieces: u32::try_from(self.pieces.len() - branch.pieces).unwrap_or(u32::MAX),
                jumps: u32::try_from(inside).unwrap_or(u32::MAX),
                locals: u32::try_from(self.locals.all.steps.len() - branch.locals)
                    .unwrap_or(u32::MAX),
            };
        }
    }

    /// The number of pieces before the current round.
    fn before_round(&self) -> usize {
        let last = self.parts.iter().rev().find_map(|part| part.last());
        last.map_or(0, |chunk| chunk.pieces.end)
    }

    /// A block whose rows start at these places, in parts of a height, and its columns likewise, or in the first where there
    /// are none; a reason where there is no such place.
    fn block<const N: usize, const M: usize>(
        &mut self,
        places: Fallible<([usize; N], [usize; M])>,
        height: usize,
        width: usize,
    ) {
        let within = |places: &[usize], part: usize, size: usize| {
            let end = |p: &usize| p.checked_add(1).and_then(|p| p.checked_mul(part));
            places.iter().all(|p| end(p).is_some_and(|end| end <= size))
        };
        let layout = self.layout;
        let is_local = self.locals.is_open();
        // a block that is only multiplied is square, whatever the array is
        let most_columns = match is_local {
            true => layout.rows,
            false => layout.columns,
        };
        let is_within = |rows: &[usize], columns: &[usize]| {
            within(rows, height, layout.rows) && within(columns, width, most_columns)
        };
        let (rows, columns, why) = match places {
            Ok((rows, columns)) if is_within(&rows, &columns) => (rows, columns, None),
            Ok(_) => ([0; N], [0; M], Some(NO_ELEMENT)),
            Err(fault) => ([0; N], [0; M], Some(missing(fault))),
        };
        if is_local {
            match why {
                Some(why) => self.locals.missing(N + M, why),
                None => {
                    self.locals.parts(rows.map(|row| row * height), height);
                    self.locals
                        .parts(columns.map(|column| column * width), width);
                }
            }
            return;
        }
        self.values += N * height * M.max(1) * width;
        self.missing |= why.is_some();
        let columns = match M {
            0 => &[0],
            _ => &columns[..],
        };
        for column in columns {
            for j in 0..width {
                for row in rows {
                    let row = why.unwrap_or((row * height) as u32);
                    let column = (column * width + j) as u32;
                    self.pieces.push([row, column, height as u32]);
                }
            }
        }
    }

    /// Ends a block: all its rows in each of its columns, or in each of so many columns of its product.
    fn end_local(&mut self, height: usize, columns: Option<usize>) {
        let Some(Rows { rows, runs }) = self.locals.end(height, columns.is_some()) else {
            return;
        };
        let values = rows.len().checked_mul(columns.unwrap_or(rows.len()));
        let values = values.and_then(|values| values.checked_add(self.values));
        let Some(values) = values.filter(|n| *n < FIRST_MISSING as usize) else {
            self.too_many = true;
            return;
        };
        self.values = values;
        let mut column = |column: u32| {
            let runs = runs.iter();
            self.pieces
                .extend(runs.map(|[row, height]| [*row, column, *height]));
        };
        match columns {
            None => rows.iter().for_each(|row| column(*row)),
            Some(columns) => (0..columns as u32).for_each(column),
        }
    }

    /// The pattern and the places in it.
    ///
    /// # Errors
    /// When there are more entries than `u32` can count.
    fn finish(self, fault: Fault) -> Fallible<ArraySlots> {
        let Layout {
            sparse,
            rows,
            columns,
        } = self.layout;
        let largest = FIRST_MISSING as usize;
        let values = self.parts.iter().flatten().map(|chunk| chunk.values).max();
        if rows >= largest
            || columns >= largest
            || self.pieces.len() >= largest
            || self.jumps.len() >= largest
            || values.is_some_and(|n| n >= largest)
            || self.too_many
            || self.locals.all.steps.len() >= largest
        {
            return Err(fault);
        }
        if !sparse {
            let entries = rows.checked_mul(columns);
            let Some(entries) = entries.filter(|n| *n < largest) else {
                return Err(fault);
            };
            let rows = rows as u32;
            let slot = |[row, column, _]: &[u32; 3]| match *row {
                row if is_missing(row) => row,
                row => column * rows + row,
            };
            let slots = self.pieces.iter().map(slot).collect();
            return Ok(self.with_slots(slots, Vec::new(), entries, Vec::new(), Vec::new()));
        }
        let there = |piece: &&[u32; 3]| !is_missing(piece[0]);
        let mut starts = vec![0usize; columns + 1];
        for [_, column, height] in self.pieces.iter().filter(there) {
            starts[*column as usize + 1] += *height as usize;
        }
        for [_, column] in self.wholes.iter().flat_map(|(places, _)| places) {
            starts[*column as usize + 1] += 1;
        }
        for k in 0..columns {
            starts[k + 1] += starts[k];
        }
        let mut next = starts.clone();
        let mut found = vec![0u32; starts[columns]];
        for [row, column, height] in self.pieces.iter().filter(there) {
            for k in 0..*height {
                let place = &mut next[*column as usize];
                found[*place] = row + k;
                *place += 1;
            }
        }
        for [row, column] in self.wholes.iter().flat_map(|(places, _)| places) {
            let place = &mut next[*column as usize];
            found[*place] = *row;
            *place += 1;
        }
        let mut sorted = Vec::with_capacity(columns);
        let mut rest = found.as_mut_slice();
        for k in 0..columns {
            let (column, after) = rest.split_at_mut(starts[k + 1] - starts[k]);
            sorted.push(column);
            rest = after;
        }
        sorted
            .par_iter_mut()
            .for_each(|column| column.sort_unstable());
        let mut pointers = Vec::with_capacity(columns + 1);
        let mut indices: Vec<usize> = Vec::new();
        pointers.push(0);
        for column in sorted {
            let first = indices.len();
            for row in column {
                let row = *row as usize;
                if indices[first..].last() != Some(&row) {
                    indices.push(row);
                }
            }
            pointers.push(indices.len());
        }
        if indices.len() >= largest {
            return Err(fault);
        }
        let slot = |row: u32, column: u32| -> u32 {
            if is_missing(row) {
                return row;
            }
            let (start, end) = (pointers[column as usize], pointers[column as usize + 1]);
            match indices[start..end].binary_search(&(row as usize)) {
                Ok(k) => (start + k) as u32,
                Err(_) => NO_ELEMENT,
            }
        };
        let slots = self.pieces.par_iter();
        let slots = slots.map(|[row, column, _]| slot(*row, *column)).collect();
        let wholes = self.wholes.iter().map(|(places, values)| Whole {
            slots: places
                .iter()
                .map(|[row, column]| slot(*row, *column))
                .collect(),
            values: values.clone(),
        });
        let wholes = wholes.collect();
        let entries = indices.len();
        Ok(self.with_slots(slots, wholes, entries, pointers, indices))
    }

    fn with_slots(
        self,
        slots: Vec<u32>,
        wholes: Vec<Whole>,
        entries: usize,
        pointers: Vec<usize>,
        indices: Vec<usize>,
    ) -> ArraySlots {
        let height = self.pieces.first().map_or(1, |piece| piece[2]);
        let heights = match self.pieces.iter().all(|piece| piece[2] == height) {
            true => Heights::All(height as usize),
            false => Heights::Each(self.pieces.iter().map(|piece| piece[2]).collect()),
        };
        ArraySlots {
            pattern: Pattern {
                rows: self.layout.rows,
                columns: self.layout.columns,
                entries,
                pointers,
                indices,
            },
            slots,
            heights,
            wholes,
            jumps: self.jumps,
            locals: self.locals.all,
            parts: self.parts,
        }
    }
}
