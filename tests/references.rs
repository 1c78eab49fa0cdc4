//! Programs as papers print them, against values that other libraries computed for real meshes.
//!
//! Every field is computed in four ways: as a whole and element by element, with all optimisations and with none.

#[allow(dead_code)]
mod support;

use iheartmesh::glam::DVec3;
use iheartmesh::{Edge, Face, FaceMesh, Vertex};

use support::reference_mesh::Tolerance::{self, Absolute, Relative};
use support::reference_mesh::{ReferenceMesh, components};

both_ways! {
    Gaussian, PlainGaussian = "tests/programs/gaussian_curvature.hlang";
    BoundaryCurvature, PlainBoundaryCurvature = "tests/programs/boundary_curvature.hlang";
    PaperMean, PlainPaperMean = "tests/programs/mean_curvature.hlang";
    Dihedral, PlainDihedral = "tests/programs/dihedral.hlang";
    Normals, PlainNormals = "tests/programs/vertex_normals.hlang";
    MaxNormals, PlainMaxNormals = "tests/programs/max_normals.hlang";
    Areas, PlainAreas = "tests/programs/vertex_areas.hlang";
    CurvatureNormals, PlainCurvatureNormals = "tests/programs/curvature_normals.hlang";
    Faces, PlainFaces = "tests/programs/faces.hlang";
    Polygons, PlainPolygons = "tests/programs/polygons.hlang";
}

const TRIANGLE_MESHES: [&str; 10] = [
    "bob_small.obj",
    "bunny_holes.off",
    "cat_head.obj",
    "cowhead.obj",
    "cube.obj",
    "double_torus.obj",
    "fox.obj",
    "octa.off",
    "sphere_small.obj",
    "spot_tri.obj",
];

const POLYGON_MESHES: [&str; 5] = [
    "dodecahedron_poly.obj",
    "platonic_shelf.obj",
    "spot_control.obj",
    "spot_control_dual.obj",
    "spot_quad.obj",
];

fn meshes(files: &'static [&'static str]) -> impl Iterator<Item = ReferenceMesh> {
    let set = support::reference_set();
    files
        .iter()
        .filter_map(move |file| Some(ReferenceMesh::read(set.as_ref()?, file)))
}

/// A field on vertices, against its column and its checksum.
fn check(mesh: &ReferenceMesh, name: &str, values: Vec<f64>, tolerance: Tolerance) {
    let values = [values];
    mesh.check_table("vertex.csv", &[name], &values, tolerance);
    mesh.check_sums(name, &values, tolerance);
}

/// A field of vectors on vertices, against its columns and their checksums.
fn check_vectors(mesh: &ReferenceMesh, name: &str, vectors: &[DVec3], tolerance: Tolerance) {
    let names = ["x", "y", "z"].map(|axis| format!("{name}_{axis}"));
    let columns = components(vectors);
    mesh.check_table(
        "vertex.csv",
        &names.each_ref().map(String::as_str),
        &columns,
        tolerance,
    );
    let bound = match tolerance {
        Relative(part) => Absolute(
            part * vectors
                .iter()
                .fold(0.0, |m: f64, v| m.max(v.abs().max_element())),
        ),
        absolute => absolute,
    };
    for (name, column) in names.iter().zip(columns) {
        mesh.check_sums(name, &[column], bound);
    }
}

#[test]
fn gaussian_curvature() {
    for mesh in meshes(&TRIANGLE_MESHES) {
        let x = &mesh.positions;
        let (a, b) = (
            Gaussian::new(&mesh.mesh, x).unwrap(),
            PlainGaussian::new(&mesh.mesh, x).unwrap(),
        );
        check(
            &mesh,
            "K_2pi",
            field!(a, b, mesh.mesh.vertices(), K, K_all),
            Absolute(1e-9),
        );

        let a = BoundaryCurvature::new(&mesh.mesh, x).unwrap();
        let b = PlainBoundaryCurvature::new(&mesh.mesh, x).unwrap();
        let curvature = field!(a, b, mesh.mesh.vertices(), K, K_all);
        let turning = std::f64::consts::TAU * mesh.mesh.euler_characteristic() as f64;
        assert!((curvature.iter().sum::<f64>() - turning).abs() < 1e-9 * x.len() as f64);
        check(&mesh, "K_pi", curvature, Absolute(1e-9));
        check(
            &mesh,
            "K_gc0",
            field!(a, b, mesh.mesh.vertices(), K0, K0_all),
            Absolute(1e-9),
        );
    }
}

#[test]
fn mean_curvature() {
    for mesh in meshes(&TRIANGLE_MESHES) {
        let x = &mesh.positions;
        let (a, b) = (
            Dihedral::new(&mesh.mesh, x).unwrap(),
            PlainDihedral::new(&mesh.mesh, x).unwrap(),
        );
        check(
            &mesh,
            "H_dihedral",
            field!(a, b, mesh.mesh.vertices(), H, H_all),
            Relative(1e-10),
        );
        let lengths = [field!(a, b, mesh.mesh.edges(), l, l_all)];
        mesh.check_table("edge.csv", &["length"], &lengths, Relative(1e-10));
        mesh.check_sums("edge_length(lexicographic i<j)", &lengths, Relative(1e-10));
        let angles = [field!(a, b, mesh.mesh.edges(), phi, phi_all)];
        mesh.check_table("edge.csv", &["dihedral"], &angles, Relative(1e-10));
        mesh.check_sums("edge_dihedral(lexicographic)", &angles, Relative(1e-10));

        let (a, b) = (
            PaperMean::new(&mesh.mesh, x).unwrap(),
            PlainPaperMean::new(&mesh.mesh, x).unwrap(),
        );
        if mesh.mesh.is_closed() {
            check(
                &mesh,
                "H_dihedral",
                field!(a, b, mesh.mesh.vertices(), H, H_all),
                Relative(1e-10),
            );
            continue;
        }
        // the formula of the paper has no value at a boundary edge; elsewhere it has
        let reference = Dihedral::new(&mesh.mesh, x).unwrap().H_all();
        let boundary = mesh.mesh.boundary_vertices();
        for v in mesh.mesh.vertices() {
            let (x, y) = (a.try_H(v), b.try_H(v));
            if boundary.contains(&v) {
                assert_eq!(x.unwrap_err().to_string(), no_opposite_face(&mesh.mesh, v));
                assert_eq!(y.unwrap_err().to_string(), no_opposite_face(&mesh.mesh, v));
            } else {
                assert!((x.unwrap() - reference[v.index()]).abs() < 1e-12);
                assert!((y.unwrap() - reference[v.index()]).abs() < 1e-12);
            }
        }
        let first = *boundary.get(0).unwrap();
        let (x, y) = (a.try_H_all().unwrap_err(), b.try_H_all().unwrap_err());
        assert_eq!(x.to_string(), no_opposite_face(&mesh.mesh, first));
        assert_eq!(y.to_string(), no_opposite_face(&mesh.mesh, first));
    }
}

/// What the paper's mean curvature says where an edge has no two faces: at the first neighbour across a boundary edge, the
/// face that runs from `v` to it is missing, or the other one.
fn no_opposite_face(mesh: &FaceMesh, v: Vertex) -> String {
    let is_boundary = |e: &Edge| mesh.edge_faces(*e).len() == 1;
    let edge = mesh.vertex_edges(v).iter().find(is_boundary).unwrap();
    let face = mesh.edge_faces(edge).get(0).unwrap();
    let (edges, signs) = mesh.face_boundary(face);
    let along = signs[edges.iter().position(|e| e == edge).unwrap()] == 1;
    let leaves = along == (mesh.edge_vertices(edge)[0] == v);
    let (name, column) = if leaves { ("h", 42) } else { ("g", 37) };
    format!(
        "`H({v})` has no value: the set has no member 1 in `{name}_1` (tests/programs/mean_curvature.hlang:22:{column})"
    )
}

#[test]
fn normals() {
    for mesh in meshes(&TRIANGLE_MESHES) {
        let x = &mesh.positions;
        let (a, b) = (
            Normals::new(&mesh.mesh, x).unwrap(),
            PlainNormals::new(&mesh.mesh, x).unwrap(),
        );
        check_vectors(
            &mesh,
            "N_area",
            &field!(a, b, mesh.mesh.vertices(), A, A_all),
            Relative(1e-10),
        );
        check_vectors(
            &mesh,
            "N_angle",
            &field!(a, b, mesh.mesh.vertices(), B, B_all),
            Relative(1e-8),
        );
        check_vectors(
            &mesh,
            "N_max",
            &field!(a, b, mesh.mesh.vertices(), N, N_all),
            Relative(1e-10),
        );
    }
    for mesh in meshes(&TRIANGLE_MESHES).chain(meshes(&POLYGON_MESHES)) {
        let x = &mesh.positions;
        let (a, b) = (
            MaxNormals::new(&mesh.mesh, x).unwrap(),
            PlainMaxNormals::new(&mesh.mesh, x).unwrap(),
        );
        check_vectors(
            &mesh,
            "N_max",
            &field!(a, b, mesh.mesh.vertices(), N, N_all),
            Relative(1e-10),
        );
        check_vectors(
            &mesh,
            "Nmax_raw",
            &field!(a, b, mesh.mesh.vertices(), n, n_all),
            Relative(1e-10),
        );
    }
}

#[test]
fn areas_and_cotangents() {
    for mesh in meshes(&TRIANGLE_MESHES) {
        let x = &mesh.positions;
        let (a, b) = (
            Areas::new(&mesh.mesh, x).unwrap(),
            PlainAreas::new(&mesh.mesh, x).unwrap(),
        );
        check(
            &mesh,
            "A_bary",
            field!(a, b, mesh.mesh.vertices(), A_bary, A_bary_all),
            Relative(1e-11),
        );
        check(
            &mesh,
            "A_mixed",
            field!(a, b, mesh.mesh.vertices(), A, A_all),
            Relative(1e-10),
        );
        check(
            &mesh,
            "K_meyer",
            field!(a, b, mesh.mesh.vertices(), K, K_all),
            Relative(1e-9),
        );
        check(
            &mesh,
            "H_meyer",
            field!(a, b, mesh.mesh.vertices(), H, H_all),
            Relative(1e-9),
        );
        check_vectors(
            &mesh,
            "HN",
            &field!(a, b, mesh.mesh.vertices(), HN, HN_all),
            Relative(1e-9),
        );

        let a = CurvatureNormals::new(&mesh.mesh, x).unwrap();
        let b = PlainCurvatureNormals::new(&mesh.mesh, x).unwrap();
        check_vectors(
            &mesh,
            "KN",
            &field!(a, b, mesh.mesh.vertices(), KN, KN_all),
            Relative(1e-10),
        );
        check_vectors(
            &mesh,
            "HN",
            &field!(a, b, mesh.mesh.vertices(), HN, HN_all),
            Relative(1e-9),
        );
        let weights = [field!(a, b, mesh.mesh.edges(), w, w_all)];
        mesh.check_table("edge.csv", &["cotan_weight"], &weights, Relative(1e-10));
        mesh.check_sums("cotan_weight(lexicographic)", &weights, Relative(1e-10));
    }
}

#[test]
fn faces() {
    for mesh in meshes(&TRIANGLE_MESHES) {
        let x = &mesh.positions;
        let (a, b) = (
            Faces::new(&mesh.mesh, x).unwrap(),
            PlainFaces::new(&mesh.mesh, x).unwrap(),
        );
        let areas = [field!(a, b, mesh.mesh.faces(), A, A_all)];
        mesh.check_table("face.csv", &["area"], &areas, Relative(1e-11));
        mesh.check_sums("face_area", &areas, Relative(1e-11));
        let normals = components(&field!(a, b, mesh.mesh.faces(), N, N_all));
        mesh.check_table("face.csv", &["nx", "ny", "nz"], &normals, Relative(1e-11));
        let corner = |f: Face, k: usize| mesh.mesh.face_vertices(f).get(k).unwrap();
        let angles: Vec<Vec<f64>> = (0..3)
            .map(|k| {
                let angle = |f| {
                    let v = corner(f, k);
                    let (x, y) = (a.theta(v, f), b.theta(v, f));
                    assert!((x - y).abs() < 1e-13);
                    x
                };
                mesh.mesh.faces().map(angle).collect()
            })
            .collect();
        mesh.check_table(
            "face.csv",
            &["angle0", "angle1", "angle2"],
            &angles,
            Absolute(1e-9),
        );
        mesh.check_sums("face_angles", &angles, Absolute(1e-9));
    }
}

#[test]
fn polygons() {
    for mesh in meshes(&POLYGON_MESHES) {
        let x = &mesh.positions;
        let (a, b) = (
            Polygons::new(&mesh.mesh, x).unwrap(),
            PlainPolygons::new(&mesh.mesh, x).unwrap(),
        );
        let areas = [field!(a, b, mesh.mesh.faces(), a, a_all)];
        mesh.check_table("face.csv", &["area_newell"], &areas, Relative(1e-9));
        mesh.check_sums("area_newell", &areas, Relative(1e-9));
        let normals = components(&field!(a, b, mesh.mesh.faces(), N, N_all));
        mesh.check_table(
            "face.csv",
            &["nx_newell", "ny_newell", "nz_newell"],
            &normals,
            Relative(1e-9),
        );
        check(
            &mesh,
            "K_2pi_corner",
            field!(a, b, mesh.mesh.vertices(), K, K_all),
            Absolute(1e-9),
        );
        check_vectors(
            &mesh,
            "N_area",
            &field!(a, b, mesh.mesh.vertices(), n, n_all),
            Relative(1e-9),
        );
    }
}
