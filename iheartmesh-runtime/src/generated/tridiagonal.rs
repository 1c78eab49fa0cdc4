//! Symmetric tridiagonal matrices of small fixed sizes: how others become such, and their eigenvalues. Nothing here allocates.

/// Steps of the QL method for one eigenvalue before it is given up; it settles after 2 or 3.
pub(super) const MOST_STEPS: usize = 60;

/// What is smaller changes no eigenvalue in its last digit, for matrices with entries around 1.
pub(super) const NEGLIGIBLE: f64 = f64::EPSILON / 4.0;

#[inline(always)]
pub(super) fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    let mut sums = [0.0; 2];
    for k in 0..N {
        sums[k % 2] += a[k] * b[k];
    }
    sums[0] + sums[1]
}

/// A symmetric tridiagonal matrix, with the reflections that made it.
pub(super) struct Tridiagonal<const N: usize> {
    pub(super) diagonal: [f64; N],
    /// At `k` the entries between `k` and `k + 1`; the last is 0.
    pub(super) beside: [f64; N],
    /// `I - inverse v vᵀ`; where the inverse is 0 there is none. The last was the first.
    pub(super) reflections: [[f64; N]; N],
    pub(super) inverses: [f64; N],
}

/// Householder's reduction of a matrix with entries up to 4, from the last row to the first.
#[inline(always)]
pub(super) fn tridiagonal<const N: usize>(mut a: [[f64; N]; N]) -> Tridiagonal<N> {
    let mut beside = [0.0; N];
    let mut inverses = [0.0; N];
    let mut diagonal = [0.0; N];
    for i in (2..N).rev() {
        let mut v = [0.0; N];
        v[..i].copy_from_slice(&a[i][..i]);
        diagonal[i] = a[i][i];
        let last = std::mem::take(&mut v[i - 1]);
        let rest = dot(&v, &v);
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
        // whole rows, since their lengths are known: what lies beyond is not used
        let mut p = [0.0; N];
        for (row, x) in a.iter().zip(&v).take(i) {
            for (sum, entry) in p.iter_mut().zip(row) {
                *sum += x * entry;
            }
        }
        let half = 0.5 * inverse * dot(&v, &p);
        for (p, v) in p.iter_mut().zip(&v) {
            *p = inverse * (*p - half * v);
        }
        for (row, (x, y)) in a.iter_mut().zip(v.iter().zip(&p)).take(i) {
            for (entry, (v, p)) in row.iter_mut().zip(v.iter().zip(&p)) {
                *entry -= x * p + y * v;
            }
        }
        a[i] = v;
    }
    if N > 1 {
        diagonal[1] = a[1][1];
        beside[0] = a[1][0];
    }
    diagonal[0] = a[0][0];
    Tridiagonal {
        diagonal,
        beside,
        reflections: a,
        inverses,
    }
}

/// How many eigenvalues of a symmetric tridiagonal matrix are below a bound: as many as pivots are negative.
#[inline(always)]
pub(super) fn below(diagonal: &[f64], beside: &[f64], bound: f64) -> usize {
    let (mut count, mut pivot, mut square) = (0, 1.0f64, 0.0);
    for (d, e) in diagonal.iter().zip(beside) {
        pivot = d - bound - square / pivot;
        if pivot.abs() < 1e-20 {
            pivot = 1e-20;
        }
        count += usize::from(pivot < 0.0);
        square = e * e;
    }
    count
}

/// Rotates a tridiagonal matrix until its entry beside `first` is negligible, with rows of vectors.
#[inline(always)]
pub(super) fn settle<const N: usize>(
    diagonal: &mut [f64; N],
    beside: &mut [f64; N],
    vectors: &mut [[f64; N]; N],
    first: usize,
) {
    for step in 0..MOST_STEPS {
        let mut last = first;
        while last + 1 < N && beside[last].abs() > NEGLIGIBLE {
            last += 1;
        }
        if last == first {
            return;
        }
        let shift = if step == 0 && last > first + 1 {
            lowest(diagonal, beside, first, last)
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
            let (mut x, mut y) = (vectors[i], vectors[i + 1]);
            for (x, y) in x.iter_mut().zip(&mut y) {
                (*x, *y) = (cosine * *x - sine * *y, sine * *x + cosine * *y);
            }
            vectors[i] = x;
            vectors[i + 1] = y;
        }
        diagonal[first] -= p;
        beside[first] = g;
        beside[last] = 0.0;
    }
}

/// About the lowest eigenvalue of some rows of a symmetric tridiagonal matrix: a few steps of Laguerre's method on its
/// characteristic polynomial, from below.
#[inline(always)]
pub(super) fn lowest(diagonal: &[f64], beside: &[f64], first: usize, last: usize) -> f64 {
    // after S. A. Gershgorin
    let mut value = f64::INFINITY;
    let mut before = 0.0;
    for k in first..=last {
        let after = if k < last { beside[k].abs() } else { 0.0 };
        value = value.min(diagonal[k] - before - after);
        before = after;
    }
    let n = (last - first + 1) as f64;
    for _ in 0..6 {
        // the determinant of the first rows and of one less, with two derivatives
        let mut here = [1.0, 0.0, 0.0];
        let mut less = [0.0; 3];
        let mut square = 0.0;
        for k in first..=last {
            let t = diagonal[k] - value;
            let next = [
                t * here[0] - square * less[0],
                t * here[1] - (square * less[1] + here[0]),
                t * here[2] - (square * less[2] + 2.0 * here[1]),
            ];
            (less, here) = (here, next);
            square = beside[k] * beside[k];
        }
        let [p, slope, bend] = here;
        if !(p > 0.0 && slope < 0.0) {
            break;
        }
        let inside = (n - 1.0) * ((n - 1.0) * slope * slope - n * p * bend);
        let step = n * p / (inside.max(0.0).sqrt() - slope);
        value += step;
        if step < 1e-3 {
            break;
        }
    }
    value
}
