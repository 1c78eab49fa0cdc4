//! Values at all vertices do not depend on the number of threads or the numbering of the mesh.

#[path = "../examples/common/generate.rs"]
#[allow(dead_code)]
mod generate;

use iheartmesh::{Error, FaceMesh, Vertex, iheartmesh};

iheartmesh! {
    pub struct GaussianCurvature = include "tests/programs/gaussian_curvature.hlang";
    pub struct MeanCurvature = include "tests/programs/mean_curvature.hlang";
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
