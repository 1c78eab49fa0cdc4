//! Symmetric tridiagonal matrices of small fixed sizes, several side by side: how others become such, and their eigenvalues.

use std::ops::RangeInclusive;

use smallvec::SmallVec;

use super::lanes::{Lanes, Mask};

/// Steps of the QL method for one eigenvalue before it is given up; it settles after 2 or 3.
pub(super) const MOST_STEPS: usize = 60;

/// What is smaller changes no eigenvalue in its last digit, for matrices with entries around 1.
pub(super) const NEGLIGIBLE: f64 = f64::EPSILON / 4.0;

/// Symmetric tridiagonal matrices, with the reflections that made them.
pub(super) struct Tridiagonal<const N: usize, const L: usize> {
    pub(super) diagonal: [Lanes<L>; N],
    /// At `k` the entries between `k` and `k + 1`; the last is 0.
    pub(super) beside: [Lanes<L>; N],
    /// The lower triangles of the matrices; once they are reduced, in row `i` the first `i` entries of `v` in
    /// `I - inverse v vᵀ`, which keeps the others. Where the inverse is 0 there is no reflection. The last was the first.
    pub(super) rows: [[Lanes<L>; N]; N],
    inverses: [Lanes<L>; N],
}

impl<const N: usize, const L: usize> Tridiagonal<N, L> {
    /// Zeros.
    #[inline(always)]
    pub(super) fn new() -> Self {
        let zero = Lanes::splat(0.0);
        Self {
            diagonal: [zero; N],
            beside: [zero; N],
            rows: [[zero; N]; N],
            inverses: [zero; N],
        }
    }

    /// Householder's reduction of the matrices with these rows, with entries up to 4, from the last row to the first.
    #[inline(always)]
    pub(super) fn reduce(&mut self) {
        let zero = Lanes::splat(0.0);
        let Self {
            diagonal,
            beside,
            rows: a,
            inverses,
        } = self;
        for i in (2..N).rev() {
            let (above, rest) = a.split_at_mut(i);
            let row = &mut rest[0];
            diagonal[i] = row[i];
            let v = &mut row[..i];
            let mut rest = zero;
            for x in &v[..i - 1] {
                rest += *x * *x;
            }
            let last = v[i - 1];
            let square = rest + last * last;
            let off = -square.sqrt().copysign(last);
            let inverse = Lanes::splat(1.0).over(square - last * off);
            let reflects = rest.greater(Lanes::splat(NEGLIGIBLE * NEGLIGIBLE));
            let off = Lanes::select(reflects, off, last);
            let inverse = Lanes::select(reflects, inverse, zero);
            beside[i - 1] = off;
            inverses[i] = inverse;
            v[i - 1] = last - off;
            let mut p = [zero; N];
            for (r, row) in above.iter().enumerate() {
                let x = v[r];
                let mut sum = row[r] * x;
                for ((entry, y), p) in row[..r].iter().zip(&*v).zip(&mut p) {
                    sum += *entry * *y;
                    *p += *entry * x;
                }
                p[r] += sum;
            }
            let mut product = zero;
            for (x, y) in v.iter().zip(&p) {
                product += *x * *y;
            }
            let half = inverse * product * 0.5;
            for (p, x) in p.iter_mut().zip(&*v) {
                *p = inverse * (*p - half * *x);
            }
            for (r, row) in above.iter_mut().enumerate() {
                let (x, y) = (v[r], p[r]);
                for (entry, (v, p)) in row[..=r].iter_mut().zip(v.iter().zip(&p)) {
                    *entry -= x * *p + y * *v;
                }
            }
        }
        if N > 1 {
            diagonal[1] = a[1][1];
            beside[0] = a[1][0];
        }
        diagonal[0] = a[0][0];
    }

    /// How many eigenvalues are below each bound.
    #[inline(always)]
    pub(super) fn below(&self, bounds: [f64; 2]) -> [Lanes<L>; 2] {
        below(N, |k| self.diagonal[k], |k| self.beside[k], bounds)
    }

    /// Multiplies each matrix.
    #[inline(always)]
    pub(super) fn scale(&mut self, factor: Lanes<L>) {
        for x in self.diagonal.iter_mut().chain(&mut self.beside) {
            *x = *x * factor + Lanes::splat(0.0);
        }
    }

    /// Rotates matrices, those of them that are unfinished, until their entry beside `first` is negligible.
    #[inline(always)]
    pub(super) fn settle(
        &mut self,
        rotations: &mut Rotations<L>,
        first: usize,
        unfinished: Mask<L>,
    ) {
        let (zero, one) = (Lanes::splat(0.0), Lanes::splat(1.0));
        let (start, most_steps) = (Lanes::splat(first as f64), Lanes::splat(MOST_STEPS as f64));
        let mut steps = Lanes::select(unfinished, zero, most_steps);
        loop {
            // how far rows hang together
            let mut together = Lanes::select(most_steps.greater(steps), one, zero);
            let mut last = start;
            for beside in &self.beside[first..N - 1] {
                let large = beside.abs().greater(Lanes::splat(NEGLIGIBLE));
                together = Lanes::select(large, together, zero);
                last += together;
            }
            let most = last.most() as usize;
            if most <= first {
                return;
            }
            // where it is less far, that waits for a step of its own
            let active = last.greater(Lanes::splat(most as f64 - 0.5));
            let active = Lanes::select(active, one, zero);
            let mut shift = self.nearest(first);
            let begins = one.greater(steps);
            if most > first + 1 && begins.contains(&true) {
                shift = Lanes::select(
                    begins,
                    lowest(first..=most, |k| self.diagonal[k], |k| self.beside[k]),
                    shift,
                );
            }
            self.rotate(rotations, first, most, active, shift);
            steps += active;
        }
    }

    /// The eigenvalue of two rows that is nearer to the first entry.
    #[inline(always)]
    fn nearest(&self, first: usize) -> Lanes<L> {
        let (x, beside) = (self.diagonal[first], self.beside[first]);
        let half = (self.diagonal[first + 1] - x) * 0.5;
        let root = (half * half + beside * beside).sqrt();
        x + (half - root.copysign(half))
    }

    /// A step of the QL method on these rows of active matrices. An entry of the diagonal is never -0, so that the rotations
    /// by nothing of the others change nothing.
    #[inline(always)]
    fn rotate(
        &mut self,
        rotations: &mut Rotations<L>,
        first: usize,
        last: usize,
        active: Lanes<L>,
        shift: Lanes<L>,
    ) {
        let (zero, one) = (Lanes::splat(0.0), Lanes::splat(1.0));
        let Self {
            diagonal, beside, ..
        } = self;
        rotations.steps.push([first, last]);
        let (mut sine, mut cosine, mut p) = (one, one, zero);
        let mut g = diagonal[last] - shift;
        for i in (first..last).rev() {
            let f = sine * beside[i];
            let b = cosine * beside[i];
            let r = (f * f + g * g).sqrt();
            let acts = active.greater(zero);
            let after = if i + 1 < last { r } else { zero };
            beside[i + 1] = Lanes::select(acts, after, beside[i + 1]);
            // both are 0 where the matrix falls apart there: no rotation, then
            let inverse = one.over(r);
            let turns = (r * active).greater(zero);
            sine = Lanes::select(turns, f * inverse, zero);
            cosine = Lanes::select(turns, g * inverse, one);
            rotations.all.push([cosine, sine]);
            let h = diagonal[i + 1] - p;
            let t = (diagonal[i] - h) * sine + cosine * b * 2.0;
            p = sine * t;
            diagonal[i + 1] = h + p;
            g = cosine * t - b;
        }
        diagonal[first] -= p;
        beside[first] = Lanes::select(active.greater(zero), g, beside[first]);
    }

    /// The eigenvectors of the whole matrices that belong to their entry at `first`, which has settled.
    #[inline(always)]
    pub(super) fn vectors(&self, rotations: &Rotations<L>, first: usize) -> [Lanes<L>; N] {
        let zero = Lanes::splat(0.0);
        let mut z = [zero; N];
        z[first] = Lanes::splat(1.0);
        let mut all = rotations.all.iter().rev();
        for [first, last] in rotations.steps.iter().rev() {
            for (i, [cosine, sine]) in (*first..*last).zip(&mut all) {
                let (x, y) = (z[i], z[i + 1]);
                z[i] = *cosine * x + *sine * y;
                z[i + 1] = *cosine * y - *sine * x;
            }
        }
        for i in 2..N {
            let v = &self.rows[i][..i];
            let mut product = zero;
            for (x, y) in v.iter().zip(&z) {
                product += *x * *y;
            }
            let part = self.inverses[i] * product;
            for (z, x) in z.iter_mut().zip(v) {
                *z -= part * *x;
            }
        }
        z
    }
}

/// How many eigenvalues of symmetric tridiagonal matrices of `n` rows are below each bound: as many as pivots are negative.
#[inline(always)]
pub(super) fn below<const L: usize>(
    n: usize,
    diagonal: impl Fn(usize) -> Lanes<L>,
    beside: impl Fn(usize) -> Lanes<L>,
    bounds: [f64; 2],
) -> [Lanes<L>; 2] {
    let (zero, one) = (Lanes::splat(0.0), Lanes::splat(1.0));
    let (mut counts, mut pivots, mut square) = ([zero; 2], [one; 2], zero);
    for k in 0..n {
        for ((count, pivot), bound) in counts.iter_mut().zip(&mut pivots).zip(bounds) {
            let next = diagonal(k) - Lanes::splat(bound) - square.over(*pivot);
            let small = Lanes::splat(1e-20).greater(next.abs());
            *pivot = Lanes::select(small, Lanes::splat(1e-20), next);
            *count += Lanes::select(zero.greater(*pivot), one, zero);
        }
        square = beside(k) * beside(k);
    }
    counts
}

/// About the lowest eigenvalue of some rows of symmetric tridiagonal matrices: a few steps of Laguerre's method on the
/// characteristic polynomial, from below.
#[inline(always)]
pub(super) fn lowest<const L: usize>(
    rows: RangeInclusive<usize>,
    diagonal: impl Fn(usize) -> Lanes<L>,
    beside: impl Fn(usize) -> Lanes<L>,
) -> Lanes<L> {
    let (zero, one) = (Lanes::splat(0.0), Lanes::splat(1.0));
    let (first, last) = rows.into_inner();
    // after S. A. Gershgorin
    let mut value = Lanes::splat(f64::INFINITY);
    let mut before = zero;
    for k in first..=last {
        let after = if k < last { beside(k).abs() } else { zero };
        value = value.min(diagonal(k) - before - after);
        before = after;
    }
    let n = (last - first + 1) as f64;
    let mut going = one;
    for _ in 0..6 {
        // the determinant of the first rows and of one less, with two derivatives
        let mut here = [one, zero, zero];
        let mut less = [zero; 3];
        let mut square = zero;
        for k in first..=last {
            let t = diagonal(k) - value;
            let next = [
                t * here[0] - square * less[0],
                t * here[1] - (square * less[1] + here[0]),
                t * here[2] - (square * less[2] + here[1] * 2.0),
            ];
            (less, here) = (here, next);
            square = beside(k) * beside(k);
        }
        let [p, slope, bend] = here;
        going = Lanes::select(p.greater(zero), going, zero);
        going = Lanes::select(zero.greater(slope), going, zero);
        let inside = (slope * slope * (n - 1.0) - p * bend * n) * (n - 1.0);
        let inside = Lanes::select(inside.greater(zero), inside, zero);
        let step = (p * n).over(inside.sqrt() - slope);
        value = Lanes::select(going.greater(zero), value + step, value);
        going = Lanes::select(step.greater(Lanes::splat(1e-3)), going, zero);
        if going.most() == 0.0 {
            break;
        }
    }
    value
}

/// Rotations that matrices have gone through. Those of matrices of up to 30 rows have room in place; there is memory of the heap
/// for more.
pub(super) struct Rotations<const L: usize> {
    /// For each step the row that it went to, and the one that it came from.
    steps: SmallVec<[[usize; 2]; 64]>,
    /// Cosine and sine.
    all: SmallVec<[[Lanes<L>; 2]; 1024]>,
}

impl<const L: usize> Rotations<L> {
    /// None yet.
    #[inline(always)]
    pub(super) fn new() -> Self {
        Self {
            steps: SmallVec::new(),
            all: SmallVec::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Half of the eigenvalues, the most that are ever needed, of eight matrices of `N` rows.
    fn has_room<const N: usize>() {
        let mut state = 0x9e37_79b9_7f4a_7c15_u64;
        for _ in 0..10 {
            let mut tridiagonal = Tridiagonal::<N, 8>::new();
            for x in tridiagonal.rows.iter_mut().flatten() {
                *x = Lanes(std::array::from_fn(|_| {
                    state ^= state << 13;
                    state ^= state >> 7;
                    state ^= state << 17;
                    (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
                }));
            }
            tridiagonal.reduce();
            let mut rotations = Rotations::new();
            for first in 0..N / 2 {
                tridiagonal.settle(&mut rotations, first, [true; 8]);
            }
            assert!(!rotations.all.is_empty());
            assert!(!rotations.all.spilled() && !rotations.steps.spilled());
        }
    }

    #[test]
    fn rotations_have_room() {
        has_room::<4>();
        has_room::<9>();
        has_room::<12>();
        has_room::<18>();
        has_room::<30>();
    }
}
