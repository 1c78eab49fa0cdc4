//! The second derivatives of elements by dual numbers, added to a planned pattern.

use glam::{DMat2, DMat3, DVec2, DVec3};
use nalgebra::SVector;
use num_dual::{Dual2SVec64, DualNum};

use super::baseline::symmetric_dirichlet::{Elements, Pattern};

/// Of triangles.
pub fn hessian(elements: &Elements<3, DMat2>, pattern: &Pattern, x: &[DVec2], values: &mut [f64]) {
    values.fill(0.0);
    for (t, vertices) in elements.vertices.iter().enumerate() {
        let at: SVector<f64, 6> =
            SVector::from_iterator(vertices.iter().flat_map(|v| x[*v as usize].to_array()));
        let energy = |x: SVector<Dual2SVec64<6>, 6>| {
            let p = [x[2] - x[0], x[3] - x[1]];
            let q = [x[4] - x[0], x[5] - x[1]];
            let r = elements.inverses[t];
            let [a, b] = std::array::from_fn(|i| p[i] * r.x_axis.x + q[i] * r.x_axis.y);
            let [c, d] = std::array::from_fn(|i| p[i] * r.y_axis.x + q[i] * r.y_axis.y);
            let determinant = a * d - b * c;
            let square = a * a + b * b + c * c + d * d;
            square * (determinant.powi(-2) + 1.0) * elements.sizes[t]
        };
        let (_, _, block) = num_dual::hessian(energy, &at);
        for (slot, value) in pattern.slots[36 * t..36 * t + 36]
            .iter()
            .zip(block.as_slice())
        {
            values[*slot as usize] += value;
        }
    }
}

/// Of tetrahedra.
pub fn hessian_of_cells(
    elements: &Elements<4, DMat3>,
    pattern: &Pattern,
    x: &[DVec3],
    values: &mut [f64],
) {
    values.fill(0.0);
    for (t, vertices) in elements.vertices.iter().enumerate() {
        let at: SVector<f64, 12> =
            SVector::from_iterator(vertices.iter().flat_map(|v| x[*v as usize].to_array()));
        let energy = |x: SVector<Dual2SVec64<12>, 12>| {
            let r = elements.inverses[t].to_cols_array_2d();
            let j: [[Dual2SVec64<12>; 3]; 3] = std::array::from_fn(|c| {
                std::array::from_fn(|i| {
                    let edge = |k: usize| x[3 * k + 3 + i] - x[i];
                    edge(0) * r[c][0] + edge(1) * r[c][1] + edge(2) * r[c][2]
                })
            });
            let cross = |a: &[Dual2SVec64<12>; 3], b: &[Dual2SVec64<12>; 3]| {
                std::array::from_fn(|k| {
                    a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]
                })
            };
            let square = |a: &[Dual2SVec64<12>; 3]| a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
            let c: [[Dual2SVec64<12>; 3]; 3] = [
                cross(&j[1], &j[2]),
                cross(&j[2], &j[0]),
                cross(&j[0], &j[1]),
            ];
            let determinant = j[0][0] * c[0][0] + j[0][1] * c[0][1] + j[0][2] * c[0][2];
            let first = square(&j[0]) + square(&j[1]) + square(&j[2]);
            let second = square(&c[0]) + square(&c[1]) + square(&c[2]);
            (first + second * determinant.powi(-2)) * elements.sizes[t]
        };
        let (_, _, block) = num_dual::hessian(energy, &at);
        for (slot, value) in pattern.slots[144 * t..144 * t + 144]
            .iter()
            .zip(block.as_slice())
        {
            values[*slot as usize] += value;
        }
    }
}
