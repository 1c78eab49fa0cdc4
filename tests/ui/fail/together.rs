//! Names that are asked for together: errors stand at the names, and a struct whose list is wrong causes no others.

iheartmesh::iheartmesh! {
    #[together(a, q)]
    #[together(a, x, s)]
    #[together(b, a, b)]
    #[together(a)]
    #[together()]
    #[together(a, 3)]
    pub struct Wrong = r#"
        x ∈ ℝ^n
        a = ‖x‖²
        b = 2x
        s(t) = t² where t ∈ ℝ
    "#;

    #[together(a, b)]
    #[together(b, a)]
    #[together(b, a)]
    pub struct Taken = r#"
        x ∈ ℝ^n
        a = ‖x‖²
        b = 2x
        `a_b` = 3
    "#;

    // what is wrong with the program comes first
    #[together(a, q)]
    pub struct Mistaken = r#"
        a = c
    "#;
}

fn main() {
    let x = vec![1.0];
    let (a, b) = Wrong::new(&x).unwrap().a_b();
    println!("{a} {b}");
}
