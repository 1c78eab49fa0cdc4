//! Optima that are known, and functions that have none.

use super::*;

const REASONS: Reasons = Reasons {
    unbounded: Fault::new("unbounded"),
    infeasible: Fault::new("infeasible"),
    unsettled: Fault::new("unsettled"),
};

fn domain(start: &[f64]) -> Domain {
    let mut domain = Domain::new();
    domain.variable(&DVector::from_column_slice(start));
    domain
}

fn least(start: &[f64], f: impl Fn(&[f64]) -> f64) -> Fallible<Optimum> {
    domain(start).optimum(false, REASONS, |x, _| Ok(f(x)))
}

fn restricted(start: &[f64], f: impl Fn(&[f64], &mut Restrictions) -> f64) -> Fallible<Optimum> {
    domain(start).optimum(false, REASONS, |x, restrictions| Ok(f(x, restrictions)))
}

#[track_caller]
fn close(found: Fallible<Optimum>, at: &[f64], value: f64, tolerance: f64) {
    let found = found.expect("an optimum");
    assert!(
        (found.value - value).abs() <= tolerance,
        "{found:?}, not {value}"
    );
    for (a, b) in found.at.iter().zip(at) {
        assert!(
            (a - b).abs() <= tolerance * b.abs().max(1.0),
            "{found:?}, not {at:?}"
        );
    }
}

fn rosenbrock(x: &[f64]) -> f64 {
    x.windows(2)
        .map(|w| 100.0 * (w[1] - w[0] * w[0]).powi(2) + (1.0 - w[0]).powi(2))
        .sum()
}

#[test]
fn smooth() {
    close(least(&[0.0], |x| (x[0] - 3.0).powi(2)), &[3.0], 0.0, 1e-9);
    close(
        least(&[0.0], |x| 1e-8 * (x[0] - 3.0).powi(2)),
        &[3.0],
        0.0,
        1e-7,
    );
    close(
        least(&[0.0], |x| 1e8 * (x[0] - 3.0).powi(2) + 5.0),
        &[3.0],
        5.0,
        1e-7,
    );
    close(least(&[0.0; 2], rosenbrock), &[1.0; 2], 0.0, 1e-7);
    close(least(&[-1.2, 1.0], rosenbrock), &[1.0; 2], 0.0, 1e-7);
    close(least(&[0.0; 10], rosenbrock), &[1.0; 10], 0.0, 1e-6);
    close(
        least(&[0.0], |x| x[0].cos()),
        &[std::f64::consts::PI],
        -1.0,
        1e-8,
    );
    close(
        least(&[0.0; 2], |x| {
            x[0].exp() - x[0] + x[1].powi(2) + x[0] * x[1]
        }),
        &[0.0, 0.0],
        1.0,
        1.0,
    );
    close(least(&[0.0], |x| (x[0] - 1e4).powi(2)), &[1e4], 0.0, 1e-7);
    close(least(&[0.0], |x| x[0].powi(4)), &[0.0], 0.0, 1e-2);
    close(least(&[0.0], |_| 2.0), &[0.0], 2.0, 0.0);
    close(least(&[0.0], |x| x[0] - x[0].ln()), &[1.0], 1.0, 1e-8);
    close(
        least(&[7.0], |x| (1000.0 * x[0]).cos() + (x[0] - 7.0).powi(2)),
        &[7.0],
        -1.0,
        5e-3,
    );
}

#[test]
fn without_derivatives() {
    close(least(&[0.0], |x| (x[0] - 3.0).abs()), &[3.0], 0.0, 1e-7);
    close(
        least(&[0.0; 2], |x| (x[0] - 3.0).abs() + 2.0 * (x[1] + 1.0).abs()),
        &[3.0, -1.0],
        0.0,
        1e-6,
    );
    close(
        least(&[0.0; 2], |x| {
            ((x[0] - 3.0).powi(2) + (x[1] - 1.0).powi(2)).sqrt()
        }),
        &[3.0, 1.0],
        0.0,
        1e-6,
    );
}

#[test]
fn within_restrictions() {
    // Hock and Schittkowski's problem 71
    let mut box_of_71 = domain(&[1.0, 5.0, 5.0, 1.0]);
    box_of_71.at_least(0, &1.0);
    box_of_71.at_most(0, &5.0);
    let found = box_of_71.optimum(false, REASONS, |x, r| {
        r.equal.push(x.iter().map(|x| x * x).sum::<f64>() - 40.0);
        r.at_most.push(25.0 - x.iter().product::<f64>());
        Ok(x[0] * x[3] * (x[0] + x[1] + x[2]) + x[2])
    });
    close(
        found,
        &[1.0, 4.742_999_63, 3.821_149_98, 1.379_408_29],
        17.014_017_289,
        1e-7,
    );
    // a linear program
    let found = restricted(&[0.0; 2], |x, r| {
        r.at_most
            .extend([x[0] + x[1] - 4.0, x[0] + 3.0 * x[1] - 6.0, -x[0], -x[1]]);
        -3.0 * x[0] - 2.0 * x[1]
    });
    close(found, &[4.0, 0.0], -12.0, 1e-8);
    // a start outside
    let found = restricted(&[0.0; 2], |x, r| {
        r.at_most.push(2.0 - x[0] - x[1]);
        x[0] * x[0] + 2.0 * x[1] * x[1]
    });
    close(found, &[4.0 / 3.0, 2.0 / 3.0], 8.0 / 3.0, 1e-8);
    // an equation with one solution
    let found = restricted(&[0.0], |x, r| {
        r.equal.push(x[0] - 2.0);
        x[0]
    });
    close(found, &[2.0], 2.0, 1e-8);
    let mut positive = domain(&[0.0; 2]);
    positive.at_least(0, &0.0);
    close(
        positive.optimum(
            false,
            REASONS,
            |x, _| Ok((x[0] + 1.0).powi(2) + x[1].sqrt()),
        ),
        &[0.0, 0.0],
        1.0,
        1e-7,
    );
    // the greatest entropy
    let mut simplex = domain(&[0.0; 3]);
    simplex.at_least(0, &0.0);
    let found = simplex.optimum(true, REASONS, |x, r| {
        r.equal.push(x.iter().sum::<f64>() - 1.0);
        Ok(-x.iter().map(|x| x * x.ln()).sum::<f64>())
    });
    close(found, &[1.0 / 3.0; 3], 3f64.ln(), 1e-7);
}

#[test]
fn without_a_value() {
    assert_eq!(least(&[0.0], |x| x[0]), Err(REASONS.unbounded));
    assert_eq!(least(&[0.0], |x| -x[0] * x[0]), Err(REASONS.unbounded));
    assert_eq!(least(&[0.0, 0.0], |x| x[0] * x[1]), Err(REASONS.unbounded));
    assert_eq!(least(&[1.0], |x| -x[0].ln()), Err(REASONS.unbounded));
    assert_eq!(least(&[0.0], |x| x[0].powi(3)), Err(REASONS.unbounded));
    let found = restricted(&[0.0; 2], |x, r| {
        r.at_most.push(x[0] - x[1]);
        -x[0] - x[1]
    });
    assert_eq!(found, Err(REASONS.unbounded));
    let found = restricted(&[0.0], |x, r| {
        r.at_most.extend([x[0], 1.0 - x[0]]);
        x[0] * x[0]
    });
    assert_eq!(found, Err(REASONS.infeasible));
    let mut empty = domain(&[0.0]);
    empty.at_least(0, &1.0);
    empty.at_most(0, &0.0);
    assert_eq!(
        empty.optimum(false, REASONS, |x, _| Ok(x[0])),
        Err(REASONS.infeasible)
    );
    assert_eq!(least(&[0.0], |_| f64::NAN), Err(REASONS.unsettled));
    let own = Fault::new("own");
    assert_eq!(
        domain(&[0.0]).optimum(false, REASONS, |_, _| Err(own)),
        Err(own)
    );
}

#[test]
fn shapes_keep_their_sizes() {
    let value = vec![DMat2::from_cols_array(&[1.0, 2.0, 3.0, 4.0]); 2];
    let mut numbers = Vec::new();
    value.put(&mut numbers);
    assert_eq!(numbers, [1.0, 2.0, 3.0, 4.0, 1.0, 2.0, 3.0, 4.0]);
    assert_eq!(value.like(&mut numbers.iter()), value);
    let found = Domain::new().optimum(false, REASONS, |_, _| Ok(3.0));
    assert_eq!(found.map(|o| o.value), Ok(3.0));
}
