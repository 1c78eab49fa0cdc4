//! Evaluation for all elements, in parallel where that pays.

use std::ops::Range;

use rayon::prelude::*;

use super::{Fallible, Fault, PlanError};

/// The values for all elements, or the first element that has none with the reason.
pub type Whole<T> = Result<Vec<T>, (u32, Fault)>;

/// Fewer elements than this are evaluated on one thread.
const LEAST_PARALLEL: usize = 2048;
/// Elements that a thread takes at a time.
const CHUNK: usize = 4096;

fn is_parallel(n: usize) -> bool {
    n >= LEAST_PARALLEL && rayon::current_num_threads() > 1
}

/// The value of `f` for every element below `n`.
pub fn for_each_element<T: Send>(n: usize, f: impl Fn(u32) -> Fallible<T> + Sync) -> Whole<T> {
    values(n, |k| k as u32, f)
}

/// The value of `f` for every member of a set.
pub fn for_each_of<T: Send>(set: &[u32], f: impl Fn(u32) -> Fallible<T> + Sync) -> Whole<T> {
    values(set.len(), |k| set[k], f)
}

#[inline]
fn values<T: Send>(
    n: usize,
    element: impl Fn(usize) -> u32 + Sync,
    f: impl Fn(u32) -> Fallible<T> + Sync,
) -> Whole<T> {
    let chunk = |range: Range<usize>| -> Whole<T> {
        let mut values = Vec::with_capacity(range.len());
        for k in range {
            let v = element(k);
            match f(v) {
                Ok(value) => values.push(value),
                Err(fault) => return Err((v, fault)),
            }
        }
        Ok(values)
    };
    if !is_parallel(n) {
        return chunk(0..n);
    }
    let chunks: Vec<Whole<T>> = (0..n.div_ceil(CHUNK))
        .into_par_iter()
        .map(|c| chunk(c * CHUNK..n.min((c + 1) * CHUNK)))
        .collect();
    let mut all = Vec::with_capacity(n);
    for chunk in chunks {
        all.append(&mut chunk?);
    }
    Ok(all)
}

/// Runs `f` over consecutive ranges of `0..n`; the results in order. A plan is made in this way.
///
/// # Errors
/// The first error in order of the ranges.
pub fn in_chunks<T: Send>(
    n: usize,
    f: impl Fn(Range<u32>) -> Result<T, PlanError> + Sync,
) -> Result<Vec<T>, PlanError> {
    let threads = rayon::current_num_threads();
    if !is_parallel(n) {
        return Ok(vec![f(0..n as u32)?]);
    }
    // a few for each thread, so that uneven work is shared
    let size = n.div_ceil(threads * 4).max(LEAST_PARALLEL / 2);
    let parts: Vec<Result<T, PlanError>> = (0..n.div_ceil(size))
        .into_par_iter()
        .map(|c| f((c * size) as u32..n.min((c + 1) * size) as u32))
        .collect();
    parts.into_iter().collect()
}
