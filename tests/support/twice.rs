//! Programs that are compiled with and without optimisations, and tests of both.

/// The programs twice: with all optimisations and without any.
macro_rules! programs {
    ($($(#[$($attribute:tt)*])* $name:ident, $plain:ident = $text:literal;)*) => {
        mod both {
            iheartmesh::iheartmesh! {
                $(
                    $(#[$($attribute)*])*
                    pub struct $name = $text;

                    $(#[$($attribute)*])*
                    #[without(all)]
                    pub struct $plain = $text;
                )*
            }
        }
        mod optimized {
            pub use super::both::{$($name),*};
        }
        mod plain {
            pub use super::both::{$($plain as $name),*};
        }
    };
}

/// The tests for the programs of both kinds.
macro_rules! for_both {
    ($(#[test] fn $name:ident() $body:block)*) => {
        mod with_optimizations {
            use super::{*, optimized::*};
            $(#[test] fn $name() $body)*
        }
        mod without_optimizations {
            use super::{*, plain::*};
            $(#[test] fn $name() $body)*
        }
    };
}
