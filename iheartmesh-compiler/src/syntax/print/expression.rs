//! Operators and atoms.

use super::super::ast::*;
use super::super::spelling;
use super::Printer;

/// What follows an expression in the printed text.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Tail {
    /// More of the same term, which a sum would swallow.
    None,
    /// Nothing that a sum would swallow, but its `where` would.
    Term,
    /// The end of the right-hand side.
    Full,
}

/// Binding strengths, from loose to tight.
const TERM: u8 = 1;
const UNION: u8 = 2;
const INTERSECTION: u8 = 3;
const PRODUCT: u8 = 4;
pub(super) const PREFIX: u8 = 5;
const POWER: u8 = 6;
pub(super) const ATOM: u8 = 7;

fn strength(op: BinaryOp) -> u8 {
    match op {
        BinaryOp::Add | BinaryOp::Subtract | BinaryOp::PlusMinus => 0,
        BinaryOp::Juxtapose | BinaryOp::Dot | BinaryOp::Divide => TERM,
        BinaryOp::Union => UNION,
        BinaryOp::Intersection => INTERSECTION,
        BinaryOp::Cross
        | BinaryOp::Hadamard
        | BinaryOp::Kronecker
        | BinaryOp::Frobenius
        | BinaryOp::Solve => PRODUCT,
        BinaryOp::Power => POWER,
    }
}

fn level(node: &Expr) -> u8 {
    match &node.kind {
        ExprKind::Binary { op, .. } => strength(*op),
        ExprKind::Unary { op, .. } => match op {
            UnaryOp::Negate => 0,
            UnaryOp::SquareRoot => PREFIX,
            UnaryOp::Size => ATOM,
            UnaryOp::Transpose | UnaryOp::Inverse | UnaryOp::PseudoInverse => POWER,
        },
        ExprKind::Big { .. }
        | ExprKind::Integral { .. }
        | ExprKind::Derivative { .. }
        | ExprKind::Gradient { .. }
        | ExprKind::Laplacian(_)
        | ExprKind::Divergence(_) => PREFIX,
        _ => ATOM,
    }
}

impl Printer {
    /// An expression where only operators of strength `least` or tighter need no parentheses.
    pub(super) fn show(&mut self, node: &Expr, least: u8, tail: Tail) -> String {
        let loose = match &node.kind {
            ExprKind::Big { locals, .. } => {
                tail == Tail::None || !locals.is_empty() && tail != Tail::Full
            }
            ExprKind::Norm { .. } => self.bars,
            ExprKind::Inner { .. } => self.ascii,
            _ => false,
        };
        if loose || level(node) < least {
            let bars = std::mem::replace(&mut self.bars, false);
            let text = match &node.kind {
                ExprKind::Inner { .. } => self.atom(node),
                _ => self.plain(node, Tail::Full),
            };
            self.bars = bars;
            return format!("({text})");
        }
        self.plain(node, tail)
    }

    /// An expression in brackets of its own.
    pub(super) fn inside(&mut self, node: &Expr) -> String {
        let bars = std::mem::replace(&mut self.bars, false);
        let text = self.show(node, 0, Tail::Term);
        self.bars = bars;
        text
    }

    pub(super) fn list(&mut self, nodes: &[Expr]) -> String {
        let nodes: Vec<String> = nodes.iter().map(|node| self.inside(node)).collect();
        nodes.join(", ")
    }

    fn plain(&mut self, node: &Expr, tail: Tail) -> String {
        match &node.kind {
            ExprKind::Unary { op, operand } => self.unary(*op, operand, tail),
            ExprKind::Binary {
                op, left, right, ..
            } => self.binary(*op, left, right, tail),
            ExprKind::Big { .. } => self.big(node, tail),
            ExprKind::Integral { .. } => self.integral(node),
            ExprKind::Derivative { .. } => self.derivative(node),
            ExprKind::Gradient { variable, operand } => {
                let variable = variable
                    .as_ref()
                    .map(|node| format!("_{}", self.inside(node)));
                let sign = self.sign('∇') + &variable.unwrap_or_default();
                format!("{sign} {}", self.show(operand, PREFIX, tail))
            }
            ExprKind::Laplacian(operand) => {
                format!("{} {}", self.sign('Δ'), self.show(operand, PREFIX, tail))
            }
            ExprKind::Divergence(operand) => {
                let sign = self.sign('∇') + &self.sign('⋅');
                format!("{sign} {}", self.show(operand, PREFIX, tail))
            }
            _ => self.atom(node),
        }
    }

    fn unary(&mut self, op: UnaryOp, operand: &Expr, tail: Tail) -> String {
        let sign = match (op, self.ascii) {
            (UnaryOp::Negate, _) => return format!("-{}", self.show(operand, TERM, tail)),
            (UnaryOp::SquareRoot, _) => {
                return self.prefix('√') + &self.show(operand, PREFIX, tail);
            }
            (UnaryOp::Size, _) => return format!("#{}", self.show(operand, ATOM, Tail::None)),
            (UnaryOp::Transpose, false) => "ᵀ",
            (UnaryOp::Transpose, true) => "^T",
            (UnaryOp::Inverse, false) => "⁻¹",
            (UnaryOp::Inverse, true) => "^-1",
            (UnaryOp::PseudoInverse, false) => "⁺",
            (UnaryOp::PseudoInverse, true) => "^+",
        };
        self.show(operand, ATOM, Tail::None) + sign
    }

    fn binary(&mut self, op: BinaryOp, left: &Expr, right: &Expr, tail: Tail) -> String {
        let this = strength(op);
        if op == BinaryOp::Power {
            return self.show(left, ATOM, Tail::None) + &self.exponent(right);
        }
        if this == PRODUCT {
            let left = self.show(left, PREFIX, Tail::None);
            let chain = match &right.kind {
                ExprKind::Binary { op: next, .. } => *next == op && op != BinaryOp::Cross,
                _ => false,
            };
            let least = if chain { PRODUCT } else { PREFIX };
            let right = self.show(right, least, tail);
            return format!("{left} {} {right}", self.operator(op));
        }
        let before = if this == 0 { Tail::Term } else { Tail::None };
        let left = match (&left.kind, this) {
            // Only the first operand of a sum may carry a sign.
            (
                ExprKind::Unary {
                    op: UnaryOp::Negate,
                    ..
                },
                0,
            ) => self.plain(left, before),
            _ => self.show(left, this, before),
        };
        let right = self.show(right, this + 1, tail);
        match op {
            BinaryOp::Juxtapose => format!("{left} {right}"),
            BinaryOp::Divide => format!("{left}/{right}"),
            _ => format!("{left} {} {right}", self.operator(op)),
        }
    }

    fn operator(&self, op: BinaryOp) -> String {
        self.sign(match op {
            BinaryOp::Add => '+',
            BinaryOp::Subtract => '-',
            BinaryOp::PlusMinus => '±',
            BinaryOp::Juxtapose => ' ',
            BinaryOp::Dot => '⋅',
            BinaryOp::Divide => '/',
            BinaryOp::Cross => '×',
            BinaryOp::Hadamard => '∘',
            BinaryOp::Kronecker => '⊗',
            BinaryOp::Frobenius => ':',
            BinaryOp::Solve => '\\',
            BinaryOp::Union => '∪',
            BinaryOp::Intersection => '∩',
            BinaryOp::Power => '^',
        })
    }

    fn exponent(&mut self, node: &Expr) -> String {
        let number = match &node.kind {
            ExprKind::Integer(number) => Some(*number),
            ExprKind::Unary {
                op: UnaryOp::Negate,
                operand,
            } => match operand.kind {
                ExprKind::Integer(number) if number > 1 => Some(-number),
                _ => None,
            },
            _ => None,
        };
        match (number, &node.kind) {
            (Some(number), _) if !self.ascii => spelling::superscript_number(number),
            (Some(number), _) => format!("^{number}"),
            (None, ExprKind::Name(name)) if name.text != "T" => format!("^{}", self.name(name)),
            (None, ExprKind::Pi) => format!("^{}", self.sign('π')),
            _ => format!("^({})", self.inside(node)),
        }
    }

    pub(super) fn subscripts(&mut self, list: &[Subscript]) -> String {
        if list.is_empty() {
            return String::new();
        }
        let mut parts = Vec::new();
        let mut tight = true;
        for part in list {
            match part {
                Subscript::All(_) => parts.push("*".to_owned()),
                Subscript::Expr(node) => {
                    tight &= matches!(node.kind, ExprKind::Name(_) | ExprKind::Integer(_));
                    parts.push(self.inside(node));
                }
            }
        }
        match tight {
            true => format!("_{}", parts.join(",")),
            false => format!("_({})", parts.join(", ")),
        }
    }

    pub(super) fn atom(&mut self, node: &Expr) -> String {
        match &node.kind {
            ExprKind::Integer(number) => number.to_string(),
            ExprKind::Real(number) => match spelling::fraction_of(*number) {
                Some(sign) if !self.ascii => sign.to_string(),
                _ => format!("{number:?}").replace('e', "E"),
            },
            ExprKind::Pi => self.sign('π'),
            ExprKind::Infinity => self.sign('∞'),
            ExprKind::Name(name) => self.name(name),
            ExprKind::Subscript { base, subscripts } => {
                let bare = match &base.kind {
                    ExprKind::Name(_) => true,
                    ExprKind::Call {
                        arguments,
                        subscripts,
                        ..
                    } => !arguments.is_empty() || subscripts.is_empty(),
                    _ => false,
                };
                let base = match bare {
                    true => self.show(base, ATOM, Tail::None),
                    false => format!("({})", self.inside(base)),
                };
                base + &self.subscripts(subscripts)
            }
            ExprKind::Call {
                function,
                subscripts,
                arguments,
            } => {
                let subscripts: Vec<Subscript> =
                    subscripts.iter().cloned().map(Subscript::Expr).collect();
                let mut text = self.name(function) + &self.subscripts(&subscripts);
                if subscripts.is_empty() || !arguments.is_empty() {
                    text += &format!("({})", self.list(arguments));
                }
                text
            }
            ExprKind::Norm { .. } => self.norm(node),
            ExprKind::Inner {
                left,
                right,
                weight,
            } => {
                let operands = format!("{}, {}", self.inside(left), self.inside(right));
                let weight = weight
                    .as_ref()
                    .map(|node| Subscript::Expr((**node).clone()));
                let weight = self.subscripts(weight.as_slice());
                match self.ascii {
                    true => format!("<{operands}>{weight}"),
                    false => format!("⟨{operands}⟩{weight}"),
                }
            }
            ExprKind::Vector(parts) => format!("({})", self.list(parts)),
            ExprKind::Matrix(rows) => self.matrix(rows),
            ExprKind::Set(parts) if parts.is_empty() => self.sign('∅'),
            ExprKind::Set(parts) => format!("{{{}}}", self.list(parts)),
            ExprKind::Builder { .. } => self.builder(node),
            ExprKind::NumberMatrix {
                ones,
                rows,
                columns,
            } => {
                let sizes = std::iter::once(rows).chain(columns);
                let sizes: Vec<Subscript> = sizes
                    .map(|node| Subscript::Expr((**node).clone()))
                    .collect();
                let number = if *ones { "1" } else { "0" };
                number.to_owned() + &self.subscripts(&sizes)
            }
            ExprKind::Error => "…".to_owned(),
            _ => {
                let text = self.right_side(node, Tail::Term);
                format!("({text})")
            }
        }
    }

    fn norm(&mut self, node: &Expr) -> String {
        let ExprKind::Norm {
            double,
            operand,
            subscript,
        } = &node.kind
        else {
            return String::new();
        };
        let outer = std::mem::replace(&mut self.bars, true);
        let mut text = self.show(operand, 0, Tail::Term);
        self.bars = outer;
        // A bar right after the opening one would be read together with it.
        if text.starts_with('|') {
            text = format!("({text})");
        }
        let subscript = match subscript {
            None => String::new(),
            Some(NormSubscript::Infinity) => format!("_{}", self.sign('∞')),
            Some(NormSubscript::Nuclear) => "_*".to_owned(),
            Some(NormSubscript::Expr(node)) => {
                self.subscripts(&[Subscript::Expr((**node).clone())])
            }
        };
        let bars = match (double, self.ascii) {
            (false, _) => "|",
            (true, false) => "‖",
            (true, true) => "||",
        };
        format!("{bars}{text}{bars}{subscript}")
    }

    /// Cells are separated by blanks where no cell contains one, by commas otherwise.
    fn matrix(&mut self, rows: &[Vec<Expr>]) -> String {
        let mut blank = true;
        let mut lines = Vec::new();
        for row in rows {
            let mut cells = Vec::new();
            for (index, node) in row.iter().enumerate() {
                let mut text = self.inside(node);
                let safe = cell_safe(node, self.ascii);
                if !safe || index == 0 && text.starts_with('|') {
                    text = format!("({text})");
                }
                let simple = !safe || level(node) >= POWER;
                blank &= simple;
                cells.push(text);
            }
            lines.push(cells);
        }
        let separator = if blank { " " } else { ", " };
        let lines: Vec<String> = lines.iter().map(|cells| cells.join(separator)).collect();
        format!("[{}]", lines.join("; "))
    }
}

/// Whether a cell may be written without parentheses: no blank in it would end it.
fn cell_safe(node: &Expr, ascii: bool) -> bool {
    match &node.kind {
        ExprKind::Binary {
            op, left, right, ..
        } => match op {
            BinaryOp::Juxtapose => false,
            BinaryOp::Power => true,
            _ => cell_safe(left, ascii) && cell_safe(right, ascii),
        },
        ExprKind::Unary { op, operand } => match op {
            UnaryOp::Negate => cell_safe(operand, ascii),
            UnaryOp::SquareRoot => !ascii && cell_safe(operand, ascii),
            _ => true,
        },
        ExprKind::Derivative { .. } => !ascii,
        _ => level(node) == ATOM,
    }
}
