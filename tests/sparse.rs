//! Sparse matrices: equations, operators, blocks, against nalgebra's dense ones, with and without optimisations.

use iheartmesh::glam::DVec3;
use iheartmesh::sprs::{CsMat, TriMat};
use nalgebra::{DMatrix, DVector, dmatrix, dvector};

#[macro_use]
#[path = "support/twice.rs"]
mod twice;

programs! {
    Equations, PlainEquations = r#"
        A, B ∈ ℝ^(n×n) sparse
        D ∈ ℝ^(n×n)
        b ∈ ℝ^n
        h ∈ ℝ
        x = A \ b
        y = (I_n - h A)⁻¹ b
        X = A \ D
        Y = A \ B
        Z = A⁻¹
        s(k) = (A - k I_n) \ b where k ∈ ℝ
    "#;

    Operators, PlainOperators = r#"
        A ∈ ℝ^(n×m) sparse
        B ∈ ℝ^(m×n) sparse
        D ∈ ℝ^(m×n)
        h ∈ ℝ
        S = Aᵀ - 2 B/3
        P = A B
        L = A D
        R = D A
        N = -(h A)
        K = A ⊗ D
        J = D ⊗ A
        T = A ⊗ B
        M = [A 0
             1 Bᵀ
             0 I]
        Q = [P I; 0 I_n]
        f = A : Dᵀ + Dᵀ : A + ‖A‖
        first(M) = M_1,1 + ∑_i ∑_j M_ij where M ∈ ℝ^(p×q)
        t = first(A)
        g ∈ ℝ^(n×m) → ℝ
        u = g(A)
    "#;

    Sums, PlainSums = r#"
        W ∈ ℝ^(n×m) sparse
        x ∈ ℝ^m
        u ∈ ℝ^n
        p_j ∈ ℝ³
        y_i = ∑_j W_ij x_j
        z_i = ∑_(j for j ≠ i) 2 W_ij
        c = ∑_i W_i,2 u_i²
        q_i = ∑_j -W_ij p_j / 2
        e = ∑_i ∑_j u_i W_ij x_j
        o = ∑_j (W_1,j + x_j)
        a = ∑_(j = 1)^2 W_2,j
        S = W Wᵀ
        r_i = ∑_j S_ij
        row(k) = ∑_j W_kj x_j where k ∈ ℤ
    "#;
}

fn sparse(a: &DMatrix<f64>) -> CsMat<f64> {
    let mut entries = TriMat::new(a.shape());
    for i in 0..a.nrows() {
        for j in 0..a.ncols() {
            if a[(i, j)] != 0.0 {
                entries.add_triplet(i, j, a[(i, j)]);
            }
        }
    }
    // one storage as well as the other
    match a.nrows().is_multiple_of(2) {
        true => entries.to_csr(),
        false => entries.to_csc(),
    }
}

fn dense(a: &CsMat<f64>) -> DMatrix<f64> {
    DMatrix::from_fn(a.rows(), a.cols(), |i, j| {
        a.get(i, j).copied().unwrap_or(0.0)
    })
}

fn near(a: &DMatrix<f64>, b: &DMatrix<f64>) {
    assert_eq!(a.shape(), b.shape());
    assert!(
        (a - b).amax() <= 1e-12 * b.amax().max(1.0),
        "{a} is not {b}"
    );
}

for_both! {
    #[test]
    fn equations() {
        let a = dmatrix![0.0, 2.0, 0.0; -1.0, 0.5, 3.0; 4.0, 0.0, 0.0];
        let b = dmatrix![1.0, 0.0, 0.0; 0.0, 0.0, -2.0; 0.0, 5.0, 0.0];
        let d = dmatrix![1.0, 2.0, 3.0; 4.0, 5.0, 6.0; 7.0, 8.0, 10.0];
        let right = dvector![1.0, -2.0, 0.5];
        let identity = DMatrix::identity(3, 3);
        let m = Equations::new(sparse(&a), sparse(&b), &d, &right, 0.1).expect("valid");
        let inverse = a.clone().try_inverse().expect("regular");
        let column = |x: DVector<f64>| DMatrix::from_column_slice(3, 1, x.as_slice());
        near(&column(m.x()), &column(&inverse * &right));
        let shifted = (&identity - 0.1 * &a).try_inverse().expect("regular");
        near(&column(m.y()), &column(shifted * &right));
        near(&m.X(), &(&inverse * &d));
        near(&dense(&m.Y()), &(&inverse * &b));
        near(&dense(&m.Z()), &inverse);
        let shifted = (&a - 0.5 * &identity).try_inverse().expect("regular");
        near(&column(m.s(0.5)), &column(shifted * &right));
    }

    #[test]
    fn singular_systems_have_no_solution() {
        let a = dmatrix![2.0, -1.0, -1.0; -1.0, 2.0, -1.0; -1.0, -1.0, 2.0];
        let m = Equations::new(sparse(&a), sparse(&a), &a, dvector![1.0, 0.0, 0.0], 0.0).expect("valid");
        let error = m.try_s(0.0).expect_err("constants are in the kernel").to_string();
        assert!(error.starts_with("`s(0)` has no value: the matrix of the system is singular in"), "{error}");
        assert!(m.try_s(-1.0).is_ok());
        assert!(m.try_x().is_err() && m.try_X().is_err() && m.try_Y().is_err() && m.try_Z().is_err());
    }

    #[test]
    fn operators() {
        let a = dmatrix![0.0, 2.0, 0.0; -1.0, 0.0, 3.0];
        let b = dmatrix![0.0, 6.0; 0.0, -3.0; 1.5, 0.0];
        let d = dmatrix![1.0, 2.0; 3.0, 4.0; 5.0, 6.0];
        let m = Operators::new(sparse(&a), sparse(&b), &d, 2.0, |x: DMatrix<f64>| 2.0 * x[(1, 2)]).expect("valid");
        near(&dense(&m.S()), &(a.transpose() - 2.0 * &b / 3.0));
        near(&dense(&m.P()), &(&a * &b));
        near(&m.L(), &(&a * &d));
        near(&m.R(), &(&d * &a));
        near(&dense(&m.N()), &(-2.0 * &a));
        near(&dense(&m.K()), &a.kronecker(&d));
        near(&dense(&m.J()), &d.kronecker(&a));
        near(&dense(&m.T()), &a.kronecker(&b));
        let mut blocks = DMatrix::zeros(7, 6);
        blocks.view_mut((0, 0), (2, 3)).copy_from(&a);
        blocks.view_mut((2, 0), (2, 3)).fill(1.0);
        blocks.view_mut((2, 3), (2, 3)).copy_from(&b.transpose());
        blocks.view_mut((4, 3), (3, 3)).fill_with_identity();
        near(&dense(&m.M()), &blocks);
        let mut blocks = DMatrix::identity(4, 4);
        blocks.view_mut((0, 0), (2, 2)).copy_from(&(&a * &b));
        blocks.view_mut((0, 2), (2, 2)).fill_with_identity();
        near(&dense(&m.Q()), &blocks);
        // zeros are not stored
        assert_eq!((m.Q().nnz(), m.M().nnz()), (3 + 4, 3 + 6 + 3 + 3));
        let product = a.component_mul(&d.transpose()).sum();
        assert!((m.f() - (2.0 * product + a.norm())).abs() < 1e-12);
        assert_eq!((m.t(), m.u()), (a.sum(), 6.0));
    }

    #[test]
    fn sums_along_rows_and_columns() {
        let w = dmatrix![0.0, 2.0, 0.0, -1.0; 3.0, 0.0, 0.0, 0.0; 0.0, 0.0, 0.0, 0.0];
        let (x, u) = (dvector![1.0, 2.0, 3.0, 4.0], dvector![5.0, 6.0, 7.0]);
        let p: Vec<DVec3> = (0..4).map(|j| DVec3::new(1.0, f64::from(j), 2.0)).collect();
        for stored in [sparse(&w).to_csc(), sparse(&w).to_csr()] {
            let m = Sums::new(stored, &x, &u, &p).expect("valid");
            assert_eq!(m.y(), &w * &x);
            assert_eq!(m.z(), DVector::from_fn(3, |i, _| 2.0 * (w.row(i).sum() - w[(i, i)])));
            assert_eq!(m.c(), 2.0 * 25.0);
            let expected = |i: usize| (0..4).map(|j| -w[(i, j)] * p[j] / 2.0).sum::<DVec3>();
            assert_eq!(m.q(), vec![expected(0), expected(1), expected(2)]);
            assert_eq!(m.e(), u.dot(&(&w * &x)));
            assert_eq!((m.o(), m.a()), (1.0 + 10.0, 3.0));
            assert_eq!(m.r(), &w * w.transpose() * dvector![1.0, 1.0, 1.0]);
            assert_eq!(m.row(2), 3.0);
            for k in [0, 4] {
                let error = m.try_row(k).expect_err("no such row").to_string();
                assert!(error.contains("the matrix has no such entry in `W_kj`"), "{error}");
            }
            let error = Sums::new(sparse(&w), &x, &u, &p[..3]).expect_err("too short");
            assert_eq!(
                error.to_string(),
                "the length of `p` is 3 but the number of columns of `W` is 4: the index `j` runs over both"
            );
        }
    }
}
