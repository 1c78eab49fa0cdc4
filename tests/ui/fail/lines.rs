// Bodies of one token a line: rustc marks the very line.
iheartmesh::iheartmesh! {
    struct Quoted = {
        "a ∈ ℝ"

        "b = a + undefined_name"
    };

    struct Commented = {
        /// a ∈ ℝ
        /// b = a + undefined_name
    };
}

fn main() {
    let _ = (Quoted::new(1.0), Commented::new(2.0));
}
