//! The hand-written baselines against closed forms and against each other.
//!
//! The tests inside of what the examples share run here too: neither is a program of its own.

#[path = "../benches/baseline/mod.rs"]
mod baseline;
#[path = "../examples/common/mod.rs"]
mod common;

use std::f64::consts::{PI, SQRT_2, TAU};

use baseline::vertex_normals::Weight;
use baseline::{
    Adjacency, Corner, Edges, NONE, Neighbour, gaussian_curvature, mean_curvature, vertex_normals,
};
use common::generate;
use glam::DVec3;

struct Mesh {
    positions: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    edges: Edges,
    adjacency: Adjacency,
}

fn mesh((positions, triangles): (Vec<DVec3>, Vec<[u32; 3]>)) -> Mesh {
    let edges = Edges::new(positions.len(), &triangles);
    let adjacency = Adjacency::new(positions.len(), &triangles, &edges);
    Mesh {
        positions,
        triangles,
        edges,
        adjacency,
    }
}

fn octahedron() -> Mesh {
    let [x, y, z] = DVec3::AXES;
    let positions = vec![x, y, z, -x, -y, -z];
    let triangles = vec![
        [0, 1, 2],
        [1, 3, 2],
        [3, 4, 2],
        [4, 0, 2],
        [1, 0, 5],
        [3, 1, 5],
        [4, 3, 5],
        [0, 4, 5],
    ];
    mesh((positions, triangles))
}

/// A polyhedron of very different faces with all its vertices on the unit sphere.
fn inscribed_in_sphere() -> Mesh {
    let Mesh {
        mut positions,
        mut triangles,
        ..
    } = octahedron();
    for round in 0..4 {
        for face in 0..triangles.len() {
            let [i, j, k] = triangles[face];
            let [x, y, z] = triangles[face].map(|vertex| positions[vertex as usize]);
            let new = positions.len() as u32;
            positions.push((x + (1.0 + 0.3 * f64::from(round)) * y + z).normalize());
            triangles[face] = [i, j, new];
            triangles.extend([[j, k, new], [k, i, new]]);
        }
    }
    mesh((positions, triangles))
}

/// Large enough that lists around its vertices are in another order than that of their numbers.
fn shuffled_torus() -> Mesh {
    let (positions, triangles) = generate::torus(61, 41);
    mesh(generate::shuffle(&positions, &triangles, 7))
}

/// Two triangles in a plane.
fn square() -> Mesh {
    mesh((
        vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y],
        vec![[0, 1, 2], [0, 2, 3]],
    ))
}

fn assert_close(left: &[f64], right: &[f64]) {
    assert_eq!(left.len(), right.len());
    for (place, (a, b)) in left.iter().zip(right).enumerate() {
        assert!((a - b).abs() < 1e-11, "at {place}: {a} and {b}");
    }
}

fn components(vectors: &[DVec3]) -> Vec<f64> {
    vectors.iter().flat_map(DVec3::to_array).collect()
}

#[test]
fn edges_are_lexicographic_and_their_signs_cancel_around_vertices() {
    for mesh in [
        octahedron(),
        inscribed_in_sphere(),
        shuffled_torus(),
        square(),
    ] {
        let edges = &mesh.edges;
        assert!(edges.ends.is_sorted() && edges.ends.iter().all(|[a, b]| a < b));
        for ((triangle, of_face), signs) in
            mesh.triangles.iter().zip(&edges.of_face).zip(&edges.signs)
        {
            for corner in 0..3 {
                let (from, to) = (triangle[corner], triangle[(corner + 1) % 3]);
                let [a, b] = edges.ends[of_face[corner] as usize];
                let expected = if signs[corner] == 1 { (a, b) } else { (b, a) };
                assert_eq!((from, to), expected);
            }
        }
    }
    assert_eq!(
        square().edges.ends,
        [[0, 1], [0, 2], [0, 3], [1, 2], [2, 3]]
    );
    assert_eq!(
        square().edges.faces,
        [[0, NONE], [1, 0], [NONE, 1], [0, NONE], [1, NONE]]
    );
    assert_eq!(square().edges.of_face, [[0, 3, 1], [1, 4, 2]]);
    assert_eq!(square().edges.signs, [[1, 1, -1], [1, 1, -1]]);
}

#[test]
fn neighbourhoods_are_ascending_and_complete() {
    let square = square().adjacency;
    assert_eq!(
        square.corners(0),
        [
            Corner {
                next: 1,
                previous: 2
            },
            Corner {
                next: 2,
                previous: 3
            }
        ]
    );
    assert_eq!(square.corner_numbers(2), [2, 4]);
    let diagonal = Neighbour {
        vertex: 2,
        opposite_forward: 3,
        opposite_backward: 1,
    };
    assert_eq!(square.neighbours(0)[1], diagonal);
    assert_eq!(square.neighbour_faces(0), [[0, NONE], [1, 0], [NONE, 1]]);

    let torus = shuffled_torus();
    for v in 0..torus.adjacency.n_vertices() {
        assert!(
            torus
                .adjacency
                .neighbours(v)
                .is_sorted_by_key(|neighbour| neighbour.vertex)
        );
        let numbers = torus.adjacency.corner_numbers(v);
        assert!(numbers.is_sorted());
        assert!(
            numbers
                .iter()
                .all(|&c| torus.triangles[c as usize / 3][c as usize % 3] == v as u32)
        );
        for (neighbour, &[forward, _]) in torus
            .adjacency
            .neighbours(v)
            .iter()
            .zip(torus.adjacency.neighbour_faces(v))
        {
            let corner = Corner {
                next: neighbour.vertex,
                previous: neighbour.opposite_forward,
            };
            assert!(torus.adjacency.corners(v).contains(&corner));
            assert!(torus.triangles[forward as usize].contains(&neighbour.opposite_forward));
        }
    }
}

#[test]
#[should_panic = "in the same direction"]
fn faces_that_disagree_about_the_orientation_are_refused() {
    Edges::new(4, &[[0, 1, 2], [0, 1, 3]]);
}

#[test]
fn gaussian_curvature_obeys_gauss_and_bonnet() {
    use gaussian_curvature::*;
    let characteristic =
        |mesh: &Mesh| gather(&mesh.positions, &mesh.adjacency).iter().sum::<f64>() / TAU;
    assert!((characteristic(&inscribed_in_sphere()) - 2.0).abs() < 1e-12);
    assert!(characteristic(&shuffled_torus()).abs() < 1e-12);
    let octahedron = octahedron();
    assert_close(
        &gather(&octahedron.positions, &octahedron.adjacency),
        &[TAU - 4.0 * PI / 3.0; 6],
    );
    let square = square();
    assert_close(
        &gather(&square.positions, &square.adjacency),
        &[1.5 * PI; 4],
    );
}

#[test]
fn mean_curvature_of_the_octahedron_and_of_flat_surfaces() {
    use mean_curvature::*;
    let octahedron = octahedron();
    let expected = [SQRT_2 * (1.0f64 / 3.0).acos(); 6];
    assert_close(
        &gather(&octahedron.positions, &octahedron.adjacency),
        &expected,
    );
    let square = square();
    assert_close(&gather(&square.positions, &square.adjacency), &[0.0; 4]);
}

#[test]
fn normals_weighted_by_max_are_exact_on_the_sphere() {
    let sphere = inscribed_in_sphere();
    let normals = vertex_normals::gather(&sphere.positions, &sphere.adjacency, Weight::Max);
    assert_close(&components(&normals), &components(&sphere.positions));
    let octahedron = octahedron();
    for weight in [Weight::Area, Weight::Angle] {
        let normals = vertex_normals::gather(&octahedron.positions, &octahedron.adjacency, weight);
        assert_close(&components(&normals), &components(&octahedron.positions));
    }
}

#[test]
fn all_forms_of_a_quantity_agree() {
    for mesh in [
        octahedron(),
        inscribed_in_sphere(),
        shuffled_torus(),
        square(),
    ] {
        let Mesh {
            positions,
            triangles,
            edges,
            adjacency,
        } = &mesh;

        let gaussian = gaussian_curvature::gather(positions, adjacency);
        assert_close(
            &gaussian,
            &gaussian_curvature::gather_parallel(positions, adjacency),
        );
        assert_close(
            &gaussian,
            &gaussian_curvature::scatter(positions, triangles),
        );
        let parallel = gaussian_curvature::scatter_parallel(positions, triangles, adjacency);
        assert_close(&gaussian, &parallel);

        let mean = mean_curvature::gather(positions, adjacency);
        assert_close(
            &mean,
            &mean_curvature::gather_parallel(positions, adjacency),
        );
        assert_close(&mean, &mean_curvature::scatter(positions, triangles, edges));
        let rows = mean_curvature::edges_of_vertices(edges, adjacency);
        let parallel =
            mean_curvature::scatter_parallel(positions, triangles, edges, adjacency, &rows);
        assert_close(&mean, &parallel);

        for weight in [Weight::Max, Weight::Area, Weight::Angle] {
            let normals = components(&vertex_normals::gather(positions, adjacency, weight));
            let parallel = vertex_normals::gather_parallel(positions, adjacency, weight);
            assert_close(&normals, &components(&parallel));
            let scatter = vertex_normals::scatter(positions, triangles, weight);
            assert_close(&normals, &components(&scatter));
            let parallel =
                vertex_normals::scatter_parallel(positions, triangles, adjacency, weight);
            assert_close(&normals, &components(&parallel));
        }
    }
}
