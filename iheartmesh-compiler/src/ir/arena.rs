//! Hash-consed storage of expressions.

use std::collections::BTreeMap;
use std::collections::HashMap;
use std::rc::Rc;

use super::{Kind, Range, Restriction, VariableId};
use crate::span::Span;
use crate::types::Type;

/// An expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ExprId(pub u32);

/// What the arena knows of an expression.
#[derive(Clone, Debug)]
pub struct Node {
    /// What it is.
    pub kind: Kind,
    /// Type of its value.
    pub ty: Type,
    /// Variables that occur in it and are not bound in it, ascending.
    pub free: Rc<[VariableId]>,
}

/// All expressions of a program. An operand always comes before what it is an operand of.
#[derive(Clone, Debug, Default)]
pub struct Arena {
    nodes: Vec<Node>,
    // only looked up, never iterated: the order of nodes is that of their creation
    index: HashMap<(Kind, Type), ExprId>,
    origins: BTreeMap<ExprId, Span>,
    variables: Vec<(String, Type)>,
}

impl Arena {
    /// The expression of this kind and type.
    pub fn add(&mut self, kind: Kind, ty: Type) -> ExprId {
        let key = (kind, ty);
        if let Some(&id) = self.index.get(&key) {
            return id;
        }
        let id = ExprId(self.nodes.len() as u32);
        let free = self.free_of(&key.0);
        self.nodes.push(Node {
            kind: key.0.clone(),
            ty: key.1.clone(),
            free,
        });
        self.index.insert(key, id);
        id
    }

    /// The expression of this kind and type, if there is one already.
    pub fn find(&self, kind: &Kind, ty: &Type) -> Option<ExprId> {
        self.index.get(&(kind.clone(), ty.clone())).copied()
    }

    /// Notes where an expression came from, for messages at run time; the first note stays.
    pub fn note_origin(&mut self, id: ExprId, span: Span) {
        self.origins.entry(id).or_insert(span);
    }

    /// Where an expression came from.
    pub fn origin(&self, id: ExprId) -> Option<Span> {
        self.origins.get(&id).copied()
    }

    /// The node of an expression.
    pub fn node(&self, id: ExprId) -> &Node {
        &self.nodes[id.0 as usize]
    }

    /// The kind of an expression.
    pub fn kind(&self, id: ExprId) -> &Kind {
        &self.node(id).kind
    }

    /// The type of an expression.
    pub fn ty(&self, id: ExprId) -> &Type {
        &self.node(id).ty
    }

    /// Whether a variable occurs free in an expression.
    pub fn depends_on(&self, id: ExprId, variable: VariableId) -> bool {
        self.node(id).free.binary_search(&variable).is_ok()
    }

    /// A new variable.
    pub fn new_variable(&mut self, name: &str, ty: Type) -> VariableId {
        self.variables.push((name.to_owned(), ty));
        VariableId(self.variables.len() as u32 - 1)
    }

    /// The author's name of a variable.
    pub fn variable_name(&self, variable: VariableId) -> &str {
        &self.variables[variable.0 as usize].0
    }

    /// The type of a variable.
    pub fn variable_type(&self, variable: VariableId) -> &Type {
        &self.variables[variable.0 as usize].1
    }

    /// The expression that is a variable.
    pub fn variable(&mut self, variable: VariableId) -> ExprId {
        let ty = self.variable_type(variable).clone();
        self.add(Kind::Variable(variable), ty)
    }

    /// An integer.
    pub fn integer(&mut self, value: i64) -> ExprId {
        self.add(Kind::Integer(value), Type::INTEGER)
    }

    /// A real number.
    pub fn real(&mut self, value: f64) -> ExprId {
        self.add(Kind::Real(value.to_bits()), Type::REAL)
    }

    /// Number of expressions so far.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Whether there is no expression yet.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    fn free_of(&self, kind: &Kind) -> Rc<[VariableId]> {
        let mut free: Vec<VariableId> = Vec::new();
        if let Kind::Variable(variable) | Kind::Column(variable, _) = kind {
            free.push(*variable);
        }
        kind.operands(|operand| free.extend_from_slice(&self.node(operand).free));
        if let Kind::Fold {
            variable, range, ..
        } = kind
        {
            free.retain(|v| v != variable);
            // the range is outside the scope of the variable; it cannot hold it, since each variable has one binder
            match range {
                Range::Set(set) => debug_assert!(!self.depends_on(*set, *variable)),
                Range::Rows { of: Some(outer) } => free.push(*outer),
                Range::Integers(..) | Range::Rows { of: None } => {}
            }
        }
        if let Kind::Tabulate { variables, .. } | Kind::Optimum { variables, .. } = kind {
            free.retain(|v| !variables.contains(v));
        }
        if let Kind::Scatter { variable, set, .. } = kind {
            free.retain(|v| v != variable);
            debug_assert!(!self.depends_on(*set, *variable));
        }
        if let Kind::Integral { variable, .. } = kind {
            free.retain(|v| v != variable);
        }
        free.sort_unstable();
        free.dedup();
        free.into()
    }
}

/// Visits each direct operand of a kind, in order of evaluation: `$visit` takes `&ExprId` with `iter`, `&mut ExprId` with
/// `iter_mut`. The one place that knows where operands stand.
macro_rules! each_operand {
    ($kind:expr, $iter:ident, $visit:expr) => {{
        let mut visit = $visit;
        match $kind {
            Kind::Integer(_)
            | Kind::Real(_)
            | Kind::Boolean(_)
            | Kind::Variable(_)
            | Kind::Input(_)
            | Kind::Global(_)
            | Kind::AllElements(_)
            | Kind::Boundary(_)
            | Kind::Size(_)
            | Kind::Fail
            | Kind::Column(..) => {}
            Kind::HostCall(function, list) => {
                visit(function);
                list.$iter().for_each(visit);
            }
            Kind::Call(_, list)
            | Kind::Vector(list)
            | Kind::Tuple(list)
            | Kind::Sequence(list)
            | Kind::Set(list) => list.$iter().for_each(visit),
            Kind::Blocks(rows) => rows.$iter().flatten().for_each(visit),
            Kind::Filled(value, sizes) => {
                visit(value);
                sizes.$iter().for_each(visit);
            }
            Kind::Tabulate { sizes, body, .. } => {
                sizes.$iter().for_each(&mut visit);
                visit(body);
            }
            Kind::Scatter {
                set,
                sizes,
                place,
                body,
                ..
            } => {
                visit(set);
                sizes.$iter().for_each(&mut visit);
                place.$iter().for_each(&mut visit);
                visit(body);
            }
            Kind::Update(base, entries) => {
                visit(base);
                for (subscripts, value) in entries.$iter() {
                    subscripts.$iter().flatten().for_each(&mut visit);
                    visit(value);
                }
            }
            Kind::Assemble { sizes, blocks } => {
                sizes.$iter().for_each(&mut visit);
                for block in blocks.$iter() {
                    let super::Block {
                        rows,
                        columns,
                        value,
                        core,
                    } = block;
                    rows.$iter().for_each(&mut visit);
                    columns.$iter().for_each(&mut visit);
                    visit(value);
                    core.$iter().for_each(&mut visit);
                }
            }
            Kind::Unary(_, a)
            | Kind::Not(a)
            | Kind::Extent(a, _)
            | Kind::Identity(a)
            | Kind::SequenceOf(a)
            | Kind::Project(a, _)
            | Kind::Cardinality(a)
            | Kind::Sized(a, _)
            | Kind::Indicator(a)
            | Kind::Apply(_, a)
            | Kind::NonZeros(a)
            | Kind::Traverse(_, a)
            | Kind::Field(_, a) => visit(a),
            Kind::Binary(_, a, b)
            | Kind::Compare(_, a, b)
            | Kind::And(a, b)
            | Kind::Or(a, b)
            | Kind::Component(a, b)
            | Kind::Item(a, b)
            | Kind::RowOf(a, b)
            | Kind::Stored(a, _, b)
            | Kind::ColumnOf(a, b)
            | Kind::SetOp(_, a, b)
            | Kind::SetItem(a, b)
            | Kind::Neighbor(_, a, b)
            | Kind::Member(a, b)
            | Kind::ValueSet(a, b)
            | Kind::Entry(_, a, b) => {
                visit(a);
                visit(b);
            }
            Kind::If(a, b, c) | Kind::At(a, b, c) | Kind::Agree(a, b, c) => {
                visit(a);
                visit(b);
                visit(c);
            }
            Kind::Fold {
                range,
                condition,
                body,
                ..
            } => {
                match range {
                    Range::Set(set) => visit(set),
                    Range::Integers(from, to) => {
                        visit(from);
                        visit(to);
                    }
                    Range::Rows { .. } => {}
                }
                condition.$iter().for_each(&mut visit);
                visit(body);
            }
            Kind::Optimum {
                start,
                restrictions,
                objective,
                ..
            } => {
                start.$iter().for_each(&mut visit);
                for restriction in restrictions.$iter() {
                    match restriction {
                        Restriction::Equal(a)
                        | Restriction::AtMost(a)
                        | Restriction::Lower(_, a)
                        | Restriction::Upper(_, a) => visit(a),
                    }
                }
                visit(objective);
            }
            Kind::Integral { from, to, body, .. } => {
                visit(from);
                visit(to);
                visit(body);
            }
        }
    }};
}

impl Kind {
    /// Calls `f` with each direct operand, in order of evaluation.
    pub fn operands(&self, mut f: impl FnMut(ExprId)) {
        each_operand!(self, iter, |e: &ExprId| f(*e));
    }

    /// The same kind with each direct operand replaced.
    pub fn map_operands(&self, mut f: impl FnMut(ExprId) -> ExprId) -> Kind {
        let mut kind = self.clone();
        each_operand!(&mut kind, iter_mut, |e: &mut ExprId| *e = f(*e));
        kind
    }
}
