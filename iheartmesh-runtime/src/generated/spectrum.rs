//! Symmetric matrices of small fixed sizes: whether they are positive semi-definite, and with their eigenvalues replaced.
//! Nothing here allocates.

use super::array::Array;

/// What replaces the eigenvalues of a symmetric matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Those below 0 become 0: the nearest positive semi-definite matrix.
    Positive,
    /// Their absolute values.
    Absolute,
}

impl Part {
    /// What replaces an eigenvalue.
    #[inline]
    pub fn replace(self, value: f64) -> f64 {
        match self {
            Self::Positive => value.max(0.0),
            Self::Absolute => value.abs(),
        }
    }
}

/// Steps of the QL method for one eigenvalue before it is given up; it settles after 2 or 3.
const MOST_STEPS: usize = 60;

/// What is smaller changes no eigenvalue in its last digit, for matrices with entries around 1.
const NEGLIGIBLE: f64 = f64::EPSILON / 4.0;

/// Matrices with smaller entries are multiplied first.
const LEAST_NORMAL: f64 = 1e-290;

/// Whether a symmetric matrix is positive semi-definite, up to rounding: `A + N ε ‖A‖ I` has a factorisation `L D Lᵀ` with
/// positive `D`. Not for one with entries that are not finite.
#[inline]
pub fn is_positive_semidefinite<const N: usize>(matrix: &impl Array<Item = f64>) -> bool {
    let mut a = [[0.0; N]; N];
    for (i, row) in a.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate().take(i + 1) {
            *entry = 0.5 * (matrix.entry(i, j) + matrix.entry(j, i));
        }
    }
    has_positive_pivots(a)
}

/// The same of the lower triangle of a matrix by its rows.
#[inline]
pub(super) fn has_positive_pivots<const N: usize>(mut a: [[f64; N]; N]) -> bool {
    // the largest entry of a positive semi-definite matrix is on its diagonal
    let mut largest = 0.0f64;
    for (k, row) in a.iter().enumerate() {
        largest = largest.max(row[k]);
    }
    if largest == 0.0 {
        return a.iter().flatten().all(|entry| *entry == 0.0);
    }
    let shift = N as f64 * f64::EPSILON * largest;
    for k in 0..N {
        let pivot = a[k][k] + shift;
        if !(pivot > 0.0 && pivot < f64::INFINITY) {
            return false;
        }
        let inverse = 1.0 / pivot;
        let column: [f64; N] = std::array::from_fn(|j| a[j][k]);
        for i in k + 1..N {
            let factor = column[i] * inverse;
            for (entry, x) in a[i][k + 1..=i].iter_mut().zip(&column[k + 1..]) {
                *entry -= factor * x;
            }
        }
    }
    true
}

/// A symmetric matrix with its eigenvalues replaced, exactly symmetric as well. One that is positive semi-definite stays as it
/// is; where an entry is not finite, all become NaN.
pub fn replaced<const N: usize>(a: &[[f64; N]; N], part: Part) -> [[f64; N]; N] {
    if N == 1 {
        return a.map(|row| row.map(|entry| part.replace(entry)));
    }
    if has_positive_pivots(*a) {
        return *a;
    }
    let Some(change) = replacement(a, part) else {
        return [[f64::NAN; N]; N];
    };
    let mut all = *a;
    change.apply(&mut all, |vector| *vector);
    all
}

/// How a symmetric matrix becomes the one with its eigenvalues replaced: a multiple of it, and `v vᵀ` of some orthogonal
/// vectors `v`. Eigenvectors are needed of one sign only, of that with fewer eigenvalues.
pub(super) struct Replacement<const N: usize> {
    factor: f64,
    vectors: [[f64; N]; N],
    count: usize,
}

impl<const N: usize> Replacement<N> {
    /// Changes a matrix; the vectors are brought into its basis, which may be of a larger space.
    #[inline(always)]
    pub(super) fn apply<const W: usize>(
        &self,
        matrix: &mut [[f64; W]; W],
        wide: impl Fn(&[f64; N]) -> [f64; W],
    ) {
        if self.factor != 1.0 {
            for entry in matrix.iter_mut().flatten() {
                *entry *= self.factor;
            }
        }
        for vector in self.vectors.iter().take(self.count) {
            let vector = wide(vector);
            for (row, x) in matrix.iter_mut().zip(&vector) {
                for (entry, y) in row.iter_mut().zip(&vector) {
                    *entry += x * y;
                }
            }
        }
    }
}

/// What replaces eigenvalues of a symmetric matrix; nothing where an entry is not finite.
///
/// After Householder's reduction to a tridiagonal matrix, whose negative eigenvalues are counted by its pivots, the implicit QL
/// method runs until as many are found, on the negated matrix if that has fewer. It finds small ones first: the first shift
/// for each is the least eigenvalue. (J. H. Wilkinson and C. Reinsch, Handbook for Automatic Computation II, 1971.)
pub(super) fn replacement<const N: usize>(
    matrix: &[[f64; N]; N],
    part: Part,
) -> Option<Replacement<N>> {
    let mut change = Replacement {
        factor: 1.0,
        vectors: [[0.0; N]; N],
        count: 0,
    };
    let largest = largest(matrix)?;
    if largest == 0.0 {
        return Some(change);
    }
    if largest < LEAST_NORMAL {
        let larger = matrix.map(|row| row.map(|x| x * power_of_two(400)));
        let mut change = replacement(&larger, part)?;
        for x in change.vectors.iter_mut().flatten() {
            *x *= power_of_two(-200);
        }
        return Some(change);
    }
    // entries around 1, so that no square of one is too large or too small
    let exponent = ((largest.to_bits() >> 52) as i64 - 1023) >> 1;
    let scale = power_of_two(-exponent);
    let Tridiagonal {
        mut diagonal,
        mut beside,
        reflections,
        inverses,
    } = tridiagonal(matrix.map(|row| row.map(|x| x * scale * scale)));

    // what is above may be 0 or positive
    let bound = -4.0 * N as f64 * f64::EPSILON;
    let mut wanted = below(&diagonal, &beside, bound);
    if 2 * wanted > N {
        wanted = N - wanted;
        change.factor = match part {
            Part::Positive => 0.0,
            Part::Absolute => -1.0,
        };
        for x in diagonal.iter_mut().chain(&mut beside) {
            *x = -*x;
        }
    }
    let times = match part {
        Part::Positive => 1.0,
        Part::Absolute => 2.0,
    };
    let mut vectors = [[0.0; N]; N];
    for (k, row) in vectors.iter_mut().enumerate() {
        row[k] = 1.0;
    }
    let mut found = 0;
    for first in 0..N {
        if found >= wanted {
            break;
        }
        settle(&mut diagonal, &mut beside, &mut vectors, first);
        let value = diagonal[first];
        if value < 0.0 {
            found += usize::from(value < bound);
            let mut vector = vectors[first];
            for (reflection, inverse) in reflections.iter().zip(&inverses) {
                let part = inverse * dot(reflection, &vector);
                for (x, y) in vector.iter_mut().zip(reflection) {
                    *x -= part * y;
                }
            }
            let length = (-times * value).sqrt() * power_of_two(exponent);
            change.vectors[change.count] = vector.map(|x| length * x);
            change.count += 1;
        }
    }
    Some(change)
}

/// `2ᵏ`, for `|k|` below 1023.
#[inline(always)]
fn power_of_two(k: i64) -> f64 {
    f64::from_bits(((k + 1023) as u64) << 52)
}

/// The largest absolute value; nothing where an entry is not finite.
#[inline(always)]
fn largest<const N: usize>(matrix: &[[f64; N]; N]) -> Option<f64> {
    // by columns, which are next to each other
    let (mut most, mut zeros) = ([0.0f64; N], [0.0; N]);
    for row in matrix {
        for ((most, zero), x) in most.iter_mut().zip(&mut zeros).zip(row) {
            let x = x.abs();
            *most = if x > *most { x } else { *most };
            // NaN from what is not finite
            *zero += x * 0.0;
        }
    }
    let largest = most.iter().fold(0.0f64, |most, x| most.max(*x));
    zeros.iter().all(|x| *x == 0.0).then_some(largest)
}

#[inline(always)]
fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    let mut sums = [0.0; 2];
    for k in 0..N {
        sums[k % 2] += a[k] * b[k];
    }
    sums[0] + sums[1]
}

/// A symmetric tridiagonal matrix, with the reflections that made it.
struct Tridiagonal<const N: usize> {
    diagonal: [f64; N],
    /// At `k` the entries between `k` and `k + 1`; the last is 0.
    beside: [f64; N],
    /// `I - inverse v vᵀ`; where the inverse is 0 there is none. The last was the first.
    reflections: [[f64; N]; N],
    inverses: [f64; N],
}

/// Householder's reduction of a matrix with entries up to 4, from the last row to the first.
#[inline(always)]
fn tridiagonal<const N: usize>(mut a: [[f64; N]; N]) -> Tridiagonal<N> {
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
fn below<const N: usize>(diagonal: &[f64; N], beside: &[f64; N], bound: f64) -> usize {
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
fn settle<const N: usize>(
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
fn lowest<const N: usize>(
    diagonal: &[f64; N],
    beside: &[f64; N],
    first: usize,
    last: usize,
) -> f64 {
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

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::DMatrix;

    fn dense<const N: usize>(a: &[[f64; N]; N]) -> DMatrix<f64> {
        DMatrix::from_fn(N, N, |i, j| a[i][j])
    }

    fn numbers() -> impl FnMut() -> f64 {
        let mut state = 0x9e37_79b9_7f4a_7c15_u64;
        move || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        }
    }

    fn symmetric<const N: usize>(next: &mut impl FnMut() -> f64) -> [[f64; N]; N] {
        let entries: [[f64; N]; N] = std::array::from_fn(|_| std::array::from_fn(|_| next()));
        std::array::from_fn(|i| std::array::from_fn(|j| entries[i.max(j)][i.min(j)]))
    }

    /// A matrix with these eigenvalues: reflected a few times.
    fn with_values<const N: usize>(
        values: [f64; N],
        next: &mut impl FnMut() -> f64,
    ) -> [[f64; N]; N] {
        let mut a = DMatrix::from_fn(N, N, |i, j| if i == j { values[i] } else { 0.0 });
        for _ in 0..N {
            let v = nalgebra::DVector::from_fn(N, |_, _| next()).normalize();
            let reflection = DMatrix::identity(N, N) - 2.0 * &v * v.transpose();
            a = &reflection * a * &reflection;
        }
        std::array::from_fn(|i| std::array::from_fn(|j| 0.5 * (a[(i, j)] + a[(j, i)])))
    }

    /// The vectors are orthogonal, and their squares the eigenvalues of one sign.
    #[track_caller]
    fn check_replacement<const N: usize>(
        a: &[[f64; N]; N],
        part: Part,
        eigenvalues: &[f64],
        scale: f64,
    ) {
        let change = replacement(a, part).unwrap();
        let tolerance = 16.0 * N as f64 * f64::EPSILON;
        let times = if part == Part::Absolute { 2.0 } else { 1.0 };
        let sign = if change.factor == 1.0 { -1.0 } else { 1.0 };
        let mut known: Vec<f64> = eigenvalues.iter().map(|x| (sign * x).max(0.0)).collect();
        known.sort_by(|x, y| y.total_cmp(x));
        let unit = (times * scale.max(f64::MIN_POSITIVE).min(f64::MAX / 4.0)).sqrt();
        let vectors = change.vectors.map(|vector| vector.map(|x| x / unit));
        let mut found = [0.0; N];
        for i in 0..N {
            assert!(i < change.count || vectors[i] == [0.0; N]);
            found[i] = dot(&vectors[i], &vectors[i]);
            for j in 0..i {
                let lengths = (found[i] * found[j]).sqrt();
                assert!(dot(&vectors[i], &vectors[j]).abs() <= tolerance * lengths);
            }
        }
        found.sort_by(|x, y| y.total_cmp(x));
        for (x, y) in found.iter().zip(&known) {
            assert!((x - y).abs() <= tolerance, "{x} {y}");
        }
    }

    #[track_caller]
    fn check<const N: usize>(a: &[[f64; N]; N]) {
        let scale = dense(a).amax();
        let near = |x: &DMatrix<f64>, y: &DMatrix<f64>, scale: f64| {
            let difference = (x - y).amax();
            assert!(
                difference <= 16.0 * N as f64 * f64::EPSILON * scale,
                "{x}{y}"
            );
        };
        // small and large entries overflow there
        let unit = dense(a) / scale.max(f64::MIN_POSITIVE);
        let expected = unit.clone().symmetric_eigen();
        let eigenvalues: Vec<f64> = expected.eigenvalues.iter().copied().collect();
        for part in [Part::Positive, Part::Absolute] {
            let values = DMatrix::from_diagonal(&expected.eigenvalues.map(|x| part.replace(x)));
            let vectors = &expected.eigenvectors;
            let expected = vectors * values * vectors.transpose();
            let found = dense(&replaced(a, part)) / scale.max(f64::MIN_POSITIVE);
            near(&found, &expected, 2.0);
            let entries = replaced(a, part);
            assert!((0..N * N).all(|k| entries[k / N][k % N] == entries[k % N][k / N]));
            check_replacement(a, part, &eigenvalues, scale);
            // what has become positive semi-definite stays
            let again = replaced(&replaced(a, part), part);
            near(&dense(&again), &dense(&replaced(a, part)), scale);
        }
    }

    fn check_size<const N: usize>() {
        let mut next = numbers();
        for round in 0..60 {
            let a = symmetric::<N>(&mut next);
            for scale in [1.0, 1e-150, 1e150, 1e-300, 1e300] {
                check(&a.map(|row| row.map(|x| x * scale)));
            }
            // repeated, with zeros, of very different sizes
            let kinds: [fn(usize) -> f64; 4] = [
                |k| if k % 2 == 0 { 1.0 } else { -1.0 },
                |k| if k == 0 { -1.0 } else { 0.0 },
                |k| 10f64.powi(-(2 * k as i32)) * if k % 2 == 0 { 1.0 } else { -1.0 },
                |k| (k / 2) as f64,
            ];
            check::<N>(&with_values(
                std::array::from_fn(kinds[round % 4]),
                &mut next,
            ));
        }
        check(&[[0.0; N]; N]);
        check(&[[1.0; N]; N]);
        check(&[[-1.0; N]; N]);
    }

    #[test]
    fn results_are_those_of_nalgebra() {
        check_size::<1>();
        check_size::<2>();
        check_size::<3>();
        check_size::<4>();
        check_size::<5>();
        check_size::<6>();
        check_size::<7>();
        check_size::<8>();
        check_size::<9>();
        check_size::<10>();
        check_size::<11>();
        check_size::<12>();
    }

    #[test]
    fn numbers_that_are_not_finite_end() {
        for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for at in 0..3 {
                let mut a = [[1.0, 2.0, 0.0], [2.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
                a[at][0] = x;
                a[0][at] = x;
                assert!(replacement(&a, Part::Absolute).is_none());
                let found = replaced(&a, Part::Positive);
                assert!(found.iter().flatten().all(|entry| entry.is_nan()));
                assert!(!is_positive_semidefinite::<3>(&nalgebra::Matrix3::from(a)));
            }
        }
    }

    #[test]
    fn semidefinite_matrices_are_seen() {
        let mut next = numbers();
        for _ in 0..200 {
            // of rank 4
            let b = nalgebra::SMatrix::<f64, 4, 6>::from_fn(|_, _| next());
            assert!(is_positive_semidefinite::<6>(&(b.transpose() * b)));
            assert!(!is_positive_semidefinite::<6>(&-(b.transpose() * b)));
        }
        let less = nalgebra::Matrix2::new(1.0, 1.0, 1.0, 1.0 - 1e-12);
        assert!(!is_positive_semidefinite::<2>(&less));
        let crossed = nalgebra::Matrix2::new(0.0, 1.0, 1.0, 0.0);
        assert!(!is_positive_semidefinite::<2>(&crossed));
    }
}
