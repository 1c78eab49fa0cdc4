//! Groups of rows whose terms are computed together.

mod order;

use std::hint::black_box;
use std::ops::{AddAssign, Range};

use rayon::prelude::*;

use super::all::is_parallel;
use super::{Fallible, Keys, Rows, Table, for_each_element, is_missing};

/// A sum whose terms are computed in groups.
///
/// The methods are inlined into loops over groups: a closure with so much in it, called at several places, would not be.
pub trait Grouped<const A: usize, const M: usize, const N: usize>: Sync {
    /// The type of the terms and of their sum.
    type Term: Copy + AddAssign + Send + Sync;
    /// The type of the values.
    type Value: Clone + Send + Sync;

    /// The sum of no terms.
    fn zero(&self) -> Self::Term;

    /// Reads what the terms of a group need, without computing with it.
    fn touch(&self, elements: &[u32; A]) -> u64;

    /// The terms of a group from the elements of its first row.
    ///
    /// # Errors
    /// When a term has no value.
    fn terms(&self, elements: [u32; A]) -> Fallible<[Self::Term; M]>;

    /// The term of a single row.
    ///
    /// # Errors
    /// When it has no value.
    fn term(&self, key: u32, row: &[u32; N]) -> Fallible<Self::Term>;

    /// The value of a key from the sum of its terms.
    ///
    /// # Errors
    /// When it has no value.
    fn rest(&self, key: u32, sum: Self::Term) -> Fallible<Self::Value>;
}

/// Groups of `M` rows with `A` elements each; the elements of each row of a group are those of the row before it,
/// exchanged. The first element of a row is its key.
#[derive(Clone, Debug)]
pub struct Orbits<const A: usize, const M: usize> {
    n_keys: usize,
    /// The elements of the first row of each group; in the order of the first sum that a group is added to.
    groups: Vec<[u32; A]>,
    /// Rows that belong to no group: key and number of the row; in the order of the sums.
    singles: Vec<[u32; 2]>,
    /// Which elements of the first row are the keys of the rows of a group.
    keys: [usize; M],
    /// Where the sum of each key stands, when the numbering of the keys is not local.
    rank: Option<Vec<u32>>,
    /// Then, where the sums of the keys of each group stand.
    targets: Option<Vec<[u32; M]>>,
    /// Number of sums in a block.
    block_size: usize,
    blocks: Vec<Block>,
}

/// What consecutive sums need.
#[derive(Clone, Debug, Default)]
struct Block {
    /// The end of the groups whose first sum is in this block or before.
    groups_end: u32,
    /// The end of the singles whose sum is in this block or before.
    singles_end: u32,
    /// Groups of earlier blocks that have sums in this one too; ascending.
    foreign: Vec<u32>,
}

/// About so many blocks, of which threads take several at a time.
const BLOCKS: usize = 256;
/// So many groups are read at once where they are not in the order of memory.
const BATCH: usize = 32;
/// The least number of sums in a block.
const LEAST_BLOCK: usize = 256;

/// Groups in which fewer rows than this part take part are not worth it.
const LEAST_PART: f64 = 0.5;

impl<const A: usize, const M: usize> Orbits<A, M> {
    /// Finds the groups of a table whose rows hold the elements after the key in these columns. `None` when few rows
    /// belong to groups. `order` is that of the keys of the table.
    pub fn build<const N: usize>(
        table: &Table<N>,
        columns: &[usize],
        permutation: [usize; A],
        order: Keys<'_>,
    ) -> Option<Self> {
        // where the numbering is not local, the rows are walked in a copy of the table that is
        let copy = order.vertices_in_order().map(|keys| table.taken(keys));
        let near = copy.as_ref().unwrap_or(table);
        let place = |key: u32| match order.rank() {
            None => key as usize,
            Some(rank) => rank[key as usize] as usize,
        };
        let elements = |key: u32, row: &[u32; N]| -> [u32; A] {
            std::array::from_fn(|k| if k == 0 { key } else { row[columns[k - 1]] })
        };
        let n_keys = table.n_keys();
        let mut groups = Vec::with_capacity(table.len() / M + 1);
        let mut singles = Vec::new();
        let mut taken = vec![false; table.len()];
        for (of_key, key) in order.at(0..n_keys as u32).enumerate() {
            for (number, row) in near.enumerate_rows_of(of_key) {
                if taken[number] {
                    continue;
                }
                let first = elements(key, row);
                let mut members = [number; M];
                let mut current = first;
                let mut complete = !first.iter().any(|element| is_missing(*element));
                for member in members.iter_mut().skip(1) {
                    if !complete {
                        break;
                    }
                    let next: [u32; A] = std::array::from_fn(|k| current[permutation[k]]);
                    let partner = next[0];
                    let found = ((partner as usize) < n_keys).then(|| {
                        near.enumerate_rows_of(place(partner))
                            .find(|(other, row)| {
                                *other != number && !taken[*other] && elements(partner, row) == next
                            })
                            .map(|(other, _)| other)
                    });
                    match found.flatten() {
                        Some(other) => *member = other,
                        None => complete = false,
                    }
                    current = next;
                }
                let distinct = (1..M).all(|k| !members[..k].contains(&members[k]));
                if complete && distinct {
                    groups.push(first);
                    members.iter().for_each(|member| taken[*member] = true);
                } else {
                    let of_key = number - near.range(of_key).start;
                    singles.push([key, (table.range(key as usize).start + of_key) as u32]);
                    taken[number] = true;
                }
            }
        }
        if ((groups.len() * M) as f64) < LEAST_PART * table.len() as f64 {
            return None;
        }
        let mut keys = [0; M];
        let mut current: [usize; A] = std::array::from_fn(|k| k);
        for key in keys.iter_mut().skip(1) {
            current = std::array::from_fn(|k| current[permutation[k]]);
            *key = current[0];
        }
        let (groups, singles, rank) = match order.rank() {
            Some(rank) => (groups, singles, Some(rank.to_vec())),
            None if order::is_coherent(n_keys, &groups, &keys) => (groups, singles, None),
            None => {
                let rank = order::breadth_first(n_keys, &groups, &keys);
                let groups = order::sorted_by_rank(n_keys, groups, |g| first_rank(&rank, g, &keys));
                let singles = order::sorted_by_rank(n_keys, singles, |s| rank[s[0] as usize]);
                (groups, singles, Some(rank))
            }
        };
        Some(Self::with_blocks(n_keys, groups, singles, keys, rank))
    }

    fn with_blocks(
        n_keys: usize,
        groups: Vec<[u32; A]>,
        singles: Vec<[u32; 2]>,
        keys: [usize; M],
        rank: Option<Vec<u32>>,
    ) -> Self {
        let block_size = n_keys.div_ceil(BLOCKS).max(LEAST_BLOCK);
        let n_blocks = n_keys.div_ceil(block_size);
        let targets: Option<Vec<[u32; M]>> = rank.as_ref().map(|rank| {
            let targets = |g: &[u32; A]| keys.map(|k| rank[g[k] as usize]);
            groups.par_iter().map(targets).collect()
        });
        let mut blocks = vec![Block::default(); n_blocks];
        for number in 0..groups.len() {
            let targets = match &targets {
                None => keys.map(|k| groups[number][k]),
                Some(targets) => targets[number],
            };
            let of = targets.map(|target| target as usize / block_size);
            let own = of.iter().copied().min().unwrap_or(0);
            blocks[own].groups_end = number as u32 + 1;
            for (k, &block) in of.iter().enumerate() {
                if block != own && !of[..k].contains(&block) {
                    blocks[block].foreign.push(number as u32);
                }
            }
        }
        for (number, single) in (1u32..).zip(&singles) {
            let target = rank.as_ref().map_or(single[0], |r| r[single[0] as usize]);
            blocks[target as usize / block_size].singles_end = number;
        }
        let (mut groups_end, mut singles_end) = (0, 0);
        for block in &mut blocks {
            groups_end = block.groups_end.max(groups_end);
            singles_end = block.singles_end.max(singles_end);
            (block.groups_end, block.singles_end) = (groups_end, singles_end);
        }
        Self {
            n_keys,
            groups,
            singles,
            keys,
            rank,
            targets,
            block_size,
            blocks,
        }
    }

    /// The value of each key. Every sum is formed in the same order, whatever the number of threads. `None` when any of them
    /// has no value.
    pub fn values<const N: usize, G: Grouped<A, M, N>>(
        &self,
        table: &Table<N>,
        of: &G,
    ) -> Option<Vec<G::Value>> {
        let mut sums = vec![of.zero(); self.n_keys];
        let is_parallel = is_parallel(self.n_keys);
        if is_parallel {
            // the larger the pieces, the fewer groups belong to two of them
            let pieces = 4 * rayon::current_num_threads();
            let piece = self.blocks.len().div_ceil(pieces).max(1);
            sums.par_chunks_mut(piece * self.block_size)
                .enumerate()
                .map(|(k, sums)| {
                    let blocks = k * piece..self.blocks.len().min((k + 1) * piece);
                    self.add_terms(blocks, sums, table, of)
                })
                .reduce(|| Some(()), |a, b| a.and(b))?;
        } else {
            self.add_terms(0..self.blocks.len(), &mut sums, table, of)?;
        }
        let rest = |key, sum| of.rest(key, sum);
        match &self.rank {
            // the memory of the sums is used again
            None if !is_parallel => {
                let keys = sums.into_iter().enumerate();
                keys.map(|(key, sum)| rest(key as u32, sum).ok()).collect()
            }
            None => for_each_element(self.n_keys, |key| rest(key, sums[key as usize])).ok(),
            Some(rank) => for_each_element(self.n_keys, |key| {
                rest(key, sums[rank[key as usize] as usize])
            })
            .ok(),
        }
    }

    /// Adds the terms of the keys of some blocks. A group with keys in other blocks too is evaluated there again, so
    /// that no two threads write to the same place.
    #[inline(never)]
    fn add_terms<const N: usize, G: Grouped<A, M, N>>(
        &self,
        blocks: Range<usize>,
        sums: &mut [G::Term],
        table: &Table<N>,
        of: &G,
    ) -> Option<()> {
        let first_key = blocks.start * self.block_size;
        let before = |block: usize| match block.checked_sub(1) {
            None => (0, 0),
            Some(k) => (self.blocks[k].groups_end, self.blocks[k].singles_end),
        };
        let (start, singles_start) = before(blocks.start);
        let (end, singles_end) = before(blocks.end);
        for block in blocks {
            let first = block * self.block_size;
            let range = first..first + self.block_size;
            let foreign = &self.blocks[block].foreign;
            for &group in foreign.iter().take_while(|group| **group < start) {
                let values = terms_apart(of, self.groups[group as usize])?;
                for (target, value) in self.targets_of(group as usize).into_iter().zip(values) {
                    if range.contains(&(target as usize)) {
                        sums[target as usize - first_key] += value;
                    }
                }
            }
        }
        let own = start as usize..end as usize;
        // keys of other pieces are beyond the end, those before the first one by wrapping around
        let mut add = |targets: [u32; M], values: [G::Term; M]| {
            for (target, value) in targets.into_iter().zip(values) {
                if let Some(sum) = sums.get_mut((target as usize).wrapping_sub(first_key)) {
                    *sum += value;
                }
            }
        };
        match &self.targets {
            None => {
                for group in &self.groups[own] {
                    add(self.keys.map(|k| group[k]), of.terms(*group).ok()?);
                }
            }
            Some(targets) => {
                let groups = self.groups[own.clone()].chunks(BATCH);
                for (groups, targets) in groups.zip(targets[own].chunks(BATCH)) {
                    // read at once what comes from all over memory, so that the reads do not wait for each other
                    black_box(groups.iter().fold(0, |all, group| all ^ of.touch(group)));
                    for (group, targets) in groups.iter().zip(targets) {
                        add(*targets, of.terms(*group).ok()?);
                    }
                }
            }
        }
        for &[key, number] in &self.singles[singles_start as usize..singles_end as usize] {
            let target = self.rank.as_ref().map_or(key, |rank| rank[key as usize]);
            sums[target as usize - first_key] +=
                of.term(key, &table.rows()[number as usize]).ok()?;
        }
        Some(())
    }

    #[inline]
    fn targets_of(&self, group: usize) -> [u32; M] {
        match &self.targets {
            None => self.keys.map(|k| self.groups[group][k]),
            Some(targets) => targets[group],
        }
    }
}

/// The terms of a group, where this is rarely needed.
#[inline(never)]
fn terms_apart<const A: usize, const M: usize, const N: usize, G: Grouped<A, M, N>>(
    of: &G,
    elements: [u32; A],
) -> Option<[G::Term; M]> {
    of.terms(elements).ok()
}

fn first_rank<const A: usize, const M: usize>(
    rank: &[u32],
    group: &[u32; A],
    keys: &[usize; M],
) -> u32 {
    let ranks = keys.iter().map(|k| rank[group[*k] as usize]);
    ranks.min().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::FaceMesh;
    use crate::generated::Faces;

    const SIDE: u32 = 50;

    /// The triangles of a grid, the corners after each vertex in them, and their groups.
    fn grid(number: impl Fn(u32) -> u32) -> (Vec<[u32; 3]>, FaceMesh, Table<2>) {
        let mut triangles = Vec::new();
        for (x, y) in (0..SIDE - 1).flat_map(|y| (0..SIDE - 1).map(move |x| (x, y))) {
            let corner = |a: u32, b: u32| number((y + b) * SIDE + x + a);
            triangles.push([corner(0, 0), corner(1, 0), corner(1, 1)]);
            triangles.push([corner(1, 1), corner(0, 1), corner(0, 0)]);
        }
        let mesh = FaceMesh::from_triangles((SIDE * SIDE) as usize, &triangles).unwrap();
        let mut table = Table::with_capacity((SIDE * SIDE) as usize);
        for vertex in 0..SIDE * SIDE {
            for &face in mesh.faces_around(vertex) {
                table.push([-1, 1].map(|sign| mesh.beside(face, vertex, sign).unwrap()));
            }
            table.finish_key().unwrap();
        }
        (triangles, mesh, table)
    }

    fn turned(triangle: &[u32; 3]) -> [u32; 3] {
        let mut turned = *triangle;
        let least = (0..3).min_by_key(|k| triangle[*k]).unwrap();
        turned.rotate_left(least);
        turned
    }

    fn check(number: impl Fn(u32) -> u32, is_local: bool) {
        let (triangles, mesh, table) = grid(number);
        let order = Keys::vertices(mesh.complex());
        let orbits = Orbits::<3, 3>::build(&table, &[0, 1], [1, 2, 0], order).unwrap();
        assert_eq!(orbits.rank.is_none(), is_local);
        assert!(orbits.singles.is_empty());
        let place = |key: u32| orbits.rank.as_ref().map_or(key, |rank| rank[key as usize]);
        // each triangle once, from its first corner in the order of the sums, these in order
        let firsts: Vec<u32> = orbits.groups.iter().map(|g| place(g[0])).collect();
        assert!(firsts.is_sorted());
        for group in &orbits.groups {
            assert!(group.iter().all(|key| place(*key) >= place(group[0])));
        }
        let sorted = |all: &[[u32; 3]]| {
            let mut all: Vec<[u32; 3]> = all.iter().map(turned).collect();
            all.sort_unstable();
            all
        };
        assert_eq!(sorted(&orbits.groups), sorted(&triangles));
    }

    #[test]
    fn groups_are_in_the_order_of_their_first_sums() {
        check(|k| k, true);
        check(|k| k * 1709 % (SIDE * SIDE), false);
    }

    #[test]
    fn rows_without_partners_are_single_by_their_number_in_the_table() {
        let (_, mesh, whole) = grid(|k| k * 1709 % (SIDE * SIDE));
        // some rows name another vertex than the face has
        let mut table = Table::with_capacity(whole.n_keys());
        for key in 0..whole.n_keys() {
            for (number, row) in whole.enumerate_rows_of(key) {
                table.push(match number % 50 {
                    0 => [row[1], row[0]],
                    _ => *row,
                });
            }
            table.finish_key().unwrap();
        }
        let order = Keys::vertices(mesh.complex());
        let orbits = Orbits::<3, 3>::build(&table, &[0, 1], [1, 2, 0], order).unwrap();
        assert_eq!(orbits.singles.len() + 3 * orbits.groups.len(), table.len());
        assert!(orbits.singles.len() > 100);
        let mut seen = vec![false; table.len()];
        for [key, number] in &orbits.singles {
            assert!(table.range(*key as usize).contains(&(*number as usize)));
            assert!(!std::mem::replace(&mut seen[*number as usize], true));
        }
    }
}
