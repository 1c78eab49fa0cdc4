//! The same bits for every number of threads: whatever plan was made by how many of them.

#[path = "../examples/common/generate.rs"]
#[allow(dead_code)]
mod generate;

use iheartmesh::glam::DVec3;
use iheartmesh::{FaceMesh, iheartmesh};
use rayon::{ThreadPool, ThreadPoolBuilder};

iheartmesh! {
    pub struct Gaussian = include "tests/programs/gaussian_curvature.hlang";
    pub struct Mean = include "tests/programs/mean_curvature.hlang";
    pub struct Boundary = include "tests/programs/boundary_curvature.hlang";
    pub struct Normals = include "tests/programs/vertex_normals.hlang";
    pub struct Areas = include "tests/programs/vertex_areas.hlang";
    pub struct Total = r#"
        ElementSets from MeshConnectivity
        Vertices from Neighborhoods(M)
        M : FaceMesh
        V, E, F = ElementSets(M)
        x_i ∈ ℝ³
        L = ∑_(e ∈ E) ‖x_i - x_j‖ where i, j = Vertices(e)
        X = ∑_(v ∈ V) x_v
    "#;

    #[without(all)]
    pub struct PlainNormals = include "tests/programs/vertex_normals.hlang";
}

/// All values of all modules, as bits.
fn values(mesh: &FaceMesh, x: &[DVec3], evaluate: &ThreadPool) -> Vec<u64> {
    let scalars = |list: Vec<f64>| list.into_iter().map(f64::to_bits).collect::<Vec<_>>();
    let vectors = |list: Vec<DVec3>| {
        let components = list.iter().flat_map(DVec3::to_array);
        components.map(f64::to_bits).collect::<Vec<_>>()
    };
    let gaussian = Gaussian::new(mesh, x).unwrap();
    let mean = Mean::new(mesh, x).unwrap();
    let boundary = Boundary::new(mesh, x).unwrap();
    let normals = Normals::new(mesh, x).unwrap();
    let plain = PlainNormals::new(mesh, x).unwrap();
    let areas = Areas::new(mesh, x).unwrap();
    let total = Total::new(mesh, x).unwrap();
    evaluate.install(|| {
        [
            scalars(gaussian.K_all()),
            scalars(mean.H_all()),
            scalars(boundary.K_all()),
            vectors(normals.N_all()),
            vectors(normals.A_all()),
            vectors(normals.B_all()),
            vectors(plain.N_all()),
            scalars(areas.A_all()),
            scalars(areas.K_all()),
            vectors(areas.HN_all()),
            scalars(vec![total.L()]),
            vectors(vec![total.X()]),
        ]
        .concat()
    })
}

/// The two ways in which sums are scattered, on a mesh that is large enough to be put in order.
fn scattered(mesh: &FaceMesh, x: &[DVec3]) -> Vec<u64> {
    let gaussian = Gaussian::new(mesh, x).unwrap().K_all();
    let mean = Mean::new(mesh, x).unwrap().H_all();
    gaussian.into_iter().chain(mean).map(f64::to_bits).collect()
}

fn pools() -> [ThreadPool; 4] {
    [1, 2, 3, 7].map(|n| ThreadPoolBuilder::new().num_threads(n).build().unwrap())
}

#[test]
fn threads_do_not_change_a_bit() {
    let pools = pools();
    let (x, triangles) = generate::torus(60, 50);
    let mesh = FaceMesh::from_triangles(x.len(), &triangles).unwrap();
    let expected = pools[0].install(|| values(&mesh, &x, &pools[0]));
    for (make, evaluate) in [(1, 1), (2, 2), (3, 3), (0, 3), (3, 0)] {
        let found = pools[make].install(|| values(&mesh, &x, &pools[evaluate]));
        assert!(
            expected == found,
            "plan by pool {make}, values by pool {evaluate}"
        );
    }
}

#[test]
fn nor_do_they_on_a_mesh_without_order() {
    let (x, triangles) = generate::torus(150, 120);
    let (x, triangles) = generate::shuffle(&x, &triangles, 5);
    let mesh = FaceMesh::from_triangles(x.len(), &triangles).unwrap();
    let [one, others @ ..] = pools();
    let expected = one.install(|| scattered(&mesh, &x));
    for pool in others {
        assert!(
            expected == pool.install(|| scattered(&mesh, &x)),
            "{pool:?}"
        );
    }
}
