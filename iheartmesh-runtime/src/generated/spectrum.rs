//! Symmetric matrices of small fixed sizes: whether they are positive semi-definite, and with their eigenvalues replaced.
//! Nothing here allocates, up to 30 rows.

use super::array::Array;
use super::lanes::Lanes;
use super::tridiagonal::{Rotations, Tridiagonal};

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

/// How symmetric matrices become those with their eigenvalues replaced: multiples of them, and `v vᵀ` of some orthogonal
/// vectors `v`. Eigenvectors are needed of one sign only, of that with fewer eigenvalues. No matrix has an effect on those
/// beside it.
pub(super) struct Replacements<const N: usize, const L: usize> {
    tridiagonal: Tridiagonal<N, L>,
    /// The square roots of what the matrices were divided by.
    units: Lanes<L>,
    /// How many eigenvalues are replaced.
    wanted: Lanes<L>,
    part: Part,
}

impl<const N: usize, const L: usize> Replacements<N, L> {
    /// For matrices of zeros.
    #[inline(always)]
    pub(super) fn new(part: Part) -> Self {
        Self {
            tridiagonal: Tridiagonal::new(),
            units: Lanes::splat(1.0),
            wanted: Lanes::splat(0.0),
            part,
        }
    }

    /// The rows of the matrices, of which the lower triangles are used.
    #[inline(always)]
    pub(super) fn rows(&mut self) -> &mut [[Lanes<L>; N]; N] {
        &mut self.tridiagonal.rows
    }

    /// What the matrices are multiplied by: NaN where an entry is not finite.
    ///
    /// After Householder's reduction to a tridiagonal matrix its negative eigenvalues are counted by its pivots.
    #[inline(always)]
    pub(super) fn factors(&mut self) -> Lanes<L> {
        let (zero, one) = (Lanes::splat(0.0), Lanes::splat(1.0));
        let Self {
            tridiagonal, units, ..
        } = self;
        let (mut largest, mut zeros) = (zero, zero);
        for (i, row) in tridiagonal.rows.iter().enumerate() {
            for x in &row[..=i] {
                largest = x.abs().max(largest);
                // NaN from what is not finite
                zeros += *x * 0.0;
            }
        }
        let mut scales = one;
        let mut failed = zero;
        for lane in 0..L {
            if zeros[lane] != 0.0 {
                failed[lane] = f64::NAN;
                scales[lane] = 0.0;
            } else if largest[lane] > 0.0 {
                // entries around 1, so that no square of one is too large or too small
                let more = if largest[lane] < LEAST_NORMAL { 200 } else { 0 };
                let larger = largest[lane] * power_of_two(2 * more);
                let exponent = (((larger.to_bits() >> 52) as i64 - 1023) >> 1) - more;
                scales[lane] = power_of_two(-exponent);
                units[lane] = power_of_two(exponent);
            }
        }
        let finite = one.greater(failed);
        for (i, row) in tridiagonal.rows.iter_mut().enumerate() {
            for x in &mut row[..=i] {
                *x = Lanes::select(finite, *x * scales * scales, zero) + zero;
            }
        }
        tridiagonal.reduce();
        let [negative, others] = tridiagonal.below([-bound::<N>(), bound::<N>()]);
        let positive = Lanes::splat(N as f64) - others;
        let negated = negative.greater(positive);
        tridiagonal.scale(Lanes::select(negated, -one, one));
        self.wanted = negative.min(positive);
        let factor = match self.part {
            Part::Positive => 0.0,
            Part::Absolute => -1.0,
        };
        Lanes::select(negated, Lanes::splat(factor), one) + failed
    }

    /// Then hands over vectors: one for each of some matrices, as often as needed.
    ///
    /// The implicit QL method runs until as many eigenvalues are found as are to be replaced, on the negated matrix if that has
    /// fewer negative ones. It finds small ones first: the first shift for each is the least eigenvalue. (J. H. Wilkinson and
    /// C. Reinsch, Handbook for Automatic Computation II, 1971.)
    #[inline(always)]
    pub(super) fn for_each_vector(
        &mut self,
        mut use_vectors: impl FnMut(&[bool; L], &[Lanes<L>; N]),
    ) {
        let zero = Lanes::splat(0.0);
        let times = match self.part {
            Part::Positive => 1.0,
            Part::Absolute => 2.0,
        };
        let mut rotations = Rotations::new();
        for first in 0..N {
            if self.wanted.most() <= 0.0 {
                break;
            }
            let unfinished = self.wanted.greater(zero);
            self.tridiagonal.settle(&mut rotations, first, unfinished);
            let values = self.tridiagonal.diagonal[first];
            let negative = zero.greater(values);
            let used: [bool; L] = std::array::from_fn(|lane| unfinished[lane] && negative[lane]);
            if !used.contains(&true) {
                continue;
            }
            let counts = Lanes::splat(-bound::<N>()).greater(values);
            self.wanted -= Lanes::select(counts, Lanes::splat(1.0), zero);
            let lengths = Lanes::select(used, -values * times, zero).sqrt() * self.units;
            let vectors = self.tridiagonal.vectors(&rotations, first);
            // no -0, which rotations by nothing leave or not
            use_vectors(&used, &vectors.map(|x| lengths * x + zero));
        }
    }
}

/// What lies between the negative of this and this may be 0, for matrices with entries around 1.
#[inline(always)]
fn bound<const N: usize>() -> f64 {
    4.0 * N as f64 * f64::EPSILON
}

/// `2ᵏ`, for `|k|` below 1023.
#[inline(always)]
pub(super) fn power_of_two(k: i64) -> f64 {
    f64::from_bits(((k + 1023) as u64) << 52)
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

    /// What becomes of matrices side by side: factors, and vectors.
    type Changes<const N: usize> = Vec<(f64, Vec<[f64; N]>)>;

    fn changes<const N: usize, const L: usize>(a: &[[[f64; N]; N]; L], part: Part) -> Changes<N> {
        let mut changes = Replacements::<N, L>::new(part);
        for (i, row) in changes.rows().iter_mut().enumerate() {
            for (j, x) in row.iter_mut().enumerate() {
                *x = Lanes(std::array::from_fn(|lane| a[lane][i][j]));
            }
        }
        let factors = changes.factors();
        let mut found: Changes<N> = factors.0.map(|factor| (factor, Vec::new())).into();
        changes.for_each_vector(|used, vectors| {
            for lane in (0..L).filter(|lane| used[*lane]) {
                found[lane].1.push(vectors.map(|x| x[lane]));
            }
        });
        found
    }

    fn replaced<const N: usize>(a: &[[f64; N]; N], part: Part) -> [[f64; N]; N] {
        let (factor, vectors) = changes(&[*a], part).remove(0);
        let mut all = a.map(|row| row.map(|x| factor * x));
        for v in vectors {
            for (i, row) in all.iter_mut().enumerate() {
                for (j, entry) in row.iter_mut().enumerate() {
                    *entry += v[i] * v[j];
                }
            }
        }
        all
    }

    /// The vectors are orthogonal, and their squares the eigenvalues of one sign.
    #[track_caller]
    fn check_replacement<const N: usize>(
        a: &[[f64; N]; N],
        part: Part,
        eigenvalues: &[f64],
        scale: f64,
    ) {
        let (factor, vectors) = changes(&[*a], part).remove(0);
        let tolerance = 16.0 * N as f64 * f64::EPSILON;
        let times = if part == Part::Absolute { 2.0 } else { 1.0 };
        let sign = if factor == 1.0 { -1.0 } else { 1.0 };
        let mut known: Vec<f64> = eigenvalues.iter().map(|x| (sign * x).max(0.0)).collect();
        known.sort_by(|x, y| y.total_cmp(x));
        let unit = (times * scale.clamp(f64::MIN_POSITIVE, f64::MAX / 4.0)).sqrt();
        let vectors: Vec<_> = vectors
            .iter()
            .map(|v| nalgebra::SVector::from(*v) / unit)
            .collect();
        let mut found: Vec<f64> = vectors.iter().map(|v| v.dot(v)).collect();
        for i in 0..vectors.len() {
            for j in 0..i {
                let lengths = (found[i] * found[j]).sqrt();
                assert!(vectors[i].dot(&vectors[j]).abs() <= tolerance * lengths);
            }
        }
        found.resize(N, 0.0);
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

    /// Matrices of all kinds: a lane has much or little to do, waits for others, or nothing.
    fn any<const N: usize>(kind: usize, next: &mut impl FnMut() -> f64) -> [[f64; N]; N] {
        let a = symmetric::<N>(next);
        match kind {
            0 => a,
            1 => [[0.0; N]; N],
            2 => a.map(|row| row.map(|x| x * 1e-300)),
            3 => a.map(|row| row.map(|x| x * 1e300)),
            4 => [[f64::INFINITY; N]; N],
            5 => with_values(std::array::from_fn(|k| (k % 2) as f64 - 0.5), next),
            // definite, of either sign
            6 => with_values([1.0; N], next),
            7 => with_values([-1.0; N], next),
            // falls apart in several places, also with -0
            8 => std::array::from_fn(|i| {
                std::array::from_fn(|j| if i / 2 == j / 2 { a[i][j] } else { -0.0 })
            }),
            9 => std::array::from_fn(|i| {
                std::array::from_fn(|j| if i.abs_diff(j) < 2 { a[i][j] } else { 0.0 })
            }),
            10 => std::array::from_fn(|i| {
                std::array::from_fn(|j| if i == j { a[i][j] - 0.5 } else { -0.0 })
            }),
            // of small rank
            _ => std::array::from_fn(|i| {
                std::array::from_fn(|j| a[0][i] * a[0][j] - a[0][N - 1 - i] * a[0][N - 1 - j])
            }),
        }
    }

    fn bits<const N: usize>((factor, vectors): &(f64, Vec<[f64; N]>)) -> Vec<u64> {
        let vectors = vectors.iter().flatten();
        let all = std::iter::once(factor).chain(vectors);
        all.map(|x| x.to_bits()).collect()
    }

    fn check_lanes<const N: usize, const L: usize>() {
        let mut next = numbers();
        for round in 0..200 {
            let part = if round % 2 == 0 {
                Part::Positive
            } else {
                Part::Absolute
            };
            let all: [[[f64; N]; N]; L] = std::array::from_fn(|_| {
                let kind = (next().abs() * 12.0) as usize;
                any(kind, &mut next)
            });
            let found = changes(&all, part);
            for (a, found) in all.iter().zip(&found) {
                assert_eq!(bits(found), bits(&changes(&[*a], part)[0]));
            }
        }
    }

    #[test]
    fn results_do_not_depend_on_what_is_beside() {
        check_lanes::<1, 8>();
        check_lanes::<2, 8>();
        check_lanes::<3, 2>();
        check_lanes::<4, 8>();
        check_lanes::<6, 3>();
        check_lanes::<9, 4>();
        check_lanes::<9, 8>();
        check_lanes::<12, 8>();
    }

    #[test]
    fn numbers_that_are_not_finite_end() {
        for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for at in 0..3 {
                let mut a = [[1.0, 2.0, 0.0], [2.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
                a[at][0] = x;
                a[0][at] = x;
                // those beside it stay what they are
                let beside = [[0.0, 3.0, 0.0], [3.0, 0.0, 0.0], [0.0, 0.0, -2.0]];
                let found = changes(&[beside, a, beside], Part::Positive);
                assert!(found[1].0.is_nan() && found[1].1.is_empty());
                assert_eq!(found[0], found[2]);
                assert_eq!(found[0], changes(&[beside], Part::Positive)[0]);
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
