//! Programs on cell meshes and edge meshes.
use iheartmesh::glam::DVec3;
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
    fn means() {
        let mesh = EdgeMesh::from_edges(4, &[[0, 1], [2, 0], [3, 0]]).unwrap();
        let x = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        let module = Means::new(&mesh, x).unwrap();
        assert!((module.m(Vertex::new(0)) - DVec3::splat(1.0 / 3.0)).length() < 1e-15);
        assert_eq!(module.m(Vertex::new(1)), DVec3::ZERO);
    }
}
