//! The simplex of Nelder and Mead, for functions without derivatives (J. A. Nelder, R. Mead, *A simplex method for
//! function minimization*, 1965; the crate `basin`).

use std::convert::Infallible;

use basin::{CostFunction, Executor, NelderMead, SimplexProgress, State};

use super::slope::Function;

/// Functions of more coordinates than this are not looked at: the simplex does not get on with them.
const MOST: usize = 30;

struct Penalty<'f, 'a> {
    function: &'f Function<'a>,
    weight: f64,
}

impl CostFunction for Penalty<'_, '_> {
    type Param = Vec<f64>;
    type Output = f64;
    type Error = Infallible;

    fn cost(&self, point: &Vec<f64>) -> Result<f64, Infallible> {
        let inside = self.function.inside(point);
        let outside: f64 = point.iter().zip(&inside).map(|(a, b)| (a - b).abs()).sum();
        let values = self.function.at(&inside);
        let cost = values.objective() + self.weight * (self.function.violation(&values) + outside);
        Ok(if cost.is_nan() { f64::INFINITY } else { cost })
    }
}

/// A better point around one, with a penalty of this weight for missed restrictions.
pub(super) fn better(
    function: &Function<'_>,
    point: &[f64],
    size: f64,
    weight: f64,
) -> Option<Vec<f64>> {
    if point.len() > MOST {
        return None;
    }
    let mut vertices = vec![point.to_vec()];
    for k in 0..point.len() {
        let mut vertex = point.to_vec();
        vertex[k] += size * vertex[k].abs().max(1.0);
        vertices.push(vertex);
    }
    let penalty = Penalty { function, weight };
    // the adaptive parameters shrink a simplex of two points to one
    let method = match point.len() {
        1 => NelderMead::new(),
        _ => NelderMead::adaptive(),
    };
    let method = method
        .with_absolute_simplex_size_tolerance(1e-13)
        .with_relative_simplex_size_tolerance(1e-13)
        .with_absolute_simplex_cost_tolerance(None)
        .with_relative_simplex_cost_tolerance(None);
    let found = Executor::new(penalty, method, SimplexProgress::from_simplex(vertices))
        .max_iter(400 * point.len() as u64)
        .run()
        .ok()?;
    Some(function.inside(found.state.param()))
}
