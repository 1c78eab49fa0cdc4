//! Second derivatives by dual numbers, of terms around the vertices of meshes by their lists.

use std::collections::BTreeSet;

use iheartmesh::glam::DVec3;
use iheartmesh::{FaceMesh, Set, Vertex, sprs::CsMat};
use nalgebra::{DMatrix, DVector};
pub use num_dual::Dual2DVec64 as Dual;

/// Three numbers that are differentiated.
pub type Point = [Dual; 3];

pub fn dot(a: &Point, b: &Point) -> Dual {
    a[0].clone() * &b[0] + a[1].clone() * &b[1] + a[2].clone() * &b[2]
}

pub fn minus(a: &Point, b: &Point) -> Point {
    std::array::from_fn(|k| a[k].clone() - &b[k])
}

pub fn square(a: &Dual) -> Dual {
    a.clone() * a
}

pub fn sum<'a>(points: impl Iterator<Item = &'a Point>) -> Point {
    let zero = || std::array::from_fn(|_| Dual::from(0.0));
    points.fold(zero(), |a, b| std::array::from_fn(|k| a[k].clone() + &b[k]))
}

/// A mesh with its lists by hand.
pub struct Lists {
    pub n: usize,
    pub triangles: Vec<[u32; 3]>,
    pub rings: Vec<BTreeSet<usize>>,
}

impl Lists {
    pub fn new(n: usize, triangles: &[[u32; 3]]) -> Self {
        let mut rings = vec![BTreeSet::new(); n];
        for t in triangles {
            for k in 0..3 {
                let (a, b) = (t[k] as usize, t[(k + 1) % 3] as usize);
                rings[a].insert(b);
                rings[b].insert(a);
            }
        }
        let triangles = triangles.to_vec();
        Self {
            n,
            triangles,
            rings,
        }
    }

    pub fn mesh(&self) -> FaceMesh {
        FaceMesh::from_triangles(self.n, &self.triangles).unwrap()
    }

    /// The faces around a vertex, each with this one first.
    pub fn faces(&self, i: usize) -> impl Iterator<Item = [usize; 3]> {
        self.triangles.iter().filter_map(move |t| {
            let at = t.iter().position(|v| *v as usize == i)?;
            Some(std::array::from_fn(|k| t[(at + k) % 3] as usize))
        })
    }
}

/// The second derivatives of an energy of points by all their numbers.
pub fn second(x: &[DVec3], energy: impl Fn(&[Point]) -> Dual) -> DMatrix<f64> {
    let flat = x.iter().flat_map(|x| x.to_array()).collect();
    second_of(flat, |x| {
        let points = x
            .chunks(3)
            .map(|x| std::array::from_fn(|k| x[k].clone()))
            .collect::<Vec<Point>>();
        energy(&points)
    })
}

pub fn second_of(x: Vec<f64>, energy: impl Fn(&[Dual]) -> Dual) -> DMatrix<f64> {
    let n = x.len();
    let energy = |x: DVector<Dual>| energy(x.as_slice());
    let (_, _, hessian) = num_dual::hessian(energy, &DVector::from_vec(x));
    match hessian.is_empty() {
        // of a constant
        true => DMatrix::zeros(n, n),
        false => hessian,
    }
}

/// Eigenvalues of a symmetric matrix replaced.
pub fn replaced(matrix: &DMatrix<f64>, replace: impl Fn(f64) -> f64) -> DMatrix<f64> {
    if matrix.is_empty() {
        return matrix.clone();
    }
    let eigen = matrix.clone().symmetric_eigen();
    let values = DMatrix::from_diagonal(&eigen.eigenvalues.map(replace));
    &eigen.eigenvectors * values * eigen.eigenvectors.transpose()
}

pub fn positive(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    replaced(matrix, |x| x.max(0.0))
}

pub fn dense(a: &CsMat<f64>) -> DMatrix<f64> {
    let mut all = DMatrix::zeros(a.rows(), a.cols());
    for (value, (i, j)) in a {
        all[(i, j)] += *value;
    }
    all
}

#[track_caller]
pub fn near(name: &str, a: &DMatrix<f64>, b: &DMatrix<f64>) {
    assert_eq!(a.shape(), b.shape());
    let scale = b.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
    let difference = (a - b).iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    assert!(
        difference < 1e-10 * scale,
        "{name}: {difference} of {scale}"
    );
}

pub fn grid(n: u32) -> Lists {
    let mut triangles = Vec::new();
    for a in (0..n * (n - 1)).filter(|a| a % n < n - 1) {
        triangles.extend([[a, a + 1, a + n + 1], [a, a + n + 1, a + n]]);
    }
    Lists::new((n * n) as usize, &triangles)
}

pub fn points(n: usize, seed: u64) -> Vec<DVec3> {
    let mut random = fastrand::Rng::with_seed(seed);
    (0..n)
        .map(|_| DVec3::from_array(std::array::from_fn(|_| 2.0 * random.f64() - 1.0)))
        .collect()
}

pub fn meshes() -> Vec<Lists> {
    let around: Vec<[u32; 3]> = (1..7).map(|k| [0, k, k % 6 + 1]).collect();
    vec![
        Lists::new(0, &[]),
        // isolated vertices
        Lists::new(3, &[]),
        Lists::new(7, &[[1, 3, 5]]),
        // three faces on one edge, two fans at one vertex
        Lists::new(5, &[[0, 1, 2], [1, 0, 3], [0, 1, 4]]),
        Lists::new(7, &[[0, 1, 2], [0, 2, 3], [0, 4, 5], [0, 5, 6]]),
        // closed
        Lists::new(4, &[[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]),
        Lists::new(7, &around),
        grid(3),
    ]
}

pub fn vertices(set: &BTreeSet<usize>) -> Set<Vertex> {
    set.iter().map(|k| Vertex::new(*k as u32)).collect()
}
