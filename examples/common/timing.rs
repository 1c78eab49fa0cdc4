//! Timing a computation.

use std::hint::black_box;
use std::time::{Duration, Instant};

/// The shortest of `n` runs of `compute`, and the value of the last run.
///
/// The shortest run is the one that other programs disturbed least. `n` counts as at least 1.
pub fn time_best_of<T>(n: usize, mut compute: impl FnMut() -> T) -> (Duration, T) {
    let mut run = || {
        let start = Instant::now();
        let value = black_box(compute());
        (start.elapsed(), value)
    };
    let (mut best, mut value) = run();
    for _ in 1..n {
        // The value of the run before goes first, so that two never take memory at the same time.
        drop(value);
        let duration;
        (duration, value) = run();
        best = best.min(duration);
    }
    (best, value)
}

/// The nanoseconds that each of `n_vertices` takes.
pub fn nanoseconds_per_vertex(duration: Duration, n_vertices: usize) -> f64 {
    duration.as_secs_f64() * 1e9 / n_vertices as f64
}

/// As people read it: `48.3 ns per vertex (n = 1000000, 48.3ms)`.
pub fn describe(duration: Duration, n_vertices: usize) -> String {
    let nanoseconds = nanoseconds_per_vertex(duration, n_vertices);
    format!("{nanoseconds:.1} ns per vertex (n = {n_vertices}, {duration:.1?})")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_as_often_as_asked_and_returns_the_last_value() {
        let mut runs = 0;
        let (_, last) = time_best_of(3, || {
            runs += 1;
            runs
        });
        assert_eq!(last, 3);
    }

    #[test]
    fn durations_read_well() {
        let text = describe(Duration::from_millis(50), 1_000_000);
        assert_eq!(text, "50.0 ns per vertex (n = 1000000, 50.0ms)");
    }
}
