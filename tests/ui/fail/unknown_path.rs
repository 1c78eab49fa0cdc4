// rustc itself says what is wrong with a path.
mod other {}

iheartmesh::iheartmesh! {
    use crate::other::Missing;

    struct Importing = r#"
        Faces from Missing(M)
        M : FaceMesh
    "#;
}

fn main() {}
