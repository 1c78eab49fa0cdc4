//! Curvature and normals against hand-written computations.

#[path = "../examples/common/generate.rs"]
#[allow(dead_code)]
mod generate;

use iheartmesh::{FaceMesh, Vertex, iheartmesh};

iheartmesh! {
    /// Angle defect at each vertex, in radians.
    pub struct GaussianCurvature = include "tests/programs/gaussian_curvature.hlang";

    #[without(all)]
    pub struct PlainGaussianCurvature = include "tests/programs/gaussian_curvature.hlang";

    pub struct MeanCurvature = include "tests/programs/mean_curvature.hlang";

    #[without(all)]
    pub struct PlainMeanCurvature = include "tests/programs/mean_curvature.hlang";

    pub struct VertexNormals = include "tests/programs/vertex_normals.hlang";

    #[without(all)]
    pub struct PlainVertexNormals = include "tests/programs/vertex_normals.hlang";
}

#[test]
fn smoke() {
    let (positions, triangles) = generate::torus(20, 10);
    let mesh = FaceMesh::from_triangles(positions.len(), &triangles).unwrap();
    let a = GaussianCurvature::new(&mesh, &positions).unwrap();
    let b = PlainGaussianCurvature::new(&mesh, &positions).unwrap();
    let all = a.K_all();
    let sum: f64 = all.iter().sum();
    assert!(sum.abs() < 1e-10, "{sum}");
    for v in mesh.vertices() {
        let (x, y) = (a.K(v), b.K(v));
        assert!((x - y).abs() < 1e-12);
        assert!((x - all[v.index()]).abs() < 1e-12);
    }
    let a = MeanCurvature::new(&mesh, &positions).unwrap();
    let b = PlainMeanCurvature::new(&mesh, &positions).unwrap();
    let all = a.H_all();
    for v in mesh.vertices() {
        let (x, y) = (a.H(v), b.H(v));
        assert!((x - y).abs() < 1e-12, "{x} {y}");
        assert!((x - all[v.index()]).abs() < 1e-12);
    }
    println!("{}", a.try_H(Vertex::new(1000)).unwrap_err());
    let a = VertexNormals::new(&mesh, &positions).unwrap();
    let b = PlainVertexNormals::new(&mesh, &positions).unwrap();
    let all = a.N_all();
    for v in mesh.vertices() {
        let (x, y) = (a.N(v), b.N(v));
        assert!((x - y).length() < 1e-12, "{x} {y}");
        assert!((x - all[v.index()]).length() < 1e-12);
        assert!((a.B(v) - b.B(v)).length() < 1e-12);
    }
}
