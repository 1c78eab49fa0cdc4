//! The syntax tree: what the author wrote, with a byte span on every node and nothing decided about types.
//!
//! Equality compares spans as well; [`super::print`] gives a text whose tree is equal up to spans.

use std::collections::BTreeSet;

use crate::span::Span;

/// A whole source file.
#[derive(Clone, Debug, PartialEq)]
pub struct Module {
    /// Items in textual order.
    pub items: Vec<Item>,
    /// Names in items that could not be read in full: they may be declared there, so nobody complains of them.
    pub lost: BTreeSet<String>,
}

/// A name with its place. Back-ticks are not part of the text; the text is in NFC.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// The name.
    pub text: String,
    /// Where it stands.
    pub span: Span,
}

/// One statement of a module.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// What it is.
    pub kind: ItemKind,
    /// All of it.
    pub span: Span,
}

/// The kinds of statements.
#[derive(Clone, Debug, PartialEq)]
pub enum ItemKind {
    /// `a, b as c from Module(M)`.
    Import(Import),
    /// Parameter declarations: a block headed by `where`/`given`, or a single declaration line.
    Parameters(Vec<Declaration>),
    /// `f_i(x) = … where …`.
    Function(Function),
    /// `y = …`, `a, b = …`, `y_ij = …`, `y += …`.
    Definition(Definition),
    /// A bare expression.
    Expression(Expr),
}

/// `names from module(arguments)`.
#[derive(Clone, Debug, PartialEq)]
pub struct Import {
    /// What is imported; `None` is `*`, everything.
    pub names: Option<Vec<ImportName>>,
    /// The module.
    pub module: Name,
    /// Module-level symbols handed to it.
    pub arguments: Vec<Name>,
}

/// `name as rename`.
#[derive(Clone, Debug, PartialEq)]
pub struct ImportName {
    /// Its name in the imported module.
    pub name: Name,
    /// Its name here.
    pub rename: Option<Name>,
}

/// `a, x_i ∈ ℝ³ index : text`.
#[derive(Clone, Debug, PartialEq)]
pub struct Declaration {
    /// The declared symbols.
    pub targets: Vec<Target>,
    /// `∈`, `:` or `⊂`.
    pub relation: Relation,
    /// The declared type.
    pub ty: Type,
    /// `index`, `vertices`, … after the type.
    pub attribute: Option<(Attribute, Span)>,
    /// Free text after the second colon.
    pub description: Option<String>,
    /// All of it.
    pub span: Span,
}

/// A declared symbol; with a subscript letter it is a sequence.
#[derive(Clone, Debug, PartialEq)]
pub struct Target {
    /// The symbol.
    pub name: Name,
    /// The subscript letter of a sequence.
    pub subscript: Option<Name>,
}

/// The sign between a declared symbol and its type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// `∈`.
    Member,
    /// `:`.
    Colon,
    /// `⊂`.
    Subset,
}

/// Says what the integers of a parameter are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Attribute {
    /// Host indices, from 0.
    Index,
    /// Vertices.
    Vertices,
    /// Edges.
    Edges,
    /// Faces.
    Faces,
    /// Cells.
    Cells,
}

/// ℝ or ℤ.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Number {
    /// ℝ.
    Real,
    /// ℤ.
    Integer,
}

/// A written type.
#[derive(Clone, Debug, PartialEq)]
pub struct Type {
    /// What it is.
    pub kind: TypeKind,
    /// Where it stands.
    pub span: Span,
}

/// The kinds of written types. Dimensions are expressions of integers, names, `name_name`, `#name` with
/// `+ - · /`, juxtaposition and parentheses.
#[derive(Clone, Debug, PartialEq)]
pub enum TypeKind {
    /// `ℝ`, `ℤ`, `scalar`.
    Scalar(Number),
    /// `ℝ^n`, `vector(n)`.
    Vector {
        /// Of which numbers.
        number: Number,
        /// Its length.
        length: Box<Expr>,
        /// Followed by `sparse`.
        sparse: bool,
    },
    /// `ℝ^(n×m)`, `matrix(n, m)`.
    Matrix {
        /// Of which numbers.
        number: Number,
        /// Number of rows.
        rows: Box<Expr>,
        /// Number of columns.
        columns: Box<Expr>,
        /// Followed by `sparse`.
        sparse: bool,
    },
    /// `{T}`; with several items `{T × U}` a set of tuples. `{ℝ^3}` and `{ℝ³}` are three scalars (the reference's
    /// rule), `{ℝ^(3)}` is a vector.
    Set(Vec<Type>),
    /// `{T ∨ U}`.
    SetOfAlternatives(Vec<Type>),
    /// `T × U`.
    Tuple(Vec<Type>),
    /// `T, U → V`; no parameters for `∅ → V`.
    Function {
        /// Types of the parameters.
        parameters: Vec<Type>,
        /// Types of the results.
        results: Vec<Type>,
    },
    /// `V → T`: a sequence indexed by the set `V`.
    Mapping {
        /// The index set.
        from: Name,
        /// Type of the values.
        to: Box<Type>,
    },
    /// `EdgeMesh`, `FaceMesh`, `CellMesh`.
    Mesh(MeshKind),
    /// `VertexSet`, `EdgeSet`, `FaceSet`, `CellSet`.
    ElementSet(ElementKind),
    /// `CellularSet`.
    CellularSet,
    /// A bare name: after `∈` an element of that set, after `⊂` a subset of it.
    Named(Name),
    /// An expression that is a set or an interval `[a, b]`, for variables of an optimisation.
    Members(Box<Expr>),
}

/// The kinds of meshes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum MeshKind {
    /// Vertices and edges.
    EdgeMesh,
    /// Vertices, edges and faces.
    FaceMesh,
    /// Vertices, edges, faces and cells.
    CellMesh,
}

/// The kinds of mesh elements, by dimension.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ElementKind {
    /// Dimension 0.
    Vertex,
    /// Dimension 1.
    Edge,
    /// Dimension 2.
    Face,
    /// Dimension 3.
    Cell,
}

/// `f_i,j(x, y) = body where declarations, locals`.
#[derive(Clone, Debug, PartialEq)]
pub struct Function {
    /// Its name.
    pub name: Name,
    /// Parameters written as subscripts; they come first.
    pub subscripts: Vec<Name>,
    /// Parameters in parentheses; `None` when there are no parentheses.
    pub parameters: Option<Vec<Name>>,
    /// The right-hand side.
    pub body: Expr,
    /// Types of the parameters.
    pub declarations: Vec<Declaration>,
    /// Local definitions, in any order.
    pub locals: Vec<Definition>,
}

/// `targets = value` or `target += value`.
#[derive(Clone, Debug, PartialEq)]
pub struct Definition {
    /// The left-hand sides; several for a destructuring.
    pub targets: Vec<LeftSide>,
    /// `+=` instead of `=`.
    pub add: bool,
    /// The right-hand side.
    pub value: Expr,
    /// All of it.
    pub span: Span,
}

/// `y`, `y_i`, `y_i,*`.
#[derive(Clone, Debug, PartialEq)]
pub struct LeftSide {
    /// The defined symbol.
    pub name: Name,
    /// Its subscripts, empty when there are none.
    pub subscripts: Vec<Subscript>,
}

/// One subscript.
#[derive(Clone, Debug, PartialEq)]
pub enum Subscript {
    /// An integer, a name, or any expression inside `_( )`.
    Expr(Expr),
    /// `*`: all of a row or column.
    All(Span),
}

/// An expression.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// Where it stands.
    pub span: Span,
}

/// The kinds of expressions.
#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind {
    /// An integer literal.
    Integer(i64),
    /// A decimal, exponent or vulgar fraction literal.
    Real(f64),
    /// `π`.
    Pi,
    /// `∞`.
    Infinity,
    /// A name that is not called.
    Name(Name),
    /// `base_i,j`.
    Subscript {
        /// What is indexed.
        base: Box<Expr>,
        /// The subscripts.
        subscripts: Vec<Subscript>,
    },
    /// `f_i(x)`: the name of a function with its arguments, those in subscripts first.
    Call {
        /// The function.
        function: Name,
        /// Arguments in subscripts.
        subscripts: Vec<Expr>,
        /// Arguments in parentheses.
        arguments: Vec<Expr>,
    },
    /// A prefix or postfix operator.
    Unary {
        /// The operator.
        op: UnaryOp,
        /// Its operand.
        operand: Box<Expr>,
    },
    /// An infix operator.
    Binary {
        /// The operator.
        op: BinaryOp,
        /// Left operand.
        left: Box<Expr>,
        /// Right operand.
        right: Box<Expr>,
        /// Where the operator stands; for a juxtaposition the empty place between the operands.
        op_span: Span,
    },
    /// `|x|` (absolute value, determinant, cardinality) and `‖x‖`.
    Norm {
        /// `‖…‖` or `||…||` instead of `|…|`.
        double: bool,
        /// What stands between the bars.
        operand: Box<Expr>,
        /// The subscript.
        subscript: Option<NormSubscript>,
    },
    /// `⟨a, b⟩_P`.
    Inner {
        /// Left operand.
        left: Box<Expr>,
        /// Right operand.
        right: Box<Expr>,
        /// The weight matrix.
        weight: Option<Box<Expr>>,
    },
    /// `(a, b, c)`: a column vector, or a tuple before `∈`.
    Vector(Vec<Expr>),
    /// `[a b; c d]`: rows of cells.
    Matrix(Vec<Vec<Expr>>),
    /// `{a, b}`; `{}` and `∅` are empty.
    Set(Vec<Expr>),
    /// `{element for variables ∈ range if condition}`.
    Builder {
        /// The element.
        element: Box<Expr>,
        /// The bound variables.
        variables: Vec<Name>,
        /// The set they run over.
        range: Box<Expr>,
        /// Which of them are taken.
        condition: Option<Box<Condition>>,
    },
    /// `0_n,m`, `1_n`, `𝟙_n`.
    NumberMatrix {
        /// Ones instead of zeros.
        ones: bool,
        /// Number of rows.
        rows: Box<Expr>,
        /// Number of columns; a vector when absent.
        columns: Option<Box<Expr>>,
    },
    /// `∑`, `∏`, big `∪`.
    Big {
        /// Which.
        op: BigOp,
        /// What the index runs over.
        head: Head,
        /// One term.
        body: Box<Expr>,
        /// Definitions that may use the index.
        locals: Vec<Definition>,
    },
    /// `{ a if p; b otherwise`.
    Piecewise {
        /// Values with their conditions, tested in order.
        branches: Vec<(Expr, Condition)>,
        /// The value when no condition holds.
        otherwise: Option<Box<Expr>>,
    },
    /// `argmin_(x ∈ ℝ^n) f s.t. …`.
    Optimise {
        /// Which.
        kind: OptimiseKind,
        /// The variables.
        variables: Vec<Declaration>,
        /// What is optimised.
        objective: Box<Expr>,
        /// The constraints.
        constraints: Vec<Condition>,
        /// Initial values.
        initial: Vec<Definition>,
    },
    /// `∫_[a,b] f 𝕕t`.
    Integral {
        /// The variable.
        variable: Name,
        /// Lower bound.
        from: Box<Expr>,
        /// Upper bound.
        to: Box<Expr>,
        /// The integrand.
        body: Box<Expr>,
    },
    /// `∂²y/∂a∂b`.
    Derivative {
        /// `𝕕` instead of `∂`.
        total: bool,
        /// The order on the numerator.
        order: u32,
        /// What is differentiated.
        numerator: Box<Expr>,
        /// With respect to what, each with its own order.
        denominators: Vec<(Expr, u32)>,
    },
    /// `∇_x y`; without a variable `∇ y`.
    Gradient {
        /// With respect to what.
        variable: Option<Box<Expr>>,
        /// What is differentiated.
        operand: Box<Expr>,
    },
    /// `Δ y`.
    Laplacian(Box<Expr>),
    /// `∇⋅ y`.
    Divergence(Box<Expr>),
    /// What could not be parsed; a diagnostic has been given.
    Error,
}

/// The subscript of a norm.
#[derive(Clone, Debug, PartialEq)]
pub enum NormSubscript {
    /// A number or symbol: the exponent, a weight matrix, or `F`.
    Expr(Box<Expr>),
    /// `∞`.
    Infinity,
    /// `*`: the nuclear norm.
    Nuclear,
}

/// Prefix and postfix operators.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum UnaryOp {
    /// `-a`.
    Negate,
    /// `√a`.
    SquareRoot,
    /// `aᵀ`.
    Transpose,
    /// `a⁻¹`.
    Inverse,
    /// `a⁺`.
    PseudoInverse,
    /// `#a`.
    Size,
}

/// Infix operators.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum BinaryOp {
    /// `a + b`.
    Add,
    /// `a - b`.
    Subtract,
    /// `a ± b`, in conditions only.
    PlusMinus,
    /// `a b`.
    Juxtapose,
    /// `a ⋅ b`.
    Dot,
    /// `a / b`.
    Divide,
    /// `a × b`.
    Cross,
    /// `a ∘ b`.
    Hadamard,
    /// `a ⊗ b`.
    Kronecker,
    /// `a : b`.
    Frobenius,
    /// `a \ b`: solve, or set difference.
    Solve,
    /// `a ∪ b`.
    Union,
    /// `a ∩ b`.
    Intersection,
    /// `a^b`.
    Power,
}

/// Big operators.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum BigOp {
    /// `∑`.
    Sum,
    /// `∏`.
    Product,
    /// `∪`.
    Union,
}

/// What the index of a big operator runs over.
#[derive(Clone, Debug, PartialEq)]
pub enum Head {
    /// `∑_i`: the range follows from the use of `i` as a subscript.
    Index(Name),
    /// `∑_(i for condition)`.
    Filtered(Name, Box<Condition>),
    /// `∑_(i, j ∈ range)`.
    Members(Vec<Name>, Box<Expr>),
    /// `∑_(i = a)^b`.
    Range(Name, Box<Expr>, Box<Expr>),
}

/// Which optimum.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum OptimiseKind {
    /// The least value.
    Min,
    /// The greatest value.
    Max,
    /// Where the least value is taken.
    ArgMin,
    /// Where the greatest value is taken.
    ArgMax,
}

/// A condition.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    /// What it is.
    pub kind: ConditionKind,
    /// Where it stands.
    pub span: Span,
}

/// The kinds of conditions.
#[derive(Clone, Debug, PartialEq)]
pub enum ConditionKind {
    /// `a and b`.
    And(Box<Condition>, Box<Condition>),
    /// `a or b`.
    Or(Box<Condition>, Box<Condition>),
    /// `a < b`.
    Compare {
        /// The relation.
        op: CompareOp,
        /// Left side.
        left: Box<Expr>,
        /// Right side.
        right: Box<Expr>,
    },
    /// `a ∈ S`, `(i, j) ∈ S`, `a ∉ S`.
    Member {
        /// The item; a tuple is an [`ExprKind::Vector`].
        item: Box<Expr>,
        /// `∉`.
        negated: bool,
        /// The set.
        set: Box<Expr>,
    },
    /// What could not be parsed; a diagnostic has been given.
    Error,
}

/// Relations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum CompareOp {
    /// `=`.
    Equal,
    /// `≠`.
    NotEqual,
    /// `<`.
    Less,
    /// `≤`.
    LessOrEqual,
    /// `>`.
    Greater,
    /// `≥`.
    GreaterOrEqual,
}
