// Every spelling of a body, in modules, in functions and through other macros, without any warning.
#![deny(warnings)]

mod shapes {
    iheartmesh::iheartmesh! {
        /// A documented module.
        #[must_use]
        pub struct Raw = r##"
            a ∈ ℝ
            b = 2 a
        "##;
        pub(crate) struct Escaped = "a \u{2208} \u{211d}\nb = 2 a";
        pub(super) struct Quoted = {
            "a ∈ ℝ"
            "b = 2 a"
        };
        pub(in crate::shapes) struct Commented = {
            /// a ∈ ℝ
            /// b = 2 a
        };
    }

    pub fn commented() -> &'static str {
        Commented::SOURCE
    }
}

macro_rules! module {
    ($name:ident, $text:literal) => {
        iheartmesh::iheartmesh! {
            pub struct $name = $text;
        }
    };
}

module!(Wrapped, "a ∈ ℝ\nb = 2 a");

fn main() {
    iheartmesh::iheartmesh! {
        pub struct Inner = "a ∈ ℝ\nb = 2 a";
    }
    assert_eq!(shapes::Escaped::SOURCE, "a ∈ ℝ\nb = 2 a");
    assert_eq!(shapes::Quoted::SOURCE, shapes::Escaped::SOURCE);
    assert_eq!(shapes::commented(), shapes::Escaped::SOURCE);
    assert_eq!(Wrapped::SOURCE, Inner::SOURCE);
    assert!(shapes::Raw::SOURCE.contains("b = 2 a"));
}
