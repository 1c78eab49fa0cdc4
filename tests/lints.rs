//! A crate that denies every warning may use the macro.
#![deny(
    warnings,
    missing_docs,
    unused,
    future_incompatible,
    nonstandard_style,
    rust_2018_idioms,
    single_use_lifetimes,
    trivial_casts,
    trivial_numeric_casts,
    unreachable_pub,
    unsafe_code,
    unused_import_braces,
    unused_lifetimes,
    unused_qualifications
)]
#![deny(clippy::all, clippy::pedantic)]
// calls of methods with Greek names, which this file makes itself
#![allow(mixed_script_confusables)]

#[allow(dead_code, unreachable_pub)]
mod public {
    use iheartmesh::iheartmesh;

    iheartmesh! {
        /// Angle defects.
        pub struct Gaussian = include "tests/programs/gaussian_curvature.hlang";

        /// The same without optimisation.
        #[without(all)]
        pub struct Plain = include "tests/programs/gaussian_curvature.hlang";

        /// Sums over edges in groups.
        pub struct Mean = include "tests/programs/mean_curvature.hlang";

        /// Cases and boundary vertices.
        pub struct Boundary = include "tests/programs/boundary_curvature.hlang";

        /// Functions of functions.
        pub struct Areas = include "tests/programs/vertex_areas.hlang";
    }
}

mod hidden {
    use iheartmesh::iheartmesh;

    iheartmesh! {
        /// Overloads, sets in and out, tuples; nobody calls most of it.
        pub(super) struct Neighbourhoods = include "tests/programs/neighborhoods.hlang";

        /// Recursion.
        #[without(all)]
        pub(crate) struct Rings = include "tests/programs/rings.hlang";
    }
}

iheartmesh::iheartmesh! {
    /// Names that Rust does not like.
    struct Names = r#"
        a ∈ ℝ
        x_i ∈ ℝ³
        `type` = a
        θ = 2 a
        `A'`(k) = a x_k where k ∈ ℤ
        unused(u) = 1 where u ∈ ℝ
    "#;
}

#[test]
fn every_struct_can_be_used() {
    let mesh = iheartmesh::FaceMesh::from_triangles(3, &[[0, 1, 2]]).unwrap();
    let positions = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let names = Names::new(1.5, positions).unwrap();
    assert!((names.r#type() + names.θ() + names.theta() - 7.5).abs() < 1e-12);
    assert!((names.A_prime(2).x - 1.5).abs() < 1e-12);
    let v = iheartmesh::Vertex::new(0);
    let (a, b) = (
        public::Gaussian::new(&mesh, positions).unwrap(),
        public::Plain::new(&mesh, positions).unwrap(),
    );
    assert!((a.K(v) - b.K(v)).abs() < 1e-12);
    assert!(
        public::Mean::new(&mesh, positions)
            .unwrap()
            .try_H(v)
            .is_err()
    );
    let around = hidden::Neighbourhoods::new(&mesh).unwrap();
    assert_eq!(around.rv(v), hidden::Rings::new(&mesh).unwrap().Ring(v, 1));
}
