//! STL, Gmsh, VTK and glTF: what is written is read again, what other programs write is understood, and the meshes of the
//! reference set are the same in every format.
#![cfg(feature = "io")]

#[path = "../../tests/support/reference_set.rs"]
mod locate;

use std::path::Path;

use iheartmesh_runtime::ElementKind::Face;
use iheartmesh_runtime::FaceMesh;
use iheartmesh_runtime::glam::DVec3;
use iheartmesh_runtime::io::{self, Attributes, MeshFile};

fn read(name: &str, contents: impl AsRef<[u8]>) -> MeshFile {
    io::from_bytes(name, contents.as_ref()).unwrap_or_else(|error| panic!("{error}"))
}

fn repository_mesh(name: &str) -> MeshFile {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../meshes");
    io::read(folder.join(name)).unwrap_or_else(|error| panic!("{error}"))
}

/// Positions that single precision holds.
fn positions() -> Vec<DVec3> {
    [
        [0.0, 0.5, -1.25],
        [1267650600228229401496703205376.0, -0.0, 3.0],
        [2.0, 7.0, 0.0009765625],
        [-8.0, 0.125, 0.25],
        [1.0, 1.0, 1.0],
        [2.0, 2.0, 2.5],
        [3.0, 3.0, 9.0],
        [4.0, 4.0, 4.0],
        [5.0, 5.0, 5.5],
    ]
    .map(DVec3::from)
    .to_vec()
}

/// One or two elements of each kind, with values on all kinds.
fn everything() -> MeshFile {
    let mut file = MeshFile::of_positions(positions());
    // numbers that do not survive any rounding
    file.positions[4] = DVec3::new(0.1, -1.0 / 3.0, 1e-300);
    file.edges.extend([[3, 1], [1, 0]]);
    file.polygons.push(&[0, 1, 2]);
    file.polygons.push(&[5, 1, 2, 8]);
    file.tetrahedra.push([0, 3, 2, 1]);
    file.hexahedra.extend([[0, 1, 2, 3, 4, 5, 6, 7]; 2]);
    file.polyhedra.push_pyramid([8, 7, 6, 5, 4]);
    file.polyhedra.push_prism([0, 2, 4, 6, 8, 1]);
    file.attributes = Attributes::new()
        .vertex_scalar(
            "heat",
            (0..9).map(|k| f64::from(k) / 7.0).collect::<Vec<_>>(),
        )
        .vertex_vector("normal", positions())
        .edge_scalar("length", [0.1, f64::NAN])
        .face_scalar("area", [0.5, 2.0 / 3.0])
        .face_vector("flow", [DVec3::X, DVec3::new(0.1, 0.2, 0.3)])
        .cell_scalar("area", [4.0, 3.0, 2.0, 1.0, f64::INFINITY])
        .cell_scalar("volume", [1.0 / 6.0, 1.0, 2.0, 0.1, 0.3])
        .cell_vector(
            "drift",
            [DVec3::Y, DVec3::Z, DVec3::ONE, DVec3::X, DVec3::ZERO],
        );
    file
}

/// The same values in the same order of elements, whatever the order of the attributes. NaN equals NaN.
fn assert_same(read: &MeshFile, written: &MeshFile) {
    let shown = |file: &MeshFile| {
        let mut attributes: Vec<String> = file
            .attributes
            .iter()
            .map(|all| format!("{all:?}"))
            .collect();
        attributes.sort();
        attributes
    };
    assert_eq!(read.positions, written.positions);
    assert_eq!(read.edges, written.edges);
    assert_eq!(read.polygons, written.polygons);
    assert_eq!(read.tetrahedra, written.tetrahedra);
    assert_eq!(read.hexahedra, written.hexahedra);
    assert_eq!(read.polyhedra, written.polyhedra);
    assert_eq!(shown(read), shown(written));
}

#[test]
fn vtk_and_gmsh_give_back_what_was_written() {
    for name in ["a.vtk", "a.MSH"] {
        let written = everything();
        let bytes = io::file_to_bytes(name, &written).unwrap();
        assert_same(&read(name, bytes), &written);
    }
    let mut colored = everything();
    colored.attributes = Attributes::new()
        .vertex_colors([[1, 2, 255]; 9])
        .face_colors([[0, 128, 7], [128; 3]]);
    let bytes = io::file_to_bytes("a.vtk", &colored).unwrap();
    assert_same(&read("a.vtk", bytes), &colored);
    let error = io::file_to_bytes("a.msh", &colored).unwrap_err();
    assert_eq!(
        error.to_string(),
        "a.msh: a Gmsh file cannot hold colours of each vertex; write a .ply or .vtk file"
    );
    // as a mesh of faces, with polygons of any size
    let faces: Vec<Vec<u32>> = vec![vec![0, 1, 2, 3, 4], vec![2, 1, 5]];
    let mesh = FaceMesh::from_polygons(9, &faces).unwrap();
    let bytes = io::to_bytes("a.vtk", &positions(), &mesh, &Attributes::new()).unwrap();
    assert_eq!(read("a.vtk", bytes).polygons, faces.into_iter().collect());
    let error = io::to_bytes("a.msh", &positions(), &mesh, &Attributes::new()).unwrap_err();
    assert!(
        error.to_string().contains("a face with 5 corners"),
        "{error}"
    );
}

#[test]
fn meshes_without_vertices() {
    let mut names = vec![
        "a.obj", "a.off", "a.ply", "a.stl", "a.mesh", "a.msh", "a.vtk",
    ];
    if cfg!(feature = "gltf") {
        names.extend(["a.gltf", "a.glb"]);
    }
    for name in names {
        let bytes = io::file_to_bytes(name, &MeshFile::default()).unwrap();
        assert_eq!(read(name, bytes), MeshFile::default(), "{name}");
        // nothing at all is no mesh
        for nothing in ["", " ", "\n\n"] {
            let error = io::from_bytes(name, nothing.as_bytes()).expect_err(name);
            assert!(matches!(error, io::IoError::Malformed { .. }), "{error}");
        }
    }
    for commented in ["# a comment\n", "\ng nothing\n"] {
        assert_eq!(read("a.obj", commented), MeshFile::default());
    }
}

#[test]
fn stl_files() {
    let triangles = [[0, 1, 2], [2, 1, 3], [3, 1, 0]];
    let positions = &positions()[..4];
    let normals = [DVec3::X, DVec3::new(0.0, 0.0, -1.0), DVec3::Y];
    let attributes = Attributes::new().face_vector("normal", normals);
    let bytes = io::to_bytes("a.stl", positions, &triangles[..], &attributes).unwrap();
    assert_eq!(bytes.len(), 84 + 3 * 50);
    let file = read("a.stl", &bytes);
    assert_eq!(file.positions, positions);
    assert_eq!(file.polygons.as_triangles(), Some(&triangles[..]));
    assert_eq!(file.attributes, attributes);
    // the title of a binary file may begin like a text
    let mut titled = bytes.clone();
    titled[..6].copy_from_slice(b"solid ");
    assert_eq!(read("a.stl", &titled), file);
    // normals are computed where there are none
    let bytes = io::to_bytes(
        "a.stl",
        &[DVec3::ZERO, DVec3::X, DVec3::Y],
        &[[0, 1, 2]][..],
        &Attributes::new(),
    );
    let plane = read("a.stl", bytes.unwrap());
    assert_eq!(
        plane.attributes.vector(Face, "normal"),
        Some(&[DVec3::Z][..])
    );

    // several solids, no name, no normals, blank lines and lines of Windows
    let facet = |x: &str| {
        format!(
            "facet normal 0 0 0\r\n outer loop\n vertex {x} 0 -0\nvertex 1 0 0\n\n vertex 0 1e0 0.\nendloop\nendfacet\n"
        )
    };
    let text = format!(
        "\n\nsolid\n{}endsolid\n\nsolid a b c\n{}endsolid a",
        facet("0"),
        facet("0.5")
    );
    let file = read("a.stl", text);
    assert_eq!(
        file.positions,
        [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::new(0.5, 0.0, 0.0)]
    );
    assert_eq!(
        file.polygons.as_triangles(),
        Some(&[[0, 1, 2], [3, 1, 2]][..])
    );
    assert_eq!(file.attributes, Attributes::new());

    let [text, binary] = ["stl_box_ascii.stl", "stl_box_binary.stl"].map(repository_mesh);
    let mesh = text.face_mesh().unwrap();
    assert_eq!(
        (mesh.n_vertices(), mesh.n_edges(), mesh.n_faces()),
        (8, 18, 12)
    );
    assert!(mesh.is_closed() && mesh.is_consistently_oriented());
    assert_eq!(text, binary);
}

#[test]
fn what_stl_cannot_hold_is_not_written() {
    let message = |positions: &[DVec3], faces: &[Vec<u32>], attributes: Attributes| {
        let faces: io::Polygons = faces.iter().collect();
        let error = io::to_bytes("a.stl", positions, &faces, &attributes);
        error.unwrap_err().to_string()
    };
    let [all, none] = [positions(), Vec::new()];
    assert_eq!(
        message(&all[..4], &[vec![0, 1, 2, 3]], Attributes::new()),
        "a.stl: an STL file cannot hold a face with 4 corners; divide the faces into triangles, or write a .ply file"
    );
    assert_eq!(
        message(&all[..4], &[vec![0, 1, 2]], Attributes::new()),
        "a.stl: vertex 3 is in no face, and an STL file has faces only; leave it out, or write a .ply file"
    );
    assert_eq!(
        message(&[DVec3::splat(1e39)], &[vec![0, 0, 0]], Attributes::new()),
        "a.stl: the position of vertex 0 is beyond single precision; scale the positions, or write a .ply file"
    );
    assert_eq!(
        message(&none, &[], Attributes::new().face_scalar("area", [])),
        "a.stl: an STL file cannot hold the face attribute `area`; write a .ply file"
    );
}

#[test]
fn gmsh_files_of_both_versions_are_the_mesh_of_medit() {
    let mut names = vec!["two_tets_fig3.msh", "two_tets_fig3_v41.msh"];
    for name in names.drain(..) {
        let file = repository_mesh(name);
        assert_eq!(file.tetrahedra, [[0, 1, 2, 3], [1, 2, 3, 4]], "{name}");
        assert_eq!(file.positions[4], DVec3::new(1.2, 1.1, 0.9), "{name}");
    }
    let Some(directory) = locate::reference_set(&Path::new(env!("CARGO_MANIFEST_DIR")).join(".."))
    else {
        return;
    };
    let reference = |name: &str| io::read(directory.join("meshes").join(name)).unwrap();
    for name in ["two_tets_fig3", "kuhn_cube3"] {
        assert_same(
            &reference(&format!("{name}.msh")),
            &reference(&format!("{name}.mesh")),
        );
    }
    assert_same(
        &reference("two_tets_fig3_v41.msh"),
        &reference("two_tets_fig3.mesh"),
    );
    let file = reference("bar2k.msh");
    let numbers = |name: &str| -> Vec<f64> {
        let text = std::fs::read_to_string(directory.join("meshes").join(name)).unwrap();
        let lines = text.lines().skip(1);
        let rows = lines.filter(|line| !line.trim_start().starts_with('#'));
        rows.flat_map(|line| {
            line.split_whitespace()
                .skip(1)
                .map(|word| word.parse::<f64>().unwrap())
        })
        .collect()
    };
    let positions: Vec<f64> = file.positions.iter().flat_map(|x| x.to_array()).collect();
    assert_eq!(positions, numbers("bar2k.node"));
    let corners: Vec<f64> = file
        .tetrahedra
        .iter()
        .flatten()
        .map(|&v| f64::from(v))
        .collect();
    assert_eq!(corners, numbers("bar2k.ele"));
    let mesh = file.cell_mesh().unwrap();
    assert_eq!(
        (mesh.n_edges(), mesh.n_faces(), mesh.euler_characteristic()),
        (1987, 2700, 1)
    );
}

#[test]
fn surfaces_are_the_same_in_every_format() {
    let fox = repository_mesh("fox.ply");
    let mesh = fox.face_mesh().unwrap();
    for name in ["a.obj", "a.off", "a.ply", "a.mesh", "a.msh", "a.vtk"] {
        let bytes = io::to_bytes(name, &fox.positions, &mesh, &Attributes::new()).unwrap();
        let file = read(name, bytes);
        assert_eq!(
            (&file.positions, &file.polygons),
            (&fox.positions, &fox.polygons),
            "{name}"
        );
    }
    // positions in single precision survive, vertices are numbered anew
    let bytes = io::to_bytes("a.stl", &fox.positions, &mesh, &Attributes::new()).unwrap();
    let file = read("a.stl", bytes);
    let corners = |file: &MeshFile| -> Vec<DVec3> {
        file.polygons
            .corners()
            .iter()
            .map(|&v| file.positions[v as usize])
            .collect()
    };
    assert_eq!(corners(&file), corners(&fox));
    assert_eq!(file.face_mesh().unwrap().n_edges(), mesh.n_edges());
}

#[cfg(not(feature = "gltf"))]
#[test]
fn gltf_needs_a_feature() {
    assert_eq!(
        io::from_bytes("a.glb", b"").unwrap_err().to_string(),
        "a.glb: this format needs the feature `gltf` of iheartmesh; add it in Cargo.toml"
    );
}
