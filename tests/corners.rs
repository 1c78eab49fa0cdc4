//! Sums over faces whose terms name three corners of the face, with and without optimisations: rows that are turned, so
//! that the vertex of the sum comes first, and rows that are not.

#[allow(dead_code)]
mod support;

use iheartmesh::glam::DVec3;
use iheartmesh::{FaceMesh, Vertex, iheartmesh};
use support::random::Random;
use support::soups::{self, Soup};

macro_rules! programs {
    ($($name:ident, $plain:ident = $text:literal;)*) => {
        iheartmesh! {
            $(
                pub struct $name = $text;

                #[without(all)]
                pub struct $plain = $text;
            )*
        }
    };
}

programs! {
    Corners, PlainCorners = r#"
        ElementSets from MeshConnectivity
        Faces, VertexOneRing, NextVertexAroundFace from Neighborhoods(M)
        OrientedVertices, NeighborVerticesInFace from Neighborhoods(M)
        arccos from trigonometry

        M : FaceMesh
        V, E, F = ElementSets(M)
        x_i ∈ ℝ³
        m : F → ℝ

        a(f) = ½ (x_j - x_i) × (x_k - x_i) where f ∈ F, i, j, k = OrientedVertices(f)
        θ_i,f = arccos((x_j-x_i)·(x_k-x_i)/(‖x_j-x_i‖ ‖x_k-x_i‖))
            where i ∈ V, f ∈ F, j, k = NeighborVerticesInFace(f, i)

        // all corners of a triangle are turned
        A(v) = ∑_(f ∈ Faces(v)) a(f) where v ∈ V
        // with the mass of the face as a further column
        `mass`(v) = ∑_(f ∈ Faces(v)) m_f ‖a(f)‖ where v ∈ V
        // with columns that stand in the circle of three again, on triangles
        B(v) = ∑_(f ∈ Faces(v)) θ_v,f a(f)/‖a(f)‖ where v ∈ V
        // the other way around
        `back`(v) = ∑_(f ∈ Faces(v)) ‖x_j - x_v‖ (x_k - x_i) × (x_l - x_i) where i, l, k = OrientedVertices(f), j = NextVertexAroundFace(f, v)
            where v ∈ V
        // faces that do not hold the vertex are among these
        `around`(v) = ∑_(f ∈ Faces(VertexOneRing(v))) 3 a(f) where v ∈ V
        // a division of all terms by the same number, and nothing to share
        `third`(v) = ∑_(f ∈ Faces(v)) ‖a(f)‖²/3 where v ∈ V
        `total` = ∑_(v ∈ V) ∑_(f ∈ Faces(v)) ‖a(f)‖
    "#;
}

/// The same up to rounding, or missing in both.
fn agree<T: Copy + std::fmt::Debug>(
    what: &str,
    found: Result<T, iheartmesh::Error>,
    expected: Result<T, iheartmesh::Error>,
    distance: impl Fn(T, T) -> f64,
) {
    match (found, expected) {
        (Ok(found), Ok(expected)) => {
            let distance = distance(found, expected);
            assert!(distance < 1E-12, "{what}: {found:?} and {expected:?}");
        }
        (Err(found), Err(expected)) => {
            assert_eq!(found.to_string(), expected.to_string(), "{what}")
        }
        (found, expected) => panic!("{what}: {found:?} and {expected:?}"),
    }
}

fn check(name: &str, mesh: &FaceMesh, x: &[DVec3]) {
    let mass: Vec<f64> = (0..mesh.n_faces()).map(|f| 1.0 + f as f64 / 7.0).collect();
    let turned = Corners::new(mesh, x, &mass).unwrap();
    let plain = PlainCorners::new(mesh, x, &mass).unwrap();
    let far = |a: DVec3, b: DVec3| a.distance(b);
    let apart = |a: f64, b: f64| (a - b).abs();
    macro_rules! compare {
        ($($one:ident $all:ident $distance:ident),*) => {$(
            for v in mesh.vertices() {
                let what = format!("{name}: {} of {v:?}", stringify!($one));
                agree(&what, turned.$one(v), plain.$one(v), $distance);
            }
            match (turned.$all(), plain.$all()) {
                (Ok(found), Ok(expected)) => {
                    assert_eq!(found.len(), expected.len());
                    for (v, (found, expected)) in found.into_iter().zip(expected).enumerate() {
                        let what = format!("{name}: {} of {v}", stringify!($all));
                        agree(&what, Ok(found), Ok(expected), $distance);
                    }
                }
                (found, expected) => {
                    let (found, expected) = (found.map(|_| ()), expected.map(|_| ()));
                    agree(name, found, expected, |_, _| 0.0);
                }
            }
        )*};
    }
    compare!(
        try_A try_A_all far,
        try_mass try_mass_all apart,
        try_B try_B_all far,
        try_back try_back_all far,
        try_around try_around_all far,
        try_third try_third_all apart
    );
    agree(
        name,
        turned.try_total(),
        plain.try_total(),
        |a: f64, b: f64| (a - b).abs() / (1.0 + b),
    );
}

fn position(random: &mut Random) -> DVec3 {
    let mut coordinate = || f64::from(random.below(1 << 20)) / f64::from(1 << 20);
    DVec3::new(coordinate(), coordinate(), coordinate())
}

fn check_soup(soup: &Soup) {
    let mut random = Random(soup.n.into());
    let x: Vec<DVec3> = (0..soup.n).map(|_| position(&mut random)).collect();
    let mesh = FaceMesh::from_polygons(soup.n as usize, &soup.faces);
    // not all lists of polygons are a mesh
    if let Ok(mesh) = mesh {
        check(&soup.name, &mesh, &x);
    }
}

#[test]
fn turned_rows_have_the_values_of_the_others() {
    soups::by_property().iter().for_each(check_soup);
    (0..200)
        .map(soups::random)
        .for_each(|soup| check_soup(&soup));
}

/// The vector areas of the triangles around each vertex, face by face.
#[test]
fn areas_of_triangles_add_up() {
    let (a, b) = (40, 25);
    let vertex = |i: u32, j: u32| (i % a) * b + j % b;
    let x: Vec<DVec3> = (0..a * b)
        .map(|v| {
            let (s, t) = (f64::from(v / b), f64::from(v % b));
            let (s, t) = (
                s * std::f64::consts::TAU / f64::from(a),
                t * std::f64::consts::TAU / f64::from(b),
            );
            DVec3::new(
                (2.0 + t.cos()) * s.cos(),
                (2.0 + t.cos()) * s.sin(),
                t.sin(),
            )
        })
        .collect();
    let mut triangles = Vec::new();
    for i in 0..a {
        for j in 0..b {
            let [p, q, r, s] = [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(k, l)| vertex(i + k, j + l));
            triangles.extend([[q, r, p], [p, r, s]]);
        }
    }
    let mesh = FaceMesh::from_triangles(x.len(), &triangles).unwrap();
    let mut areas = vec![DVec3::ZERO; x.len()];
    for corners in &triangles {
        let [p, q, r] = corners.map(|v| x[v as usize]);
        for v in corners {
            areas[*v as usize] += 0.5 * (q - p).cross(r - p);
        }
    }
    let mass = vec![1.0; triangles.len()];
    let module = Corners::new(&mesh, &x, &mass).unwrap();
    let all = module.A_all();
    for (v, expected) in areas.into_iter().enumerate() {
        assert!(module.A(Vertex::new(v as u32)).distance(expected) < 1E-14);
        assert!(all[v].distance(expected) < 1E-14);
    }
    check("torus", &mesh, &x);
}
