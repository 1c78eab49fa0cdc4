// A warning of the macro is one of rustc: it obeys `deny`.
#![deny(warnings)]

iheartmesh::iheartmesh! {
    use shared::Unused;

    pub struct Plain = "a ∈ ℝ\nb = 2 a";
}

fn main() {}
