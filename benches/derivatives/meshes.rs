//! Grids of about so many elements, moved a little: enough that some have indefinite second derivatives, and none is turned
//! over.

use glam::{DMat2, DMat3, DVec2, DVec3};

use super::baseline::symmetric_dirichlet::Elements;

/// How far positions are moved at most that are moved little, as a part of a side.
const GENTLE: f64 = 0.02;

/// A mesh with positions.
pub struct Grid<const N: usize, Q, X> {
    /// What does not change.
    pub elements: Elements<N, Q>,
    /// Positions at rest.
    pub rest: Vec<DVec3>,
    /// Positions.
    pub positions: Vec<X>,
    /// Positions that are stretched in all directions and moved little.
    pub gentle: Vec<X>,
}

/// Numbers between -1 and 1 without a pattern.
fn noise(random: &mut fastrand::Rng) -> f64 {
    2.0 * random.f64() - 1.0
}

/// About `count` triangles in the plane.
pub fn triangles(count: usize) -> Grid<3, DMat2, DVec2> {
    let n = ((count as f64 / 2.0).sqrt().ceil() as usize).max(2);
    let mut random = fastrand::Rng::with_seed(7);
    let mut rest = Vec::new();
    let mut positions = Vec::new();
    for j in 0..=n {
        for i in 0..=n {
            let at = DVec2::new(i as f64, j as f64);
            let moved = DVec2::new(noise(&mut random), noise(&mut random)) * 0.15;
            rest.push((at + moved).extend(0.0));
            let moved = DVec2::new(noise(&mut random), noise(&mut random)) * 0.15;
            positions.push(at * DVec2::new(1.3, 0.9) + moved);
        }
    }
    let number = |i: usize, j: usize| (i + j * (n + 1)) as u32;
    let mut vertices = Vec::new();
    for j in 0..n {
        for i in 0..n {
            let [a, b, c, d] = [
                number(i, j),
                number(i + 1, j),
                number(i + 1, j + 1),
                number(i, j + 1),
            ];
            vertices.extend([[a, b, c], [a, c, d]]);
        }
    }
    let gentle = rest
        .iter()
        .map(|at| {
            let moved = DVec2::new(noise(&mut random), noise(&mut random)) * GENTLE;
            at.truncate() * DVec2::new(1.3, 1.1) + moved
        })
        .collect();
    let edges = |[a, b, c]: [u32; 3]| {
        let [a, b, c] = [a, b, c].map(|v| rest[v as usize].truncate());
        DMat2::from_cols(b - a, c - a)
    };
    let elements = Elements {
        inverses: vertices.iter().map(|v| edges(*v).inverse()).collect(),
        sizes: vertices
            .iter()
            .map(|v| 0.5 * edges(*v).determinant())
            .collect(),
        vertices,
    };
    Grid {
        elements,
        rest,
        positions,
        gentle,
    }
}

/// About `count` tetrahedra: cubes of six. Their vertices are in ascending order, as `Vertices` has them, and so oriented
/// either way; the inverses of the edges at rest are, too.
pub fn tetrahedra(count: usize) -> Grid<4, DMat3, DVec3> {
    let n = ((count as f64 / 6.0).cbrt().ceil() as usize).max(2);
    let mut random = fastrand::Rng::with_seed(7);
    let mut rest = Vec::new();
    let mut positions = Vec::new();
    let mut moved =
        |size: f64| DVec3::from_array(std::array::from_fn(|_| size * noise(&mut random)));
    for k in 0..=n {
        for j in 0..=n {
            for i in 0..=n {
                let at = DVec3::new(i as f64, j as f64, k as f64);
                rest.push(at + moved(0.1));
                positions.push(at * DVec3::new(1.2, 0.95, 0.9) + moved(0.1));
            }
        }
    }
    let gentle = rest
        .iter()
        .map(|at| *at * DVec3::new(1.2, 1.1, 1.05) + moved(GENTLE))
        .collect();
    let number = |[i, j, k]: [usize; 3]| (i + (n + 1) * (j + (n + 1) * k)) as u32;
    let mut vertices = Vec::new();
    for corner in 0..n * n * n {
        let start = [corner % n, corner / n % n, corner / n / n];
        for order in [
            [0, 1, 2],
            [1, 2, 0],
            [2, 0, 1],
            [0, 2, 1],
            [2, 1, 0],
            [1, 0, 2],
        ] {
            let mut at = start;
            let mut cell = [number(at); 4];
            for (slot, axis) in cell[1..].iter_mut().zip(order) {
                at[axis] += 1;
                *slot = number(at);
            }
            vertices.push(cell);
        }
    }
    let edges = |cell: [u32; 4]| {
        let [a, b, c, d] = cell.map(|v| rest[v as usize]);
        DMat3::from_cols(b - a, c - a, d - a)
    };
    let elements = Elements {
        inverses: vertices.iter().map(|v| edges(*v).inverse()).collect(),
        sizes: vertices
            .iter()
            .map(|v| edges(*v).determinant().abs() / 6.0)
            .collect(),
        vertices,
    };
    Grid {
        elements,
        rest,
        positions,
        gentle,
    }
}
