//! What has no value: integers that are too large, recursion without an end, sizes that disagree in one parameter.

#[macro_use]
#[path = "support/twice.rs"]
mod twice;

use nalgebra::{dmatrix, dvector};

programs! {
    Integers, PlainIntegers = r#"
        product(n) = ∏_(i = 1)^n i where n ∈ ℤ
        square(k) = k k where k ∈ ℤ
        twice(k) = ∑_(i = 1)^2 k where k ∈ ℤ
        factorial(n) = { 1 if n ≤ 1
                         n factorial(n - 1) otherwise
        where n ∈ ℤ
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
    ] {
        assert!(error.to_string().contains("an integer is too large in"), "{error}");
    }
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
}
