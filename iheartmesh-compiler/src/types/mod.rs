//! The vocabulary of types: what a value is, how long it is, which mesh it belongs to.
//!
//! Types are plain values: equality is structural and no source position is kept in them.

mod dimension;
pub mod display;

pub use crate::syntax::ast::{ElementKind, MeshKind, Number};
pub use dimension::{Atom, Dimension, Place};

/// Index of a mesh among the inputs of a program: the *owner* of elements, element sets and matrices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct MeshId(pub u32);

/// A kind of element of one mesh; as a set, all elements of that kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Element {
    /// Vertex, edge, face or cell.
    pub kind: ElementKind,
    /// The mesh that it belongs to.
    pub mesh: MeshId,
}

/// The type of a value.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Type {
    /// ℝ or ℤ.
    Scalar(Number),
    /// The outcome of a condition; not a type that a program can write.
    Boolean,
    /// A vertex, edge, face or cell of a mesh.
    Element(Element),
    /// A column vector.
    Vector {
        /// Of which numbers.
        number: Number,
        /// Number of entries.
        length: Dimension,
        /// Stored as a sparse vector.
        sparse: bool,
        /// For a chain (an indicator vector or a product with a boundary matrix): what its entries stand for.
        space: Option<Element>,
    },
    /// A matrix.
    Matrix {
        /// Of which numbers.
        number: Number,
        /// Number of rows.
        rows: Dimension,
        /// Number of columns.
        columns: Dimension,
        /// Stored as a sparse matrix.
        sparse: bool,
        /// For a boundary matrix: what its rows and its columns stand for.
        spaces: Option<(Element, Element)>,
    },
    /// `x_i ∈ T`, or `x : V → T` with an index set.
    Sequence {
        /// Type of the items.
        item: Box<Type>,
        /// Number of items.
        length: Dimension,
        /// The elements that index it, where declared.
        index: Option<Element>,
    },
    /// A sorted set without repetitions.
    Set(Box<Type>),
    /// A tuple.
    Tuple(Vec<Type>),
    /// Sets of vertices, edges, faces and cells of one mesh; `None` when it is not known which.
    CellularSet(Option<MeshId>),
    /// A function handed in by the host.
    Function {
        /// Types of the parameters.
        parameters: Vec<Type>,
        /// Type of the result.
        result: Box<Type>,
    },
    /// A mesh.
    Mesh(MeshKind, MeshId),
    /// The type of what is in error; it agrees with everything, so that one mistake gives one message.
    Error,
}

impl Type {
    /// ℝ.
    pub const REAL: Type = Type::Scalar(Number::Real);
    /// ℤ.
    pub const INTEGER: Type = Type::Scalar(Number::Integer);

    /// The set of these.
    pub fn set_of(item: Type) -> Type {
        Type::Set(Box::new(item))
    }

    /// A dense real column vector of a fixed length.
    pub fn vector(length: i64) -> Type {
        Type::Vector {
            number: Number::Real,
            length: Dimension::known(length),
            sparse: false,
            space: None,
        }
    }

    /// A dense real column vector.
    pub fn real_vector(length: Dimension) -> Type {
        Type::Vector {
            number: Number::Real,
            length,
            sparse: false,
            space: None,
        }
    }

    /// A dense real matrix.
    pub fn real_matrix(rows: Dimension, columns: Dimension) -> Type {
        Type::Matrix {
            number: Number::Real,
            rows,
            columns,
            sparse: false,
            spaces: None,
        }
    }

    /// A sparse real matrix.
    pub fn sparse_matrix(rows: Dimension, columns: Dimension) -> Type {
        Type::Matrix {
            number: Number::Real,
            rows,
            columns,
            sparse: true,
            spaces: None,
        }
    }

    /// Number, vector or matrix, with its size; nothing for what else there is, chains and boundary matrices among it.
    pub fn shape(&self) -> Option<Shape> {
        match self {
            Type::Scalar(_) => Some(Shape::Scalar),
            Type::Vector {
                length,
                space: None,
                ..
            } => Some(Shape::Vector(length.clone())),
            Type::Matrix {
                rows,
                columns,
                spaces: None,
                ..
            } => Some(Shape::Matrix(rows.clone(), columns.clone())),
            _ => None,
        }
    }

    /// Whether it is a sparse vector or matrix.
    pub fn is_sparse(&self) -> bool {
        matches!(
            self,
            Type::Vector { sparse: true, .. } | Type::Matrix { sparse: true, .. }
        )
    }

    /// Whether a type is that of sparse matrices, or of vectors and matrices whose size the program does not fix.
    pub fn is_of_any_size(&self) -> bool {
        let fixed = |n: &Dimension| n.value().is_some();
        match self.shape() {
            _ if self.is_integer() => false,
            Some(Shape::Matrix(n, m)) => self.is_sparse() || !(fixed(&n) && fixed(&m)),
            Some(Shape::Vector(n)) => !self.is_sparse() && !fixed(&n),
            _ => false,
        }
    }

    /// Whether its numbers are integers.
    pub fn is_integer(&self) -> bool {
        matches!(
            self,
            Type::Scalar(Number::Integer)
                | Type::Vector {
                    number: Number::Integer,
                    ..
                }
                | Type::Matrix {
                    number: Number::Integer,
                    ..
                }
        )
    }

    /// The same with real numbers.
    pub fn with_reals(&self) -> Type {
        let mut ty = self.clone();
        if let Type::Scalar(number) | Type::Vector { number, .. } | Type::Matrix { number, .. } =
            &mut ty
        {
            *number = Number::Real;
        }
        ty
    }

    /// Whether it is the type of what is in error, or is made of such.
    pub fn is_error(&self) -> bool {
        match self {
            Type::Error => true,
            Type::Set(item) => item.is_error(),
            Type::Sequence { item, .. } => item.is_error(),
            Type::Tuple(items) => items.iter().any(Type::is_error),
            _ => false,
        }
    }

    /// Whether it is ℝ or ℤ.
    pub fn is_scalar(&self) -> bool {
        matches!(self, Type::Scalar(_))
    }

    /// Whether it is an element of a mesh.
    pub fn is_element(&self) -> bool {
        matches!(self, Type::Element(_))
    }

    /// The elements that a set of elements has.
    pub fn element_of_set(&self) -> Option<Element> {
        match self {
            Type::Set(item) => match **item {
                Type::Element(element) => Some(element),
                _ => None,
            },
            _ => None,
        }
    }

    /// Calls `f` with each unknown number in its sizes.
    pub fn atoms(&self, f: &mut impl FnMut(&Atom)) {
        let mut of = |size: &Dimension| size.terms().flat_map(|(_, atoms)| atoms).for_each(&mut *f);
        match self {
            Type::Vector { length, .. } => of(length),
            Type::Matrix { rows, columns, .. } => {
                of(rows);
                of(columns);
            }
            Type::Sequence { item, length, .. } => {
                of(length);
                item.atoms(f);
            }
            Type::Set(item) => item.atoms(f),
            Type::Tuple(items) => items.iter().for_each(|item| item.atoms(f)),
            Type::Function { parameters, result } => {
                parameters.iter().for_each(|item| item.atoms(f));
                result.atoms(f);
            }
            _ => {}
        }
    }

    /// Whether all of its sizes are numbers; so it is for what has none.
    pub fn is_fixed(&self) -> bool {
        match self {
            Type::Vector { length, .. } => length.value().is_some(),
            Type::Matrix { rows, columns, .. } => {
                rows.value().is_some() && columns.value().is_some()
            }
            Type::Sequence { item, .. } | Type::Set(item) => item.is_fixed(),
            Type::Tuple(items) => items.iter().all(Type::is_fixed),
            _ => true,
        }
    }

    /// The type with the unknowns in its sizes replaced.
    pub fn with_atoms(&self, replace: &dyn Fn(&Atom) -> Option<Atom>) -> Type {
        self.with_sizes(&|size| size.substitute(&|atom| replace(atom).map(Dimension::atom)))
    }

    /// The type with its sizes replaced.
    pub fn with_sizes(&self, replace: &dyn Fn(&Dimension) -> Dimension) -> Type {
        let mut ty = self.clone();
        match &mut ty {
            Type::Vector { length, .. } => *length = replace(length),
            Type::Matrix { rows, columns, .. } => {
                *rows = replace(rows);
                *columns = replace(columns);
            }
            Type::Sequence { item, length, .. } => {
                **item = item.with_sizes(replace);
                *length = replace(length);
            }
            Type::Set(item) => **item = item.with_sizes(replace),
            Type::Tuple(items) => items
                .iter_mut()
                .for_each(|item| *item = item.with_sizes(replace)),
            _ => {}
        }
        ty
    }

    /// The length of a dense vector of a fixed number of reals or integers.
    pub fn fixed_vector(&self) -> Option<i64> {
        match self {
            Type::Vector {
                length,
                sparse: false,
                ..
            } => length.value(),
            _ => None,
        }
    }
}

/// What has a size of its own.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A number.
    Scalar,
    /// A column vector of this length.
    Vector(Dimension),
    /// A matrix of so many rows and columns.
    Matrix(Dimension, Dimension),
}

impl Shape {
    /// The dense real type of this shape.
    pub fn real(self) -> Type {
        match self {
            Shape::Scalar => Type::REAL,
            Shape::Vector(length) => Type::real_vector(length),
            Shape::Matrix(rows, columns) => Type::real_matrix(rows, columns),
        }
    }
}

/// All kinds of elements in order of their dimension.
pub const ELEMENT_KINDS: [ElementKind; 4] = [
    ElementKind::Vertex,
    ElementKind::Edge,
    ElementKind::Face,
    ElementKind::Cell,
];

/// Dimension of an element: 0 for a vertex to 3 for a cell.
pub fn element_dimension(kind: ElementKind) -> usize {
    kind as usize
}

/// The highest dimension of the elements of a mesh.
pub fn mesh_dimension(kind: MeshKind) -> usize {
    match kind {
        MeshKind::EdgeMesh => 1,
        MeshKind::FaceMesh => 2,
        MeshKind::CellMesh => 3,
    }
}
