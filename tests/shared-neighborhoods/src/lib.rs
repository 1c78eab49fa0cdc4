//! Neighbourhoods as anyone may publish them: what tests import from another crate.

use iheartmesh::iheartmesh;

mod private {
    use iheartmesh::iheartmesh;

    iheartmesh! {
        /// The ring around a vertex; no other crate can name this module.
        pub(crate) struct OneRing = r#"
            ElementSets from MeshConnectivity
            VertexOneRing from Neighborhoods(M)
            M : FaceMesh
            V, E, F = ElementSets(M)
            Ring(v) = VertexOneRing(v) where v ∈ V
        "#;
    }
}

pub mod rings {
    //! Rings of vertices.

    use iheartmesh::iheartmesh;

    iheartmesh! {
        use crate::private::OneRing;

        /// Vertices at one and two edges from a vertex.
        pub struct KRings = r#"
            ElementSets from MeshConnectivity
            Ring from OneRing(M)
            M : FaceMesh
            V, E, F = ElementSets(M)
            FirstRing(v) = Ring(v) where v ∈ V
            SecondRing(v) = (∪_(j ∈ Ring(v)) Ring(j)) - Ring(v) - {v} where v ∈ V
        "#;
    }
}

// what is published at the root is found there too
pub use rings::KRings;

iheartmesh! {
    use rings::KRings as Rings;

    /// A module with modules of its own call and of this crate behind it.
    pub struct Disks = r#"
        ElementSets from MeshConnectivity
        Center from Centers(M)
        FirstRing from Rings(M)
        M : FaceMesh
        V, E, F = ElementSets(M)
        Disk(v) = Center(v) ∪ FirstRing(v) where v ∈ V
    "#;

    /// The set of one vertex.
    pub struct Centers = r#"
        ElementSets from MeshConnectivity
        M : FaceMesh
        V, E, F = ElementSets(M)
        Center(v) = {v} where v ∈ V
    "#;
}
