// One item with errors leaves the others as they are; all errors come at once.
mod three {
    iheartmesh::iheartmesh! {
        pub struct First = r#"
            a ∈ ℝ
            b = a + undefined_name
        "#;
        pub struct Second = r#"
            a ∈ ℝ
            b = 2 a
        "#;
        pub struct Third = r#"
            a ∈ ℝ
            b = a + another_name
        "#;
    }
}

use three::{First, Second, Third};

fn main() {
    let second: f64 = Second::new(1.0).unwrap().b();
    let _ = (First::new(1.0), Third::new(second));
}
