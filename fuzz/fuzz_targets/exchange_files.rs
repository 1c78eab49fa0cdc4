//! Any bytes as a file of MEDIT, Gmsh, STL, VTK or glTF: a mesh or an error; what was read can be written and read again.

#![no_main]

use iheartmesh_runtime::glam::DVec3;
use iheartmesh_runtime::io::{self, MeshFile};
use libfuzzer_sys::fuzz_target;

/// Reads, writes and reads again in every format that can hold the values.
fn check(file: &MeshFile) {
    let _ = (file.face_mesh(), file.edge_mesh());
    if let Ok(mesh) = file.cell_mesh() {
        let again = MeshFile::of_cells(file.positions.clone(), &mesh).cell_mesh();
        let again = again.expect("the cells of a mesh are a mesh");
        assert_eq!(again.boundary(3), mesh.boundary(3));
    }
    for path in ["again.mesh", "again.msh", "again.vtk", "again.stl", "again.glb"] {
        let Ok(written) = io::file_to_bytes(path, file) else {
            continue;
        };
        let again = io::from_bytes(path, &written).expect("what is written can be read");
        assert_eq!(again.polygons.len(), file.polygons.len(), "{path}");
        // single precision rounds, and merges what is equal then
        if path == "again.stl" {
            continue;
        }
        // MEDIT has a list for each kind
        if path != "again.mesh" {
            assert_eq!(again.polygons, file.polygons, "{path}");
        }
        assert_eq!(again.edges, file.edges, "{path}");
        assert_eq!(again.tetrahedra, file.tetrahedra, "{path}");
        assert_eq!(again.hexahedra, file.hexahedra, "{path}");
        assert_eq!(again.polyhedra.len(), file.polyhedra.len(), "{path}");
        if path == "again.vtk" {
            assert_eq!(again.polyhedra, file.polyhedra);
        }
        if path != "again.glb" {
            let bits = |position: &DVec3| position.to_array().map(f64::to_bits);
            let positions = again.positions.iter().map(bits);
            assert!(positions.eq(file.positions.iter().map(bits)), "{path}");
        }
    }
    let mut merged = file.clone();
    merged.merge_equal_positions();
    assert!(merged.positions.len() <= file.positions.len());
}

fuzz_target!(|bytes: &[u8]| {
    for path in ["fuzz.mesh", "fuzz.msh", "fuzz.stl", "fuzz.vtk", "fuzz.gltf"] {
        match io::from_bytes(path, bytes) {
            Ok(file) => check(&file),
            Err(error) => drop(error.to_string()),
        }
    }
});
