//! The symmetric Dirichlet energy and its derivatives in closed form, for triangles in the plane and for tetrahedra. With
//! the Jacobian `J = D Q`, edges `D` and inverses `Q` of the edges at rest, the energy of an element is
//! `A (‖J‖² + ‖J⁻¹‖²)`; `c` are the cofactors of `J` and `d` is its determinant, so that `∂d/∂J = c`.

use glam::{DMat2, DMat3, DVec2, DVec3};
use nalgebra::{Matrix4, SMatrix};

/// What is known of the elements before positions are.
pub struct Elements<const N: usize, Q> {
    /// Their vertices.
    pub vertices: Vec<[u32; N]>,
    /// The inverses of their edges at rest, in columns.
    pub inverses: Vec<Q>,
    /// Their sizes at rest.
    pub sizes: Vec<f64>,
}

/// Second derivatives: which entries there are, and where those of each element go.
pub struct Pattern {
    /// Where columns begin.
    pub columns: Vec<usize>,
    /// Rows of the entries.
    pub rows: Vec<usize>,
    /// For each element the places of its entries, column by column.
    pub slots: Vec<u32>,
}

impl Pattern {
    /// The pattern of elements with `D` numbers for each vertex.
    pub fn new<const N: usize>(elements: &[[u32; N]], n_vertices: usize, d: usize) -> Self {
        let n = n_vertices * d;
        let mut entries = Vec::new();
        for element in elements {
            for j in element
                .iter()
                .flat_map(|v| (0..d).map(move |k| *v as usize * d + k))
            {
                for i in element
                    .iter()
                    .flat_map(|v| (0..d).map(move |k| *v as usize * d + k))
                {
                    entries.push((j as u32, i as u32));
                }
            }
        }
        let mut sorted = entries.clone();
        sorted.sort_unstable();
        sorted.dedup();
        let mut columns = vec![0; n + 1];
        for (j, _) in &sorted {
            columns[*j as usize + 1] += 1;
        }
        for j in 0..n {
            columns[j + 1] += columns[j];
        }
        let slot = |(j, i): &(u32, u32)| {
            let range = columns[*j as usize]..columns[*j as usize + 1];
            let start = range.start;
            let found = sorted[range].binary_search(&(*j, *i));
            (start + found.expect("the entry has just been collected")) as u32
        };
        let slots = entries.iter().map(slot).collect();
        Self {
            rows: sorted.iter().map(|(_, i)| *i as usize).collect(),
            columns,
            slots,
        }
    }
}

#[inline(always)]
fn jacobian(elements: &Elements<3, DMat2>, t: usize, x: &[DVec2]) -> (DMat2, f64) {
    let [a, b, c] = elements.vertices[t].map(|v| x[v as usize]);
    let j = DMat2::from_cols(b - a, c - a) * elements.inverses[t];
    (j, j.determinant())
}

/// The energy of triangles; infinite where one is turned over.
pub fn energy(elements: &Elements<3, DMat2>, x: &[DVec2]) -> f64 {
    let mut sum = 0.0;
    for (t, size) in elements.sizes.iter().enumerate() {
        let (j, d) = jacobian(elements, t, x);
        if d <= 0.0 {
            return f64::INFINITY;
        }
        let n = j.x_axis.length_squared() + j.y_axis.length_squared();
        sum += size * n * (1.0 + 1.0 / (d * d));
    }
    sum
}

/// Its gradient.
pub fn gradient(elements: &Elements<3, DMat2>, x: &[DVec2], gradient: &mut [f64]) {
    gradient.fill(0.0);
    for (t, size) in elements.sizes.iter().enumerate() {
        let (j, d) = jacobian(elements, t, x);
        if d <= 0.0 {
            continue;
        }
        let r = 1.0 / d;
        let n = j.x_axis.length_squared() + j.y_axis.length_squared();
        let cofactors = DMat2::from_cols_array(&[j.y_axis.y, -j.y_axis.x, -j.x_axis.y, j.x_axis.x]);
        let by_j = j * (2.0 * size * (1.0 + r * r)) - cofactors * (2.0 * size * n * r * r * r);
        let by_edges = by_j * elements.inverses[t].transpose();
        let (b, c) = (by_edges.x_axis, by_edges.y_axis);
        for (v, part) in elements.vertices[t].iter().zip([-b - c, b, c]) {
            gradient[2 * *v as usize] += part.x;
            gradient[2 * *v as usize + 1] += part.y;
        }
    }
}

/// The second derivatives of one triangle by its Jacobian.
#[inline(always)]
fn by_jacobian(j: DMat2, d: f64, size: f64) -> Matrix4<f64> {
    let u = j.to_cols_array();
    let c = [u[3], -u[2], -u[1], u[0]];
    let r = 1.0 / d;
    let n = u.iter().map(|u| u * u).sum::<f64>();
    let (r2, r3) = (r * r, r * r * r);
    let (first, second) = (-4.0 * size * r3, 6.0 * size * n * r3 * r);
    let mut k = Matrix4::zeros();
    for b in 0..4 {
        for a in b..4 {
            k[(a, b)] = first * (u[a] * c[b] + c[a] * u[b]) + second * c[a] * c[b];
        }
        k[(b, b)] += 2.0 * size * (1.0 + r2);
    }
    let last = 2.0 * size * n * r3;
    k[(3, 0)] -= last;
    k[(2, 1)] += last;
    for b in 0..4 {
        for a in 0..b {
            k[(a, b)] = k[(b, a)];
        }
    }
    k
}

/// The nearest positive semi-definite matrix; itself where a factorisation shows that it is definite.
#[inline(always)]
fn projected(k: Matrix4<f64>) -> Matrix4<f64> {
    if k.cholesky().is_some() {
        return k;
    }
    let mut parts = k.symmetric_eigen();
    parts.eigenvalues.apply(|value| *value = value.max(0.0));
    parts.recompose()
}

/// The second derivatives of the energy of triangles into the entries of a pattern; `psd` projects those of each by its
/// Jacobian.
pub fn hessian(
    elements: &Elements<3, DMat2>,
    pattern: &Pattern,
    x: &[DVec2],
    psd: bool,
    values: &mut [f64],
) {
    values.fill(0.0);
    for (t, size) in elements.sizes.iter().enumerate() {
        let (j, d) = jacobian(elements, t, x);
        if d <= 0.0 {
            continue;
        }
        let mut k = by_jacobian(j, d, *size);
        if psd {
            k = projected(k);
        }
        // J = ∑_v x_v w_vᵀ
        let q = elements.inverses[t];
        let (wb, wc) = (q.row(0), q.row(1));
        let w = [-wb - wc, wb, wc];
        let mut block = SMatrix::<f64, 6, 6>::zeros();
        for (b, wb) in w.iter().enumerate() {
            for l in 0..2 {
                let column: [f64; 4] =
                    std::array::from_fn(|a| k[(a, l)] * wb.x + k[(a, l + 2)] * wb.y);
                for (a, wa) in w.iter().enumerate() {
                    for m in 0..2 {
                        block[(2 * a + m, 2 * b + l)] = column[m] * wa.x + column[m + 2] * wa.y;
                    }
                }
            }
        }
        for (slot, value) in pattern.slots[36 * t..36 * t + 36]
            .iter()
            .zip(block.as_slice())
        {
            values[*slot as usize] += value;
        }
    }
}

#[inline(always)]
fn jacobian_of_cell(elements: &Elements<4, DMat3>, t: usize, x: &[DVec3]) -> (DMat3, DMat3, f64) {
    let [i, j, k, l] = elements.vertices[t].map(|v| x[v as usize]);
    let j = DMat3::from_cols(j - i, k - i, l - i) * elements.inverses[t];
    let (a, b, c) = (j.x_axis, j.y_axis, j.z_axis);
    let cofactors = DMat3::from_cols(b.cross(c), c.cross(a), a.cross(b));
    (j, cofactors, a.dot(cofactors.x_axis))
}

fn square(a: DMat3) -> f64 {
    a.x_axis.length_squared() + a.y_axis.length_squared() + a.z_axis.length_squared()
}

/// The energy of tetrahedra; infinite where one is turned over.
pub fn energy_of_cells(elements: &Elements<4, DMat3>, x: &[DVec3]) -> f64 {
    let mut sum = 0.0;
    for (t, size) in elements.sizes.iter().enumerate() {
        let (j, c, d) = jacobian_of_cell(elements, t, x);
        if d <= 0.0 {
            return f64::INFINITY;
        }
        sum += size * (square(j) + square(c) / (d * d));
    }
    sum
}

/// Its gradient.
pub fn gradient_of_cells(elements: &Elements<4, DMat3>, x: &[DVec3], gradient: &mut [f64]) {
    gradient.fill(0.0);
    for (t, size) in elements.sizes.iter().enumerate() {
        let (j, c, d) = jacobian_of_cell(elements, t, x);
        if d <= 0.0 {
            continue;
        }
        let r = 1.0 / d;
        // ∂‖c‖²/∂J = 2 (‖J‖² J - J Jᵀ J)
        let n = square(j);
        let by_c = j * n - j * (j.transpose() * j);
        let by_j = (j + by_c * (r * r) - c * (square(c) * r * r * r)) * (2.0 * size);
        let by_edges = by_j * elements.inverses[t].transpose();
        let (b, c, e) = (by_edges.x_axis, by_edges.y_axis, by_edges.z_axis);
        for (v, part) in elements.vertices[t].iter().zip([-b - c - e, b, c, e]) {
            for (k, part) in part.to_array().into_iter().enumerate() {
                gradient[3 * *v as usize + k] += part;
            }
        }
    }
}

/// The second derivatives of one tetrahedron by its Jacobian, the lower triangle. With `n = ‖J‖²` and cofactors `c`,
/// `‖c‖² = ½ (n² - ‖JᵀJ‖²)` and `∂‖c‖²/∂J = 2 (n J - J Jᵀ J)`.
#[inline(always)]
fn by_jacobian_of_cell(jacobian: DMat3, c: DMat3, d: f64, size: f64) -> [[f64; 9]; 9] {
    let r = 1.0 / d;
    let (r2, r3) = (r * r, r * r * r);
    let (n, m) = (square(jacobian), square(c));
    let right = jacobian.transpose() * jacobian;
    let left = (jacobian * jacobian.transpose()).to_cols_array_2d();
    let slope = ((jacobian * n - jacobian * right) * 2.0).to_cols_array();
    let (u, v) = (jacobian.to_cols_array(), c.to_cols_array());
    let (j, right) = (jacobian.to_cols_array_2d(), right.to_cols_array_2d());
    let mut k = [[0.0; 9]; 9];
    for p in 0..9 {
        let (a, i) = (p / 3, p % 3);
        for q in 0..=p {
            let (b, l) = (q / 3, q % 3);
            // of ‖c‖²
            let mut second = 4.0 * u[p] * u[q] - 2.0 * j[b][i] * j[a][l];
            if i == l {
                second -= 2.0 * right[a][b];
            }
            if a == b {
                second -= 2.0 * left[i][l];
            }
            if p == q {
                second += 2.0 * n;
            }
            let mut entry = r2 * second - 2.0 * r3 * (slope[p] * v[q] + v[p] * slope[q])
                + 6.0 * m * r2 * r2 * v[p] * v[q];
            if p == q {
                entry += 2.0;
            }
            // of d, which is linear in each column: the vector product with the third one
            if a != b && i != l {
                let sign = if ((l + 3 - i) % 3 == 1) == ((b + 3 - a) % 3 == 1) {
                    1.0
                } else {
                    -1.0
                };
                entry -= 2.0 * m * r3 * sign * j[3 - a - b][3 - i - l];
            }
            k[p][q] = size * entry;
        }
    }
    k
}

/// The second derivatives of the energy of tetrahedra into the entries of a pattern.
pub fn hessian_of_cells(
    elements: &Elements<4, DMat3>,
    pattern: &Pattern,
    x: &[DVec3],
    values: &mut [f64],
) {
    values.fill(0.0);
    for (t, size) in elements.sizes.iter().enumerate() {
        let (j, c, d) = jacobian_of_cell(elements, t, x);
        if d <= 0.0 {
            continue;
        }
        let lower = by_jacobian_of_cell(j, c, d, *size);
        let k = |p: usize, q: usize| lower[p.max(q)][p.min(q)];
        // J = ∑_v x_v w_vᵀ
        let q = elements.inverses[t].transpose();
        let w = [
            -q.x_axis - q.y_axis - q.z_axis,
            q.x_axis,
            q.y_axis,
            q.z_axis,
        ];
        let mut block = [[0.0; 12]; 12];
        for (b, wb) in w.iter().enumerate() {
            for l in 0..3 {
                let column: [f64; 9] = std::array::from_fn(|p| {
                    k(p, l) * wb.x + k(p, l + 3) * wb.y + k(p, l + 6) * wb.z
                });
                for (a, wa) in w.iter().enumerate() {
                    for m in 0..3 {
                        block[3 * b + l][3 * a + m] =
                            column[m] * wa.x + column[m + 3] * wa.y + column[m + 6] * wa.z;
                    }
                }
            }
        }
        for (slot, value) in pattern.slots[144 * t..144 * t + 144]
            .iter()
            .zip(block.as_flattened())
        {
            values[*slot as usize] += value;
        }
    }
}
