//! A program: what the host hands in, what is defined, what the host may call.

use super::{Arena, ExprId, VariableId};
use crate::span::Span;
use crate::types::{Dimension, Element, MeshId, MeshKind, Type};

/// A value handed in by the host.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct InputId(pub u32);

/// A definition without parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct GlobalId(pub u32);

/// A definition with parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FunctionId(pub u32);

/// A mesh among the inputs.
#[derive(Clone, Debug)]
pub struct MeshInput {
    /// The author's name.
    pub name: String,
    /// Edge, face or cell mesh.
    pub kind: MeshKind,
}

/// One value that the host hands in to `new`.
#[derive(Clone, Debug)]
pub struct Input {
    /// The author's name.
    pub name: String,
    /// Its type; a mesh is [`Type::Mesh`].
    pub ty: Type,
    /// The set that an element or a subset must be of.
    pub within: Option<ExprId>,
    /// Elements that index it somewhere: it must have an item for each.
    pub indexed_by: Vec<Element>,
    /// Matrices that its members, pairs of integers, are the rows and columns of.
    pub pairs: Vec<Pairs>,
    /// The author's description.
    pub description: Option<String>,
    /// Where it is declared.
    pub span: Span,
}

/// What pairs of integers are the rows and columns of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pairs {
    /// The author's name of the matrix.
    pub matrix: String,
    /// Its numbers of rows and columns.
    pub sizes: [Dimension; 2],
    /// What the host calls the first row and column.
    pub first: i64,
}

/// Two sizes that must be the same because one index runs over what has them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tie {
    /// The sizes: that of an input, not of its items, and that of another, the number of elements of a mesh, or a number.
    pub sizes: [Dimension; 2],
    /// The author's name of the index.
    pub index: String,
}

/// A definition without parameters.
#[derive(Clone, Debug)]
pub struct Global {
    /// The author's name.
    pub name: String,
    /// Its value.
    pub value: ExprId,
    /// Where it is defined.
    pub span: Span,
}

/// A parameter of a function.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// The author's name.
    pub name: String,
    /// The variable that stands for it in the body.
    pub variable: VariableId,
    /// Its type.
    pub ty: Type,
    /// For an element the set it must be a member of, for a set the set it must be part of.
    pub within: Option<ExprId>,
    /// That set as the author calls it.
    pub within_name: String,
}

/// A definition with parameters.
#[derive(Clone, Debug)]
pub struct Function {
    /// The author's name; overloads share it.
    pub name: String,
    /// Its parameters, those in subscripts first.
    pub parameters: Vec<Parameter>,
    /// Its value.
    pub body: ExprId,
    /// Type of its value.
    pub ty: Type,
    /// Whether it calls itself, directly or through others.
    pub recursive: bool,
    /// Whether it is of the module itself, and not imported.
    pub own: bool,
    /// Where it is defined, with its local definitions.
    pub span: Span,
}

/// What the host may call, in order of the text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Export {
    /// A definition without parameters.
    Global(GlobalId),
    /// A definition with parameters.
    Function(FunctionId),
}

/// Definitions that the host asks for at once.
#[derive(Clone, Debug)]
pub struct Together {
    /// Which, in the order in which they are asked for.
    pub members: Vec<GlobalId>,
    /// What computes several of them in one pass.
    pub pass: Option<Pass>,
}

/// A definition that nobody names: the values of others, in a tuple. Only what is emitted for it tells its loops from theirs.
#[derive(Clone, Debug)]
pub struct Pass {
    /// The definition.
    pub global: GlobalId,
    /// What its items are the values of: arrays first, those of them that are sparse before others, then numbers.
    pub members: Vec<GlobalId>,
}

/// What is said when an expression fails at run time.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Site {
    /// The message.
    pub text: String,
}

/// A whole program.
#[derive(Clone, Debug, Default)]
pub struct Program {
    /// All expressions.
    pub arena: Arena,
    /// The meshes, by [`MeshId`].
    pub meshes: Vec<MeshInput>,
    /// What the host hands in.
    pub inputs: Vec<Input>,
    /// The inputs in order of declaration: the order of the arguments of `new`.
    pub input_order: Vec<InputId>,
    /// Sizes of inputs that must be the same.
    pub ties: Vec<Tie>,
    /// Definitions without parameters, each after those it depends on.
    pub globals: Vec<Global>,
    /// Definitions with parameters, of the module and of what it imports.
    pub functions: Vec<Function>,
    /// What the host may call.
    pub exports: Vec<Export>,
    /// What the host asks for at once.
    pub together: Vec<Together>,
}

impl Program {
    /// A mesh.
    pub fn mesh(&self, id: MeshId) -> &MeshInput {
        &self.meshes[id.0 as usize]
    }

    /// An input.
    pub fn input(&self, id: InputId) -> &Input {
        &self.inputs[id.0 as usize]
    }

    /// A definition without parameters.
    pub fn global(&self, id: GlobalId) -> &Global {
        &self.globals[id.0 as usize]
    }

    /// A definition with parameters.
    pub fn function(&self, id: FunctionId) -> &Function {
        &self.functions[id.0 as usize]
    }

    /// Whether an input, and not each of its items, has a size.
    pub fn is_given(&self, size: &Dimension) -> bool {
        self.inputs.iter().any(|input| match &input.ty {
            Type::Vector { length, .. } | Type::Sequence { length, .. } => length == size,
            Type::Matrix { rows, columns, .. } => rows == size || columns == size,
            _ => false,
        })
    }

    /// What a definition computes in one pass, if that is what it is for.
    pub fn pass(&self, id: GlobalId) -> Option<&Pass> {
        let mut passes = self.together.iter().filter_map(|t| t.pass.as_ref());
        passes.find(|pass| pass.global == id)
    }

    /// All functions with their ids.
    pub fn function_ids(&self) -> impl Iterator<Item = FunctionId> + use<> {
        (0..self.functions.len() as u32).map(FunctionId)
    }
}
