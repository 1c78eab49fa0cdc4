//! Evaluation for all elements, in parallel where that pays.

use std::ops::{AddAssign, Range};
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use super::missing::named;
use super::{Fallible, Fault, PlanError};
use crate::element::ElementKind;

/// The values for all elements, or the first element that has none with the reason.
pub type Whole<T> = Result<Vec<T>, (u32, Fault)>;

/// Fewer elements than this are evaluated on one thread.
const LEAST_PARALLEL: usize = 2048;

/// Whether work on so many elements is shared among threads.
pub(super) fn is_parallel(n: usize) -> bool {
    n >= LEAST_PARALLEL && rayon::current_num_threads() > 1
}

/// The value of `f` for every element below `n`.
pub fn for_each_element<T: Clone + Send + Sync>(
    n: usize,
    f: impl Fn(u32) -> Fallible<T> + Sync,
) -> Whole<T> {
    values(n, |k| k as u32, f)
}

/// The value of `f` for every member of a set.
pub fn for_each_of<T: Clone + Send + Sync>(
    set: &[u32],
    f: impl Fn(u32) -> Fallible<T> + Sync,
) -> Whole<T> {
    values(set.len(), |k| set[k], f)
}

#[inline]
fn values<T: Clone + Send + Sync>(
    n: usize,
    element: impl Fn(usize) -> u32 + Sync,
    f: impl Fn(u32) -> Fallible<T> + Sync,
) -> Whole<T> {
    if !is_parallel(n) {
        let mut values = Vec::with_capacity(n);
        for k in 0..n {
            let v = element(k);
            match f(v) {
                Ok(value) => values.push(value),
                Err(fault) => return Err((v, fault)),
            }
        }
        return Ok(values);
    }
    // Values are written in place. Where there is none, that of the first element stands in, and all are thrown away.
    let value = |k: usize| f(element(k)).map_err(|fault| (element(k), fault));
    let stand_in = value(0)?;
    let failed = AtomicUsize::new(n);
    let values = (0..n)
        .into_par_iter()
        .with_min_len(LEAST_PARALLEL / 2)
        .map(|k| match f(element(k)) {
            Ok(value) => value,
            Err(_) => {
                failed.fetch_min(k, Ordering::Relaxed);
                stand_in.clone()
            }
        })
        .collect();
    match failed.into_inner() {
        k if k < n => value(k).map(|_| values),
        _ => Ok(values),
    }
}

/// So many terms of a total are added one after the other.
const TERMS: usize = 512;

/// Fewer pieces of a total than this are computed before another thread has woken up.
const FEW: usize = 16;

/// A sum over `0..n`, all elements of a kind if it is given; `terms` gives that over a range. Pieces of a fixed size are summed first and then added in order, so
/// that the result does not depend on the number of threads.
///
/// # Errors
/// That of the first term without a value.
pub fn total<T: Send + AddAssign>(
    kind: Option<ElementKind>,
    n: usize,
    terms: impl Fn(Range<usize>) -> Fallible<T> + Sync,
) -> Fallible<T> {
    let piece = |k: usize| {
        let range = k * TERMS..n.min((k + 1) * TERMS);
        terms(range.clone()).map_err(|fault| named(kind, range, fault, |range| terms(range).err()))
    };
    let pieces = n.div_ceil(TERMS);
    let add = |mut sum: T, term: Fallible<T>| {
        sum += term?;
        Ok(sum)
    };
    if pieces < FEW || !is_parallel(n) {
        return (1..pieces).map(piece).try_fold(piece(0)?, add);
    }
    let sums: Vec<Fallible<T>> = (0..pieces).into_par_iter().map(piece).collect();
    let mut sums = sums.into_iter();
    let first = sums.next().unwrap_or_else(|| piece(0))?;
    sums.try_fold(first, add)
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
