//! Programs of linear algebra: sequences, products, ranks, functions of any size, sizes that are handed in.

use iheartmesh::glam::{DMat2, DVec2, DVec3};
use nalgebra::{DMatrix, DVector, SMatrix, dmatrix, dvector};

#[macro_use]
#[path = "support/twice.rs"]
mod twice;

programs! {
    Sequences, PlainSequences = r#"
        vec, vec⁻¹ from linearalgebra
        q_i ∈ ℝ^(2×2)
        x_i ∈ ℝ³
        w_i ∈ ℝ
        t = ∑_i q_i,1,2
        u = ∑_i ∑_r ∑_c q_i,r,c
        v = vec(x)
        y = vec⁻¹_x(2 v)
        z = vec(q_1)
        p = vec⁻¹_q(vec(q) + vec(q))
        r_i = q_i (1, 1)
        s = ∑_i q_i,*,2
        a = ∑_(i for i > 1 and w_i > 0) w_i x_i
        b = ∑_(i for i > 1 and w_i > 0) w_i
    "#;

    Products, PlainProducts = r#"
        A ∈ ℝ^(n×n)
        x ∈ ℝ^n
        k ∈ ℤ
        a = xᵀ x + 1
        b = √(xᵀ A x)
        c = (xᵀ A x) x
        d = { 1 if xᵀ x > 0; 0 otherwise
        e = A³
        f = A^k
        g = x ⊗ x
        h = xᵀ ⊗ x
        D_ii = x_i
        o = D x
        p = D A
        q = A D
        r = xᵀ D x
        s = Dᵀ + 2 D
        t = [A x; xᵀ 1]
        u = A⁻¹ A
        v = xᵀ A⁻¹
        w = x/x_1
        y = [x x]
        z = A A⁻¹ x
        multiples = [A I/x_1; -2I/x_1 -x_2⋅I/(2x_1)]
    "#;

    Deficient, PlainDeficient = r#"
        rank, null, orth, psd, svd, det from linearalgebra
        A ∈ ℝ^(m×n)
        S ∈ ℝ^(k×k)
        B ∈ ℝ^(2×3)
        r = rank(A)
        N = null(A)
        O = orth(A)
        P = psd(S)
        z = A N
        p = A⁺
        U, s, V = svd(B)
        b = rank(B)
        K = null(B)
        d = det(S)
        c = ‖S‖_*
    "#;

    Overloads, PlainOverloads = r#"
        A ∈ ℝ^(m×n)
        x ∈ ℝ^n
        u ∈ ℝ²
        v ∈ ℝ³
        h ∈ ℝ^n → ℝ^m
        f(a) = 2 where a ∈ ℝ²
        f(a) = 3 where a ∈ ℝ³
        f(a) = p where a ∈ ℝ^p
        g(B) = Bᵀ B where B ∈ ℝ^(p×q)
        l(a) = ∑_i a_i / p where a ∈ ℝ^p
        z(a) = [a 1_p] where a ∈ ℝ^p
        s = 100 f(u) + 10 f(v) + f(x)
        t = g(A) + I_n
        w = l(u) + l(x)
        y = A x + h(x)
        c = z(x)
        k_i = (z(v))_i,1
    "#;

    Letters, PlainLetters = r#"
        a_n ∈ ℝ
        b ∈ ℝ^n
        B ∈ ℝ^(2×3)
        C ∈ ℝ^(2×1)
        s = ∑_n a_n
        t = ∑_(i = 1)^n b_i
        K = [B C; C B]
        m = 3 n
        o = 1_(n,2)
        z = (b, 0, b)
        e_i = i b_i
    "#;

    Sparse, PlainSparse = r#"
        null from linearalgebra
        A ∈ ℝ^(n×n) sparse
        B ∈ ℝ^(2×3)
        C ∈ ℝ^(3×1)
        x ∈ ℝ^n
        a = A x
        b = Aᵀ x
        c = A A
        d = A + A
        e = A - I_n
        f = xᵀ A x
        g = 2 A
        h = A_1,2
        s = ∑_i A_ii
        t = A⁻¹ x
        D_ii = x_i
        E = D + A
        F = I_n + D
        u = { A if x_1 > 0
              2 A otherwise
        v = { A if x_1 < 0
              I_n otherwise
        w = null(B) + C
        y = C + null(B)
        z = null(B) + null(B)
    "#;

    Shapes, PlainShapes = r#"
        v ∈ ℝ³
        A ∈ ℝ^(n×n)
        a ∈ ℤ^n
        B ∈ ℤ^(2×2)
        f(a) = tuple(a, 2a) where a ∈ ℝ^p
        s, t = f(v)
        w = s + t
        z = B (1, 2)
        c = a_1 + 1
        u = ∑_i a_i
        d = |B|
        P(k) = { I_n if k < 1
                 A P(k - 1) otherwise
            where k ∈ ℤ
        g(i, j) = A_i,j where i, j ∈ ℤ
        B̄_ij = g(i, j) + A_ij
        h(s) = ‖y‖ where s ∈ ℝ, y_i = s A_i,1
        S = {A_1,*, A_2,*, A_1,*}
        T = { x⋅x for x ∈ S }
        Q = {A, 0 A}
        R = { [v (0 v)] for x ∈ S }
    "#;

    Counts, PlainCounts = r#"
        n, m ∈ ℤ
        b ∈ ℝ^n
        o = 1_m
        c = [b 1_n]
        f(n) = 1_n where n ∈ ℤ
        g(k) = ‖1_(k,k)‖² where k ∈ ℤ
        y = 0_(m,n)
    "#;
}

fn close(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-12 * (1.0 + b.abs()), "{a} is not {b}");
}

for_both! {
#[test]
fn sequences() {
    let q = [DMat2::from_cols_array(&[1.0, 3.0, 2.0, 4.0]), DMat2::from_cols_array(&[5.0, 7.0, 6.0, 8.0])];
    let x = [DVec3::new(1.0, 2.0, 3.0), DVec3::new(4.0, 5.0, 6.0), DVec3::new(7.0, 8.0, 9.0)];
    assert!(Sequences::new(q, x, [1.0, 1.0, 1.0]).is_err());
    let mut module = Sequences::new(q, &x[..2], [1.0, -1.0]).unwrap();
    close(module.t(), 8.0);
    close(module.u(), 36.0);
    assert_eq!(module.v(), dvector![1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    assert_eq!(module.y()[..], [x[0] * 2.0, x[1] * 2.0]);
    assert_eq!(module.z().to_array(), [1.0, 3.0, 2.0, 4.0]);
    assert_eq!(module.p()[..], [q[0] * 2.0, q[1] * 2.0]);
    assert_eq!(module.r()[..], [DVec2::new(3.0, 7.0), DVec2::new(11.0, 15.0)]);
    assert_eq!(module.s(), DVec2::new(8.0, 12.0));
    assert_eq!(module.a(), DVec3::ZERO);
    module.set_w([1.0, 2.0]).unwrap();
    assert_eq!(module.a(), x[1] * 2.0);
    close(module.b(), 2.0);
    assert!(module.set_w([1.0]).is_err());
}

#[test]
fn products() {
    let a = dmatrix![2.0, 1.0; 1.0, 3.0];
    let x = dvector![1.0, 2.0];
    let mut module = Products::new(&a, &x, 2).unwrap();
    close(module.a(), 6.0);
    close(module.b(), 18f64.sqrt());
    assert_eq!(module.c(), &x * 18.0);
    assert_eq!(module.d(), 1);
    assert_eq!(module.e(), &a * &a * &a);
    assert_eq!(module.f(), &a * &a);
    assert_eq!(module.g(), dmatrix![1.0; 2.0; 2.0; 4.0]);
    assert_eq!(module.h(), dmatrix![1.0, 2.0; 2.0, 4.0]);
    let d = DMatrix::from_diagonal(&x);
    assert_eq!(module.o(), &d * &x);
    assert_eq!(module.p(), &d * &a);
    assert_eq!(module.q(), &a * &d);
    close(module.r(), 9.0);
    assert_eq!(module.s().to_dense()[[1, 1]], 6.0);
    assert_eq!(module.t(), dmatrix![2.0, 1.0, 1.0; 1.0, 3.0, 2.0; 1.0, 2.0, 1.0]);
    let mut multiples = DMatrix::<f64>::zeros(4, 4);
    multiples.view_mut((0, 0), (2, 2)).copy_from(&a);
    for (place, value) in [((0, 2), 1.0 / x[0]), ((2, 0), -2.0 / x[0]), ((2, 2), -x[1] / (2.0 * x[0]))] {
        multiples.view_mut(place, (2, 2)).fill_diagonal(value);
    }
    assert_eq!(module.multiples(), multiples);
    assert!((module.u() - DMatrix::<f64>::identity(2, 2)).amax() < 1e-12);
    assert!((module.v() * &a - x.transpose()).amax() < 1e-12);
    assert_eq!(module.w(), x);
    assert_eq!(module.y(), dmatrix![1.0, 1.0; 2.0, 2.0]);
    assert!((module.z() - &x).amax() < 1e-12);
    module.set_k(0).unwrap();
    assert_eq!(module.f(), DMatrix::<f64>::identity(2, 2));
    module.set_k(-1).unwrap();
    assert!((module.f() * &a - DMatrix::<f64>::identity(2, 2)).amax() < 1e-12);
    assert!(module.set_x(dvector![1.0]).is_err());
}

#[test]
fn matrices_without_full_rank() {
    let a = dmatrix![1.0, 2.0, 3.0; 2.0, 4.0, 6.0];
    let s = dmatrix![1.0, 0.0; 0.0, -2.0];
    let b = SMatrix::<f64, 2, 3>::new(1.0, 0.0, 0.0, 0.0, 2.0, 0.0);
    let module = Deficient::new(&a, &s, b).unwrap();
    assert_eq!(module.r(), 1);
    assert_eq!(module.N().shape(), (3, 2));
    assert!(module.z().amax() < 1e-12);
    assert_eq!(module.O().shape(), (2, 1));
    assert!((module.P() - dmatrix![1.0, 0.0; 0.0, 0.0]).amax() < 1e-12);
    assert!((&a * module.p() * &a - &a).amax() < 1e-12);
    let mut values: Vec<f64> = module.s().to_array().into();
    values.sort_by(f64::total_cmp);
    close(values[0], 1.0);
    close(values[1], 2.0);
    assert_eq!(module.b(), 2);
    assert_eq!(module.K().shape(), (3, 1));
    close(module.d(), -2.0);
    close(module.c(), 3.0);
}

#[test]
fn functions_of_any_size() {
    let a = dmatrix![1.0, 2.0, 0.0, 0.0; 0.0, 1.0, 0.0, 1.0];
    let x = dvector![1.0, 2.0, 3.0, 4.0];
    let module = Overloads::new(&a, &x, DVec2::new(1.0, 3.0), DVec3::new(4.0, 5.0, 6.0), |x: DVector<f64>| {
        dvector![x[0], x[3]]
    }).unwrap();
    close(module.s() as f64, 234.0);
    assert_eq!(module.t(), a.transpose() * &a + DMatrix::<f64>::identity(4, 4));
    close(module.w(), 2.0 + 2.5);
    assert_eq!(module.y(), dvector![6.0, 10.0]);
    assert_eq!(module.c().column(0), x);
    assert_eq!(module.c().column(1), dvector![1.0, 1.0, 1.0, 1.0]);
    assert_eq!(module.k(), DVec3::new(4.0, 5.0, 6.0));
    close(module.l(dvector![1.0, 2.0]), 1.5);
}

#[test]
fn letters_and_sizes() {
    let b = SMatrix::<f64, 2, 3>::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0);
    let c = SMatrix::<f64, 2, 1>::new(7.0, 8.0);
    let mut module = Letters::new([1.0, 2.0, 3.0], dvector![4.0, 5.0], b, c).unwrap();
    close(module.s(), 6.0);
    close(module.t(), 9.0);
    assert_eq!(module.K().row(0).to_array(), [1.0, 2.0, 3.0, 7.0]);
    assert_eq!(module.K().row(3).to_array(), [8.0, 4.0, 5.0, 6.0]);
    assert_eq!(module.m(), 6);
    assert_eq!(module.z(), dvector![4.0, 5.0, 0.0, 4.0, 5.0]);
    module.set_b(dvector![1.0, 2.0, 3.0]).unwrap();
    assert_eq!(module.m(), 9);
    assert_eq!(module.o().shape(), (3, 2));
    assert_eq!(module.e(), dvector![1.0, 4.0, 9.0]);
    close(module.t(), 6.0);
}

#[test]
fn sizes_that_are_handed_in() {
    let Err(error) = Counts::new(3, 2, dvector![1.0, 2.0]) else {
        panic!("different sizes are accepted")
    };
    assert_eq!(error.to_string(), "the length of `b` is 2 but should be 3: it is `n`, and `n` says so");
    let mut module = Counts::new(2, 3, dvector![1.0, 2.0]).unwrap();
    assert_eq!(module.o(), dvector![1.0, 1.0, 1.0]);
    assert_eq!(module.c(), dmatrix![1.0, 1.0; 2.0, 1.0]);
    assert_eq!(module.f(1), dvector![1.0]);
    close(module.g(3), 9.0);
    assert_eq!(module.y().shape(), (3, 2));
    module.set_m(1).unwrap();
    assert_eq!(module.o(), dvector![1.0]);
    assert_eq!(module.y().shape(), (1, 2));
    module.set_n(2).unwrap();
    let error = module.set_n(3).unwrap_err().to_string();
    assert_eq!(error, "the value of `n` is 3 but should be 2: it is `n`, and `b` says so");
    assert_eq!(module.c().nrows(), 2);
}

#[test]
fn sparse_matrices() {
    let a = dmatrix![1.0, 2.0; 0.0, 3.0];
    let mut triplets = iheartmesh::sprs::TriMat::new((2, 2));
    triplets.add_triplet(0, 0, 1.0);
    triplets.add_triplet(0, 1, 2.0);
    triplets.add_triplet(1, 1, 3.0);
    let b = SMatrix::<f64, 2, 3>::new(1.0, 0.0, 0.0, 0.0, 1.0, 0.0);
    let c = SMatrix::<f64, 3, 1>::new(1.0, 2.0, 3.0);
    let x = dvector![1.0, 2.0];
    let sparse: iheartmesh::sprs::CsMat<f64> = triplets.to_csc();
    let module = Sparse::new(sparse, b, c, &x).unwrap();
    let dense = |m: &iheartmesh::sprs::CsMat<f64>| {
        let m = m.to_dense();
        DMatrix::from_fn(2, 2, |i, j| m[[i, j]])
    };
    let one = DMatrix::<f64>::identity(2, 2);
    let d = DMatrix::from_diagonal(&x);
    assert_eq!(module.a(), &a * &x);
    assert_eq!(module.b(), a.transpose() * &x);
    assert_eq!(dense(&module.c()), &a * &a);
    assert_eq!(dense(&module.d()), &a * 2.0);
    assert_eq!(dense(&module.e()), &a - &one);
    close(module.f(), 17.0);
    assert_eq!(dense(&module.g()), &a * 2.0);
    close(module.h(), 2.0);
    close(module.s(), 4.0);
    assert!((&a * module.t() - &x).amax() < 1e-12);
    assert_eq!(dense(&module.E()), &d + &a);
    assert_eq!(dense(&module.F()), &d + &one);
    assert_eq!(dense(&module.u()), a);
    assert_eq!(module.v(), one);
    let null = DMatrix::from_column_slice(3, 1, &[1.0, 2.0, 3.0]);
    assert!((module.w() - module.y()).amax() < 1e-12);
    assert!((module.w() - null - module.z() / 2.0).amax() < 1e-12);
}

#[test]
fn shapes() {
    let a = dmatrix![1.0, 2.0; 3.0, 4.0];
    let v = DVec3::new(1.0, 2.0, 3.0);
    let b = SMatrix::<i64, 2, 2>::new(1, 2, 3, 4);
    let module = Shapes::new(v, &a, dvector![5, 6], b).unwrap();
    assert_eq!(module.w(), v * 3.0);
    assert_eq!(module.z(), DVec2::new(5.0, 11.0));
    assert_eq!(module.c(), 6);
    close(module.u() as f64, 11.0);
    close(module.d(), -2.0);
    assert_eq!(module.P(3), &a * &a * &a);
    assert_eq!(module.B̄(), &a * 2.0);
    close(module.h(2.0), 40f64.sqrt());
    assert_eq!(module.S().as_slice(), [dvector![1.0, 2.0], dvector![3.0, 4.0]]);
    assert_eq!(module.T().as_slice(), [5.0, 25.0]);
    assert_eq!(module.Q().as_slice(), [&a * 0.0, a.clone()]);
    assert_eq!(module.R().len(), 1);
}
}
