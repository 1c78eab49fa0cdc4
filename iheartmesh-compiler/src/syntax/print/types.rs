//! Declarations and types.

use super::super::ast::*;
use super::super::spelling;
use super::Printer;
use super::expression::Tail;

impl Printer {
    pub(super) fn declaration(&mut self, node: &Declaration) -> String {
        let targets = node.targets.iter().map(|target| match &target.subscript {
            None => self.name(&target.name),
            Some(letter) => format!("{}_{}", self.name(&target.name), self.name(letter)),
        });
        let targets = targets.collect::<Vec<_>>().join(", ");
        let relation = match node.relation {
            Relation::Member => self.sign('∈'),
            Relation::Colon => ":".to_owned(),
            Relation::Subset => self.sign('⊂'),
        };
        let mut text = format!("{targets} {relation} {}", self.ty(&node.ty));
        if let Some((attribute, _)) = node.attribute {
            text += match attribute {
                Attribute::Index => " index",
                Attribute::Vertices => " vertices",
                Attribute::Edges => " edges",
                Attribute::Faces => " faces",
                Attribute::Cells => " tets",
            };
        }
        if let Some(description) = &node.description {
            text += &format!(" : {description}");
        }
        text
    }

    fn number(&self, number: Number) -> String {
        self.sign(match number {
            Number::Real => 'ℝ',
            Number::Integer => 'ℤ',
        })
    }

    fn types(&mut self, list: &[Type], separator: &str) -> String {
        let list: Vec<String> = list.iter().map(|node| self.part(node)).collect();
        list.join(separator)
    }

    /// A type inside another one.
    fn part(&mut self, node: &Type) -> String {
        let text = self.ty(node);
        match node.kind {
            TypeKind::Tuple(_) | TypeKind::Function { .. } | TypeKind::Mapping { .. } => {
                format!("({text})")
            }
            _ => text,
        }
    }

    /// A type on one side of an arrow.
    fn side(&mut self, node: &Type) -> String {
        match node.kind {
            TypeKind::Tuple(_) => self.ty(node),
            _ => self.part(node),
        }
    }

    fn sides(&mut self, list: &[Type]) -> String {
        let list: Vec<String> = list.iter().map(|node| self.side(node)).collect();
        list.join(", ")
    }

    fn ty(&mut self, node: &Type) -> String {
        let cross = format!(" {} ", self.sign('×'));
        let arrow = self.sign('→');
        match &node.kind {
            TypeKind::Scalar(number) => self.number(*number),
            TypeKind::Vector {
                number,
                length,
                sparse,
            } => {
                let size = match &length.kind {
                    ExprKind::Integer(size) if !self.ascii => spelling::superscript_number(*size),
                    ExprKind::Integer(size) => format!("^{size}"),
                    ExprKind::Name(name) => format!("^{}", self.name(name)),
                    _ => format!("^({})", self.show(length, 0, Tail::Term)),
                };
                self.number(*number) + &size + few(*sparse)
            }
            TypeKind::Matrix {
                number,
                rows,
                columns,
                sparse,
            } => {
                let rows = self.show(rows, 0, Tail::Term);
                let columns = self.show(columns, 0, Tail::Term);
                let narrow = if self.ascii { cross.as_str() } else { "×" };
                format!(
                    "{}^({rows}{narrow}{columns}){}",
                    self.number(*number),
                    few(*sparse)
                )
            }
            TypeKind::Set(parts) => {
                // A bare integer exponent would make a set of tuples.
                if let [Type { kind, .. }] = parts.as_slice()
                    && let TypeKind::Vector {
                        number,
                        length,
                        sparse,
                    } = kind
                {
                    let length = self.show(length, 0, Tail::Term);
                    return format!("{{{}^({length}){}}}", self.number(*number), few(*sparse));
                }
                format!("{{{}}}", self.types(parts, &cross))
            }
            TypeKind::SetOfAlternatives(parts) => {
                let or = format!(" {} ", self.sign('∨'));
                format!("{{{}}}", self.types(parts, &or))
            }
            TypeKind::Tuple(parts) => self.types(parts, &cross),
            TypeKind::Function {
                parameters,
                results,
            } => {
                let parameters = match parameters.is_empty() {
                    true => self.sign('∅'),
                    false => self.sides(parameters),
                };
                format!("{parameters} {arrow} {}", self.sides(results))
            }
            TypeKind::Mapping { from, to } => {
                let to = self.side(to);
                format!("{} {arrow} {to}", self.name(from))
            }
            TypeKind::Mesh(kind) => format!("{kind:?}"),
            TypeKind::ElementSet(kind) => format!("{kind:?}Set"),
            TypeKind::CellularSet => "CellularSet".to_owned(),
            TypeKind::Named(name) => self.name(name),
            TypeKind::Members(set) => self.show(set, 0, Tail::Term),
        }
    }
}

fn few(sparse: bool) -> &'static str {
    if sparse { " sparse" } else { "" }
}
