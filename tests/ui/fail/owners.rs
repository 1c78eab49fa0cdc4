// Elements of two meshes do not mix, in any spelling of a body.
iheartmesh::iheartmesh! {
    pub struct Raw = r#"
        ElementSets from MeshConnectivity
        M, N : FaceMesh
        V, E, F = ElementSets(M)
        U, G, H = ElementSets(N)
        both = V ∪ U
    "#;
    pub struct Commented = {
        /// ElementSets from MeshConnectivity
        /// M, N : FaceMesh
        /// V, E, F = ElementSets(M)
        /// U, G, H = ElementSets(N)
        /// both = V ∪ U
    };
    pub struct Escaped = "ElementSets from MeshConnectivity\nM, N : FaceMesh\nV, E, F = ElementSets(M)\n\
                          U, G, H = ElementSets(N)\nboth = V \u{222a} U";
}

fn main() {}
