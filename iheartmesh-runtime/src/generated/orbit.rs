//! Groups of rows whose terms are computed together.

use std::ops::AddAssign;

use rayon::prelude::*;

use super::{Fallible, Fault, NO_ELEMENT, Table};

/// Groups of `M` rows with `A` elements each; the elements of each row of a group are those of the row before it,
/// exchanged. The first element of a row is its key.
#[derive(Clone, Debug)]
pub struct Orbits<const A: usize, const M: usize> {
    /// The elements of the first row of each group.
    groups: Vec<[u32; A]>,
    /// Rows that belong to no group: key and number of the row.
    singles: Vec<[u32; 2]>,
    /// Which elements of the first row are the keys of the rows of a group.
    keys: [usize; M],
    /// For each key, where its terms are among those of the groups, then of the singles; ascending.
    starts: Vec<u32>,
    places: Vec<u32>,
}

/// Groups in which fewer rows than this part take part are not worth it.
const LEAST_PART: f64 = 0.5;

impl<const A: usize, const M: usize> Orbits<A, M> {
    /// Finds the groups of a table whose rows hold the elements after the key in these columns. `None` when few rows
    /// belong to groups.
    pub fn build<const N: usize>(
        table: &Table<N>,
        columns: &[usize],
        permutation: [usize; A],
    ) -> Option<Self> {
        let elements = |key: u32, row: &[u32; N]| -> [u32; A] {
            std::array::from_fn(|k| if k == 0 { key } else { row[columns[k - 1]] })
        };
        let n_keys = table.n_keys();
        let mut groups = Vec::with_capacity(table.len() / M + 1);
        let mut singles = Vec::new();
        let mut place = vec![u32::MAX; table.len()];
        for key in 0..n_keys {
            for (number, row) in table.enumerate_rows_of(key) {
                if place[number] != u32::MAX {
                    continue;
                }
                let first = elements(key as u32, row);
                let mut members = [number; M];
                let mut current = first;
                let mut complete = !first.contains(&NO_ELEMENT);
                for member in members.iter_mut().skip(1) {
                    if !complete {
                        break;
                    }
                    let next: [u32; A] = std::array::from_fn(|k| current[permutation[k]]);
                    let partner = next[0] as usize;
                    let found = (partner < n_keys).then(|| {
                        table
                            .enumerate_rows_of(partner)
                            .find(|(other, row)| {
                                *other != number
                                    && place[*other] == u32::MAX
                                    && elements(next[0], row) == next
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
                    let start = (groups.len() * M) as u32;
                    groups.push(first);
                    for (k, member) in members.iter().enumerate() {
                        place[*member] = start + k as u32;
                    }
                } else {
                    // its place follows when all groups are known
                    singles.push([key as u32, number as u32]);
                    place[number] = u32::MAX - 1;
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
        let mut orbits = Self {
            groups,
            singles,
            keys,
            starts: Vec::new(),
            places: Vec::new(),
        };
        orbits.order_for_locality(n_keys);
        orbits.place_terms(n_keys);
        Some(orbits)
    }

    /// Puts the groups in an order in which those that share elements are near each other, where the numbering of the
    /// elements does not give it.
    fn order_for_locality(&mut self, n_keys: usize) {
        let spread: u64 = self
            .groups
            .iter()
            .step_by(1 + self.groups.len() / 4096)
            .map(|g| u64::from(g[0].abs_diff(g[self.keys[1]])))
            .sum();
        let samples = self
            .groups
            .len()
            .div_ceil(1 + self.groups.len() / 4096)
            .max(1) as u64;
        // neighbours in a coherent numbering are a row of the mesh apart, about √n; in a random one about n/3
        if n_keys < 16_384 || spread / samples < n_keys as u64 / 16 {
            return;
        }
        let rank = breadth_first(n_keys, &self.groups, &self.keys);
        let keys = self.keys;
        self.groups.par_sort_by_cached_key(|g| {
            keys.iter().map(|k| rank[g[*k] as usize]).min().unwrap_or(0)
        });
    }

    fn keys_of_terms(&self) -> impl Iterator<Item = u32> {
        let keys = self.keys;
        let grouped = self.groups.iter().flat_map(move |g| keys.map(|k| g[k]));
        grouped.chain(self.singles.iter().map(|s| s[0]))
    }

    /// Notes for each key where its terms are.
    fn place_terms(&mut self, n_keys: usize) {
        let mut starts = vec![0u32; n_keys + 1];
        for key in self.keys_of_terms() {
            starts[key as usize + 1] += 1;
        }
        for k in 0..n_keys {
            starts[k + 1] += starts[k];
        }
        let mut next = starts.clone();
        let mut places = vec![0u32; starts[n_keys] as usize];
        for (place, key) in (0u32..).zip(self.keys_of_terms()) {
            let slot = &mut next[key as usize];
            places[*slot as usize] = place;
            *slot += 1;
        }
        self.starts = starts;
        self.places = places;
    }

    /// The sum of the terms of each key. `terms` gives those of a group from the elements of its first row, `term` that
    /// of a single row. Every sum is formed in the same order, whatever the number of threads.
    ///
    /// # Errors
    /// A key with a term that has no value, and the reason.
    pub fn sums<const N: usize, T>(
        &self,
        table: &Table<N>,
        zero: T,
        terms: impl Fn([u32; A]) -> Fallible<[T; M]> + Sync,
        term: impl Fn(u32, &[u32; N]) -> Fallible<T> + Sync,
    ) -> Result<Vec<T>, (u32, Fault)>
    where
        T: Copy + AddAssign + Send + Sync,
    {
        let n_keys = self.starts.len() - 1;
        let single = |[key, number]: [u32; 2]| match term(key, &table.rows()[number as usize]) {
            Ok(value) => Ok(value),
            Err(fault) => Err((key, fault)),
        };
        let group = |elements: &[u32; A]| match terms(*elements) {
            Ok(values) => Ok(values),
            Err(fault) => Err((elements[0], fault)),
        };
        if rayon::current_num_threads() == 1 || self.groups.len() < 2048 {
            let mut sums = vec![zero; n_keys];
            for elements in &self.groups {
                let values = group(elements)?;
                for (k, value) in self.keys.iter().zip(values) {
                    sums[elements[*k] as usize] += value;
                }
            }
            for &[key, number] in &self.singles {
                sums[key as usize] += single([key, number])?;
            }
            return Ok(sums);
        }
        let mut values = vec![zero; self.groups.len() * M + self.singles.len()];
        let (grouped, rest) = values.split_at_mut(self.groups.len() * M);
        grouped
            .par_chunks_mut(M * 1024)
            .zip(self.groups.par_chunks(1024))
            .try_for_each(|(values, groups)| {
                for (values, elements) in values.chunks_exact_mut(M).zip(groups) {
                    values.copy_from_slice(&group(elements)?);
                }
                Ok(())
            })?;
        for (value, row) in rest.iter_mut().zip(&self.singles) {
            *value = single(*row)?;
        }
        let sum = |key: usize| {
            let places = &self.places[self.starts[key] as usize..self.starts[key + 1] as usize];
            let mut sum = zero;
            for place in places {
                sum += values[*place as usize];
            }
            sum
        };
        Ok((0..n_keys)
            .into_par_iter()
            .with_min_len(1024)
            .map(sum)
            .collect())
    }
}

/// The rank of each key in a breadth-first walk over keys that share a group.
fn breadth_first<const A: usize, const M: usize>(
    n_keys: usize,
    groups: &[[u32; A]],
    keys: &[usize; M],
) -> Vec<u32> {
    let mut starts = vec![0u32; n_keys + 1];
    for group in groups {
        for k in keys {
            starts[group[*k] as usize + 1] += 1;
        }
    }
    for k in 0..n_keys {
        starts[k + 1] += starts[k];
    }
    let mut next = starts.clone();
    let mut around = vec![0u32; starts[n_keys] as usize];
    for (number, group) in (0u32..).zip(groups) {
        for k in keys {
            let slot = &mut next[group[*k] as usize];
            around[*slot as usize] = number;
            *slot += 1;
        }
    }
    let mut rank = vec![u32::MAX; n_keys];
    let mut queue: Vec<u32> = Vec::with_capacity(n_keys);
    for start in 0..n_keys as u32 {
        if rank[start as usize] != u32::MAX {
            continue;
        }
        rank[start as usize] = queue.len() as u32;
        let mut head = queue.len();
        queue.push(start);
        while head < queue.len() {
            let key = queue[head] as usize;
            head += 1;
            for &group in &around[starts[key] as usize..starts[key + 1] as usize] {
                for k in keys {
                    let other = groups[group as usize][*k];
                    if rank[other as usize] == u32::MAX {
                        rank[other as usize] = queue.len() as u32;
                        queue.push(other);
                    }
                }
            }
        }
    }
    rank
}
