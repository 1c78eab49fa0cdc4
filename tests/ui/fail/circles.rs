// Modules that import each other, in one call and across calls.
iheartmesh::iheartmesh! {
    struct Selfish = r#"
        a from Selfish
    "#;
    struct Left = r#"
        a from Right
    "#;
    struct Right = r#"
        a from Left
    "#;
}

mod above {
    iheartmesh::iheartmesh! {
        use crate::below::Below;
        pub struct Above = r#"
            a from Below
        "#;
    }
}

mod below {
    iheartmesh::iheartmesh! {
        use crate::above::Above;
        pub struct Below = r#"
            a from Above
        "#;
    }
}

fn main() {}
