//! What several tests share.

pub mod cellular;
pub mod fields;
pub mod json;
pub mod random;
pub mod reference_mesh;
pub mod reference_set;
pub mod solids;
pub mod soups;
#[macro_use]
pub mod ways;

use std::path::{Path, PathBuf};

/// The root of the repository.
pub fn workspace() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The directory of the reference set, if it is there.
pub fn reference_set() -> Option<PathBuf> {
    reference_set::reference_set(workspace())
}

/// Two modules of one source: `$optimised`, and `$plain` with every optimisation off.
#[macro_export]
macro_rules! both_ways {
    ($($optimised:ident, $plain:ident = $source:literal;)*) => {
        iheartmesh::iheartmesh! {
            $(
                pub struct $optimised = include $source;

                #[without(all)]
                pub struct $plain = include $source;
            )*
        }
    };
}
