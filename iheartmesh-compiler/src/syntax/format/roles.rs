//! What the tree says of tokens whose kind does not tell it.

use super::super::ast::{BinaryOp, Expr, ExprKind, Module, UnaryOp};
use super::super::strip::each_expression;
use super::super::token::{Kind, Token};

/// What a token is in the tree.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) enum Role {
    #[default]
    Other,
    /// An operator with a blank on both sides.
    Loose,
    /// An operator with a blank on both sides or on neither, as its author likes.
    Close,
    /// The sign of a number or a term.
    Negate,
    /// Opens a norm.
    OpenBar,
    /// Closes `|x|`.
    CloseBar,
    /// Closes `‖x‖`.
    CloseDoubleBar,
    /// Opens an inner product.
    OpenAngle,
    /// Closes an inner product.
    CloseAngle,
    /// Opens a matrix.
    Matrix,
    /// The `^` of an exponent that is an integer.
    Power,
    /// The `^` of `^T`.
    Transpose,
}

struct Finder<'a> {
    tokens: &'a [Token],
    roles: Vec<Role>,
}

/// The roles of all tokens; strips the spans of the module.
pub(super) fn roles(module: &mut Module, tokens: &[Token]) -> Vec<Role> {
    let mut finder = Finder {
        tokens,
        roles: vec![Role::Other; tokens.len()],
    };
    each_expression(module, &mut |node| finder.expression(node));
    finder.roles
}

impl Finder<'_> {
    /// The first token at a place or after it.
    fn at(&self, place: u32) -> usize {
        let index = self.tokens.partition_point(|token| token.start < place);
        index.min(self.tokens.len() - 1)
    }

    fn kind(&self, index: usize) -> Kind {
        self.tokens[index.min(self.tokens.len() - 1)].kind
    }

    /// The first token of some kinds at a place or after it.
    fn after(&self, place: u32, wanted: [Kind; 2]) -> usize {
        let mut index = self.at(place);
        while !wanted.contains(&self.kind(index)) && index + 1 < self.tokens.len() {
            index += 1;
        }
        index
    }

    fn tight(&self, index: usize) -> bool {
        self.tokens.get(index).is_some_and(|token| !token.space)
    }

    fn expression(&mut self, node: &Expr) {
        let start = self.at(node.span.start);
        match &node.kind {
            ExprKind::Binary {
                op, right, op_span, ..
            } if op_span.start < op_span.end => {
                let index = self.at(op_span.start);
                match op {
                    BinaryOp::Power => self.power(index, right),
                    BinaryOp::Add
                    | BinaryOp::Subtract
                    | BinaryOp::PlusMinus
                    | BinaryOp::Union
                    | BinaryOp::Intersection
                    | BinaryOp::Solve
                    | BinaryOp::Frobenius => self.roles[index] = Role::Loose,
                    BinaryOp::Juxtapose => {}
                    _ => self.roles[index] = Role::Close,
                }
            }
            ExprKind::Unary { op, operand } => match op {
                UnaryOp::Negate if self.kind(start) == Kind::Minus => {
                    self.roles[start] = Role::Negate;
                }
                UnaryOp::Transpose => {
                    let last = self.at(node.span.end).saturating_sub(1);
                    let caret = last.saturating_sub(1);
                    let written = self.tokens[caret].start >= operand.span.end;
                    if self.kind(caret) == Kind::Caret && self.tight(last) && written {
                        self.roles[caret] = Role::Transpose;
                    }
                }
                _ => {}
            },
            ExprKind::Norm {
                operand, double, ..
            } => {
                let close = self.after(operand.span.end, [Kind::Bar, Kind::DoubleBar]);
                self.roles[start] = Role::OpenBar;
                self.roles[close] = match double {
                    true => Role::CloseDoubleBar,
                    false => Role::CloseBar,
                };
            }
            ExprKind::Inner { right, .. } => {
                let close = self.after(right.span.end, [Kind::Greater, Kind::RightAngle]);
                self.roles[start] = Role::OpenAngle;
                self.roles[close] = Role::CloseAngle;
            }
            ExprKind::Matrix(_) => self.roles[start] = Role::Matrix,
            ExprKind::Derivative { denominators, .. } => {
                for (variable, _) in denominators {
                    let index = self.at(variable.span.end);
                    if self.kind(index) == Kind::Caret {
                        self.roles[index] = Role::Power;
                    }
                }
            }
            _ => {}
        }
    }

    /// `^2` and `^-2` can be superscripts.
    fn power(&mut self, caret: usize, right: &Expr) {
        let (number, place) = match &right.kind {
            ExprKind::Unary {
                op: UnaryOp::Negate,
                operand,
            } => (&operand.kind, caret + 2),
            kind => (kind, caret + 1),
        };
        let is_number = matches!(number, ExprKind::Integer(_));
        let is_written = matches!(self.kind(place), Kind::Integer(_));
        if self.kind(caret) == Kind::Caret && is_number && is_written {
            self.roles[caret] = Role::Power;
        }
    }
}
