//! Triangles in the plane.

use iheartmesh::FaceMesh;
use iheartmesh::glam::DVec2;

/// A grid of so many vertices on each side, moved a little.
pub fn grid(n: usize) -> (Vec<DVec2>, Vec<[u32; 3]>) {
    let mut random = fastrand::Rng::with_seed(5);
    let points = (0..n * n).map(|k| {
        let noise = DVec2::new(random.f64(), random.f64()) * 0.8;
        DVec2::new((k % n) as f64, (k / n) as f64) + noise
    });
    let points = points.collect();
    let mut triangles = Vec::new();
    for y in 0..n as u32 - 1 {
        for x in 0..n as u32 - 1 {
            let a = y * n as u32 + x;
            let (b, c, d) = (a + 1, a + n as u32, a + n as u32 + 1);
            triangles.extend([[a, b, d], [a, d, c]]);
        }
    }
    (points, triangles)
}

/// Meshes with different properties, each with positions; the last is a grid.
pub fn meshes(side: usize) -> Vec<(FaceMesh, Vec<DVec2>)> {
    let (points, triangles) = grid(side);
    let mut random = fastrand::Rng::with_seed(9);
    let mut more = |n: usize, triangles: &[[u32; 3]]| {
        let points = (0..n).map(|_| DVec2::new(random.f64(), random.f64()) * 3.0);
        let points: Vec<DVec2> = points.collect();
        (FaceMesh::from_triangles(n, triangles).unwrap(), points)
    };
    let mut all = vec![
        more(0, &[]),
        // isolated vertices: empty columns
        more(4, &[]),
        more(7, &[[1, 3, 5]]),
        // three faces on one edge, two fans at one vertex
        more(5, &[[0, 1, 2], [1, 0, 3], [0, 1, 4]]),
        more(7, &[[0, 1, 2], [0, 2, 3], [0, 4, 5], [0, 5, 6]]),
        // closed
        more(4, &[[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]),
    ];
    all.push((
        FaceMesh::from_triangles(points.len(), &triangles).unwrap(),
        points,
    ));
    all
}
