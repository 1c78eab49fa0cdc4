//! The blocks of first and second derivatives of a formula.

use std::collections::BTreeMap;

use super::ENTRIES;
use super::differentiate::{Leaves, Sparse};
use super::formula::{Formulas, Item};
use crate::ir::{Block, ExprId, Kind};
use crate::types::{Dimension, Type};

impl Formulas<'_, '_> {
    /// The items that a formula takes, with all of their entries in order.
    fn stencil(&mut self) -> Option<(Vec<Item>, Vec<ExprId>)> {
        let items: Vec<Item> = self.items.values().cloned().collect();
        let entries: Vec<ExprId> = items.iter().flat_map(|i| i.entries.clone()).collect();
        let each = items.first().map_or(0, |item| item.entries.len());
        let even = items.iter().all(|item| item.entries.len() == each);
        (even && entries.len() <= ENTRIES).then_some((items, entries))
    }

    fn matrix(&mut self, n: usize, entry: impl Fn(usize, usize) -> ExprId) -> ExprId {
        let size = Dimension::known(n as i64);
        let rows = (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect());
        match n {
            1 => entry(0, 0),
            _ => self.normal.program.arena.add(
                Kind::Blocks(rows.collect()),
                Type::real_matrix(size.clone(), size),
            ),
        }
    }

    /// The first derivatives of a formula; no block where they are 0.
    pub(super) fn first_block(&mut self, e: ExprId) -> Option<Option<Block>> {
        let (items, entries) = self.stencil()?;
        let leaves = Leaves::new(entries);
        let gradient = self.gradient(e, &leaves)?;
        if gradient.is_empty() {
            return Some(None);
        }
        let zero = self.numbers().real(0.0);
        let entry = |k| gradient.get(&k).copied().unwrap_or(zero);
        let n = leaves.all.len();
        let value = match n {
            1 => entry(0),
            _ => self.normal.program.arena.add(
                Kind::Vector((0..n).map(entry).collect()),
                Type::real_vector(Dimension::known(n as i64)),
            ),
        };
        Some(Some(Block {
            rows: items.iter().map(|item| item.place).collect(),
            columns: Vec::new(),
            value,
            core: None,
        }))
    }

    /// First derivatives in a row of a matrix.
    pub(super) fn in_row(&mut self, block: Block, row: ExprId) -> Block {
        let mut s = self.normal.algebra();
        let value = match s.ty(block.value).is_scalar() {
            true => block.value,
            false => s.transpose(block.value),
        };
        Block {
            rows: vec![row],
            columns: block.rows,
            value,
            core: None,
        }
    }

    /// The second derivatives of a formula; no block where they are 0.
    pub(super) fn second_block(&mut self, e: ExprId) -> Option<Option<Block>> {
        let (items, entries) = self.stencil()?;
        let n = entries.len();
        let zero = self.numbers().real(0.0);
        let mut frontier = self.frontier(e, &entries);
        if frontier.len() >= n {
            frontier.clone_from(&entries);
        }
        let small = frontier.len();
        let leaves = Leaves::new(frontier);
        let inner = self.second(e, &leaves)?;
        if inner.is_empty() {
            return Some(None);
        }
        let core = |i: usize, j: usize| {
            let entry = inner.get(&(i.max(j), i.min(j)));
            entry.copied().unwrap_or(zero)
        };
        let mut block = Block {
            rows: items.iter().map(|item| item.place).collect(),
            columns: items.iter().map(|item| item.place).collect(),
            value: zero,
            core: None,
        };
        if leaves.all == entries {
            block.value = self.matrix(n, core);
            return Some(Some(block));
        }
        let by_entries = Leaves::new(entries);
        let mut linear = Vec::new();
        for y in &leaves.all {
            linear.push(self.gradient(*y, &by_entries)?);
        }
        let outer = self.expanded(small, &core, &linear, items.len(), n);
        let outer = |i: usize, j: usize| {
            let entry = outer.get(&(i.max(j), i.min(j)));
            entry.copied().unwrap_or(zero)
        };
        block.value = self.matrix(n, outer);
        if small < n {
            block.core = Some(self.matrix(small, core));
        }
        Some(Some(block))
    }

    /// The lower triangle of `Bᵀ K B`; the rows of `B` are given.
    fn expanded(
        &mut self,
        small: usize,
        core: &impl Fn(usize, usize) -> ExprId,
        linear: &[Sparse],
        items: usize,
        n: usize,
    ) -> BTreeMap<(usize, usize), ExprId> {
        let each = n / items;
        let left_out = self.left_out(linear, items, each);
        let is_in = |k: usize| left_out != Some(k / each);
        let mut all = BTreeMap::new();
        for j in (0..n).filter(|j| is_in(*j)) {
            // a column of K B
            let column = linear.iter().enumerate();
            let column: Vec<_> = column
                .filter_map(|(y, row)| Some((y, *row.get(&j)?)))
                .collect();
            let product: Vec<ExprId> = (0..small)
                .map(|i| {
                    let mut s = self.numbers();
                    let zero = s.real(0.0);
                    column.iter().fold(zero, |sum, (y, b)| {
                        let term = s.multiply(core(i, *y), *b);
                        s.add(sum, term)
                    })
                })
                .collect();
            for i in (j..n).filter(|i| is_in(*i)) {
                let mut s = self.numbers();
                let mut sum = s.real(0.0);
                for (y, row) in linear.iter().enumerate() {
                    if let Some(b) = row.get(&i) {
                        let term = s.multiply(*b, product[y]);
                        sum = s.add(sum, term);
                    }
                }
                all.insert((i, j), sum);
            }
        }
        let Some(out) = left_out else {
            return all;
        };
        // minus the sum over the other items, first across, then down
        let at = |all: &BTreeMap<(usize, usize), ExprId>, i: usize, j: usize| {
            all.get(&(i.max(j), i.min(j))).copied()
        };
        let others: Vec<usize> = (0..items).filter(|p| *p != out).collect();
        for columns in [&others[..], &[out]] {
            for j in columns.iter().flat_map(|p| p * each..(p + 1) * each) {
                for k in 0..each {
                    let i = out * each + k;
                    let mut sum = self.numbers().real(0.0);
                    for p in &others {
                        if let Some(entry) = at(&all, p * each + k, j) {
                            sum = self.numbers().add(sum, entry);
                        }
                    }
                    let sum = self.numbers().negate(sum);
                    all.insert((i.max(j), i.min(j)), sum);
                }
            }
        }
        all
    }

    /// An item whose part follows from those of the others, since moving all of them together changes nothing: the one
    /// with the longest formulas.
    fn left_out(&mut self, linear: &[Sparse], items: usize, each: usize) -> Option<usize> {
        let mut lengths = vec![0; items];
        for row in linear {
            for k in 0..each {
                let mut sum = BTreeMap::new();
                for (p, length) in lengths.iter_mut().enumerate() {
                    if let Some(entry) = row.get(&(p * each + k)) {
                        let mut own = BTreeMap::new();
                        self.numbers().terms(*entry, 1.0, &mut own);
                        *length += own.len();
                        for (term, count) in own {
                            *sum.entry(term).or_insert(0.0) += count;
                        }
                    }
                }
                if sum.values().any(|count| *count != 0.0) {
                    return None;
                }
            }
        }
        let longest = (0..items).max_by_key(|p| lengths[*p]);
        longest.filter(|_| items > 1)
    }
}
