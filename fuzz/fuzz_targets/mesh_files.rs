//! Any bytes as a mesh file: a mesh or an error; what was read can be written and read again.

#![no_main]

use iheartmesh_runtime::glam::DVec3;
use iheartmesh_runtime::io::{self, MeshFile};
use libfuzzer_sys::fuzz_target;

/// Reads, writes and reads again in every format that can hold the values.
fn check(file: &MeshFile) {
    let _ = file.face_mesh();
    for path in ["again.obj", "again.off", "again.ply"] {
        let Ok(written) = io::to_bytes(path, &file.positions, &file.polygons, &file.attributes)
        else {
            continue;
        };
        let again = io::from_bytes(path, &written).expect("what is written can be read");
        let bits = |position: &DVec3| position.to_array().map(f64::to_bits);
        let positions = again.positions.iter().map(bits);
        assert!(positions.eq(file.positions.iter().map(bits)), "{path}");
        assert_eq!(again.polygons, file.polygons, "{path}");
    }
}

fuzz_target!(|bytes: &[u8]| {
    for path in ["fuzz.obj", "fuzz.off", "fuzz.ply"] {
        if let Ok(file) = io::from_bytes(path, bytes) {
            check(&file);
        }
    }
});
