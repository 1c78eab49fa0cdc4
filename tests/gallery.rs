//! The programs of the gallery against loops, with all optimisations and with none.

#[path = "../examples/gallery/by_hand.rs"]
mod by_hand;
#[allow(dead_code)]
mod support;

use by_hand::Topology;
use iheartmesh::glam::DVec3;
use iheartmesh::nalgebra::{DMatrix, DVector};
use iheartmesh::{CellMesh, Edge, FaceMesh, Vertex, io};

both_ways! {
    PointConvolution, PlainPointConvolution = "examples/gallery/point_convolution.hlang";
    GraphConvolution, PlainGraphConvolution = "examples/gallery/graph_convolution.hlang";
    DifferentialCoordinates, PlainDifferentialCoordinates = "examples/gallery/differential_coordinates.hlang";
    PatchDifferences, PlainPatchDifferences = "examples/gallery/patch_differences.hlang";
    SegmentLengths, PlainSegmentLengths = "examples/gallery/segment_lengths.hlang";
    CellAverage, PlainCellAverage = "examples/gallery/cell_average.hlang";
    AngleDefect, PlainAngleDefect = "examples/gallery/angle_defect.hlang";
    EdgeEnergy, PlainEdgeEnergy = "examples/gallery/edge_energy.hlang";
}

/// A closed mesh with its positions, and numbers of all sizes between -1 and 1.
struct Input {
    mesh: FaceMesh,
    x: Vec<DVec3>,
    random: fastrand::Rng,
}

impl Input {
    fn new() -> Input {
        let file = io::read(support::workspace().join("meshes/bob_small.ply")).unwrap();
        Input {
            mesh: file.face_mesh().unwrap(),
            x: file.positions,
            random: fastrand::Rng::with_seed(7),
        }
    }

    fn topology(&self) -> Topology<'_> {
        Topology::new(self.x.len(), self.mesh.triangles().unwrap())
    }

    fn numbers(&mut self, n: usize) -> Vec<f64> {
        (0..n).map(|_| 2.0 * self.random.f64() - 1.0).collect()
    }

    fn vectors(&mut self, n: usize, length: usize) -> Vec<DVector<f64>> {
        (0..n)
            .map(|_| DVector::from_vec(self.numbers(length)))
            .collect()
    }
}

#[test]
fn point_convolution() {
    let Input { mesh, x, .. } = &Input::new();
    let expected = Input::new().topology().point_convolution(x, 0.3);
    let a = PointConvolution::new(mesh, x, 0.3).unwrap();
    let b = PlainPointConvolution::new(mesh, x, 0.3).unwrap();
    for (v, expected) in mesh.vertices().zip(expected) {
        assert!((a.a(v) - expected).abs() < 1e-14);
        assert!((b.a(v) - expected).abs() < 1e-14);
    }
}

#[test]
fn graph_convolution() {
    let mut input = Input::new();
    let n = input.x.len();
    let (f, b) = (input.vectors(n, 4), input.vectors(n, 2));
    let kernels: Vec<DMatrix<f64>> = (0..n)
        .map(|_| DMatrix::from_vec(2, 4, input.numbers(8)))
        .collect();
    for rings in 0..4 {
        let expected = input.topology().graph_convolution(rings, &f, &kernels, &b);
        let mesh = &input.mesh;
        let one = GraphConvolution::new(mesh, rings, &f, &kernels, &b).unwrap();
        let other = PlainGraphConvolution::new(mesh, rings, &f, &kernels, &b).unwrap();
        let all = one.f_prime_all();
        for (v, expected) in mesh.vertices().zip(expected) {
            assert!((&all[v.index()] - &expected).norm() < 1e-13);
            if v.index() % 20 == 0 {
                assert!((other.f_prime(v) - expected).norm() < 1e-13);
            }
        }
    }
}

#[test]
fn differential_coordinates() {
    let Input { mesh, x, .. } = &Input::new();
    let a = DifferentialCoordinates::new(mesh, x).unwrap();
    let b = PlainDifferentialCoordinates::new(mesh, x).unwrap();
    let found = field!(a, b, mesh.vertices(), delta, delta_all);
    let expected = Input::new().topology().differential_coordinates(x);
    let off = found.iter().zip(expected).map(|(a, b)| a.distance(b));
    assert!(off.fold(0.0, f64::max) < 1e-14);
}

#[test]
fn patch_differences() {
    let mut input = Input::new();
    let alpha = input.vectors(input.mesh.n_faces(), 5);
    let (sum, squares) = input.topology().patch_differences(&alpha);
    let a = PatchDifferences::new(&input.mesh, &alpha).unwrap();
    let b = PlainPatchDifferences::new(&input.mesh, &alpha).unwrap();
    for (printed, squared) in [(a.E_O(), a.E_2()), (b.E_O(), b.E_2())] {
        assert!((printed - sum).abs() < 1e-11, "{printed} {sum}");
        assert!(printed.abs() < 1e-11);
        assert!((squared - squares).abs() < 1e-11 * squares && squares > 1000.0);
    }
}

#[test]
fn cell_average() {
    let (x, tetrahedra) = by_hand::bent_cube(4);
    let mesh = CellMesh::from_tetrahedra(x.len(), &tetrahedra).unwrap();
    let flow = |p: DVec3| DVec3::new(-p.y, p.x, p.z * p.z);
    let a = CellAverage::new(&mesh, &x, flow).unwrap();
    let b = PlainCellAverage::new(&mesh, &x, flow).unwrap();
    let expected = by_hand::cell_average(&x, &tetrahedra, flow);
    for ((v, all), expected) in mesh.vertices().zip(a.F̂_all()).zip(expected) {
        for found in [all, a.F̂(v), b.F̂(v)] {
            assert!(found.distance(expected) < 1e-14);
        }
    }
}

#[test]
fn segment_lengths() {
    let mut input = Input::new();
    // without the triangles around a few vertices, which are far from each other
    let is_kept = |t: &&[u32; 3]| !t.iter().any(|v| [10, 90, 240].contains(v));
    let triangles: Vec<[u32; 3]> = input
        .mesh
        .triangles()
        .unwrap()
        .iter()
        .filter(is_kept)
        .copied()
        .collect();
    let mesh = FaceMesh::from_triangles(input.x.len(), &triangles).unwrap();
    let w = input.numbers(mesh.n_edges());
    let topology = Topology::new(input.x.len(), &triangles);
    let expected = topology.segment_lengths(&input.x, &w);
    assert!(expected.len() > 12);
    let a = SegmentLengths::new(&mesh, &input.x, &w).unwrap();
    let b = PlainSegmentLengths::new(&mesh, &input.x, &w).unwrap();
    for (number, ends) in topology.edges.keys().enumerate() {
        let edge = Edge::new(number as u32);
        assert_eq!(mesh.edge_vertices(edge), ends.map(Vertex::new));
        let (x, y) = (a.try_l_prime(edge), b.try_l_prime(edge));
        match expected.get(ends) {
            Some(value) => {
                assert!((x.unwrap() - value).abs() < 1e-14);
                assert!((y.unwrap() - value).abs() < 1e-14);
                assert_eq!(a.prev(a.next(edge)), edge);
                assert_ne!(a.next(edge), edge);
            }
            // not a segment
            None => assert_eq!(x.unwrap_err().to_string(), y.unwrap_err().to_string()),
        }
    }
}

#[test]
fn angle_defect() {
    let Input { mesh, x, .. } = &Input::new();
    let a = AngleDefect::new(mesh, x).unwrap();
    let b = PlainAngleDefect::new(mesh, x).unwrap();
    let found = field!(a, b, mesh.vertices(), kappa, kappa_all);
    let expected = Input::new().topology().angle_defect(x);
    let off = found.iter().zip(expected).map(|(a, b)| (a - b).abs());
    assert!(off.fold(0.0, f64::max) < 1e-12);
}

#[test]
fn edge_energy() {
    let mut input = Input::new();
    let f: Vec<DVec3> = (0..input.mesh.n_faces())
        .map(|_| DVec3::from_slice(&input.numbers(3)))
        .collect();
    let w: Vec<f64> = input
        .numbers(input.mesh.n_edges())
        .iter()
        .map(|x| x.abs())
        .collect();
    for p in [1.0, 2.0, 2.5] {
        let expected = input.topology().edge_energy(&w, &f, p);
        let a = EdgeEnergy::new(&input.mesh, &w, &f, p).unwrap();
        let b = PlainEdgeEnergy::new(&input.mesh, &w, &f, p).unwrap();
        for found in [a.E_p(), b.E_p()] {
            assert!(
                (found - expected).abs() < 1e-12 * expected,
                "{found} {expected}"
            );
        }
    }
}
