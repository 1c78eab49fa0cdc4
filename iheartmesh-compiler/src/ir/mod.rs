//! The intermediate language: one small, pure, typed expression language.
//!
//! An expression is a node of an [`Arena`]. Structurally equal expressions are one node (hash-consing), so a
//! value that is used twice is written once. Binders are explicit: a node that binds a [`VariableId`] holds it, and
//! every variable is bound at one place. *When* an expression is evaluated is not part of the language: the
//! only expressions that must not be evaluated before their place are the branches of [`Kind::If`], the right side
//! of [`Kind::And`] and [`Kind::Or`], and what stands inside a binder, because they may fail or not end.
//!
//! Elements are host numbers (from 0), integers are mathematical (from 1 where they index).
//!
//! **Invariant:** nothing here knows the syntax tree or Rust. Types agree as [`validate`] says, after every
//! pass.

mod arena;
mod display;
mod failure;
mod listing;
mod program;
mod unproven;
pub mod validate;

pub use arena::{Arena, ExprId, Node};
pub use display::expression;
pub use failure::{failure, no_optimum};
pub use listing::{program, types};
pub use program::{
    Export, Function, FunctionId, Global, GlobalId, Input, InputId, MeshInput, Pairs, Parameter,
    Pass, Program, Site, Tie, Together,
};

pub use unproven::{Axis, is_of_unknown_size, unproven};

pub use crate::syntax::ast::CompareOp;
use crate::types::{Dimension, Element, MeshId};

/// A bound variable or a function's parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct VariableId(pub u32);

/// Operations with one operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Unary {
    /// `-a`.
    Negate,
    /// `|a|` of a number.
    Absolute,
    /// `√a`.
    SquareRoot,
    /// `‖a‖₂` of a vector, the Frobenius norm of a matrix.
    Norm,
    /// The sum of the absolute values of the entries.
    NormOne,
    /// The largest absolute value of the entries.
    NormMax,
    /// The number of entries other than 0.
    NormZero,
    /// The sum of the singular values.
    NormNuclear,
    /// `aᵀ`.
    Transpose,
    /// `a⁻¹` of a matrix.
    Inverse,
    /// `a⁺`.
    PseudoInverse,
    /// The determinant.
    Determinant,
    /// The sum of the diagonal.
    Trace,
    /// The rank.
    Rank,
    /// The diagonal of a matrix, or the matrix with this diagonal.
    Diagonal,
    /// The columns of a matrix, or the items of a sequence, one below the other.
    Stack,
    /// A basis of the kernel, in columns.
    NullSpace,
    /// A basis of the column space, in columns.
    OrthogonalBasis,
    /// The singular value decomposition: a tuple of `U`, the singular values, `V`.
    SingularValues,
    /// The least entry of a vector or matrix, the least item of a sequence.
    Least,
    /// The greatest entry of a vector or matrix, the greatest item of a sequence.
    Greatest,
    /// The positive semi-definite matrix nearest to a symmetric one.
    PositivePart,
    /// A symmetric matrix with the absolute values of its eigenvalues.
    AbsolutePart,
    /// A vector as a matrix with one column, a 1×1 matrix as a number, and back: the type says which.
    Reshape,
    /// An integer as a real number; a boundary matrix as a sparse matrix of real numbers.
    ToReal,
    /// The mathematical number of an element: its host number plus one.
    ToInteger,
    /// The element with a mathematical number; the number is that of one.
    ToElement,
    /// The same sparse matrix, stored so that its rows can be walked along.
    ByRows,
    /// The same sparse matrix, stored so that its columns can be walked along.
    ByColumns,
    /// Integers that the host counts from 0, counted from 1: each integer in the value plus one.
    FromHost,
    /// A function of one real number, or of each entry of a vector.
    Apply(Elementary),
}

/// Elementary functions of one real number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[expect(missing_docs, reason = "each is the function of its name")]
pub enum Elementary {
    Sin,
    Cos,
    Tan,
    Cot,
    Sec,
    Csc,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
    Asinh,
    Acosh,
    Atanh,
    Exp,
    Ln,
    Log2,
    Log10,
}

/// Operations with two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Binary {
    /// Sum of numbers or of vectors.
    Add,
    /// Difference of numbers or of vectors.
    Subtract,
    /// A number times a number or a vector; the number is on the left.
    Multiply,
    /// A number or a vector divided by a number.
    Divide,
    /// A number to the power of a number.
    Power,
    /// Dot product of vectors.
    Dot,
    /// Cross product of vectors of length 3.
    Cross,
    /// `atan2(y, x)`.
    Atan2,
    /// The lesser number.
    Min,
    /// The greater number.
    Max,
    /// The product of matrices, or of a matrix and a vector.
    Product,
    /// The product entry by entry.
    Hadamard,
    /// The Kronecker product.
    Kronecker,
    /// The sum of the products of the entries.
    Frobenius,
    /// The solution `x` of `a x = b`.
    Solve,
    /// A matrix to an integer or real power.
    MatrixPower,
    /// `‖a‖_p` with any exponent `p`.
    NormPower,
    /// `√(aᵀ P a)`.
    NormWeighted,
    /// The inverse of [`Unary::Stack`]: the entries of the right side in the shape of the left one.
    Unstack,
    /// A sequence with an item added at the end.
    Append,
}

/// What an element-wise definition makes of its values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Layout {
    /// Numbers as the entries of a vector.
    Vector,
    /// Values as the items of a sequence.
    Sequence,
    /// Numbers as the entries of a matrix.
    Matrix,
    /// Vectors as the rows of a matrix.
    Rows,
    /// Vectors as the columns of a matrix.
    Columns,
    /// Numbers on the diagonal of a sparse matrix.
    Diagonal,
    /// Numbers as the entries of a sparse matrix, of which those that are 0 are not stored.
    Sparse,
}

/// Operations with two sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SetOp {
    /// Elements of either.
    Union,
    /// Elements of both.
    Intersection,
    /// Elements of the left one only.
    Difference,
}

/// Big operators.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Fold {
    /// `∑`.
    Sum,
    /// `∏`.
    Product,
    /// Big `∪`.
    Union,
    /// The least value; fails when there is none.
    Min,
    /// The greatest value; fails when there is none.
    Max,
    /// The body is a tuple of a number and a value: the value that stands with the least number, the first of several;
    /// fails when there is none.
    ArgMin,
    /// The same with the greatest number.
    ArgMax,
    /// `{ … for … }`: the set of the values.
    Collect,
}

/// What a bound variable runs over.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Range {
    /// The members of a set, ascending.
    Set(ExprId),
    /// The integers from the first to the second, both included.
    Integers(ExprId, ExprId),
    /// The rows of a plan: the space that has the bound variable's name. The variable's own value is a column. `of` is the
    /// variable whose rows these belong to, if they differ from one of its rows to the next: the loop depends on it.
    Rows {
        /// The variable of the space that this one is below.
        of: Option<VariableId>,
    },
}

/// What restricts the variables of a [`Kind::Optimum`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Restriction {
    /// Each entry of the value is 0; it is under the variables.
    Equal(ExprId),
    /// No entry of the value is above 0; it is under the variables.
    AtMost(ExprId),
    /// The variable of this number, from 0, is not below a value entry by entry; one number holds for all entries. The
    /// value does not know the variables.
    Lower(u32, ExprId),
    /// The variable of this number is not above a value.
    Upper(u32, ExprId),
}

/// One boundary matrix of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Boundary {
    /// The mesh.
    pub mesh: MeshId,
    /// Its columns are the elements of this dimension, its rows those of one less: 1 for vertices by edges.
    pub dimension: u8,
    /// Entries with signs, or their absolute values.
    pub signed: bool,
    /// Rows and columns exchanged.
    pub transposed: bool,
}

/// How an element stands beside two others. Each is the first of a set of such elements, found without the set.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Neighbor {
    /// An edge that has both vertices; of one vertex any of its edges.
    EdgeBetween(MeshId),
    /// A vertex of the edges e of a face f at its vertex v where ∂²\[e, f\] ∂¹\[v, e\] is the sign, other than v: the next one
    /// around the face for −1, the one before for +1.
    VertexInFace(MeshId, i8),
    /// A face f at an edge e where ∂²\[e, f\] ∂¹\[v, e\] with a vertex v is the sign.
    FaceWith(MeshId, i8),
    /// A face at an edge where that is not the sign.
    FaceWithout(MeshId, i8),
}

/// A value that is added to an array, whole or in pieces.
///
/// The rows of the value are divided evenly among the places in `rows`: the piece for place `p`, an element or a number
/// from 1, of height `h` goes to the rows from `(p - 1) h + 1`. Columns likewise. For a vector there are no columns; a matrix
/// that is added to one is taken column by column.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Block {
    /// Where its rows go.
    pub rows: Vec<ExprId>,
    /// Where its columns go.
    pub columns: Vec<ExprId>,
    /// The value.
    pub value: ExprId,
    /// A symmetric matrix, smaller than the value: where it is positive semi-definite, so is the value. Kept only where
    /// eigenvalues of the value are replaced; it has no part in what the block adds.
    pub core: Option<ExprId>,
}

/// The kinds of expressions.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Kind {
    /// An integer.
    Integer(i64),
    /// A real number, by its bits.
    Real(u64),
    /// Truth.
    Boolean(bool),
    /// A bound variable.
    Variable(VariableId),
    /// A value handed in by the host.
    Input(InputId),
    /// A definition without parameters.
    Global(GlobalId),
    /// All elements of a kind.
    AllElements(Element),
    /// A boundary matrix.
    Boundary(Boundary),
    /// A call of a function of the program.
    Call(FunctionId, Vec<ExprId>),
    /// One operand.
    Unary(Unary, ExprId),
    /// Two operands.
    Binary(Binary, ExprId, ExprId),
    /// A comparison of numbers, elements or sets.
    Compare(CompareOp, ExprId, ExprId),
    /// The right side is evaluated only when the left one holds.
    And(ExprId, ExprId),
    /// The right side is evaluated only when the left one does not hold.
    Or(ExprId, ExprId),
    /// Negation of a condition.
    Not(ExprId),
    /// A column vector of numbers.
    Vector(Vec<ExprId>),
    /// An entry of a vector, by its number from 1.
    Component(ExprId, ExprId),
    /// An item of a sequence, by an element or by its number from 1.
    Item(ExprId, ExprId),
    /// A size: the number of items or rows (0), of columns (1).
    Extent(ExprId, u8),
    /// A size by its symbols.
    Size(Dimension),
    /// An entry of a matrix, by its numbers from 1.
    At(ExprId, ExprId, ExprId),
    /// Of a sparse matrix the set of the columns in which a row has stored entries (0), or of the rows in which a column
    /// has (1); all are numbers from 1. The matrix is [`Unary::ByRows`] or [`Unary::ByColumns`].
    Stored(ExprId, u8, ExprId),
    /// A row of a matrix as a vector, by its number from 1.
    RowOf(ExprId, ExprId),
    /// A column of a matrix as a vector, by its number from 1.
    ColumnOf(ExprId, ExprId),
    /// A matrix by its rows of blocks: numbers, vectors and matrices.
    Blocks(Vec<Vec<ExprId>>),
    /// A vector or matrix with one number everywhere, by its sizes; a vector has one.
    Filled(ExprId, Vec<ExprId>),
    /// The identity matrix of a size.
    Identity(ExprId),
    /// An element-wise definition: the body for all values of the variables, from 1 to the sizes.
    Tabulate {
        /// What is made of the values.
        layout: Layout,
        /// The indices.
        variables: Vec<VariableId>,
        /// How far each runs.
        sizes: Vec<ExprId>,
        /// The value for each.
        body: ExprId,
    },
    /// A sparse matrix: for each member of a set a number at a row and a column, both from 1. Numbers at one place add
    /// up; what has none is 0. Fails for a place outside of the sizes.
    Scatter {
        /// The member.
        variable: VariableId,
        /// What it runs over, ascending.
        set: ExprId,
        /// The numbers of rows and columns.
        sizes: [ExprId; 2],
        /// The row and the column for each member.
        place: [ExprId; 2],
        /// The number for each.
        body: ExprId,
    },
    /// A vector, matrix or sequence with entries replaced one after the other: the subscripts of each, from 1, with its
    /// value. A subscript that is missing stands for all: the value is a row or a column. Fails for a place outside.
    Update(ExprId, Vec<(Vec<Option<ExprId>>, ExprId)>),
    /// An array of zeros to which blocks are added: what derivatives are put together from.
    Assemble {
        /// Its number of entries, or of rows and columns.
        sizes: Vec<ExprId>,
        /// What is added.
        blocks: Vec<Block>,
    },
    /// A sequence by its items.
    Sequence(Vec<ExprId>),
    /// A set as a sequence, ascending.
    SequenceOf(ExprId),
    /// A call of a function that the host handed in: an input, or an item of an input that is a sequence.
    HostCall(ExprId, Vec<ExprId>),
    /// Two sizes that must agree at run time, then the value.
    Agree(ExprId, ExprId, ExprId),
    /// A tuple.
    Tuple(Vec<ExprId>),
    /// An item of a tuple, from 0.
    Project(ExprId, u32),
    /// A set by its members.
    Set(Vec<ExprId>),
    /// Two sets.
    SetOp(SetOp, ExprId, ExprId),
    /// Number of members.
    Cardinality(ExprId),
    /// A member of a set in ascending order, by its number from 1; fails when there is none.
    SetItem(ExprId, ExprId),
    /// An element beside two others; fails when there is none. The pass `steps` makes these.
    Neighbor(Neighbor, ExprId, ExprId),
    /// A set (left) that must have exactly as many members as the number says; fails otherwise.
    Sized(ExprId, u32),
    /// Whether an item is a member of a set.
    Member(ExprId, ExprId),
    /// The chain that is 1 at the members of a set.
    Indicator(ExprId),
    /// Product of a boundary matrix and a chain.
    Apply(Boundary, ExprId),
    /// The elements where a chain is not 0.
    NonZeros(ExprId),
    /// The elements where a chain has the value on the right.
    ValueSet(ExprId, ExprId),
    /// The elements that a boundary matrix connects to a member of the set: the non-zero entries of its unsigned
    /// product with the indicator of the set.
    Traverse(Boundary, ExprId),
    /// An entry of a boundary matrix, by row and column element.
    Entry(Boundary, ExprId, ExprId),
    /// A loop.
    Fold {
        /// How the values are put together.
        op: Fold,
        /// The bound variable.
        variable: VariableId,
        /// What it runs over.
        range: Range,
        /// Which of them are taken.
        condition: Option<ExprId>,
        /// The value for each.
        body: ExprId,
    },
    /// The least or greatest value of a real number, and where it is taken: a tuple of the value and, for each variable,
    /// its own. The search begins at the start values and ends at a local optimum: within 10⁻⁶ of the slopes around it, or
    /// where no method finds a better point. Fails when the objective goes on without a bound, when no point
    /// satisfies the restrictions, when the search does not settle.
    Optimum {
        /// The greatest value instead of the least.
        greatest: bool,
        /// The variables: real numbers, vectors, matrices, or sequences of them.
        variables: Vec<VariableId>,
        /// Their start values, which also say how large they are; these do not know the variables.
        start: Vec<ExprId>,
        /// What holds at the optimum.
        restrictions: Vec<Restriction>,
        /// The number.
        objective: ExprId,
    },
    /// The integral of a real number from one bound to another, either of which may be infinite. Fails when it is not
    /// known up to 10⁻¹⁰ of itself.
    Integral {
        /// A real number between the bounds.
        variable: VariableId,
        /// The lower bound, a real number.
        from: ExprId,
        /// The upper bound, a real number.
        to: ExprId,
        /// The integrand.
        body: ExprId,
    },
    /// A choice; only the chosen branch is evaluated.
    If(ExprId, ExprId, ExprId),
    /// No case applies.
    Fail,
    /// A column of the current row of a plan: of the space with this variable.
    Column(VariableId, u32),
    /// The value of a function of one element that has been computed for all elements beforehand.
    Field(FunctionId, ExprId),
}
