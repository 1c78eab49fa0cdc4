//! The example of normals on three kinds of mesh, against other libraries, and against what is known without them.

#[allow(dead_code)]
mod support;

use std::collections::BTreeMap;
use std::path::Path;

use iheartmesh::glam::DVec3;
use iheartmesh::nalgebra::Matrix3;
use iheartmesh::{EdgeMesh, io};

use support::random::Random;
use support::reference_mesh::ReferenceMesh;

both_ways! {
    Triangles, PlainTriangles = "examples/normals/triangles.hlang";
    Polygons, PlainPolygons = "examples/normals/polygons.hlang";
    Points, PlainPoints = "examples/normals/points.hlang";
}

/// The columns of a table by their names, by the number of the vertex.
fn table(file: &Path) -> BTreeMap<usize, BTreeMap<String, f64>> {
    let text = std::fs::read_to_string(file).unwrap();
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().unwrap().split(',').collect();
    lines
        .map(|line| {
            let cells: Vec<f64> = line.split(',').map(|x| x.parse().unwrap()).collect();
            let named = header
                .iter()
                .zip(&cells)
                .map(|(h, x)| ((*h).to_owned(), *x));
            (cells[0] as usize, named.collect())
        })
        .collect()
}

fn vector(row: &BTreeMap<String, f64>, name: &str) -> DVec3 {
    DVec3::from(["x", "y", "z"].map(|axis| row[&format!("{name}{axis}")]))
}

#[test]
fn surfaces_of_the_reference_set() {
    let Some(set) = support::reference_set() else {
        return;
    };
    for (file, is_polygon) in [
        ("spot_tri.obj", false),
        ("cat_head.obj", false),
        ("spot_quad.obj", true),
        ("spot_control.obj", true),
        ("spot_control_dual.obj", true),
        ("dodecahedron_poly.obj", true),
        ("spot_tri.obj", true),
    ] {
        let reference = ReferenceMesh::read(&set, file);
        let (mesh, x) = (&reference.mesh, &reference.positions);
        let (found, plain, name) = match is_polygon {
            false => (
                Triangles::new(mesh, x).unwrap().N_all(),
                PlainTriangles::new(mesh, x).unwrap().N_all(),
                "N_area_",
            ),
            true => (
                Polygons::new(mesh, x).unwrap().N_all(),
                PlainPolygons::new(mesh, x).unwrap().N_all(),
                "N_max_",
            ),
        };
        let rows = table(&set.join("ref").join(&reference.name).join("vertex.csv"));
        assert!(rows.len() > 10, "{file}");
        for (v, row) in rows {
            let expected = vector(&row, name);
            assert!((found[v] - expected).length() < 1e-10, "{file} {v}");
            assert!((plain[v] - expected).length() < 1e-10, "{file} {v}");
        }
    }
}

#[test]
fn point_clouds_of_the_reference_set() {
    let Some(set) = support::reference_set() else {
        return;
    };
    let x = io::read(set.join("meshes/spot_noisy_points.ply"))
        .unwrap()
        .positions;
    for k in [6, 10] {
        let mesh = EdgeMesh::from_k_nearest(&x, k).unwrap();
        let found = Points::new(&mesh, &x).unwrap().N_all();
        let plain = PlainPoints::new(&mesh, &x).unwrap().N_all();
        let file = format!("ref/spot_noisy_points/knn{k}_pca_normals.csv");
        let rows = table(&set.join(file));
        assert!(rows.len() > 100);
        for (v, row) in rows {
            let expected = vector(&row, "n");
            let tolerance = f64::max(1e-10, 1e-12 / row["eigen_separation"]);
            assert!(1.0 - found[v].dot(expected).abs() <= tolerance, "{k} {v}");
            assert!(1.0 - plain[v].dot(expected).abs() <= tolerance, "{k} {v}");
        }
    }
}

/// Random points, against the eigenvectors of their scatter matrices.
#[test]
fn normals_are_eigenvectors() {
    let mut random = Random(11);
    let mut coordinate =
        |scale: f64| scale * (f64::from(random.below(1 << 20)) / f64::from(1 << 20) - 0.5);
    let x: Vec<DVec3> = (0..300)
        .map(|_| DVec3::new(coordinate(3.0), coordinate(2.0), coordinate(0.2)))
        .collect();
    let mesh = EdgeMesh::from_k_nearest(&x, 8).unwrap();
    let normals = Points::new(&mesh, &x).unwrap().N_all();
    for v in mesh.vertices() {
        let ends = mesh
            .vertex_edges(v)
            .iter()
            .flat_map(|e| mesh.edge_vertices(e));
        let mut around: Vec<usize> = ends.map(|w| w.index()).collect();
        around.sort_unstable();
        around.dedup();
        let mean = around.iter().map(|&w| x[w]).sum::<DVec3>() / around.len() as f64;
        let scatter: Matrix3<f64> = around
            .iter()
            .map(|&w| {
                let d = iheartmesh::nalgebra::Vector3::from((x[w] - mean).to_array());
                d * d.transpose()
            })
            .sum();
        let eigen = scatter.symmetric_eigen();
        let (least, _) = eigen.eigenvalues.argmin();
        let expected = DVec3::from_slice(eigen.eigenvectors.column(least).as_slice());
        assert!(1.0 - normals[v.index()].dot(expected).abs() < 1e-10, "{v}");
        assert!((normals[v.index()].length() - 1.0).abs() < 1e-12);
    }
}

/// On a sphere all three are nearly radial.
#[test]
fn normals_of_a_sphere() {
    let file = io::read(support::workspace().join("meshes/sphere_small.ply")).unwrap();
    let (mesh, x) = (file.face_mesh().unwrap(), file.positions);
    let near = EdgeMesh::from_k_nearest(&x, 8).unwrap();
    let centre = x.iter().sum::<DVec3>() / x.len() as f64;
    let triangles = Triangles::new(&mesh, &x).unwrap().N_all();
    let polygons = Polygons::new(&mesh, &x).unwrap().N_all();
    let points = Points::new(&near, &x).unwrap().N_all();
    for v in 0..x.len() {
        let radial = (x[v] - centre).normalize();
        assert!(triangles[v].dot(radial) > 0.999, "{v}");
        assert!(polygons[v].dot(radial) > 0.999, "{v}");
        assert!(points[v].dot(radial).abs() > 0.99, "{v}");
    }
}
