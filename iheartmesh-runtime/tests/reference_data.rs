//! Real meshes against counts and matrices that other libraries computed.
//!
//! The meshes in `meshes/` are always tested, the others where the reference set is.
#![cfg(feature = "io")]

#[path = "../../tests/support/reference_set.rs"]
mod locate;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use iheartmesh_runtime::io::{self, MeshFile};
use iheartmesh_runtime::{BoundaryMatrix, EdgeMesh, FaceMesh, Vertex};

fn reference_set() -> Option<PathBuf> {
    locate::reference_set(&Path::new(env!("CARGO_MANIFEST_DIR")).join(".."))
}

fn repository_mesh(name: &str) -> MeshFile {
    io::read(
        Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../meshes")
            .join(name),
    )
    .unwrap()
}

/// A value of a flat JSON object, as text.
fn field<'a>(json: &'a str, name: &str) -> &'a str {
    let (_, rest) = json
        .split_once(&format!("\"{name}\":"))
        .unwrap_or_else(|| panic!("no field {name}"));
    rest.trim_start()
        .split([',', '\n', '}'])
        .next()
        .unwrap()
        .trim()
        .trim_matches('"')
}

fn number(json: &str, name: &str) -> i64 {
    field(json, name).parse().unwrap()
}

/// Row, column (from 0) and value of each entry of a Matrix Market file, and the shape.
fn matrix_market(text: &str) -> ((usize, usize), BTreeMap<(usize, usize), i8>) {
    let mut lines = text
        .lines()
        .filter(|line| !line.starts_with('%'))
        .map(|line| {
            let values: Vec<i64> = line
                .split_whitespace()
                .map(|token| token.parse().unwrap())
                .collect();
            <[i64; 3]>::try_from(values).unwrap()
        });
    let [rows, columns, n_entries] = lines.next().unwrap();
    let entries: BTreeMap<_, _> = lines
        .map(|[row, column, value]| ((row as usize - 1, column as usize - 1), value as i8))
        .collect();
    assert_eq!(entries.len() as i64, n_entries);
    ((rows as usize, columns as usize), entries)
}

fn check_matrix(matrix: &BoundaryMatrix, path: &Path) {
    let Ok(text) = fs::read_to_string(path) else {
        return;
    };
    let (shape, expected) = matrix_market(&text);
    assert_eq!(matrix.shape(), shape, "{}", path.display());
    let entries: BTreeMap<_, _> = matrix
        .iter()
        .map(|(&value, (row, column))| ((row as usize, column as usize), value))
        .collect();
    assert_eq!(entries, expected, "{}", path.display());
}

/// Everything that `topology.json` says of a mesh. `n_dropped` faces of the file are not in it.
fn check_topology(mesh: &FaceMesh, n_dropped: i64, json: &str) {
    let is = |name: &str, value: usize| assert_eq!(value as i64, number(json, name), "{name}");
    is("V", mesh.n_vertices());
    is("E", mesh.n_edges());
    is("F", mesh.n_faces() + n_dropped as usize);
    assert_eq!(mesh.euler_characteristic() + n_dropped, number(json, "chi"));
    is("isolated_vertices", mesh.isolated_vertices().len());
    is(
        "components_of_referenced",
        mesh.n_components() - mesh.isolated_vertices().len(),
    );
    is("boundary_edges", mesh.boundary_edges().len());
    is("nonmanifold_edges", mesh.non_manifold_edges().len());
    is(
        "interior_edges",
        mesh.edges()
            .filter(|&edge| mesh.edge_faces(edge).len() == 2)
            .count(),
    );
    is("nnz_d1", mesh.boundary(1).nnz());
    is("nnz_d2", mesh.boundary(2).nnz());
    assert_eq!(mesh.is_closed(), number(json, "boundary_edges") == 0);
    if n_dropped == 0 {
        assert_eq!(
            mesh.is_consistently_oriented(),
            field(json, "consistently_oriented") == "true"
        );
    }
    let mut degrees: BTreeMap<usize, i64> = BTreeMap::new();
    for face in mesh.faces() {
        *degrees.entry(mesh.face_vertices(face).len()).or_default() += 1;
    }
    assert_eq!(
        mesh.is_triangle_mesh(),
        degrees.keys().all(|&degree| degree == 3)
    );
    if n_dropped == 0 {
        degrees
            .iter()
            .for_each(|(degree, &count)| assert_eq!(count, number(json, &degree.to_string())));
    }
}

#[test]
fn surfaces_of_the_reference_set() {
    let Some(directory) = reference_set() else {
        return;
    };
    let mut n_checked = 0;
    for entry in fs::read_dir(directory.join("meshes")).unwrap() {
        let path = entry.unwrap().path();
        let is_surface = ["obj", "off", "ply"].contains(
            &path
                .extension()
                .unwrap_or_default()
                .to_string_lossy()
                .as_ref(),
        );
        let reference = directory.join("ref").join(path.file_stem().unwrap());
        let Ok(json) = fs::read_to_string(reference.join("topology.json")) else {
            continue;
        };
        if !is_surface {
            continue;
        }
        println!("{}", path.display());
        let file = io::read(&path).unwrap();
        if number(&json, "degenerate_faces") > 0 {
            // Checked in a test of its own.
            continue;
        }
        let mesh = file.face_mesh().unwrap();
        check_topology(&mesh, 0, &json);
        check_matrix(mesh.boundary(1), &reference.join("d1.mtx"));
        check_matrix(mesh.boundary(2), &reference.join("d2.mtx"));
        if let Ok(text) = fs::read_to_string(reference.join("edges.csv")) {
            let edges: Vec<String> = mesh
                .edges()
                .map(|edge| {
                    let [tail, head] = mesh.edge_vertices(edge).map(Vertex::id);
                    format!("{tail},{head}")
                })
                .collect();
            assert_eq!(text.lines().skip(1).collect::<Vec<_>>(), edges);
        }
        let again = FaceMesh::from_boundary_matrices(mesh.boundary(1), mesh.boundary(2)).unwrap();
        assert_eq!(again.boundary_transpose(2), mesh.boundary_transpose(2));
        n_checked += 1;
    }
    assert!(
        n_checked >= 20,
        "only {n_checked} surfaces in {}",
        directory.display()
    );
}

#[test]
fn orientability_of_the_reference_set() {
    let Some(directory) = reference_set() else {
        return;
    };
    let is_orientable = |name| {
        io::read(directory.join("meshes").join(name))
            .unwrap()
            .face_mesh()
            .unwrap()
            .is_orientable()
    };
    assert!(
        !is_orientable("mobius_tri.obj")
            && !is_orientable("rp2_6.obj")
            && !is_orientable("fan3.obj")
    );
    assert!(
        is_orientable("double_torus.obj")
            && is_orientable("bunny_holes.off")
            && is_orientable("spot_control.obj")
    );
}

#[test]
fn a_degenerate_face_is_a_clear_error() {
    let Some(directory) = reference_set() else {
        return;
    };
    let mut file = io::read(directory.join("meshes/bad_dup_isolated.obj")).unwrap();
    assert_eq!(
        file.face_mesh().unwrap_err().to_string(),
        "face 500 is degenerate: vertex 3 stands in it more than once; remove the face or the repeated corner"
    );
    // All else in this file is legal: a repeated face, isolated vertices, edges with three faces.
    file.polygons = file
        .polygons
        .iter()
        .filter(|corners| *corners != [3, 3, 5])
        .collect();
    let json = fs::read_to_string(directory.join("ref/bad_dup_isolated/topology.json")).unwrap();
    check_topology(&file.face_mesh().unwrap(), 1, &json);
}

#[test]
fn the_same_mesh_in_several_formats() {
    let Some(directory) = reference_set() else {
        return;
    };
    let read = |name: &str| io::read(directory.join("meshes").join(name)).unwrap();
    assert_eq!(read("bob_small.obj"), read("bob_small.ply"));
    assert_eq!(read("bob_small.off"), read("bob_small.ply"));
    assert_eq!(read("fox.obj"), read("fox.ply"));
    assert_eq!(read("sphere_small.obj"), read("sphere_small.ply"));

    // Texture coordinates in the faces are skipped; the positions are rounded to single precision.
    let (obj, ply) = (read("spot_tri.obj"), read("spot.ply"));
    assert_eq!(obj.polygons, ply.polygons);
    for (exact, rounded) in obj.positions.iter().zip(&ply.positions) {
        assert_eq!(exact.as_vec3().as_dvec3(), *rounded);
    }
    // A point cloud in a text file, and the same numbers as plain text.
    let points = read("spot_noisy_points.ply");
    assert!(points.polygons.is_empty());
    let text = fs::read_to_string(directory.join("meshes/spot_noisy_points.xyz")).unwrap();
    for (position, line) in points.positions.iter().zip(text.lines()) {
        let expected: Vec<f64> = line
            .split_whitespace()
            .take(3)
            .map(|token| token.parse().unwrap())
            .collect();
        assert_eq!(position.to_array(), expected[..]);
    }
}

#[test]
fn meshes_of_this_repository() {
    let expected = [
        ("bob_small.ply", 250, 750, 500, 0),
        ("fox.ply", 313, 933, 622, 2),
        ("sphere_small.ply", 162, 480, 320, 2),
        ("spot.ply", 2930, 8784, 5856, 2),
    ];
    for (name, n_vertices, n_edges, n_faces, characteristic) in expected {
        let file = repository_mesh(name);
        let mesh = file.face_mesh().unwrap();
        assert_eq!(
            (mesh.n_vertices(), mesh.n_edges(), mesh.n_faces()),
            (n_vertices, n_edges, n_faces),
            "{name}"
        );
        assert_eq!(mesh.euler_characteristic(), characteristic, "{name}");
        assert!(
            mesh.is_closed() && mesh.is_consistently_oriented() && mesh.is_triangle_mesh(),
            "{name}"
        );
        assert_eq!(mesh.n_components(), 1, "{name}");
        // Counterclockwise from outside: the volume is positive.
        let corner = |face, i| file.positions[mesh.face_vertices(face).get(i).unwrap().index()];
        let volume: f64 = mesh
            .faces()
            .map(|f| corner(f, 0).dot(corner(f, 1).cross(corner(f, 2))) / 6.0)
            .sum();
        assert!(volume > 0.0, "{name}");
    }
}

/// Neighbours of points, against graphs that other libraries computed.
#[test]
fn point_clouds_of_the_reference_set() {
    let Some(directory) = reference_set() else {
        return;
    };
    let file = io::read(directory.join("meshes/spot_noisy_points.ply")).unwrap();
    let reference = directory.join("ref/spot_noisy_points");
    let summary = fs::read_to_string(reference.join("summary.json")).unwrap();
    let radius: f64 = field(&summary, "r").parse().unwrap();
    for (name, mesh) in [
        ("knn6", EdgeMesh::from_k_nearest(&file.positions, 6)),
        ("knn10", EdgeMesh::from_k_nearest(&file.positions, 10)),
        ("radius", EdgeMesh::from_radius(&file.positions, radius)),
    ] {
        let mesh = mesh.unwrap();
        let text = fs::read_to_string(reference.join(format!("{name}_edges.csv"))).unwrap();
        let edges = mesh.edges().map(|edge| {
            let [tail, head] = mesh.edge_vertices(edge).map(Vertex::id);
            format!("{tail},{head}")
        });
        let mut expected: Vec<&str> = text.lines().skip(1).collect();
        expected.sort_by_key(|line| -> Vec<u32> {
            line.split(',').map(|id| id.parse().unwrap()).collect()
        });
        assert_eq!(edges.collect::<Vec<_>>(), expected, "{name}");
    }
}
