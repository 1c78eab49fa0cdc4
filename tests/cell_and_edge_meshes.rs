//! Programs on cell meshes and edge meshes.
use iheartmesh::glam::DVec3;
use iheartmesh::nalgebra::DVector;
use iheartmesh::{Cell, CellMesh, EdgeMesh, Vertex};

#[macro_use]
#[path = "support/twice.rs"]
mod twice;

programs! {
    Volumes, PlainVolumes = r#"
        ElementSets from MeshConnectivity
        OrientedVertices from TetrahderonNeighborhoods(M)
        M : CellMesh
        V, E, F, C = ElementSets(M)
        x_i ∈ ℝ^3
        vol(c) = |[x_b-x_a x_d-x_a x_k-x_a]|/6 where c ∈ C, a, b, d, k = OrientedVertices(c)
        total = ∑_(c ∈ C) vol(c)
    "#;
    Exterior, PlainExterior = r#"
        ElementSets, BoundaryMatrices from MeshConnectivity
        vec from linearalgebra
        M : CellMesh
        V, E, F, C = ElementSets(M)
        `∂⁰`, `∂¹`, `∂²` = BoundaryMatrices(M)
        u : V → ℝ
        s ∈ ℝ^(#V)
        d = `∂⁰`ᵀ vec(u)
        L = `∂⁰` `∂⁰`ᵀ
        Z = `∂⁰` `∂¹`
        Y = `∂¹` `∂²`
        y = L s
        t = sᵀ L s + (2 `∂⁰`ᵀ s)⋅d
    "#;
    Means, PlainMeans = r#"
        ElementSets from MeshConnectivity
        VertexOneRing from PointCloudNeighborhoods(M)
        M : EdgeMesh
        V, E = ElementSets(M)
        x_i ∈ ℝ^3
        m(v) = 1/|VertexOneRing(v)| ∑_(w ∈ VertexOneRing(v)) x_w where v ∈ V
    "#;
}

for_both! {
    #[test]
    fn volumes() {
        let mesh = CellMesh::from_tetrahedra(5, &[[0, 1, 2, 3], [1, 2, 3, 4], [3, 2, 1, 4]]).unwrap();
        let x = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z, DVec3::ONE];
        let module = Volumes::new(&mesh, x).unwrap();
        let expected = [1.0 / 6.0, 1.0 / 3.0, -1.0 / 3.0];
        for (cell, expected) in mesh.cells().zip(expected) {
            assert!((module.vol(cell) - expected).abs() < 1e-15, "{cell:?}");
        }
        assert!((module.total() - 1.0 / 6.0).abs() < 1e-15);
        assert_eq!(module.vol_all().len(), 3);
        let _ = Cell::new(0);
    }

    #[test]
    fn boundary_matrices_are_matrices() {
        let mesh = CellMesh::from_tetrahedra(5, &[[0, 1, 2, 3], [1, 2, 3, 4]]).unwrap();
        let u = [1.0, -2.0, 0.5, 3.0, 7.0];
        let module = Exterior::new(&mesh, u, DVector::from_row_slice(&u)).unwrap();
        let differences: Vec<f64> = mesh
            .edges()
            .map(|edge| {
                let [tail, head] = mesh.edge_vertices(edge);
                u[head.index()] - u[tail.index()]
            })
            .collect();
        assert_eq!(module.d().as_slice(), differences);
        let degree = |v: usize| mesh.vertex_edges(Vertex::new(v as u32)).len() as f64;
        for v in 0..5 {
            assert_eq!(module.L().get(v, v), Some(&degree(v)));
            let around = mesh.edges().map(|edge| mesh.edge_vertices(edge).map(|v| v.index()));
            let expected: f64 = around
                .filter(|ends| ends.contains(&v))
                .map(|[i, j]| u[v] - u[if i == v { j } else { i }])
                .sum();
            assert!((module.y()[v] - expected).abs() < 1e-14);
        }
        // the boundary of a boundary is nothing
        for product in [module.Z(), module.Y()] {
            assert!(product.data().iter().all(|entry| *entry == 0.0));
        }
        assert_eq!((module.Z().rows(), module.Z().cols()), (5, 7));
        let squares: f64 = differences.iter().map(|d| d * d).sum();
        assert!((module.t() - 3.0 * squares).abs() < 1e-12);
    }

    #[test]
    fn means() {
        let mesh = EdgeMesh::from_edges(4, &[[0, 1], [2, 0], [3, 0]]).unwrap();
        let x = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        let module = Means::new(&mesh, x).unwrap();
        assert!((module.m(Vertex::new(0)) - DVec3::splat(1.0 / 3.0)).length() < 1e-15);
        assert_eq!(module.m(Vertex::new(1)), DVec3::ZERO);
    }
}
