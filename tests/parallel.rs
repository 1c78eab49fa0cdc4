//! Values at all vertices do not depend on the number of threads or the numbering of the mesh.

#[path = "../examples/common/generate.rs"]
#[allow(dead_code)]
mod generate;

use iheartmesh::glam::DVec3;
use iheartmesh::nalgebra::DVector;
use iheartmesh::{Error, FaceMesh, Vertex, iheartmesh};

iheartmesh! {
    pub struct GaussianCurvature = include "tests/programs/gaussian_curvature.hlang";
    pub struct MeanCurvature = include "tests/programs/mean_curvature.hlang";
    pub struct Totals = include "tests/programs/totals.hlang";
    #[without(all)]
    pub struct PlainTotals = include "tests/programs/totals.hlang";
}

fn on_threads<T: Send>(n: usize, compute: impl FnOnce() -> T + Send) -> T {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(n).build();
    pool.unwrap().install(compute)
}

#[test]
fn threads_and_numbering_do_not_matter() {
    // above 2048 vertices work is shared among threads
    let (positions, triangles) = generate::torus(70, 50);
    let shuffled = generate::shuffle(&positions, &triangles, 3);
    for (positions, triangles) in [(positions, triangles), shuffled] {
        let mesh = FaceMesh::from_triangles(positions.len(), &triangles).unwrap();
        let evaluate = || {
            let k = GaussianCurvature::new(&mesh, &positions).unwrap();
            let h = MeanCurvature::new(&mesh, &positions).unwrap();
            (k.K_all(), h.H_all())
        };
        let (k, h) = on_threads(1, evaluate);
        let single = GaussianCurvature::new(&mesh, &positions).unwrap();
        let mean = MeanCurvature::new(&mesh, &positions).unwrap();
        for v in mesh.vertices() {
            assert!((single.K(v) - k[v.index()]).abs() < 1e-12);
            assert!((mean.H(v) - h[v.index()]).abs() < 1e-12);
        }
        for threads in [2, 3, 7] {
            assert_eq!(on_threads(threads, evaluate), (k.clone(), h.clone()));
        }
    }
}

#[test]
fn the_first_vertex_without_a_value_is_named() {
    let (positions, mut triangles) = generate::torus(70, 50);
    // the edges of the missing face have no second face
    let missing = triangles.remove(4000);
    let first = Vertex::new(*missing.iter().min().unwrap());
    let mesh = FaceMesh::from_triangles(positions.len(), &triangles).unwrap();
    for threads in [1, 2, 5] {
        let error = on_threads(threads, || {
            let h = MeanCurvature::new(&mesh, &positions).unwrap();
            assert!(h.try_H(first).is_err());
            h.try_H_all().unwrap_err()
        });
        let Error::Undefined { call, .. } = error else {
            panic!("{error}");
        };
        assert_eq!(call, format!("H({first})"));
    }
}

#[test]
fn totals_do_not_depend_on_threads() {
    // more than two pieces of a total, and enough of them for several threads
    for (around, across) in [(3, 4), (20, 30), (110, 90)] {
        let (x, mut triangles) = generate::torus(around, across);
        // so that there is a boundary
        triangles.pop();
        let mesh = FaceMesh::from_triangles(x.len(), &triangles).unwrap();
        let evaluate = || {
            let totals = Totals::new(&mesh, &x, 0.5).unwrap();
            (
                totals.a(),
                totals.n(),
                totals.b(),
                totals.m(),
                totals.s(2.0),
            )
        };
        let found = on_threads(1, evaluate);
        for threads in [2, 3, 7] {
            assert_eq!(on_threads(threads, evaluate), found);
        }
        let plain = on_threads(2, || {
            let totals = PlainTotals::new(&mesh, &x, 0.5).unwrap();
            (
                totals.a(),
                totals.n(),
                totals.b(),
                totals.m(),
                totals.s(2.0),
            )
        });
        // a closed surface without one triangle: its area vector and its border are that of the triangle
        let [p, q, r] = triangles_corners(&x, &[0, 1, 2].map(|k| missing(around, across)[k]));
        let hole = (q - p).cross(r - p);
        let border = p.distance(q) + q.distance(r) + r.distance(p);
        let area: f64 = triangles
            .iter()
            .map(|t| {
                let [p, q, r] = triangles_corners(&x, t);
                (q - p).cross(r - p).length()
            })
            .sum();
        let second: f64 = x.iter().map(|p| p.x * p.x).sum();
        for (a, n, b, m, s) in [found, plain] {
            assert!((a - 0.5 * area).abs() < 1e-12 * area);
            assert!((n + hole).length() < 1e-12 * area);
            assert!((b - border).abs() < 1e-12);
            assert!((m.x_axis.x - second).abs() < 1e-12 * second);
            assert!((s - 2.0 * area).abs() < 1e-11 * area);
        }
    }
}

fn missing(around: usize, across: usize) -> [u32; 3] {
    *generate::torus(around, across).1.last().unwrap()
}

fn triangles_corners(x: &[DVec3], triangle: &[u32; 3]) -> [DVec3; 3] {
    triangle.map(|v| x[v as usize])
}

#[test]
fn what_has_no_value_names_the_first_element() {
    let (x, mut triangles) = generate::torus(110, 90);
    triangles.swap_remove(7000);
    triangles.swap_remove(12000);
    let mesh = FaceMesh::from_triangles(x.len(), &triangles).unwrap();
    let is_border = |e: &iheartmesh::Edge| mesh.edge_faces(*e).len() == 1;
    let border = mesh.edges().find(is_border).unwrap();
    for threads in [1, 2, 3, 7] {
        on_threads(threads, || {
            let totals = Totals::new(&mesh, &x, 0.5).unwrap();
            for (name, error) in [
                ("d", totals.try_d().err()),
                ("h", totals.try_h().err()),
                ("h", totals.try_h_into(&mut DVector::default()).err()),
                ("largest", totals.try_largest().err()),
                ("product", totals.try_product().err()),
                ("values", totals.try_values().err()),
                ("y", totals.try_y().err()),
                ("count", totals.try_count().err()),
                ("chosen", totals.try_chosen().err()),
                ("scaled(2)", totals.try_scaled(2.0).err()),
                ("k", totals.try_k().err()),
            ] {
                let neighbors = if name == "k" { "Vertices" } else { "Faces" };
                let expected = format!(
                    "`{name}` has no value: for {border}, `Opposite{neighbors}` has no value in `Opposite{neighbors}(e)` "
                );
                let error = error.unwrap().to_string();
                assert!(error.starts_with(&expected), "{error}");
            }
        });
    }
}
