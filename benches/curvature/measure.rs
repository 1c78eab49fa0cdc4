//! Measuring computations against each other: alternately, the best of many rounds.

use std::hint::black_box;
use std::time::{Duration, Instant};

/// How long to measure.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// The least number of rounds.
    pub least_rounds: usize,
    /// More rounds follow until this much time is used.
    pub budget: Duration,
}

/// A computation that measures itself.
pub type Contestant<'a> = Box<dyn FnMut() -> Duration + 'a>;

/// A computation; freeing its result is not part of its time.
pub fn contestant<'a, T>(mut compute: impl FnMut() -> T + 'a) -> Contestant<'a> {
    Box::new(move || {
        let start = Instant::now();
        let value = black_box(compute());
        let duration = start.elapsed();
        drop(value);
        duration
    })
}

/// The shortest time of each, run in turn, so that whatever else happens on the machine meets all of them alike.
pub fn contest(effort: Effort, contestants: &mut [Contestant<'_>]) -> Vec<Duration> {
    let mut best = vec![Duration::MAX; contestants.len()];
    let start = Instant::now();
    let mut rounds = 0;
    while rounds < effort.least_rounds || start.elapsed() < effort.budget {
        for (best, run) in best.iter_mut().zip(contestants.iter_mut()) {
            *best = (*best).min(run());
        }
        rounds += 1;
    }
    best
}
