//! Where the reference set is: real meshes, and values that other libraries computed for them.
//!
//! The set is not part of the repository. It is looked for in the directory that the environment variable
//! `IHEARTMESH_DATA` names, else in `../shared/data` beside the repository.

use std::io::Write;
use std::path::{Path, PathBuf};

/// The directory of the reference set; `None`, said aloud, if it is not there. `workspace` is the root of the repository.
pub fn reference_set(workspace: &Path) -> Option<PathBuf> {
    let beside = || workspace.join("../shared/data");
    let directory = std::env::var_os("IHEARTMESH_DATA").map_or_else(beside, PathBuf::from);
    if directory.join("ref").is_dir() {
        return Some(directory);
    }
    assert!(
        std::env::var_os("IHEARTMESH_DATA").is_none(),
        "IHEARTMESH_DATA: {} has no ref/",
        directory.display()
    );
    // Not `eprintln!`, which the test harness keeps to itself when a test passes.
    let _ = writeln!(
        std::io::stderr(),
        "SKIPPED: no reference data in {}; set IHEARTMESH_DATA",
        directory.display()
    );
    None
}
