//! What has no value: integers that are too large, recursion without an end, sizes that disagree or are negative,
//! decompositions of matrices with NaN.

#[macro_use]
#[path = "support/twice.rs"]
mod twice;

use nalgebra::{DMatrix, DVector, dmatrix, dvector};

programs! {
    Integers, PlainIntegers = r#"
        product(n) = ∏_(i = 1)^n i where n ∈ ℤ
        square(k) = k k where k ∈ ℤ
        twice(k) = ∑_(i = 1)^2 k where k ∈ ℤ
        factorial(n) = { 1 if n ≤ 1
                         n factorial(n - 1) otherwise
        where n ∈ ℤ
        minus(k) = -k where k ∈ ℤ
        size(k) = |k| where k ∈ ℤ
        less(k, n) = n - k where k, n ∈ ℤ
        down(n) = { 0 if n = 0
                    down(n - 1) otherwise
        where n ∈ ℤ
    "#;

    Square, PlainSquare = r#"
        Q ∈ ℝ^(n×n)
        c ∈ ℝ^n
        y = Q c
        t = Qᵀ Q
    "#;

    Lengths, PlainLengths = r#"
        w ∈ ℝ^n
        f(u, v) = u + v where u, v ∈ ℝ^p
        g(u) = u + w where u ∈ ℝ^n
        h(A, v) = A v where A ∈ ℝ^(3×p), v ∈ ℝ^p
        l(a, b) = (a, a) + b where a ∈ ℝ^p, b ∈ ℝ^(2p)
    "#;

    Kernels, PlainKernels = r#"
        null from linearalgebra
        A ∈ ℝ^(m×n)
        B ∈ ℝ^(m×n)
        sum = null(A) + null(B)
        product = null(A) null(B)ᵀ
        scalars = null(A) : null(B)
        blocks = [null(A) null(A); null(B) null(B)]
        rows_i,* = null(i A - B)_i,*
        terms(k) = ∑_(i = 1)^k null(A - i B) where k ∈ ℤ
        one(k) = ∑_(i = 1)^k null(A) where k ∈ ℤ
    "#;

    Empty, PlainEmpty = r#"
        A ∈ ℝ^(n×n)
        b ∈ ℝ^n
        w ∈ ℝ^m
        P ∈ ℝ^(m×m) sparse
        x = A⁻¹ b
        B = A⁻¹
        R_i,* = w_i (1, 2, 3)
        C_*,i = w_i (1, 2, 3)
        times(u, k) = ∑_(i = 1)^k u where u ∈ ℝ^p, k ∈ ℤ
        doubled(k) = times(b, k) + b where k ∈ ℤ
        several(k) = ∑_(i = 1)^k P where k ∈ ℤ
    "#;

    Decompositions, PlainDecompositions = r#"
        rank, svd, null, orth, psd from linearalgebra
        A ∈ ℝ^(m×n)
        r = rank(A)
        K = null(A)
        B = orth(A)
        U, s, V = svd(A)
        P = A⁺
        t = ‖A‖_*
        p = psd(AᵀA)
        root = (AᵀA)^(½)
        largest = ‖A_1,*‖_∞
        least = min(A)
    "#;

    Written, PlainWritten = r#"
        k ∈ ℤ
        I1 = I_k
        ones = 1_k
        zeros = 0_k,2
    "#;

    Returned, PlainReturned = r#"
        f ∈ ℝ^n → ℝ^n
        g ∈ ℝ^n → ℝ^(n×2)
        x ∈ ℝ^n
        y = f(x)
        z = g(x) (1, 1)
    "#;
}

for_both! {
#[test]
fn integers_that_are_too_large() {
    let module = Integers::new().unwrap();
    assert_eq!(module.product(20), 2_432_902_008_176_640_000);
    for error in [
        module.try_product(25).unwrap_err(),
        module.try_factorial(25).unwrap_err(),
        module.try_square(1 << 40).unwrap_err(),
        module.try_twice(i64::MAX).unwrap_err(),
        module.try_minus(i64::MIN).unwrap_err(),
        module.try_size(i64::MIN).unwrap_err(),
        module.try_less(i64::MIN, 0).unwrap_err(),
    ] {
        assert!(error.to_string().contains("an integer is too large in"), "{error}");
    }
}

#[test]
fn the_least_integer() {
    let module = Integers::new().unwrap();
    assert_eq!(module.minus(i64::MAX), -i64::MAX);
    assert_eq!(module.less(1, -i64::MAX), i64::MIN);
}

#[test]
fn nothing_to_compute_with() {
    let none = iheartmesh::sprs::CsMat::eye_csc(0);
    let module = Empty::new(DMatrix::zeros(0, 0), DVector::zeros(0), DVector::zeros(0), none).unwrap();
    assert_eq!(module.x().len(), 0);
    assert_eq!(module.B().shape(), (0, 0));
    // the type says how long rows would be
    assert_eq!(module.R().shape(), (0, 3));
    assert_eq!(module.C().shape(), (3, 0));
}

#[test]
fn sizes_of_arguments() {
    let (two, three) = (dvector![1.0, 2.0], dvector![1.0, 2.0, 3.0]);
    let module = Lengths::new(&two).unwrap();
    assert_eq!(module.f(&three, &three).len(), 3);
    assert_eq!(module.l(&two, dvector![0.0, 0.0, 0.0, 1.0])[3], 3.0);
    for (error, expected) in [
        (
            module.try_f(&two, &three).unwrap_err(),
            "the length of `v` is 3 but should be 2: it is `p`, and `u` says so",
        ),
        (
            module.try_g(&three).unwrap_err(),
            "the length of `u` is 3 but should be 2: it is `n`, and `w` says so",
        ),
        (
            module.try_h(dmatrix![1.0, 2.0], &two).unwrap_err(),
            "the number of rows of `A` is 1 but should be 3",
        ),
        (
            module.try_h(DMatrix::zeros(3, 3), &two).unwrap_err(),
            "the length of `v` is 2 but should be 3: it is `p`, and `A` says so",
        ),
        (
            module.try_l(&two, &three).unwrap_err(),
            "the length of `b` is 3 but should be 4: it is `2p`, and `a` says so",
        ),
    ] {
        assert_eq!(error.to_string(), expected);
    }
}

#[test]
fn sizes_that_agree_by_chance() {
    // the kernels of both are of dimension 1
    let module = Kernels::new(dmatrix![1.0, 0.0; 0.0, 0.0], dmatrix![0.0, 0.0; 0.0, 1.0]).unwrap();
    assert_eq!(module.sum().shape(), (2, 1));
    assert_eq!(module.product().shape(), (2, 2));
    assert_eq!(module.blocks().shape(), (4, 2));
    assert_eq!(module.one(2).shape(), (2, 1));
    assert!(module.try_one(0).is_err());
    // of dimension 1 and 2
    let module = Kernels::new(dmatrix![1.0, 0.0; 0.0, 0.0], dmatrix![0.0, 0.0; 0.0, 0.0]).unwrap();
    for error in [
        module.try_sum().unwrap_err(),
        module.try_product().unwrap_err(),
        module.try_scalars().unwrap_err(),
        module.try_blocks().unwrap_err(),
    ] {
        assert!(error.to_string().contains("the sizes do not fit in"), "{error}");
    }
    // of dimension 0 for the first, and 1 for the second
    let module = Kernels::new(dmatrix![1.0, 0.0; 0.0, 1.0], dmatrix![1.0, 0.0; 0.0, 3.0]).unwrap();
    assert_eq!(module.terms(1).shape(), (2, 1));
    let error = module.try_rows().unwrap_err();
    assert!(error.to_string().contains("the sizes do not fit in"), "{error}");
    let module = Kernels::new(dmatrix![1.0, 0.0; 0.0, 3.0], dmatrix![1.0, 0.0; 0.0, 1.0]).unwrap();
    assert_eq!(module.terms(1).shape(), (2, 1));
    let error = module.try_terms(2).unwrap_err();
    assert!(error.to_string().contains("terms of different sizes"), "{error}");
}

#[test]
fn sums_of_arrays_without_terms() {
    let p = iheartmesh::sprs::CsMat::eye_csc(3);
    let module = Empty::new(dmatrix![2.0], dvector![3.0], dvector![1.0, 1.0, 1.0], &p).unwrap();
    assert_eq!(module.times(dvector![1.0, 2.0], 3), dvector![3.0, 6.0]);
    assert_eq!(module.times(dvector![1.0, 2.0], 0), dvector![0.0, 0.0]);
    assert_eq!(module.doubled(2), dvector![9.0]);
    assert_eq!(module.several(0).shape(), (3, 3));
    assert_eq!(module.several(2).get(1, 1), Some(&2.0));
}

#[test]
fn recursion_without_an_end() {
    let module = Integers::new().unwrap();
    assert_eq!(module.down(100), 0);
    let error = module.try_down(-1).unwrap_err().to_string();
    assert!(error.contains("`down` calls itself more than 500 times"), "{error}");
    // the count begins anew
    assert_eq!(module.down(400), 0);
}

#[test]
fn a_size_that_stands_twice() {
    let c = dvector![1.0, 1.0];
    let error = Square::new(dmatrix![1.0, 2.0, 3.0; 4.0, 5.0, 6.0], &c).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the number of columns of `Q` is 3 but should be 2: it is `n`, which has this value elsewhere"
    );
    let mut module = Square::new(dmatrix![1.0, 2.0; 3.0, 4.0], &c).unwrap();
    assert_eq!(module.y(), dvector![3.0, 7.0]);
    assert!(module.set_Q(dmatrix![1.0; 2.0]).is_err());
    assert_eq!(module.t(), dmatrix![10.0, 14.0; 14.0, 20.0]);
}

#[test]
fn decompositions_of_what_is_no_number() {
    for bad in [f64::NAN, f64::INFINITY] {
        let module = Decompositions::new(dmatrix![1.0, 2.0, 3.0; 4.0, bad, 6.0]).unwrap();
        for error in [
            module.try_r().unwrap_err(),
            module.try_K().unwrap_err(),
            module.try_B().unwrap_err(),
        ] {
            assert!(error.to_string().contains("a matrix with NaN or ∞ has no rank: in"), "{error}");
        }
        assert!(module.t().is_nan());
        for (matrix, shape) in [
            (module.U(), (2, 2)),
            (module.V(), (3, 3)),
            (module.P(), (3, 2)),
            (module.p(), (3, 3)),
            (module.root(), (3, 3)),
        ] {
            assert_eq!(matrix.shape(), shape);
            assert!(matrix.iter().all(|x| x.is_nan()));
        }
    }
    let module = Decompositions::new(dmatrix![f64::NAN, 1.0]).unwrap();
    assert!(module.largest().is_nan() && module.least().is_nan());
    let module = Decompositions::new(dmatrix![1.0, f64::NAN, 2.0]).unwrap();
    assert!(module.largest().is_nan() && module.least().is_nan());
}

#[test]
fn decompositions_of_nothing() {
    let module = Decompositions::new(DMatrix::zeros(2, 0)).unwrap();
    assert_eq!((module.r(), module.t()), (0, 0.0));
    assert_eq!((module.K().shape(), module.B().shape()), ((0, 0), (2, 0)));
    assert_eq!((module.U().shape(), module.s().len(), module.V().shape()), ((2, 2), 0, (0, 0)));
    assert_eq!((module.P().shape(), module.root().shape()), ((0, 2), (0, 0)));
    assert_eq!(module.p().shape(), (0, 0));
}

#[test]
fn sizes_that_are_written() {
    assert_eq!(Written::new(0).unwrap().I1().shape(), (0, 0));
    for k in [-1, i64::MIN, i64::MAX, 1 << 40] {
        let module = Written::new(k).unwrap();
        for error in [
            module.try_I1().unwrap_err(),
            module.try_ones().unwrap_err(),
            module.try_zeros().unwrap_err(),
        ] {
            assert!(error.to_string().contains("a size is negative"), "{error}");
        }
    }
}

#[test]
fn sizes_that_a_closure_returns() {
    let longer = |x: DVector<f64>| DVector::zeros(x.len() + 1);
    let taller = |x: DVector<f64>| DMatrix::zeros(x.len(), 3);
    let module = Returned::new(longer, taller, dvector![1.0, 2.0]).unwrap();
    for error in [module.try_y().unwrap_err(), module.try_z().unwrap_err()] {
        assert!(error.to_string().contains("two sizes differ in"), "{error}");
    }
    let module = Returned::new(|x| x, |x| DMatrix::zeros(x.len(), 2), dvector![1.0, 2.0]).unwrap();
    assert_eq!((module.y(), module.z()), (dvector![1.0, 2.0], dvector![0.0, 0.0]));
}
}
