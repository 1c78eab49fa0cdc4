//! Write the formula as the paper prints it; get Rust that runs like hand-written code on meshes.
//!
//! [`iheartmesh!`] compiles mathematical notation for computations on meshes into a struct. Everything that depends on
//! the mesh alone is worked out once, when the struct is made; what is left for each call is straight arithmetic.
//!
//! ```
//! use iheartmesh::{FaceMesh, glam::DVec3, iheartmesh};
//!
//! iheartmesh! {
//!     /// Angle defect at each vertex, in radians.
//!     pub struct GaussianCurvature = r#"
//!         ElementSets from MeshConnectivity
//!         Faces, NeighborVerticesInFace from Neighborhoods(M)
//!         arccos from trigonometry
//!
//!         M : FaceMesh
//!         V, E, F = ElementSets(M)
//!         x_i ∈ ℝ³
//!
//!         K(v) = 2π - ∑_(f ∈ Faces(v)) θ_v,f where v ∈ V
//!
//!         θ_i,f = arccos((x_j-x_i)·(x_k-x_i)/(‖x_j-x_i‖ ‖x_k-x_i‖))
//!             where i ∈ V, f ∈ F, j,k = NeighborVerticesInFace(f,i)
//!     "#;
//! }
//!
//! // a regular tetrahedron
//! let mesh = FaceMesh::from_triangles(4, &[[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])?;
//! let positions = [[1., 1., 1.], [1., -1., -1.], [-1., 1., -1.], [-1., -1., 1.]].map(DVec3::from);
//! let curvature = GaussianCurvature::new(&mesh, positions)?;
//! // Gauss and Bonnet: 2π times the Euler characteristic, which is 2
//! let total: f64 = curvature.K_all().iter().sum();
//! assert!((total - 4.0 * std::f64::consts::PI).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The parameters of the source (`M`, `x`) are the parameters of `new`, in the order of their declarations; each
//! definition is a method. The documentation of [`iheartmesh!`] tells how a call is written, how modules import each
//! other, and what errors look like.
//!
//! What generated code runs on is here too, and is useful by itself: the meshes [`FaceMesh`],
//! [`CellMesh`] and [`EdgeMesh`], the handles of their
//! elements ([`Vertex`], [`Edge`], [`Face`], [`Cell`]) and sets of them ([`Set`]).
//!
//! Where a source has an energy with its gradient and Hessian, [`check_derivatives`] compares them with finite
//! differences, and, with the feature `solve`, `solve::Newton` and `solve::GradientDescent` search for a minimum; both ask
//! an [`Objective`], which a generated struct becomes with a line for each method.

pub use iheartmesh_neighborhoods as neighborhoods;
pub use iheartmesh_runtime::*;
#[cfg(feature = "solve")]
pub use iheartmesh_solve::solve;
pub use iheartmesh_solve::{
    Comparison, DerivativeCheck, DerivativeError, DerivativeReport, Failure, Functions, Item,
    Objective, TwiceDifferentiable, WrongLength, check_derivatives, check_gradient, inverse_vec,
    vec,
};

/// Compiles modules written in mathematical notation, each into a struct.
///
/// ```text
/// iheartmesh::iheartmesh! {
///     use my_rings::KRings;                       // modules of other crates that the sources import
///
///     /// Documentation of the struct.
///     pub struct Name = r#"…"#;                   // attributes, visibility, name, source
///     pub(crate) struct Other = include "other.hlang";
/// }
/// ```
///
/// # The source
///
/// rustc splits the input of a macro into Rust tokens before the macro sees it and rejects `∑`, `∈`, `‖` and most
/// other signs. So the source is a string, in one of these spellings:
///
/// - one string literal, raw or not: `r#"…"#`;
/// - `include "file.hlang"`: a file of its own, relative to the directory of `Cargo.toml`. An edit of the file
///   compiles the module anew;
/// - lines in braces, of string literals `{ "M : FaceMesh" "x_i ∈ ℝ³" }` or of comments
///   ```text
///   struct Name = {
///       /// M : FaceMesh
///       /// x_i ∈ ℝ³
///   };
///   ```
///   One space after `///` does not count. In both, rustc marks the very line that an error is about.
///
/// Each item ends with `;`, and a call may hold any number of them.
///
/// # Attributes
///
/// - `#[together(e, g, H)]` adds the methods `e_g_H` and `e_g_H_into`, which compute several definitions at once, in one pass
///   over the elements where their sums have the same range: an energy with its derivatives.
/// - `#[without(plan)]` leaves out an optimisation, `#[without(all)]` all of them, to compare.
/// - All others are attributes of the struct.
///
/// # Modules that import modules
///
/// `Faces from Neighborhoods(M)` in a source imports from another module. It may be
///
/// - one of the standard [`neighborhoods`],
/// - another item of the same call,
/// - any module that was compiled by this macro, in this crate or another, which a line `use path::Name;` or
///   `use path::Name as Other;` in the call makes known to its sources. The path is the path of the struct, and its
///   visibility is that of the struct: a crate that has `pub struct KRings = …;` publishes the neighbourhood along
///   with the struct. Paths within a crate are best written from `crate`: `super::…` works too, but a third module,
///   which imports what imports that, cannot follow it.
///
/// Sources that are imported are checked and optimised together with the one that imports them.
///
/// # Errors
///
/// Every error is shown with the file, the line and the column where it is in the source, and with that line marked;
/// all errors of all items come at once. An item with errors does not cause further errors where it is used.
#[macro_export]
macro_rules! iheartmesh {
    // `$crate` is this crate whatever name it was given in a `Cargo.toml`.
    ($($call:tt)*) => {
        $crate::__macros::expand! {
            [$crate] [$crate::__macros] [$crate::__macros::neighborhoods] $($call)*
        }
    };
}

/// What the macros call by path: the macros themselves and the standard modules.
#[doc(hidden)]
pub mod __macros {
    pub use iheartmesh_macros::{expand, resume};
    pub use iheartmesh_neighborhoods as neighborhoods;
}

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

#[cfg(doctest)]
#[doc = include_str!("../docs/neighborhoods.md")]
struct NeighborhoodsPage;
