//! Surfaces of every kind against closed forms and hand-written loops: the meshes of this repository, which need no
//! reference set, and meshes that are open, not manifold, not orientable or broken.

#[allow(dead_code)]
mod support;

use std::f64::consts::{PI, TAU};

use iheartmesh::glam::DVec3;
use iheartmesh::io::{self, MeshFile};
use iheartmesh::{Edge, FaceMesh, Vertex};

use support::workspace;

both_ways! {
    Gaussian, PlainGaussian = "tests/programs/gaussian_curvature.hlang";
    BoundaryCurvature, PlainBoundaryCurvature = "tests/programs/boundary_curvature.hlang";
    Mean, PlainMean = "tests/programs/mean_curvature.hlang";
    Dihedral, PlainDihedral = "tests/programs/dihedral.hlang";
    Areas, PlainAreas = "tests/programs/vertex_areas.hlang";
    MaxNormals, PlainMaxNormals = "tests/programs/max_normals.hlang";
}

const BUNDLED: [&str; 4] = ["bob_small.ply", "fox.ply", "sphere_small.ply", "spot.ply"];

fn bundled(name: &str) -> (Vec<DVec3>, FaceMesh) {
    let file = io::read(workspace().join("meshes").join(name)).unwrap();
    let mesh = file.face_mesh().unwrap();
    (file.positions, mesh)
}

fn reference(name: &str) -> Option<MeshFile> {
    let set = support::reference_set()?;
    Some(io::read(set.join("meshes").join(name)).unwrap())
}

/// Each corner of a mesh: a vertex with those after and before it.
fn corners(mesh: &FaceMesh) -> impl Iterator<Item = [usize; 3]> + '_ {
    mesh.faces().flat_map(|f| {
        let face: Vec<usize> = mesh.face_vertices(f).iter().map(|v| v.index()).collect();
        let n = face.len();
        (0..n)
            .map(|k| [face[k], face[(k + 1) % n], face[(k + n - 1) % n]])
            .collect::<Vec<_>>()
    })
}

/// 2π minus the angles of all corners at a vertex, corner by corner.
fn angle_defects(mesh: &FaceMesh, x: &[DVec3]) -> Vec<f64> {
    let mut defects = vec![TAU; x.len()];
    for [i, j, k] in corners(mesh) {
        defects[i] -= (x[j] - x[i]).angle_between(x[k] - x[i]);
    }
    defects
}

/// ¼ ∑ length · dihedral angle over the edges of two faces that are oriented alike.
fn mean_curvatures(mesh: &FaceMesh, x: &[DVec3]) -> Vec<f64> {
    let normal = |f| {
        let face = mesh.face_vertices(f).to_vec();
        let [a, b, c] = [0, 1, 2].map(|k: usize| x[face[k].index()]);
        (b - a).cross(c - a).normalize()
    };
    let mut sums = vec![0.0; x.len()];
    for e in mesh.edges() {
        let [i, j] = mesh.edge_vertices(e).map(Vertex::index);
        let sign = |f| {
            let (edges, signs) = mesh.face_boundary(f);
            signs[edges.iter().position(|other| other == e).unwrap()]
        };
        let mut faces = mesh.edge_faces(e).to_vec();
        faces.sort_by_key(|f| -sign(*f));
        let [f, g] = faces[..] else { continue };
        let (m, n) = (normal(f), normal(g));
        let along = x[j] - x[i];
        let angle = along.normalize().dot(m.cross(n)).atan2(m.dot(n));
        sums[i] += 0.25 * along.length() * angle;
        sums[j] += 0.25 * along.length() * angle;
    }
    sums
}

fn assert_close(name: &str, found: &[f64], expected: &[f64], bound: f64) {
    assert_eq!(found.len(), expected.len());
    for (place, (a, b)) in found.iter().zip(expected).enumerate() {
        assert!((a - b).abs() <= bound, "{name} at {place}: {a} and {b}");
    }
}

#[test]
fn closed_surfaces_of_the_repository() {
    for name in BUNDLED {
        let (x, mesh) = bundled(name);
        let turning = TAU * mesh.euler_characteristic() as f64;

        let (a, b) = (
            Gaussian::new(&mesh, &x).unwrap(),
            PlainGaussian::new(&mesh, &x).unwrap(),
        );
        let curvature = field!(a, b, mesh.vertices(), K, K_all);
        assert_close(name, &curvature, &angle_defects(&mesh, &x), 1e-11);
        // Gauss and Bonnet
        assert!((curvature.iter().sum::<f64>() - turning).abs() < 1e-9);

        // without a boundary all ways to treat it are one
        let a = BoundaryCurvature::new(&mesh, &x).unwrap();
        let b = PlainBoundaryCurvature::new(&mesh, &x).unwrap();
        assert_close(
            name,
            &field!(a, b, mesh.vertices(), K, K_all),
            &curvature,
            1e-13,
        );
        assert_close(
            name,
            &field!(a, b, mesh.vertices(), K0, K0_all),
            &curvature,
            1e-13,
        );

        let expected = mean_curvatures(&mesh, &x);
        let (a, b) = (
            Mean::new(&mesh, &x).unwrap(),
            PlainMean::new(&mesh, &x).unwrap(),
        );
        assert_close(
            name,
            &field!(a, b, mesh.vertices(), H, H_all),
            &expected,
            1e-12,
        );
        let (a, b) = (
            Dihedral::new(&mesh, &x).unwrap(),
            PlainDihedral::new(&mesh, &x).unwrap(),
        );
        assert_close(
            name,
            &field!(a, b, mesh.vertices(), H, H_all),
            &expected,
            1e-12,
        );

        // the parts of a face that belong to its corners are all of it
        let (a, b) = (
            Areas::new(&mesh, &x).unwrap(),
            PlainAreas::new(&mesh, &x).unwrap(),
        );
        let total: f64 = field!(a, b, mesh.faces(), a, a_all).iter().sum();
        let thirds: f64 = field!(a, b, mesh.vertices(), A_bary, A_bary_all)
            .iter()
            .sum();
        let mixed: f64 = field!(a, b, mesh.vertices(), A, A_all).iter().sum();
        assert!((total - thirds).abs() < 1e-12 * total && (total - mixed).abs() < 1e-12 * total);
        // the gradient of the area does not move the surface as a whole
        let drift: DVec3 = field!(a, b, mesh.vertices(), HN, HN_all).iter().sum();
        assert!(drift.length() < 1e-11, "{name}: {drift}");
    }
}

#[test]
fn a_sphere() {
    let (x, mesh) = bundled("sphere_small.ply");
    let centre = x.iter().sum::<DVec3>() / x.len() as f64;
    let radius = x.iter().map(|x| x.distance(centre)).sum::<f64>() / x.len() as f64;
    let areas = Areas::new(&mesh, &x).unwrap();
    let mean = Mean::new(&mesh, &x).unwrap();
    let normals = MaxNormals::new(&mesh, &x).unwrap();
    for v in mesh.vertices() {
        // H of a vertex is its share of ∫ 1/r, K of ∫ 1/r²
        let share = areas.A(v) / radius;
        assert!(
            (mean.H(v) / share - 1.0).abs() < 0.015,
            "{v}: {} {share}",
            mean.H(v)
        );
        assert!((areas.K(v) * radius * radius - 1.0).abs() < 0.022);
        assert!((areas.H(v) * radius - 1.0).abs() < 2e-4);
        // the weights of Max are exact where all vertices are on a sphere
        let outward = (x[v.index()] - centre).normalize();
        assert!(normals.N(v).distance(outward) < 1e-5, "{v}");
    }
    let whole: f64 = mean.H_all().iter().sum();
    assert!((whole / (4.0 * PI * radius) - 1.0).abs() < 0.007);
}

#[test]
fn surfaces_that_are_not_manifold_or_not_orientable() {
    for (name, has_mean_curvature) in [
        ("mobius_tri.obj", false),
        ("rp2_6.obj", false),
        ("fan3.obj", false),
        ("hourglass_ico.obj", true),
        ("beetle_bad.obj", false),
    ] {
        let Some(file) = reference(name) else { return };
        let (x, mesh) = (&file.positions, file.face_mesh().unwrap());
        let (a, b) = (
            Gaussian::new(&mesh, x).unwrap(),
            PlainGaussian::new(&mesh, x).unwrap(),
        );
        let curvature = field!(a, b, mesh.vertices(), K, K_all);
        assert_close(name, &curvature, &angle_defects(&mesh, x), 1e-7);

        let (a, b) = (
            Mean::new(&mesh, x).unwrap(),
            PlainMean::new(&mesh, x).unwrap(),
        );
        assert_eq!(a.try_H_all().is_ok(), has_mean_curvature, "{name}");
        for v in mesh.vertices() {
            // the value needs two faces, oriented alike, at every edge; where there are more, it is that of the first
            let has_value = |e: Edge| {
                let signs: Vec<i8> = mesh
                    .edge_faces(e)
                    .iter()
                    .map(|f| sign(&mesh, e, f))
                    .collect();
                signs.contains(&1) && signs.contains(&-1)
            };
            let expected = mesh.vertex_edges(v).iter().all(has_value);
            match (a.try_H(v), b.try_H(v)) {
                (Ok(x), Ok(y)) => {
                    assert!(expected, "{name} {v}");
                    assert!((x - y).abs() < 1e-12);
                }
                (Err(x), Err(y)) => {
                    assert!(!expected, "{name} {v}");
                    let start = format!("`H({v})` has no value: ");
                    let y = y.to_string();
                    assert_eq!(x.to_string(), y);
                    let reason = y.strip_prefix(&start).unwrap();
                    assert!(
                        [
                            "the set has no member 1 in `g_1` (tests/programs/mean_curvature.hlang:22:37)",
                            "the set has no member 1 in `h_1` (tests/programs/mean_curvature.hlang:22:42)",
                        ]
                        .contains(&reason),
                        "{reason}"
                    );
                }
                (x, y) => panic!("{name} {v}: {x:?} {y:?}"),
            }
        }
    }
}

fn sign(mesh: &FaceMesh, e: Edge, f: iheartmesh::Face) -> i8 {
    let (edges, signs) = mesh.face_boundary(f);
    signs[edges.iter().position(|other| other == e).unwrap()]
}

#[test]
fn a_mesh_with_a_degenerate_face() {
    let Some(mut file) = reference("bad_dup_isolated.obj") else {
        return;
    };
    assert_eq!(
        file.face_mesh().unwrap_err().to_string(),
        "face 500 is degenerate: vertex 3 stands in it more than once; remove the face or the repeated corner"
    );
    file.polygons = file.polygons.iter().filter(|p| *p != [3, 3, 5]).collect();
    let (x, mesh) = (&file.positions, file.face_mesh().unwrap());
    // a repeated face and vertices of no face are legal: such a vertex has no angles
    let (a, b) = (
        Gaussian::new(&mesh, x).unwrap(),
        PlainGaussian::new(&mesh, x).unwrap(),
    );
    let curvature = field!(a, b, mesh.vertices(), K, K_all);
    assert_close("bad", &curvature, &angle_defects(&mesh, x), 1e-11);
    let isolated = mesh.isolated_vertices();
    assert_eq!(isolated.len(), 2);
    let mean = Mean::new(&mesh, x).unwrap();
    for v in isolated {
        assert_eq!(curvature[v.index()], TAU);
        assert_eq!(mean.H(v), 0.0);
    }
}
