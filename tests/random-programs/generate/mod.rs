//! Random programs that are well typed by construction, with values for their parameters.

mod agree;
mod data;
mod energy;
mod expression;
mod numbers;
mod program;
mod run;
mod sets;

pub use agree::agree;
pub use data::{Datum, Polygons};
pub use energy::{Energy, energy};
pub use program::program;
pub use run::{Form, compile, deep, evaluate, interpret, seeds};

use std::collections::BTreeMap;

/// A program with all that is needed to run it.
#[derive(Clone)]
pub struct Generated {
    /// The text.
    pub source: String,
    /// Its mesh, if it has one.
    pub mesh: Option<Polygons>,
    /// Its parameters in order, without the mesh.
    pub inputs: Vec<(String, Datum)>,
    /// Definitions to ask for.
    pub definitions: Vec<String>,
    /// Functions to call, with arguments.
    pub calls: Vec<(String, Vec<Datum>)>,
    /// Functions to evaluate for all elements.
    pub fields: Vec<(String, Kind)>,
}

/// Kinds of elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    Vertex,
    Edge,
    Face,
}

impl Kind {
    pub const ALL: [Kind; 3] = [Kind::Vertex, Kind::Edge, Kind::Face];

    /// The set of all of them in the program.
    pub fn set(self) -> &'static str {
        match self {
            Kind::Vertex => "V",
            Kind::Edge => "E",
            Kind::Face => "F",
        }
    }

    /// The neighbourhood with elements of this kind.
    pub fn neighbours(self) -> &'static str {
        match self {
            Kind::Vertex => "Vertices",
            Kind::Edge => "Edges",
            Kind::Face => "Faces",
        }
    }

    /// The handle in Rust.
    pub fn handle(self) -> &'static str {
        match self {
            Kind::Vertex => "Vertex",
            Kind::Edge => "Edge",
            Kind::Face => "Face",
        }
    }
}

/// Sizes: some known in the program, some by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Size {
    Known(usize),
    N,
    M,
    /// A size that only the parameters of a function name.
    Own,
}

impl Size {
    pub const ALL: [Size; 5] = [
        Size::Known(2),
        Size::Known(3),
        Size::Known(5),
        Size::N,
        Size::M,
    ];

    pub fn text(self) -> String {
        match self {
            Size::Known(n) => n.to_string(),
            Size::N => "n".to_owned(),
            Size::M => "m".to_owned(),
            Size::Own => "g".to_owned(),
        }
    }
}

/// Types of the programs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Ty {
    Real,
    Integer,
    Vector(Size),
    Matrix(Size, Size),
    Sparse,
    Integers,
    /// `x_k ∈ ℝ³`
    Points,
    /// `q_k ∈ ℝ`
    Weights,
    SetOf(Member),
    Element(Kind),
    /// `x : V → ℝ³` and `m_e : E → ℝ`.
    FieldOfPoints,
    Field(Kind),
    Function,
    /// An index whose range follows from what it indexes.
    Index,
}

/// Members of sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Member {
    Integer,
    Real,
    Pair,
    Element(Kind),
}

impl Ty {
    /// The type with another size in place of that of a function.
    pub fn with(self, own: Size) -> Ty {
        let replaced = |size| if size == Size::Own { own } else { size };
        match self {
            Ty::Vector(n) => Ty::Vector(replaced(n)),
            Ty::Matrix(n, m) => Ty::Matrix(replaced(n), replaced(m)),
            other => other,
        }
    }

    /// As a program declares it: the part behind the name.
    pub fn declared(self) -> String {
        match self {
            Ty::Real => "∈ ℝ".to_owned(),
            Ty::Integer => "∈ ℤ".to_owned(),
            Ty::Vector(n) => format!("∈ ℝ^{}", n.text()),
            Ty::Matrix(n, m) => format!("∈ ℝ^({}×{})", n.text(), m.text()),
            Ty::Sparse => "∈ ℝ^(n×n) sparse".to_owned(),
            Ty::Integers => "∈ ℤ^n".to_owned(),
            Ty::Points => "∈ ℝ³".to_owned(),
            Ty::Weights => "∈ ℝ".to_owned(),
            Ty::SetOf(Member::Integer) => "∈ {ℤ}".to_owned(),
            Ty::SetOf(Member::Real) => "∈ {ℝ}".to_owned(),
            Ty::SetOf(Member::Pair) => "∈ {ℤ × ℤ}".to_owned(),
            Ty::SetOf(Member::Element(kind)) => format!("⊂ {}", kind.set()),
            Ty::Element(kind) => format!("∈ {}", kind.set()),
            Ty::FieldOfPoints => ": V → ℝ³".to_owned(),
            Ty::Field(kind) => format!(": {} → ℝ", kind.set()),
            Ty::Function => "∈ ℝ → ℝ".to_owned(),
            Ty::Index => panic!("an index is no parameter"),
        }
    }
}

/// A function of the program.
#[derive(Clone)]
pub struct Signature {
    pub name: String,
    pub parameters: Vec<Ty>,
    pub result: Ty,
}

/// What the text that is being made can use.
pub struct Generator {
    pub random: fastrand::Rng,
    pub has_mesh: bool,
    /// Whether this is the body of a function of any size.
    pub has_own_size: bool,
    /// Whether all that is made has derivatives. Then numbers have no pattern, and faces have three sides.
    pub is_differentiable: bool,
    /// Parameters so far, by name.
    pub inputs: BTreeMap<String, Ty>,
    pub functions: Vec<Signature>,
    /// Names with their types: definitions, and what is bound around the place at hand.
    pub scope: Vec<(String, Ty)>,
}
