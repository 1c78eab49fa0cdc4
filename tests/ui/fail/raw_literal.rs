// The place is the one in this file, and using the item causes no further error.
mod sums {
    iheartmesh::iheartmesh! {
        pub struct Sums = r#"
            a ∈ ℝ
            ∑∈ = b = a + undefined_name
        "#;
    }
}

use sums::Sums;

struct Holder<'a> {
    sums: Sums<'a>,
}

fn evaluate(sums: &Sums) -> f64 {
    sums.b() + 1.0
}

fn main() -> Result<(), iheartmesh::MeshError> {
    let mut sums = Sums::new(2.0)?;
    sums.set_a(3.0)?;
    for value in sums.b_all() {
        println!("{value} {}", Sums::SOURCE);
    }
    evaluate(&Holder { sums }.sums);
    Ok(())
}
