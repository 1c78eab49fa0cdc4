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
fn the_module_is_compiled() {
    assert!(Valence::SOURCE.contains("VertexOneRing"));
}
