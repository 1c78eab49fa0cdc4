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

fn sides([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

fn pair([i, j]: [u32; 2]) -> Pair {
    [i.min(j), i.max(j)]
}
