//! How expressions are shown: `hlangc --emit ir` and `--emit plan`.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use super::{
    Arena, Binary, Boundary, ExprId, Fold, Kind, Neighbor, Program, Range, Restriction, SetOp,
    Unary,
};
use crate::syntax::ast::CompareOp;

/// An expression with more parts than this is shown with names for what stands in it several times.
const LONG: usize = 400;

/// An expression in one line; a long one with a line for each part that stands in it several times.
pub fn expression(program: &Program, e: ExprId) -> String {
    let mut text = String::new();
    let names = repeated(&program.arena, e);
    let mut writer = Writer {
        program,
        text: &mut text,
        names: &names,
    };
    writer.expr(e);
    for (part, name) in &names {
        writer.put(&format!("\n        with t{name} = "));
        writer.whole(*part);
    }
    text
}

/// The parts of a long expression that stand in it several times, with their numbers.
fn repeated(arena: &Arena, e: ExprId) -> BTreeMap<ExprId, usize> {
    // the number of parts of each, with repetitions, and how often it stands in another
    let mut sizes: BTreeMap<ExprId, usize> = BTreeMap::new();
    let mut uses: BTreeMap<ExprId, usize> = BTreeMap::new();
    let mut open = vec![(e, false)];
    while let Some((e, is_done)) = open.pop() {
        if is_done {
            let mut size: usize = 1;
            arena.kind(e).operands(|operand| {
                size = size.saturating_add(sizes.get(&operand).copied().unwrap_or(1));
                *uses.entry(operand).or_insert(0) += 1;
            });
            sizes.insert(e, size);
        } else if let Entry::Vacant(entry) = sizes.entry(e) {
            entry.insert(1);
            open.push((e, true));
            arena
                .kind(e)
                .operands(|operand| open.push((operand, false)));
        }
    }
    if sizes.get(&e).is_none_or(|size| *size <= LONG) {
        return BTreeMap::new();
    }
    let parts = uses.into_iter().filter(|(e, n)| *n > 1 && sizes[e] > 2);
    let parts = parts.enumerate();
    parts.map(|(k, (e, _))| (e, k + 1)).collect()
}

struct Writer<'a> {
    program: &'a Program,
    text: &'a mut String,
    names: &'a BTreeMap<ExprId, usize>,
}

impl Writer<'_> {
    fn arena(&self) -> &Arena {
        &self.program.arena
    }

    fn put(&mut self, text: &str) {
        self.text.push_str(text);
    }

    fn list(&mut self, items: &[ExprId]) {
        for (k, item) in items.iter().enumerate() {
            if k > 0 {
                self.put(", ");
            }
            self.expr(*item);
        }
    }

    fn call(&mut self, name: &str, items: &[ExprId]) {
        self.put(name);
        self.put("(");
        self.list(items);
        self.put(")");
    }

    fn infix(&mut self, a: ExprId, sign: &str, b: ExprId) {
        self.put("(");
        self.expr(a);
        self.put(sign);
        self.expr(b);
        self.put(")");
    }

    fn expr(&mut self, e: ExprId) {
        match self.names.get(&e) {
            Some(name) => self.put(&format!("t{name}")),
            None => self.whole(e),
        }
    }

    /// An expression by its parts.
    fn whole(&mut self, e: ExprId) {
        let kind = self.arena().kind(e).clone();
        match &kind {
            Kind::Integer(v) => self.put(&v.to_string()),
            Kind::Real(bits) => self.put(&format!("{:?}", f64::from_bits(*bits))),
            Kind::Boolean(v) => self.put(&v.to_string()),
            Kind::Variable(v) => {
                let name = format!("{}.{}", self.arena().variable_name(*v), v.0);
                self.put(&name);
            }
            Kind::Input(id) => {
                let name = self.program.input(*id).name.clone();
                self.put(&name);
            }
            Kind::Global(id) => {
                let name = self.program.global(*id).name.clone();
                self.put(&name);
            }
            Kind::AllElements(element) => {
                let text = format!(
                    "{}[{}]",
                    crate::types::display::plural(element.kind),
                    self.program.mesh(element.mesh).name
                );
                self.put(&text);
            }
            Kind::Boundary(b) => {
                let name = self.boundary(*b);
                self.put(&name);
            }
            Kind::Call(id, arguments) => {
                let name = format!("{}#{}", self.program.function(*id).name, id.0);
                self.call(&name, arguments);
            }
            Kind::Field(id, a) => {
                let name = format!("field {}#{}", self.program.function(*id).name, id.0);
                self.put(&name);
                self.put("[");
                self.expr(*a);
                self.put("]");
            }
            Kind::Unary(op, a) => {
                let name = match op {
                    Unary::Negate => "-".to_owned(),
                    Unary::Absolute => "abs".to_owned(),
                    Unary::SquareRoot => "sqrt".to_owned(),
                    Unary::Norm => "norm".to_owned(),
                    Unary::ToReal => "real".to_owned(),
                    Unary::ToInteger => "integer".to_owned(),
                    Unary::ToElement => "element".to_owned(),
                    Unary::Apply(function) => format!("{function:?}").to_lowercase(),
                    other => spelled(&format!("{other:?}")),
                };
                self.call(&name, &[*a]);
            }
            Kind::Binary(op, a, b) => match op {
                Binary::Add => self.infix(*a, " + ", *b),
                Binary::Subtract => self.infix(*a, " - ", *b),
                Binary::Multiply => self.infix(*a, " * ", *b),
                Binary::Divide => self.infix(*a, " / ", *b),
                Binary::Power => self.infix(*a, " ^ ", *b),
                Binary::Dot => self.infix(*a, " ⋅ ", *b),
                Binary::Cross => self.infix(*a, " × ", *b),
                Binary::Atan2 => self.call("atan2", &[*a, *b]),
                Binary::Min => self.call("min", &[*a, *b]),
                Binary::Max => self.call("max", &[*a, *b]),
                Binary::Product => self.infix(*a, " · ", *b),
                other => self.call(&spelled(&format!("{other:?}")), &[*a, *b]),
            },
            Kind::Compare(op, a, b) => self.infix(*a, compare_sign(*op), *b),
            Kind::And(a, b) => self.infix(*a, " and ", *b),
            Kind::Or(a, b) => self.infix(*a, " or ", *b),
            Kind::Not(a) => self.call("not", &[*a]),
            Kind::Vector(items) => self.call("vector", items),
            Kind::Component(a, b) | Kind::Item(a, b) | Kind::SetItem(a, b) => {
                self.expr(*a);
                self.put("[");
                self.expr(*b);
                self.put("]");
            }
            Kind::Extent(a, axis) => self.call(if *axis == 0 { "rows" } else { "columns" }, &[*a]),
            Kind::Size(size) => self.put(&format!("⌗{size}")),
            Kind::At(a, i, j) => {
                self.expr(*a);
                self.put("[");
                self.list(&[*i, *j]);
                self.put("]");
            }
            Kind::RowOf(a, i) => self.call("row", &[*a, *i]),
            Kind::ColumnOf(a, i) => self.call("column", &[*a, *i]),
            Kind::Blocks(rows) => {
                self.put("[");
                for (k, row) in rows.iter().enumerate() {
                    if k > 0 {
                        self.put("; ");
                    }
                    self.list(row);
                }
                self.put("]");
            }
            Kind::Filled(value, sizes) => {
                let all: Vec<ExprId> = [*value].into_iter().chain(sizes.iter().copied()).collect();
                self.call("filled", &all);
            }
            Kind::Identity(n) => self.call("identity", &[*n]),
            Kind::Tabulate {
                layout,
                variables,
                sizes,
                body,
            } => {
                self.put(&spelled(&format!("{layout:?}")));
                for (variable, size) in variables.iter().zip(sizes) {
                    let name = format!(
                        "({}.{} to ",
                        self.arena().variable_name(*variable),
                        variable.0
                    );
                    self.put(&name);
                    self.expr(*size);
                    self.put(")");
                }
                self.put(": (");
                self.expr(*body);
                self.put(")");
            }
            Kind::Stored(matrix, axis, index) => {
                let name = ["stored columns", "stored rows"][usize::from(*axis)];
                self.call(name, &[*matrix, *index]);
            }
            Kind::Scatter {
                variable,
                set,
                sizes,
                place,
                body,
            } => {
                self.call("scatter", sizes);
                let name = self.arena().variable_name(*variable);
                self.put(&format!("({name}.{} in ", variable.0));
                self.expr(*set);
                self.put(": [");
                self.list(place);
                self.put("] ");
                self.expr(*body);
                self.put(")");
            }
            Kind::Update(base, entries) => {
                self.put("update(");
                self.expr(*base);
                for (subscripts, value) in entries {
                    self.put("; [");
                    for (k, subscript) in subscripts.iter().enumerate() {
                        if k > 0 {
                            self.put(", ");
                        }
                        match subscript {
                            Some(subscript) => self.expr(*subscript),
                            None => self.put("*"),
                        }
                    }
                    self.put("] ");
                    self.expr(*value);
                }
                self.put(")");
            }
            Kind::Assemble { sizes, blocks } => {
                self.call("assemble", sizes);
                for block in blocks {
                    self.call(" at ", &block.rows);
                    self.call(", ", &block.columns);
                    self.call(" += ", &[block.value]);
                    if let Some(core) = block.core {
                        self.call(" from ", &[core]);
                    }
                }
            }
            Kind::Sequence(items) => self.call("sequence", items),
            Kind::SequenceOf(a) => self.call("sequence of ", &[*a]),
            Kind::HostCall(function, arguments) => {
                self.put("host ");
                self.expr(*function);
                self.call("", arguments);
            }
            Kind::Agree(a, b, value) => self.call("agree", &[*a, *b, *value]),
            Kind::Tuple(items) => self.call("tuple", items),
            Kind::Project(a, k) => {
                self.expr(*a);
                self.put(&format!(".{k}"));
            }
            Kind::Set(items) => {
                self.put("{");
                self.list(items);
                self.put("}");
            }
            Kind::SetOp(op, a, b) => {
                let sign = match op {
                    SetOp::Union => " ∪ ",
                    SetOp::Intersection => " ∩ ",
                    SetOp::Difference => " ∖ ",
                };
                self.infix(*a, sign, *b);
            }
            Kind::Cardinality(a) => self.call("cardinality", &[*a]),
            Kind::Sized(a, n) => self.call(&format!("exactly {n} "), &[*a]),
            Kind::Member(a, b) => self.infix(*a, " ∈ ", *b),
            Kind::Indicator(a) => self.call("indicator", &[*a]),
            Kind::Apply(b, a) => {
                let name = format!("{} ", self.boundary(*b));
                self.call(&name, &[*a]);
            }
            Kind::NonZeros(a) => self.call("nonzeros", &[*a]),
            Kind::ValueSet(a, b) => self.call("valueset", &[*a, *b]),
            Kind::Traverse(b, a) => {
                let name = format!("traverse {} ", self.boundary(*b));
                self.call(&name, &[*a]);
            }
            Kind::Neighbor(neighbor, a, b) => {
                let (mesh, name) = match *neighbor {
                    Neighbor::EdgeBetween(mesh) => (mesh, "edge between".to_owned()),
                    Neighbor::VertexInFace(mesh, sign) => {
                        (mesh, format!("vertex in face {sign:+}"))
                    }
                    Neighbor::FaceWith(mesh, sign) => (mesh, format!("face with {sign:+}")),
                    Neighbor::FaceWithout(mesh, sign) => (mesh, format!("face without {sign:+}")),
                };
                let mesh = &self.program.mesh(mesh).name;
                let name = format!("{name}[{mesh}]");
                self.call(&name, &[*a, *b]);
            }
            Kind::Entry(b, row, column) => {
                let name = self.boundary(*b);
                self.put(&name);
                self.put("[");
                self.list(&[*row, *column]);
                self.put("]");
            }
            Kind::Fold {
                op,
                variable,
                range,
                condition,
                body,
            } => {
                let sign = match op {
                    Fold::Sum => "∑",
                    Fold::Product => "∏",
                    Fold::Union => "∪",
                    Fold::Min => "min",
                    Fold::Max => "max",
                    Fold::ArgMin => "argmin",
                    Fold::ArgMax => "argmax",
                    Fold::Collect => "set",
                };
                let name = format!("{}.{}", self.arena().variable_name(*variable), variable.0);
                self.put(&format!("{sign}({name} in "));
                match range {
                    Range::Set(set) => self.expr(*set),
                    Range::Integers(from, to) => {
                        self.expr(*from);
                        self.put("..=");
                        self.expr(*to);
                    }
                    Range::Rows { .. } => self.put("rows"),
                }
                if let Some(condition) = condition {
                    self.put(" if ");
                    self.expr(*condition);
                }
                self.put(": ");
                self.expr(*body);
                self.put(")");
            }
            Kind::Optimum {
                greatest,
                variables,
                start,
                restrictions,
                objective,
            } => {
                self.put(if *greatest { "greatest(" } else { "least(" });
                for (variable, start) in variables.iter().zip(start) {
                    let name = format!("{}.{}", self.arena().variable_name(*variable), variable.0);
                    self.put(&format!("{name} from "));
                    self.expr(*start);
                    self.put(", ");
                }
                for restriction in restrictions {
                    let bound = |k: u32| {
                        let variable = variables[k as usize];
                        format!("{}.{}", self.arena().variable_name(variable), variable.0)
                    };
                    let (before, value, after) = match restriction {
                        Restriction::Equal(e) => (String::new(), e, " = 0, "),
                        Restriction::AtMost(e) => (String::new(), e, " ≤ 0, "),
                        Restriction::Lower(k, e) => (format!("{} ≥ ", bound(*k)), e, ", "),
                        Restriction::Upper(k, e) => (format!("{} ≤ ", bound(*k)), e, ", "),
                    };
                    self.put(&before);
                    self.expr(*value);
                    self.put(after);
                }
                self.expr(*objective);
                self.put(")");
            }
            Kind::Integral {
                variable,
                from,
                to,
                body,
            } => {
                let name = format!("{}.{}", self.arena().variable_name(*variable), variable.0);
                self.put(&format!("integral({name} from "));
                self.expr(*from);
                self.put(" to ");
                self.expr(*to);
                self.put(": ");
                self.expr(*body);
                self.put(")");
            }
            Kind::If(condition, a, b) => {
                self.put("(if ");
                self.expr(*condition);
                self.put(" then ");
                self.expr(*a);
                self.put(" else ");
                self.expr(*b);
                self.put(")");
            }
            Kind::Fail => self.put("fail"),
            Kind::Column(variable, k) => {
                let name = self.arena().variable_name(*variable).to_owned();
                self.put(&format!("{name}.{}⟨{k}⟩", variable.0));
            }
        }
    }

    fn boundary(&self, b: Boundary) -> String {
        format!(
            "{}{}{}[{}]",
            if b.signed { "∂" } else { "B" },
            b.dimension,
            if b.transposed { "ᵀ" } else { "" },
            self.program.mesh(b.mesh).name
        )
    }
}

/// `NormMax` as `norm max`.
fn spelled(name: &str) -> String {
    let mut text = String::new();
    for (k, c) in name.chars().enumerate() {
        if k > 0 && c.is_uppercase() {
            text.push(' ');
        }
        text.extend(c.to_lowercase());
    }
    text
}

/// The sign of a relation, with spaces.
pub fn compare_sign(op: CompareOp) -> &'static str {
    match op {
        CompareOp::Equal => " = ",
        CompareOp::NotEqual => " ≠ ",
        CompareOp::Less => " < ",
        CompareOp::LessOrEqual => " ≤ ",
        CompareOp::Greater => " > ",
        CompareOp::GreaterOrEqual => " ≥ ",
    }
}
