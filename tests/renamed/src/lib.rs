//! Nothing here is called `iheartmesh` or `shared-neighborhoods`, and the macro works all the same.

use formulas::iheartmesh as formula;

formula! {
    use rings::Disks;

    /// How many vertices are close to each vertex.
    pub struct Valence = r#"
        ElementSets from MeshConnectivity
        VertexOneRing from Neighborhoods(M)
        Disk from Disks(M)
        M : FaceMesh
        V, E, F = ElementSets(M)
        valence(v) = |VertexOneRing(v)| where v ∈ V
        size(v) = |Disk(v)| where v ∈ V
    "#;
}

#[test]
fn the_module_computes() -> Result<(), Box<dyn std::error::Error>> {
    // two triangles with a common side, and a vertex that nothing touches
    let mesh = formulas::FaceMesh::from_triangles(5, &[[0, 1, 2], [2, 1, 3]])?;
    let valence = Valence::new(&mesh)?;
    assert_eq!(valence.valence_all(), [2, 3, 3, 2, 0]);
    assert_eq!(valence.size_all(), [3, 4, 4, 3, 1]);
    assert!(Valence::SOURCE.contains("VertexOneRing"));
    Ok(())
}
