//! An order of keys in which those of a group are near each other.

/// Fewer keys than this are in the cache, and on one thread.
const LEAST_KEYS: usize = 2048;

/// Whether the keys of groups are near each other in the numbering as it is: in a local numbering they are a row of the
/// mesh apart, about √n, in a random one about n/3.
pub(super) fn is_coherent<const A: usize, const M: usize>(
    n_keys: usize,
    groups: &[[u32; A]],
    keys: &[usize; M],
) -> bool {
    let sample = groups.iter().step_by(1 + groups.len() / 4096);
    let count = sample.len().max(1) as u64;
    let spread: u64 = sample
        .map(|g| u64::from(g[keys[0]].abs_diff(g[keys[1]])))
        .sum();
    n_keys < LEAST_KEYS || spread / count < n_keys as u64 / 16
}

/// Sorts by a rank below `n`; items of the same rank keep their order.
pub(super) fn sorted_by_rank<T: Copy>(n: usize, items: Vec<T>, rank: impl Fn(&T) -> u32) -> Vec<T> {
    let ranks: Vec<u32> = items.iter().map(rank).collect();
    let mut next = vec![0u32; n + 1];
    for rank in &ranks {
        next[*rank as usize + 1] += 1;
    }
    for k in 0..n {
        next[k + 1] += next[k];
    }
    let mut sorted = items.clone();
    for (item, rank) in items.iter().zip(ranks) {
        let place = &mut next[rank as usize];
        sorted[*place as usize] = *item;
        *place += 1;
    }
    sorted
}

/// The rank of each key in a breadth-first walk over keys that share a group.
pub(super) fn breadth_first<const A: usize, const M: usize>(
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
