//! The programs that are measured, with all optimisations and without each.

use iheartmesh::{FaceMesh, Vertex, glam::DVec3, iheartmesh};

iheartmesh! {
    pub struct GaussianCurvature = include "tests/programs/gaussian_curvature.hlang";
    pub struct MeanCurvature = include "tests/programs/mean_curvature.hlang";
    pub struct VertexNormals = include "tests/programs/vertex_normals.hlang";
}

/// The same programs without one optimisation each, and without all.
pub mod without {
    use super::iheartmesh;

    iheartmesh! {
        #[without(traverse)]
        pub struct GaussianTraverse = include "tests/programs/gaussian_curvature.hlang";
        #[without(inline)]
        pub struct GaussianInline = include "tests/programs/gaussian_curvature.hlang";
        #[without(steps)]
        pub struct GaussianSteps = include "tests/programs/gaussian_curvature.hlang";
        #[without(share)]
        pub struct GaussianShare = include "tests/programs/gaussian_curvature.hlang";
        #[without(plan)]
        pub struct GaussianPlan = include "tests/programs/gaussian_curvature.hlang";
        #[without(fields)]
        pub struct GaussianFields = include "tests/programs/gaussian_curvature.hlang";
        #[without(orbits)]
        pub struct GaussianOrbits = include "tests/programs/gaussian_curvature.hlang";
        #[without(all)]
        pub struct GaussianAll = include "tests/programs/gaussian_curvature.hlang";

        #[without(traverse)]
        pub struct MeanTraverse = include "tests/programs/mean_curvature.hlang";
        #[without(inline)]
        pub struct MeanInline = include "tests/programs/mean_curvature.hlang";
        #[without(steps)]
        pub struct MeanSteps = include "tests/programs/mean_curvature.hlang";
        #[without(share)]
        pub struct MeanShare = include "tests/programs/mean_curvature.hlang";
        #[without(plan)]
        pub struct MeanPlan = include "tests/programs/mean_curvature.hlang";
        #[without(fields)]
        pub struct MeanFields = include "tests/programs/mean_curvature.hlang";
        #[without(orbits)]
        pub struct MeanOrbits = include "tests/programs/mean_curvature.hlang";
        #[without(all)]
        pub struct MeanAll = include "tests/programs/mean_curvature.hlang";
    }
}

/// A curvature with its plan.
pub trait Curvature<'a>: Sized {
    /// Makes the plan.
    fn plan(mesh: &'a FaceMesh, positions: &'a [DVec3]) -> Self;
    /// The value at one vertex.
    fn at(&self, vertex: Vertex) -> f64;
    /// The values at all vertices.
    fn everywhere(&self) -> Vec<f64>;
}

macro_rules! curvatures {
    ($at:ident, $everywhere:ident: $($program:path),* $(,)?) => {$(
        impl<'a> Curvature<'a> for $program {
            fn plan(mesh: &'a FaceMesh, positions: &'a [DVec3]) -> Self {
                Self::new(mesh, positions).expect("a torus has a plan")
            }

            fn at(&self, vertex: Vertex) -> f64 {
                self.$at(vertex)
            }

            fn everywhere(&self) -> Vec<f64> {
                self.$everywhere()
            }
        }
    )*};
}

curvatures!(K, K_all:
    GaussianCurvature<'a>,
    without::GaussianTraverse<'a>,
    without::GaussianInline<'a>,
    without::GaussianSteps<'a>,
    without::GaussianShare<'a>,
    without::GaussianPlan<'a>,
    without::GaussianFields<'a>,
    without::GaussianOrbits<'a>,
    without::GaussianAll<'a>,
);
curvatures!(H, H_all:
    MeanCurvature<'a>,
    without::MeanTraverse<'a>,
    without::MeanInline<'a>,
    without::MeanSteps<'a>,
    without::MeanShare<'a>,
    without::MeanPlan<'a>,
    without::MeanFields<'a>,
    without::MeanOrbits<'a>,
    without::MeanAll<'a>,
);
