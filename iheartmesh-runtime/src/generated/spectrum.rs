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

/// Sweeps of Jacobi's method before it is given up; it settles after 6 to 8.
const MOST_SWEEPS: usize = 40;

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
fn has_positive_pivots<const N: usize>(mut a: [[f64; N]; N]) -> bool {
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

/// A symmetric matrix with its eigenvalues replaced. One that is positive semi-definite stays as it is; where an entry
/// is not finite, all become NaN.
pub fn replaced<const N: usize>(a: &[[f64; N]; N], part: Part) -> [[f64; N]; N] {
    if N == 1 {
        return a.map(|row| row.map(|entry| part.replace(entry)));
    }
    if has_positive_pivots(*a) {
        return *a;
    }
    let Some((values, vectors)) = eigen(a) else {
        return [[f64::NAN; N]; N];
    };
    // only what changes is added
    let mut all = *a;
    for (value, vector) in values.iter().zip(&vectors) {
        let change = part.replace(*value) - value;
        if change != 0.0 {
            for (row, x) in all.iter_mut().zip(vector) {
                let x = change * x;
                for (entry, y) in row.iter_mut().zip(vector) {
                    *entry += x * y;
                }
            }
        }
    }
    all
}

/// The eigenvalues of a symmetric matrix, in no order, and their eigenvectors, by Jacobi's cyclic method; nothing where an
/// entry is not finite.
///
/// J. Demmel and K. Veselić, Jacobi's method is more accurate than QR, 1992; the rotations are those of H. Rutishauser, 1966.
pub fn eigen<const N: usize>(matrix: &[[f64; N]; N]) -> Option<([f64; N], [[f64; N]; N])> {
    let largest = matrix
        .iter()
        .flatten()
        .try_fold(0.0f64, |most, x| x.is_finite().then(|| most.max(x.abs())))?;
    let mut vectors = [[0.0; N]; N];
    for (k, row) in vectors.iter_mut().enumerate() {
        row[k] = 1.0;
    }
    if largest == 0.0 {
        return Some(([0.0; N], vectors));
    }
    // entries around 1, so that no square of one is too large or too small
    let mut a = matrix.map(|row| row.map(|x| x / largest));
    // what is smaller changes no eigenvalue in its last digit
    let least = f64::EPSILON / 16.0;
    // pairs in rounds as of a tournament: those of a round have no row in common, so that their rotations do not wait for
    // each other
    let players = N + N % 2;
    for _ in 0..MOST_SWEEPS {
        let mut settled = true;
        for round in 0..players - 1 {
            let mut pairs = [(0, 0, 0.0, 0.0); N];
            let mut n = 0;
            for k in 0..players / 2 {
                let x = (round + k) % (players - 1);
                let y = match k {
                    0 => players - 1,
                    _ => (round + players - 1 - k) % (players - 1),
                };
                let (p, q) = (x.min(y), x.max(y));
                if q < N && a[p][q].abs() > least {
                    let (cosine, sine) = rotation(a[p][p], a[q][q], a[p][q]);
                    pairs[n] = (p, q, cosine, sine);
                    n += 1;
                }
            }
            settled &= n == 0;
            rotate(&mut a, &mut vectors, &pairs[..n]);
        }
        if settled {
            break;
        }
    }
    let mut values = [0.0; N];
    for (k, value) in values.iter_mut().enumerate() {
        *value = a[k][k] * largest;
    }
    Some((values, vectors))
}

/// Cosine and sine of the smaller angle that makes the entry `off` 0 between two on the diagonal.
#[inline(always)]
fn rotation(pp: f64, qq: f64, off: f64) -> (f64, f64) {
    let (difference, twice) = (qq - pp, 2.0 * off);
    let root = (difference * difference + twice * twice).sqrt();
    let tangent = twice / (difference + root.copysign(difference));
    let cosine = 1.0 / (tangent * tangent + 1.0).sqrt();
    (cosine, tangent * cosine)
}

/// Rotates pairs of rows and columns; no row is in two of them.
#[inline(always)]
fn rotate<const N: usize>(
    a: &mut [[f64; N]; N],
    vectors: &mut [[f64; N]; N],
    pairs: &[(usize, usize, f64, f64)],
) {
    for (p, q, cosine, sine) in pairs {
        for rows in [&mut *a, &mut *vectors] {
            let (mut x, mut y) = (rows[*p], rows[*q]);
            for (x, y) in x.iter_mut().zip(&mut y) {
                (*x, *y) = (cosine * *x - sine * *y, sine * *x + cosine * *y);
            }
            rows[*p] = x;
            rows[*q] = y;
        }
    }
    for row in &mut *a {
        for (p, q, cosine, sine) in pairs {
            let (x, y) = (row[*p], row[*q]);
            row[*p] = cosine * x - sine * y;
            row[*q] = sine * x + cosine * y;
        }
    }
    for (p, q, ..) in pairs {
        a[*p][*q] = 0.0;
        a[*q][*p] = 0.0;
    }
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

    #[track_caller]
    fn check<const N: usize>(a: &[[f64; N]; N]) {
        let scale = dense(a).amax();
        let (values, vectors) = eigen(a).unwrap();
        let (values, vectors) = (DMatrix::from_row_slice(N, 1, &values), dense(&vectors));
        let near = |x: &DMatrix<f64>, y: &DMatrix<f64>, scale: f64| {
            let difference = (x - y).amax();
            assert!(
                difference <= 16.0 * N as f64 * f64::EPSILON * scale,
                "{x}{y}"
            );
        };
        near(
            &(&vectors * vectors.transpose()),
            &DMatrix::identity(N, N),
            1.0,
        );
        let diagonal = DMatrix::from_diagonal(&values.column(0).into_owned());
        near(
            &(vectors.transpose() * diagonal * &vectors),
            &dense(a),
            scale,
        );
        // small and large entries overflow there
        let unit = dense(a) / scale.max(f64::MIN_POSITIVE);
        let expected = unit.clone().symmetric_eigen();
        let mut sorted: Vec<f64> = values
            .iter()
            .map(|x| x / scale.max(f64::MIN_POSITIVE))
            .collect();
        let mut known: Vec<f64> = expected.eigenvalues.iter().copied().collect();
        sorted.sort_by(f64::total_cmp);
        known.sort_by(f64::total_cmp);
        for (x, y) in sorted.iter().zip(&known) {
            assert!((x - y).abs() <= 16.0 * N as f64 * f64::EPSILON, "{x} {y}");
        }
        for part in [Part::Positive, Part::Absolute] {
            let values = DMatrix::from_diagonal(&expected.eigenvalues.map(|x| part.replace(x)));
            let vectors = &expected.eigenvectors;
            let expected = vectors * values * vectors.transpose();
            let found = dense(&replaced(a, part)) / scale.max(f64::MIN_POSITIVE);
            near(&found, &expected, 2.0);
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
    fn eigenvalues_are_those_of_nalgebra() {
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
                assert!(eigen(&a).is_none());
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
