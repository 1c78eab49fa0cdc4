//! What the programs of the gallery compute, as loops over triangles and sets of numbers.

use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::TAU;

use iheartmesh::glam::DVec3;
use iheartmesh::nalgebra::{DMatrix, DVector};

/// The numbers of two vertices, the smaller one first.
pub type Pair = [u32; 2];

/// What is next to what on a mesh of triangles.
pub struct Topology<'a> {
    triangles: &'a [[u32; 3]],
    /// The neighbours of each vertex.
    neighbours: Vec<BTreeSet<usize>>,
    /// The triangles at each edge, by the vertices of the edge: in the order in which edges are numbered.
    pub edges: BTreeMap<Pair, Vec<usize>>,
}

impl<'a> Topology<'a> {
    pub fn new(n_vertices: usize, triangles: &'a [[u32; 3]]) -> Topology<'a> {
        let mut neighbours = vec![BTreeSet::new(); n_vertices];
        let mut edges: BTreeMap<Pair, Vec<usize>> = BTreeMap::new();
        for (number, triangle) in triangles.iter().enumerate() {
            for [i, j] in sides(*triangle) {
                neighbours[i as usize].insert(j as usize);
                neighbours[j as usize].insert(i as usize);
                edges.entry(pair([i, j])).or_default().push(number);
            }
        }
        Topology {
            triangles,
            neighbours,
            edges,
        }
    }

    /// `point_convolution.hlang`.
    pub fn point_convolution(&self, p: &[DVec3], h: f64) -> Vec<f64> {
        let value = |j: usize| {
            let (mut above, mut below) = (0.0, 0.0);
            for &i in &self.neighbours[j] {
                let distance = p[i].distance(p[j]);
                let weight = (-distance * distance / (h * h)).exp();
                above += weight * distance;
                below += weight;
            }
            above / below
        };
        (0..p.len()).map(value).collect()
    }

    /// `graph_convolution.hlang`.
    pub fn graph_convolution(
        &self,
        rings: i64,
        f: &[DVector<f64>],
        kernels: &[DMatrix<f64>],
        b: &[DVector<f64>],
    ) -> Vec<DVector<f64>> {
        let value = |k: usize| {
            let mut ring = BTreeSet::from([k]);
            for _ in 0..rings {
                let next: Vec<usize> = ring
                    .iter()
                    .flat_map(|l| self.neighbours[*l].iter().copied())
                    .collect();
                ring.extend(next);
            }
            let weight = 1.0 / ring.len() as f64;
            ring.iter()
                .fold(b[k].clone(), |sum, &l| sum + weight * (&kernels[l] * &f[l]))
        };
        (0..f.len()).map(value).collect()
    }

    /// `differential_coordinates.hlang`.
    pub fn differential_coordinates(&self, v: &[DVec3]) -> Vec<DVec3> {
        let value = |i: usize| {
            let ring = &self.neighbours[i];
            v[i] - ring.iter().map(|j| v[*j]).sum::<DVec3>() / ring.len() as f64
        };
        (0..v.len()).map(value).collect()
    }

    /// `patch_differences.hlang`: the sum as printed, and that of the squares.
    pub fn patch_differences(&self, alpha: &[DVector<f64>]) -> (f64, f64) {
        let (mut sum, mut squares) = (0.0, 0.0);
        // two triangles with two edges in common are neighbours once
        let pairs: BTreeSet<(usize, usize)> = self
            .edges
            .values()
            .flat_map(|faces| faces.iter().flat_map(|p| faces.iter().map(|q| (*p, *q))))
            .filter(|(p, q)| p != q)
            .collect();
        for (p, q) in pairs {
            for (a, b) in alpha[p].iter().zip(alpha[q].iter()) {
                sum += a - b;
                squares += (a - b) * (a - b);
            }
        }
        (sum, squares)
    }

    /// `segment_lengths.hlang`: the values at the edges of the boundary, with a width for each edge of the mesh.
    pub fn segment_lengths(&self, x: &[DVec3], w: &[f64]) -> BTreeMap<Pair, f64> {
        let width: BTreeMap<Pair, f64> =
            self.edges.keys().copied().zip(w.iter().copied()).collect();
        let at_boundary: Vec<[u32; 2]> = self
            .triangles
            .iter()
            .flat_map(|triangle| sides(*triangle))
            .filter(|side| self.edges[&pair(*side)].len() == 1)
            .collect();
        let after: BTreeMap<u32, [u32; 2]> =
            at_boundary.iter().map(|side| (side[0], *side)).collect();
        let before: BTreeMap<u32, [u32; 2]> =
            at_boundary.iter().map(|side| (side[1], *side)).collect();
        let value = |&[from, to]: &[u32; 2]| {
            let length = x[from as usize].distance(x[to as usize]);
            let (previous, next) = (width[&pair(before[&from])], width[&pair(after[&to])]);
            (pair([from, to]), previous + length + next)
        };
        at_boundary.iter().map(value).collect()
    }

    /// `angle_defect.hlang`.
    pub fn angle_defect(&self, x: &[DVec3]) -> Vec<f64> {
        let mut defects = vec![TAU; x.len()];
        for triangle in self.triangles {
            for k in 0..3 {
                let [v, j, i] = [0, 1, 2].map(|step| triangle[(k + step) % 3] as usize);
                defects[v] -= (x[j] - x[v]).angle_between(x[i] - x[v]);
            }
        }
        defects
    }

    /// `edge_energy.hlang`, on a closed mesh.
    pub fn edge_energy(&self, w: &[f64], f: &[DVec3], p: f64) -> f64 {
        let terms = self
            .edges
            .values()
            .zip(w)
            .map(|(faces, weight)| match faces[..] {
                [first, second] => weight * f[first].distance(f[second]).powf(p),
                _ => f64::NAN,
            });
        terms.sum::<f64>().powf(1.0 / p)
    }
}

/// A cube of n³ smaller ones, each cut into the six tetrahedra around its diagonal, with bent sides.
pub fn bent_cube(n: u32) -> (Vec<DVec3>, Vec<[u32; 4]>) {
    let vertex = |[i, j, k]: [u32; 3]| i + (n + 1) * (j + (n + 1) * k);
    let steps = || (0..n * n * n).map(|c| [c % n, c / n % n, c / n / n]);
    let orders = [
        [0, 1, 2],
        [1, 2, 0],
        [2, 0, 1],
        [0, 2, 1],
        [2, 1, 0],
        [1, 0, 2],
    ];
    let tetrahedra = steps().flat_map(|corner| {
        orders.iter().enumerate().map(move |(number, order)| {
            let mut place = corner;
            let mut path = [vertex(place); 4];
            for (step, axis) in order.iter().enumerate() {
                place[*axis] += 1;
                path[step + 1] = vertex(place);
            }
            if number >= 3 {
                path.swap(2, 3);
            }
            path
        })
    });
    let m = n + 1;
    let points = (0..m * m * m).map(|c| {
        let p = DVec3::new((c % m).into(), (c / m % m).into(), (c / m / m).into()) / f64::from(n);
        p + 0.1 * DVec3::new(p.y * p.z, (3.0 * p.x).sin(), p.x * p.y)
    });
    (points.collect(), tetrahedra.collect())
}

/// `cell_average.hlang`.
pub fn cell_average(
    x: &[DVec3],
    tetrahedra: &[[u32; 4]],
    value: impl Fn(DVec3) -> DVec3,
) -> Vec<DVec3> {
    let (mut sums, mut weights) = (vec![DVec3::ZERO; x.len()], vec![0.0; x.len()]);
    for tetrahedron in tetrahedra {
        let [a, b, c, d] = tetrahedron.map(|v| x[v as usize]);
        let volume = (b - a).cross(c - a).dot(d - a) / 6.0;
        let centre = (a + b + c + d) / 4.0;
        for v in tetrahedron.map(|v| v as usize) {
            let weight = volume / centre.distance(x[v]);
            sums[v] += weight * value(centre);
            weights[v] += weight;
        }
    }
    sums.iter()
        .zip(weights)
        .map(|(sum, weight)| *sum / weight)
        .collect()
}

fn sides([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

fn pair([i, j]: [u32; 2]) -> Pair {
    [i.min(j), i.max(j)]
}
