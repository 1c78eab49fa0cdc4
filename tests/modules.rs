//! Modules that import modules of other crates, from a crate that is neither theirs nor the macro's.

use iheartmesh::iheartmesh;

iheartmesh! {
    use shared_neighborhoods::rings::KRings as Rings;

    /// How many vertices are at two edges.
    struct Reach = r#"
        ElementSets from MeshConnectivity
        SecondRing from Rings(M)
        M : FaceMesh
        V, E, F = ElementSets(M)
        n(v) = |SecondRing(v)| where v ∈ V
    "#;
}

/// One module for each kind of place that the other tests of imports do not reach.
mod same_name {
    use iheartmesh::iheartmesh;

    iheartmesh! {
        // the same module through two paths is one module
        use shared_neighborhoods::KRings;
        use shared_neighborhoods::Disks;

        pub struct Reach = r#"
            ElementSets from MeshConnectivity
            FirstRing from KRings(M)
            Disk from Disks(M)
            M : FaceMesh
            V, E, F = ElementSets(M)
            n(v) = |Disk(v)| - |FirstRing(v)| where v ∈ V
        "#;
    }
}

#[test]
fn modules_of_the_same_name_live_beside_each_other() {
    assert_ne!(Reach::SOURCE, same_name::Reach::SOURCE);
}

#[test]
fn the_standard_modules_can_be_used_from_rust() {
    assert!(iheartmesh::neighborhoods::Neighborhoods::SOURCE.contains("VertexOneRing"));
}
