//! Programs of linear algebra, without a mesh, against values computed by hand, with and without optimisations.

use iheartmesh::glam::{DMat2, DMat3, DVec2, DVec3};
use nalgebra::{DMatrix, DVector, SMatrix, dmatrix, dvector};

#[macro_use]
#[path = "support/twice.rs"]
mod twice;

programs! {
    Dot, PlainDot = r#"
        a, b ∈ ℝ^n
        y = aᵀb + ‖a‖_1
        w_i = a_i b_i
        t = { y if y > 0
              -y otherwise
        z = ∑_i a_i b_i
        m = max(a)
        p = ‖a‖_3
        q = ‖a‖_∞
    "#;

    Blocks, PlainBlocks = r#"
        A ∈ ℝ^(k×k)
        B ∈ ℝ^(k×m)
        C ∈ ℝ^(m×m)
        S = [A B
             Bᵀ C]
        K = [A 0
             0 I]
        J = [I 0; 0 A]
        d = |A|
    "#;

    Least, PlainLeast = r#"
        A ∈ ℝ^(m×n)
        b ∈ ℝ^m
        x = (AᵀA)⁻¹ Aᵀ b
        r = ‖A x - b‖²
    "#;

    Fixed, PlainFixed = r#"
        given
        R ∈ ℝ^(3×3)
        u, v ∈ ℝ³
        M ∈ ℝ^(2×2)
        N ∈ ℝ^(3×2)
        w = R u + u × v
        c = uᵀ R v
        i = R⁻¹ u
        d = |R| + |M|
        g = NᵀN + M
        o = u vᵀ
        h = (u, 1)
        T = [R u; 0 1]
    "#;

    Sums, PlainSums = r#"
        x_i ∈ ℝ³
        w_i ∈ ℝ
        A ∈ ℝ^(m×n)
        c = ∑_i w_i x_i / ∑_i w_i
        s = ∑_i ∑_j A_ij
        t = ∑_(i for i > 1) w_i
        p = ∏_i w_i
        q = ∑_(i = 1)^3 i²
        B_ij = A_ij + i - j
        r_i = ∑_j A_ij
        e_i,* = x_i
        f = ∑_i x_i x_iᵀ
    "#;

    Functions, PlainFunctions = r#"
        trace, diag, vec, rank, svd, null, det, inv from linearalgebra
        sin, cos from trigonometry
        A ∈ ℝ^(n×n)
        f ∈ ℝ → ℝ
        a = trace(A)
        d = diag(A)
        v = vec(A)
        k = rank(A)
        U, s, W = svd(A)
        R(φ) = [cos(φ) -sin(φ)
                sin(φ) cos(φ)] where φ ∈ ℝ
        g(x) = f(x)² + 1 where x ∈ ℝ
        h(x, y) = xᵀ y where x ∈ ℝ^p, y ∈ ℝ^p
        l = log_2(8) + log_10(100) + ln(exp(1))
        A²
    "#;

    Ball, PlainBall = r#"
        S ∈ {ℤ}
        a_i ∈ ℝ
        odd = { k+1 for k ∈ S if k > 2 and k < 9 }
        Q = (S ∪ odd) \ S
        u = ∑_(i ∈ S) a_i
        n = |S|
        F(k) = { 1 if k ≤ 1
                 k F(k - 1) otherwise
        where k ∈ ℤ
    "#;

    Inner, PlainInner = r#"
        P ∈ ℝ^(n×n)
        x, y ∈ ℝ^n
        a = <x, y>_P
        b = ‖x‖_P
        c = x ∘ y
        d = P : P
        K = P ⊗ P
        f = ‖P‖_F
        e = P⁺
        z = 2 x - y/2
        o = 1_n
        E = I_n
        r = P_1,*
        q = P_*,2
        D_ii = x_i
    "#;
}

fn close(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-12 * (1.0 + b.abs()), "{a} is not {b}");
}

for_both! {
#[test]
fn vectors_of_a_named_size() {
    let (a, b) = (dvector![1.0, -2.0, 3.0], dvector![4.0, 5.0, 6.0]);
    let module = Dot::new(&a, &b).unwrap();
    close(module.y(), 12.0 + 6.0);
    close(module.z(), 12.0);
    close(module.t(), 18.0);
    close(module.m(), 3.0);
    close(module.p(), 36f64.cbrt());
    close(module.q(), 3.0);
    assert_eq!(module.w(), dvector![4.0, -10.0, 18.0]);
    let Err(error) = Dot::new(a, dvector![1.0]) else {
        panic!("different lengths are accepted")
    };
    assert_eq!(
        error.to_string(),
        "the length of `b` is 1 but should be 3: it is `n`, and `a` says so"
    );
}

#[test]
fn block_matrices() {
    let a = dmatrix![1.0, 2.0; 3.0, 4.0];
    let b = dmatrix![5.0; 6.0];
    let c = dmatrix![7.0];
    let module = Blocks::new(&a, &b, &c).unwrap();
    assert_eq!(
        module.S(),
        dmatrix![1.0, 2.0, 5.0; 3.0, 4.0, 6.0; 5.0, 6.0, 7.0]
    );
    assert_eq!(
        module.K(),
        dmatrix![1.0, 2.0, 0.0; 3.0, 4.0, 0.0; 0.0, 0.0, 1.0]
    );
    close(module.d(), -2.0);
}

#[test]
fn least_squares() {
    let a = dmatrix![1.0, 0.0; 1.0, 1.0; 1.0, 2.0];
    let module = Least::new(&a, dvector![6.0, 0.0, 0.0]).unwrap();
    let x: DVector<f64> = module.x();
    close(x[0], 5.0);
    close(x[1], -3.0);
    close(module.r(), 6.0);
}

#[test]
fn fixed_sizes() {
    let r = DMat3::from_cols_array(&[2.0, 0.0, 0.0, 0.0, 4.0, 0.0, 1.0, 0.0, 1.0]);
    let (u, v) = (DVec3::new(1.0, 2.0, 3.0), DVec3::new(0.0, 1.0, -1.0));
    let m = DMat2::from_cols_array(&[1.0, 2.0, 3.0, 4.0]);
    let n = SMatrix::<f64, 3, 2>::new(1.0, 0.0, 0.0, 1.0, 2.0, 2.0);
    let module = Fixed::new(r, u, v, m, n).unwrap();
    assert_eq!(module.w(), r * u + u.cross(v));
    close(module.c(), u.dot(r * v));
    assert!((module.i() - r.inverse() * u).length() < 1e-12);
    close(module.d(), 8.0 - 2.0);
    assert_eq!(
        module.g(),
        DMat2::from_cols(DVec2::new(6.0, 6.0), DVec2::new(7.0, 9.0))
    );
    assert_eq!(module.o(), DMat3::from_cols(u * v.x, u * v.y, u * v.z));
    assert_eq!(module.h(), u.extend(1.0));
    assert_eq!(module.T().w_axis, u.extend(1.0));
}

#[test]
fn sums() {
    let x = [DVec3::X, DVec3::Y, DVec3::Z];
    let a = dmatrix![1.0, 2.0; 3.0, 4.0];
    let module = Sums::new(x, [1.0, 2.0, 3.0], &a).unwrap();
    assert_eq!(module.c(), DVec3::new(1.0, 2.0, 3.0) / 6.0);
    close(module.s(), 10.0);
    close(module.t(), 5.0);
    close(module.p(), 6.0);
    close(module.q() as f64, 14.0);
    assert_eq!(module.B(), dmatrix![1.0, 1.0; 4.0, 4.0]);
    assert_eq!(module.r(), dvector![3.0, 7.0]);
    assert_eq!(module.e(), DMatrix::<f64>::identity(3, 3));
    assert_eq!(module.f(), DMat3::IDENTITY);
}

#[test]
fn functions() {
    let a = dmatrix![2.0, 1.0; 0.0, 3.0];
    let module = Functions::new(&a, |x| x + 1.0).unwrap();
    close(module.a(), 5.0);
    assert_eq!(module.d(), dvector![2.0, 3.0]);
    assert_eq!(module.v(), dvector![2.0, 0.0, 1.0, 3.0]);
    assert_eq!(module.k(), 2);
    let s = DMatrix::from_diagonal(&module.s());
    let back = module.U() * s * module.W().transpose();
    assert!((back - &a).amax() < 1e-12);
    close(module.g(2.0), 10.0);
    close(module.l(), 3.0 + 2.0 + 1.0);
    close(module.R(0.5).x_axis.y, 0.5f64.sin());
    close(module.h(dvector![1.0, 2.0], dvector![3.0, 4.0]), 11.0);
    assert_eq!(module.ret(), &a * &a);
}

#[test]
fn sets_and_recursion() {
    let module = Ball::new(
        [1i64, 3, 4].into_iter().collect::<iheartmesh::Set<i64>>(),
        [10.0, 20.0, 30.0, 40.0],
    )
    .unwrap();
    assert_eq!(module.odd().as_slice(), [4, 5]);
    assert_eq!(module.Q().as_slice(), [5]);
    close(module.u(), 80.0);
    assert_eq!(module.n(), 3);
    assert_eq!(module.F(5), 120);
}

#[test]
fn products_and_norms() {
    let p = dmatrix![2.0, 1.0; 1.0, 3.0];
    let (x, y) = (dvector![1.0, 2.0], dvector![3.0, -1.0]);
    let module = Inner::new(&p, &x, &y).unwrap();
    close(module.a(), (y.transpose() * &p * &x)[0]);
    close(module.b(), (x.transpose() * &p * &x)[0].sqrt());
    assert_eq!(module.c(), dvector![3.0, -2.0]);
    close(module.d(), 15.0);
    assert_eq!(module.K(), p.kronecker(&p));
    close(module.f(), 15f64.sqrt());
    assert!((module.e() * &p - DMatrix::<f64>::identity(2, 2)).amax() < 1e-12);
    assert_eq!(module.z(), &x * 2.0 - &y / 2.0);
    assert_eq!(module.o(), dvector![1.0, 1.0]);
    assert_eq!(module.r(), dvector![2.0, 1.0]);
    assert_eq!(module.q(), dvector![1.0, 3.0]);
    assert_eq!(module.D().to_dense()[[1, 1]], 2.0);
}
}
