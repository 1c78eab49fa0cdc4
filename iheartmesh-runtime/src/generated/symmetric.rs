//! Symmetric matrices whose size is known only at run time: whether they are positive semi-definite, and with their
//! eigenvalues replaced, as in [`super::spectrum`] for fixed sizes. Nothing here allocates: memory is handed over.
//!
//! A matrix of `n` rows is a slice of `n²` entries, row by row.

use super::lanes::Lanes;
use super::spectrum::{LEAST_NORMAL, Part, power_of_two};
use super::tridiagonal::{MOST_STEPS, NEGLIGIBLE, below, lowest};

/// How many numbers of memory [`replace`] needs for a matrix of so many rows.
pub(super) fn memory(n: usize) -> usize {
    2 * n * n + 4 * n
}

/// Replaces the eigenvalues of a symmetric matrix, which stays exactly symmetric. One that is positive semi-definite stays as it
/// is; where an entry is not finite, all become NaN.
pub(super) fn replace(a: &mut [f64], n: usize, part: Part, work: &mut [f64]) {
    let (reduced, work) = work.split_at_mut(n * n);
    reduced.copy_from_slice(a);
    if has_positive_pivots(reduced, n) {
        return;
    }
    let largest = a.iter().fold(0.0f64, |most, x| most.max(x.abs()));
    if !a.iter().all(|x| x.is_finite()) {
        a.fill(f64::NAN);
        return;
    }
    // entries around 1, so that no square of one is too large or too small
    let lift = if largest < LEAST_NORMAL { 400 } else { 0 };
    let exponent = (((largest * power_of_two(lift)).to_bits() >> 52) as i64 - 1023) >> 1;
    let scale = power_of_two(-exponent);
    let unit = power_of_two(exponent) * power_of_two(-lift / 2);
    for (to, from) in reduced.iter_mut().zip(&*a) {
        *to = from * power_of_two(lift) * scale * scale;
    }
    let (vectors, work) = work.split_at_mut(n * n);
    let (diagonal, work) = work.split_at_mut(n);
    let (beside, work) = work.split_at_mut(n);
    let (inverses, vector) = work.split_at_mut(n);
    let vector = &mut vector[..n];
    tridiagonal(reduced, n, diagonal, beside, inverses, vector);

    // what lies between may be 0
    let bound = 4.0 * n as f64 * f64::EPSILON;
    let counts = below(
        n,
        |k| Lanes([diagonal[k]]),
        |k| Lanes([beside[k]]),
        [-bound, bound],
    );
    let [mut wanted, others] = counts.map(|count| count[0] as usize);
    let positive = n - others;
    if positive < wanted {
        wanted = positive;
        let factor = match part {
            Part::Positive => 0.0,
            Part::Absolute => -1.0,
        };
        a.iter_mut().for_each(|x| *x *= factor);
        diagonal.iter_mut().for_each(|x| *x = -*x);
        beside.iter_mut().for_each(|x| *x = -*x);
    }
    let times = match part {
        Part::Positive => 1.0,
        Part::Absolute => 2.0,
    };
    vectors.fill(0.0);
    vectors.iter_mut().step_by(n + 1).for_each(|x| *x = 1.0);
    let mut found = 0;
    for first in 0..n {
        if found >= wanted {
            break;
        }
        settle(diagonal, beside, vectors, first);
        let value = diagonal[first];
        if value < 0.0 {
            found += usize::from(value < -bound);
            vector.copy_from_slice(&vectors[first * n..(first + 1) * n]);
            for (reflection, inverse) in reduced.chunks_exact(n).zip(&*inverses) {
                if *inverse != 0.0 {
                    let part = inverse * dot(reflection, vector);
                    add_multiple(vector, -part, reflection);
                }
            }
            let length = (-times * value).sqrt() * unit;
            vector.iter_mut().for_each(|x| *x *= length);
            for (row, x) in a.chunks_exact_mut(n).zip(&*vector) {
                add_multiple(row, *x, vector);
            }
        }
    }
}

/// Whether a symmetric matrix is positive semi-definite, up to rounding: `A + n ε ‖A‖ I` has a factorisation `L D Lᵀ` with
/// positive `D`. Not for one with entries that are not finite. Its lower triangle is used up.
fn has_positive_pivots(a: &mut [f64], n: usize) -> bool {
    // the largest entry of a positive semi-definite matrix is on its diagonal
    let diagonal = a.iter().step_by(n + 1);
    let largest = diagonal.fold(0.0f64, |most, x| most.max(*x));
    if largest == 0.0 {
        return a.iter().all(|entry| *entry == 0.0);
    }
    let shift = n as f64 * f64::EPSILON * largest;
    for k in 0..n {
        let (done, rest) = a.split_at_mut((k + 1) * n);
        let pivot = done[k * n + k] + shift;
        if !(pivot > 0.0 && pivot < f64::INFINITY) {
            return false;
        }
        let inverse = 1.0 / pivot;
        // the column below the pivot, in place of the row beside it
        let column = &mut done[k * n + k + 1..];
        for (x, row) in column.iter_mut().zip(rest.chunks_exact(n)) {
            *x = row[k];
        }
        for (i, row) in rest.chunks_exact_mut(n).enumerate() {
            let factor = column[i] * inverse;
            add_multiple(&mut row[k + 1..=k + 1 + i], -factor, &column[..=i]);
        }
    }
    true
}

/// Householder's reduction of a matrix with entries up to 4, from the last row to the first, see
/// [`super::tridiagonal::Tridiagonal`]. The matrix becomes the reflections.
fn tridiagonal(
    a: &mut [f64],
    n: usize,
    diagonal: &mut [f64],
    beside: &mut [f64],
    inverses: &mut [f64],
    p: &mut [f64],
) {
    beside.fill(0.0);
    inverses.fill(0.0);
    for i in (2..n).rev() {
        let (before, row) = a.split_at_mut(i * n);
        diagonal[i] = row[i];
        row[i..n].fill(0.0);
        let v = &mut row[..i];
        let last = std::mem::take(&mut v[i - 1]);
        let rest = dot(v, v);
        if rest <= NEGLIGIBLE * NEGLIGIBLE {
            beside[i - 1] = last;
            continue;
        }
        let square = rest + last * last;
        let off = -square.sqrt().copysign(last);
        beside[i - 1] = off;
        let inverse = 1.0 / (square - last * off);
        inverses[i] = inverse;
        v[i - 1] = last - off;
        let p = &mut p[..i];
        p.fill(0.0);
        for (k, row) in before.chunks_exact(n).enumerate() {
            let x = v[k];
            p[k] += row[k] * x + dot(&row[..k], &v[..k]);
            add_multiple(&mut p[..k], x, &row[..k]);
        }
        let half = 0.5 * inverse * dot(v, p);
        for (p, v) in p.iter_mut().zip(&*v) {
            *p = inverse * (*p - half * v);
        }
        for (k, row) in before.chunks_exact_mut(n).enumerate() {
            let (x, y) = (v[k], p[k]);
            for (entry, (v, p)) in row[..=k].iter_mut().zip(v.iter().zip(&*p)) {
                *entry -= x * p + y * v;
            }
        }
    }
    if n > 1 {
        diagonal[1] = a[n + 1];
        beside[0] = a[n];
    }
    diagonal[0] = a[0];
}

/// Rotates a tridiagonal matrix until its entry beside `first` is negligible, with rows of vectors, see
/// [`super::tridiagonal::Tridiagonal`].
fn settle(diagonal: &mut [f64], beside: &mut [f64], vectors: &mut [f64], first: usize) {
    let n = diagonal.len();
    for step in 0..MOST_STEPS {
        let mut last = first;
        while last + 1 < n && beside[last].abs() > NEGLIGIBLE {
            last += 1;
        }
        if last == first {
            return;
        }
        let shift = if step == 0 && last > first + 1 {
            lowest(
                first..=last,
                |k| Lanes([diagonal[k]]),
                |k| Lanes([beside[k]]),
            )[0]
        } else {
            // the eigenvalue of the first two rows that is nearer to the first entry
            let half = 0.5 * (diagonal[first + 1] - diagonal[first]);
            let root = (half * half + beside[first] * beside[first]).sqrt();
            diagonal[first] + (half - root.copysign(half))
        };
        let mut g = diagonal[last] - shift;
        let (mut sine, mut cosine, mut p) = (1.0, 1.0, 0.0);
        for i in (first..last).rev() {
            let f = sine * beside[i];
            let b = cosine * beside[i];
            let r = (f * f + g * g).sqrt();
            beside[i + 1] = r;
            // both are 0 where the matrix falls apart there: no rotation, then
            let inverse = 1.0 / r;
            (sine, cosine) = match r > 0.0 {
                true => (f * inverse, g * inverse),
                false => (0.0, 1.0),
            };
            let h = diagonal[i + 1] - p;
            let t = (diagonal[i] - h) * sine + 2.0 * cosine * b;
            p = sine * t;
            diagonal[i + 1] = h + p;
            g = cosine * t - b;
            let (x, y) = vectors[i * n..(i + 2) * n].split_at_mut(n);
            for (x, y) in x.iter_mut().zip(y) {
                (*x, *y) = (cosine * *x - sine * *y, sine * *x + cosine * *y);
            }
        }
        diagonal[first] -= p;
        beside[first] = g;
        beside[last] = 0.0;
    }
}

/// Four sums side by side, so that several are added at a time.
#[inline]
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let ((a, rest_a), (b, rest_b)) = (a.as_chunks::<4>(), b.as_chunks::<4>());
    let mut sums = [0.0; 4];
    for (x, y) in a.iter().zip(b) {
        for k in 0..4 {
            sums[k] += x[k] * y[k];
        }
    }
    let rest = rest_a.iter().zip(rest_b).map(|(x, y)| x * y).sum::<f64>();
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + rest
}

#[inline]
fn add_multiple(to: &mut [f64], factor: f64, from: &[f64]) {
    for (x, y) in to.iter_mut().zip(from) {
        *x += factor * y;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, DVector};

    fn numbers() -> impl FnMut() -> f64 {
        let mut state = 0x2545_f491_4f6c_dd1d_u64;
        move || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        }
    }

    /// A matrix with these eigenvalues: reflected a few times.
    fn with_values(values: &DVector<f64>, next: &mut impl FnMut() -> f64) -> DMatrix<f64> {
        let n = values.len();
        let mut a = DMatrix::from_diagonal(values);
        for _ in 0..4 {
            let v = DVector::from_fn(n, |_, _| next()).normalize();
            let w = &a * &v;
            a -= 2.0 * (&v * w.transpose() + &w * v.transpose())
                - 4.0 * v.dot(&w) * &v * v.transpose();
        }
        (&a + a.transpose()) * 0.5
    }

    fn replaced(a: &DMatrix<f64>, part: Part) -> DMatrix<f64> {
        let n = a.nrows();
        let mut found = a.clone();
        // what was in memory before does not matter
        let mut work = vec![f64::NAN; memory(n)];
        replace(found.as_mut_slice(), n, part, &mut work);
        found
    }

    #[track_caller]
    fn check(a: &DMatrix<f64>) {
        let scale = a.amax().max(f64::MIN_POSITIVE);
        // small and large entries overflow there
        let eigen = (a / scale).symmetric_eigen();
        for part in [Part::Positive, Part::Absolute] {
            let values = DMatrix::from_diagonal(&eigen.eigenvalues.map(|x| part.replace(x)));
            let vectors = &eigen.eigenvectors;
            let expected = vectors * values * vectors.transpose();
            let found = replaced(a, part);
            assert_eq!(found, found.transpose());
            let tolerance = 32.0 * (a.nrows() as f64).max(2.0) * f64::EPSILON;
            let difference = (&found / scale - expected).amax();
            assert!(difference <= tolerance, "{difference}: {a}");
            // what has become positive semi-definite stays
            let again = (&replaced(&found, part) - &found).amax() / scale;
            assert!(again <= tolerance, "{again}: {a}");
        }
    }

    #[test]
    fn results_are_those_of_nalgebra() {
        let mut next = numbers();
        for n in (1..14).chain([21, 30, 63, 150]) {
            let rounds = if n < 40 { 5 } else { 1 };
            for round in 0..rounds {
                let any = DMatrix::from_fn(n, n, |_, _| next());
                let any = &any + any.transpose();
                let scales = [1.0, 1e-150, 1e150, 1e-300, 1e300];
                for scale in &scales[..rounds] {
                    check(&(&any * *scale));
                }
                // repeated, with zeros, of very different sizes, of small rank
                let kinds: [fn(usize) -> f64; 5] = [
                    |k| if k % 2 == 0 { 1.0 } else { -1.0 },
                    |k| if k == 0 { -1.0 } else { 0.0 },
                    |k| 10f64.powi(-(2 * k.min(60) as i32)) * if k % 2 == 0 { 1.0 } else { -1.0 },
                    |k| (k / 2) as f64,
                    |k| if k < 3 { 2.0 - k as f64 } else { 0.0 },
                ];
                let values = DVector::from_fn(n, |k, _| kinds[round % 5](k));
                check(&with_values(&values, &mut next));
            }
            check(&DMatrix::zeros(n, n));
            check(&DMatrix::from_element(n, n, 1.0));
            check(&DMatrix::from_element(n, n, -1.0));
        }
    }

    #[test]
    fn numbers_that_are_not_finite_end() {
        for n in [1, 2, 7] {
            for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                for at in 0..n {
                    let mut a = DMatrix::identity(n, n);
                    a[(at, 0)] = x;
                    a[(0, at)] = x;
                    let found = replaced(&a, Part::Positive);
                    assert!(found.iter().all(|entry| entry.is_nan()));
                }
            }
        }
    }

    #[test]
    fn semidefinite_matrices_are_seen() {
        let mut next = numbers();
        for n in [2, 6, 21, 60] {
            for _ in 0..20 {
                // of rank n / 2
                let b = DMatrix::from_fn(n / 2, n, |_, _| next());
                let a = b.transpose() * b;
                let a = (&a + a.transpose()) * 0.5;
                assert!(has_positive_pivots(a.clone().as_mut_slice(), n));
                assert_eq!(replaced(&a, Part::Positive), a);
                assert!(!has_positive_pivots((-a).as_mut_slice(), n));
            }
        }
    }
}
