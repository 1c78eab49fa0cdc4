//! Values that several threads compute and one at a time uses, in order.

use std::collections::VecDeque;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use super::{Fallible, Fault};

/// What the threads share.
struct State<F> {
    /// What uses the values, while no thread does.
    user: Option<F>,
    /// How many are used.
    used: usize,
    /// Those that wait for others before them, with their numbers.
    waiting: Vec<(usize, Vec<f64>)>,
    /// Memory for more.
    free: Vec<Vec<f64>>,
    /// The first without a value.
    failed: Option<(usize, Fault)>,
}

/// Computes the values of `0..n` on all threads and uses them in this order. A thread uses those that it has computed
/// itself, which are in its caches; as long as it is not their turn it computes more. So no thread waits for another. What
/// is left when all are computed, any thread uses. `memory` is kept from call to call.
///
/// # Errors
/// The first in order.
pub(super) fn in_order(
    n: usize,
    memory: &mut Vec<Vec<f64>>,
    compute: impl Fn(usize, &mut Vec<f64>) -> Fallible<()> + Sync,
    user: impl FnMut(usize, &[f64]) + Send,
) -> Fallible<()> {
    let state = Mutex::new(State {
        user: Some(user),
        used: 0,
        waiting: Vec::new(),
        free: std::mem::take(memory),
        failed: None,
    });
    let started = AtomicUsize::new(0);
    let has_failed = AtomicBool::new(false);
    let work = || {
        // those of this thread that wait for their turn
        let mut own: VecDeque<(usize, Vec<f64>)> = VecDeque::new();
        // whatever has been started is finished, so that the first failure is found
        while !has_failed.load(Ordering::Relaxed) {
            let k = started.fetch_add(1, Ordering::Relaxed);
            if k >= n {
                break;
            }
            let mut values = locked(&state).free.pop().unwrap_or_default();
            if let Err(fault) = compute(k, &mut values) {
                let mut now = locked(&state);
                if now.failed.is_none_or(|(first, _)| k < first) {
                    now.failed = Some((k, fault));
                }
                has_failed.store(true, Ordering::Relaxed);
                now.free.push(values);
                break;
            }
            own.push_back((k, values));
            use_all(&state, |now| {
                let is_next = own.front().is_some_and(|(k, _)| *k == now.used);
                is_next.then(|| own.pop_front()).flatten()
            });
        }
        locked(&state).waiting.extend(own);
        use_all(&state, |now| {
            let place = now.waiting.iter().position(|(k, _)| *k == now.used)?;
            Some(now.waiting.swap_remove(place))
        });
    };
    rayon::scope(|scope| {
        for _ in 1..rayon::current_num_threads().min(n) {
            scope.spawn(|_| work());
        }
        work();
    });
    let mut state = state.into_inner().unwrap_or_else(PoisonError::into_inner);
    let waiting = state.waiting.drain(..).map(|(_, values)| values);
    state.free.extend(waiting);
    *memory = state.free;
    state.failed.map_or(Ok(()), |(_, fault)| Err(fault))
}

/// Uses what `next` finds, until it finds nothing or another thread uses something.
fn use_all<F: FnMut(usize, &[f64])>(
    state: &Mutex<State<F>>,
    mut next: impl FnMut(&mut State<F>) -> Option<(usize, Vec<f64>)>,
) {
    let mut now = locked(state);
    let Some(mut user) = now.user.take() else {
        return;
    };
    while let Some((k, values)) = next(&mut now) {
        drop(now);
        user(k, &values);
        now = locked(state);
        now.used += 1;
        now.free.push(values);
    }
    now.user = Some(user);
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with_threads<T: Send>(threads: usize, f: impl FnOnce() -> T + Send) -> T {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.expect("a pool of threads").install(f)
    }

    #[test]
    fn values_are_used_in_order() {
        for threads in [1, 2, 3, 8] {
            for n in [0, 1, 2, 100, 1000] {
                let mut used = Vec::new();
                let mut memory = Vec::new();
                let done = with_threads(threads, || {
                    let compute = |k: usize, values: &mut Vec<f64>| {
                        // some take longer
                        (0..k * 7919 % 1000).for_each(|i| {
                            std::hint::black_box(i);
                        });
                        values.clear();
                        values.push(k as f64);
                        Ok(())
                    };
                    in_order(n, &mut memory, compute, |k, values| {
                        used.push((k, values[0]));
                    })
                });
                assert!(done.is_ok());
                let expected: Vec<_> = (0..n).map(|k| (k, k as f64)).collect();
                assert_eq!(used, expected);
            }
        }
    }

    #[test]
    fn the_first_failure_is_told() {
        for threads in [1, 2, 5] {
            for round in 0..50 {
                let failure = |k: usize, _: &mut Vec<f64>| match k {
                    300.. if k % 2 == 1 => Err(Fault::new("late")),
                    200 => Err(Fault::new("first")),
                    201 if round % 2 == 0 => Err(Fault::new("second")),
                    _ => Ok(()),
                };
                let mut last = None;
                let found = with_threads(threads, || {
                    in_order(1000, &mut Vec::new(), failure, |k, _| last = Some(k))
                });
                assert!(found == Err(Fault::new("first")));
                assert!(last.is_none_or(|k| k < 200));
            }
        }
    }
}
