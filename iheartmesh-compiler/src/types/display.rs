//! How types are shown in messages: as one writes them.

use std::fmt;

use super::{Dimension, ElementKind, MeshId, MeshKind, Number, Type};

impl fmt::Display for ElementKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            ElementKind::Vertex => "vertex",
            ElementKind::Edge => "edge",
            ElementKind::Face => "face",
            ElementKind::Cell => "cell",
        })
    }
}

impl fmt::Display for MeshKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            MeshKind::EdgeMesh => "EdgeMesh",
            MeshKind::FaceMesh => "FaceMesh",
            MeshKind::CellMesh => "CellMesh",
        })
    }
}

/// The plural of an element kind.
pub fn plural(kind: ElementKind) -> &'static str {
    match kind {
        ElementKind::Vertex => "vertices",
        ElementKind::Edge => "edges",
        ElementKind::Face => "faces",
        ElementKind::Cell => "cells",
    }
}

fn superscript(text: &str) -> Option<String> {
    text.chars()
        .map(|c| match c {
            '0' => Some('⁰'),
            '1' => Some('¹'),
            '2' => Some('²'),
            '3' => Some('³'),
            '4'..='9' => char::from_u32('⁰' as u32 + (c as u32 - '0' as u32)),
            '×' => Some('ˣ'),
            _ => None,
        })
        .collect()
}

fn letter(number: Number) -> char {
    match number {
        Number::Real => 'ℝ',
        Number::Integer => 'ℤ',
    }
}

fn sized(f: &mut fmt::Formatter<'_>, number: Number, size: &str) -> fmt::Result {
    match superscript(size) {
        Some(size) => write!(f, "{}{size}", letter(number)),
        None if size.chars().count() == 1 => write!(f, "{}^{size}", letter(number)),
        None => write!(f, "{}^({size})", letter(number)),
    }
}

fn list(f: &mut fmt::Formatter<'_>, items: &[Type], separator: &str) -> fmt::Result {
    for (k, item) in items.iter().enumerate() {
        if k > 0 {
            f.write_str(separator)?;
        }
        write!(f, "{item}")?;
    }
    Ok(())
}

impl fmt::Display for Type {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = |rows: &Dimension, columns: &Dimension| format!("{rows}×{columns}");
        match self {
            Type::Scalar(number) => write!(f, "{}", letter(*number)),
            Type::Boolean => f.write_str("condition"),
            Type::Element(element) => write!(f, "{}", element.kind),
            Type::Vector {
                space: Some(space), ..
            } => write!(f, "chain of {}", plural(space.kind)),
            Type::Vector {
                number,
                length,
                sparse,
                ..
            } => {
                sized(f, *number, &length.to_string())?;
                f.write_str(if *sparse { " sparse" } else { "" })
            }
            Type::Matrix {
                spaces: Some((rows, columns)),
                ..
            } => write!(
                f,
                "boundary matrix from {} to {}",
                plural(columns.kind),
                plural(rows.kind)
            ),
            Type::Matrix {
                number,
                rows,
                columns,
                sparse,
                ..
            } => {
                sized(f, *number, &size(rows, columns))?;
                f.write_str(if *sparse { " sparse" } else { "" })
            }
            Type::Sequence { item, .. } => match &**item {
                Type::Element(element) => write!(f, "sequence of {}", plural(element.kind)),
                Type::Set(_) if item.element_of_set().is_some() => {
                    write!(
                        f,
                        "sequence of {}",
                        item.to_string().replacen("set", "sets", 1)
                    )
                }
                item => write!(f, "sequence of {item}"),
            },
            Type::Set(item) => match **item {
                Type::Element(element) => write!(f, "set of {}", plural(element.kind)),
                _ => write!(f, "{{{item}}}"),
            },
            Type::Tuple(items) => {
                f.write_str("(")?;
                list(f, items, ", ")?;
                f.write_str(")")
            }
            Type::CellularSet(_) => f.write_str("CellularSet"),
            Type::Function { parameters, result } => {
                if parameters.is_empty() {
                    f.write_str("∅")?;
                }
                list(f, parameters, ", ")?;
                write!(f, " → {result}")
            }
            Type::Mesh(kind, _) => write!(f, "{kind}"),
            Type::Error => f.write_str("?"),
        }
    }
}

impl Type {
    /// How a sentence calls a value of this type: `a vertex`, `an edge`, `a set of faces`, `ℝ³`.
    pub fn described(&self) -> String {
        let article = match self {
            Type::Element(_)
            | Type::Vector { space: Some(_), .. }
            | Type::Matrix {
                spaces: Some(_), ..
            }
            | Type::Sequence { .. }
            | Type::CellularSet(_)
            | Type::Mesh(..) => true,
            Type::Set(item) if item.is_error() => return "an empty set".to_owned(),
            Type::Set(item) => item.is_element(),
            Type::Tuple(_) => return format!("a tuple {self}"),
            Type::Function { .. } => return format!("a function {self}"),
            _ => false,
        };
        let text = self.to_string();
        match article {
            true if text.starts_with(['e', 'E']) => format!("an {text}"),
            true => format!("a {text}"),
            false => text,
        }
    }

    /// The mesh that a value of this type belongs to.
    pub fn owner(&self) -> Option<MeshId> {
        match self {
            Type::Element(element) => Some(element.mesh),
            Type::Vector { space, .. } => space.map(|space| space.mesh),
            Type::Matrix { spaces, .. } => spaces.map(|(rows, _)| rows.mesh),
            Type::Sequence { index, .. } => index.map(|index| index.mesh),
            Type::Set(item) => item.owner(),
            Type::Tuple(items) => items.iter().find_map(Type::owner),
            Type::CellularSet(mesh) => *mesh,
            Type::Mesh(_, mesh) => Some(*mesh),
            _ => None,
        }
    }
}
