// Names that no `use` explains, with and without a similar one.
iheartmesh::iheartmesh! {
    struct Near = r#"
        Faces from Neighbourhoods(M)
        M : FaceMesh
    "#;

    struct Far = r#"
        Faces from SomethingElse(M)
        M : FaceMesh
    "#;
}

fn main() {}
