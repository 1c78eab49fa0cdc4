// What is not an item of this macro.
mod calls {
    iheartmesh::iheartmesh! {
        pub struct Number = 5;
        pub enum Kind = r#"a ∈ ℝ"#;
        pub struct Borrowing<'a> = r#"a ∈ ℝ"#;
        pub struct Braces { a: f64 }
        pub struct File = include "/no/such/file.hlang"
        pub struct Text = include_str!("text.hlang");
        pub struct __ihmReserved = r#"a ∈ ℝ"#;
        pub use a::B;
        use a::{B, C};
        pub struct Two = "a ∈ ℝ" "b = a";
        pub struct Good = "a ∈ ℝ\nb = a";
        pub struct Good = "a ∈ ℝ\nb = a";
        pub struct Last = "a ∈ ℝ\nb = a"
    }
}

use calls::{Braces, Good, Kind, Number};

fn main() {
    let _ = (Number::new(), Kind::new(1), Braces::new(), Good::new(1.0));
}
