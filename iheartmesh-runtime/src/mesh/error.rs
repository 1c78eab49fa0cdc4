//! Why a mesh could not be made.

use std::error::Error;
use std::fmt::{self, Display};

use crate::element::ElementKind;

/// Why a mesh could not be made from the given indices or boundary matrices.
///
/// All numbers count from 0. `element` is the number of an element of `kind` in the order of the input.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum MeshError {
    /// A corner names a vertex that does not exist.
    VertexOutOfRange {
        /// Kind of the element that names the vertex.
        kind: ElementKind,
        /// Its number.
        element: usize,
        /// Position of the vertex in the element's list.
        corner: usize,
        /// The vertex number given there.
        vertex: u32,
        /// Number of vertices of the mesh.
        n_vertices: usize,
    },
    /// An element has fewer vertices than its kind needs: a face and a side of a cell have at least three.
    TooFewCorners {
        /// Kind of the element.
        kind: ElementKind,
        /// Its number.
        element: usize,
        /// How many vertices it has.
        corners: usize,
    },
    /// An element names the same vertex twice.
    RepeatedVertex {
        /// Kind of the element.
        kind: ElementKind,
        /// Its number.
        element: usize,
        /// The vertex that stands in it more than once.
        vertex: u32,
    },
    /// More elements of a kind than can be numbered.
    TooManyElements {
        /// Kind of the elements.
        kind: ElementKind,
        /// How many there are, or how many at least.
        count: usize,
        /// How many there may be.
        maximum: usize,
    },
    /// The faces, or the sides of the cells, have more corners in total than can be indexed.
    TooManyCorners {
        /// How many there are at least.
        count: usize,
        /// How many there may be.
        maximum: usize,
    },
    /// A complex is given by another number of boundary matrices than one, two or three.
    NumberOfMatrices {
        /// How many were given.
        found: usize,
    },
    /// ∂ᵏ has another number of rows than ∂ᵏ⁻¹ has columns.
    ShapeMismatch {
        /// The k of ∂ᵏ.
        k: usize,
        /// Number of rows of ∂ᵏ.
        rows: usize,
        /// Number of columns of ∂ᵏ⁻¹.
        expected: usize,
    },
    /// A stored entry of ∂ᵏ is neither −1 nor +1.
    InvalidEntry {
        /// The k of ∂ᵏ.
        k: usize,
        /// Row of the entry.
        row: usize,
        /// Column of the entry.
        column: usize,
        /// The entry.
        value: i8,
    },
    /// A column of ∂¹ is not one −1 (tail) and one +1 (head).
    InvalidEdge {
        /// The column.
        edge: usize,
    },
    /// ∂ᵏ⁻¹∂ᵏ ≠ 0: the boundary of an element has a boundary itself.
    NotAComplex {
        /// Kind of the element.
        kind: ElementKind,
        /// The first such element.
        element: usize,
    },
    /// A cell has fewer than four sides.
    TooFewSides {
        /// The cell.
        cell: usize,
        /// How many sides it has.
        sides: usize,
    },
    /// A cell has the same side twice.
    RepeatedFace {
        /// The cell.
        cell: usize,
    },
    /// The sides of a cell do not close.
    OpenCell {
        /// The cell.
        cell: usize,
    },
    /// A point has a coordinate that is infinite or not a number.
    NotFinite {
        /// The point.
        point: usize,
    },
    /// A radius that is negative or not a number.
    InvalidRadius,
    /// A column of ∂² is not one closed walk that meets each of its vertices once.
    NotAPolygon {
        /// The column.
        face: usize,
    },
}

impl Display for MeshError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            MeshError::VertexOutOfRange {
                kind,
                element,
                corner,
                vertex,
                n_vertices,
            } => write!(
                formatter,
                "{kind} {element} names vertex {vertex} at corner {corner}, but the mesh has {n_vertices} vertices; \
                 vertices are numbered from 0"
            ),
            MeshError::TooFewCorners {
                kind: ElementKind::Cell,
                element,
                corners,
            } => write!(
                formatter,
                "a side of cell {element} has too few corners ({corners}); remove it or give it all its vertices"
            ),
            MeshError::TooFewCorners {
                kind,
                element,
                corners,
            } => write!(
                formatter,
                "{kind} {element} has too few corners ({corners}); remove it or give it all its vertices"
            ),
            MeshError::RepeatedVertex {
                kind,
                element,
                vertex,
            } => write!(
                formatter,
                "{kind} {element} is degenerate: vertex {vertex} stands in it more than once; remove the {kind} or the \
                 repeated corner"
            ),
            MeshError::TooManyElements {
                kind,
                count,
                maximum,
            } => write!(
                formatter,
                "too many elements of kind {kind} ({count}): at most {maximum} can be numbered; split the mesh"
            ),
            MeshError::TooManyCorners { count, maximum } => write!(
                formatter,
                "faces or cells have too many corners in total ({count} or more): at most {maximum} can be indexed; split the mesh"
            ),
            MeshError::NumberOfMatrices { found } => write!(
                formatter,
                "expected one, two or three boundary matrices, found {found}; give ∂¹, ∂², … in order"
            ),
            MeshError::ShapeMismatch { k, rows, expected } => write!(
                formatter,
                "∂{k} has {rows} rows, but ∂{} has {expected} columns; both count the elements of dimension {}",
                k - 1,
                k - 1
            ),
            MeshError::InvalidEntry {
                k,
                row,
                column,
                value,
            } => write!(
                formatter,
                "entry ({row}, {column}) of ∂{k} is {value}; store only −1 and +1, and leave out zeros"
            ),
            MeshError::InvalidEdge { edge } => write!(
                formatter,
                "column {edge} of ∂1 is no edge; it must hold −1 at one vertex (tail) and +1 at another (head)"
            ),
            MeshError::NotAComplex { kind, element } => write!(
                formatter,
                "the boundary of {kind} {element} has a boundary (the product of the two boundary matrices is not \
                 zero); check the signs of its column"
            ),
            MeshError::TooFewSides { cell, sides } => write!(
                formatter,
                "cell {cell} has too few sides ({sides}); a cell has at least four"
            ),
            MeshError::RepeatedFace { cell } => write!(
                formatter,
                "cell {cell} has the same side twice; remove one of the two"
            ),
            MeshError::OpenCell { cell } => write!(
                formatter,
                "the sides of cell {cell} do not close; give all of them, each counter-clockwise seen from outside"
            ),
            MeshError::NotFinite { point } => write!(
                formatter,
                "point {point} has a coordinate that is infinite or not a number; remove the point"
            ),
            MeshError::InvalidRadius => {
                write!(
                    formatter,
                    "the radius is negative or not a number; give one that is at least 0"
                )
            }
            MeshError::NotAPolygon { face } => write!(
                formatter,
                "column {face} of ∂2 is no polygon; its edges must form one closed walk that meets no vertex twice"
            ),
        }
    }
}

impl Error for MeshError {}
