//! Symmetric matrices of small fixed sizes: whether they are positive semi-definite, and with their eigenvalues replaced.
//! Nothing here allocates.

use super::array::Array;
use super::tridiagonal::{Tridiagonal, below, dot, settle, tridiagonal};

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

/// Matrices with smaller entries are multiplied first.
pub(super) const LEAST_NORMAL: f64 = 1e-290;

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

    // what lies between may be 0
    let bound = 4.0 * N as f64 * f64::EPSILON;
    let mut wanted = below(&diagonal, &beside, -bound);
    let positive = N - below(&diagonal, &beside, bound);
    if positive < wanted {
        wanted = positive;
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
            found += usize::from(value < -bound);
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
pub(super) fn power_of_two(k: i64) -> f64 {
    f64::from_bits(((k + 1023) as u64) << 52)
}

/// The largest absolute value; nothing where an entry is not finite.
#[inline(always)]
pub(super) fn largest<const N: usize>(matrix: &[[f64; N]; N]) -> Option<f64> {
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
        let unit = (times * scale.clamp(f64::MIN_POSITIVE, f64::MAX / 4.0)).sqrt();
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
