// A mistake in a module is reported there, and not again by those who import it.
mod library {
    iheartmesh::iheartmesh! {
        pub struct Scales = r#"
            s ∈ ℝ
            u ∈ ℝ³
            scaled(t) = t (s + u) where t ∈ ℝ
        "#;
        pub struct Local = r#"
            scaled from Scales(s, u)
            s ∈ ℝ
            u ∈ ℝ³
            y = scaled(2)
        "#;
    }
}

iheartmesh::iheartmesh! {
    use library::Scales;

    pub struct Remote = r#"
        scaled from Scales(a, b)
        a ∈ ℝ
        b ∈ ℝ
        y = scaled(2)
    "#;
}

fn main() {}
