//! Canonical text of a tree: minimal parentheses, one item on a line, and read back it gives the same tree up to
//! spans. Descriptions stay; comments are not part of the tree.

mod binder;
mod expression;
mod types;
mod visible;

use std::collections::BTreeSet;

use unicode_normalization::char::is_combining_mark;

use super::ast::*;
use super::{letters, spelling};
use expression::Tail;

/// Which signs the text is written with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spelling {
    /// The signs of mathematics: `∑_(v ∈ V) ‖x_v‖²`.
    Unicode,
    /// Their ASCII spellings: `sum_(v \in V) ||x_v||^2`. Names keep letters that have no ASCII spelling.
    Ascii,
}

/// The text of a module.
pub fn module(module: &Module, spelling: Spelling) -> String {
    let mut printer = Printer {
        ascii: spelling == Spelling::Ascii,
        module: visible::module(module),
        item: BTreeSet::new(),
        bars: false,
    };
    let mut text = String::new();
    for item in &module.items {
        printer.item = visible::item(item);
        text += &printer.item(item);
        text.push('\n');
    }
    text
}

/// What printing depends on.
struct Printer {
    ascii: bool,
    /// Words that may be written without back-ticks anywhere.
    module: BTreeSet<String>,
    /// Words that may be written without back-ticks in this item.
    item: BTreeSet<String>,
    /// Directly between bars, where a further bar would close them.
    bars: bool,
}

impl Printer {
    /// A sign of the language.
    fn sign(&self, sign: char) -> String {
        if !self.ascii {
            return sign.to_string();
        }
        let text = match sign {
            'ℝ' => "RR",
            'ℤ' => "ZZ",
            '∑' => "sum",
            '∏' => "prod",
            '∫' => "int",
            '±' => "+-",
            '≠' => "!=",
            '≤' => "<=",
            '≥' => ">=",
            '→' => "->",
            '∅' => "{}",
            _ => {
                return match spelling::name_of(sign) {
                    Some(name) => format!("\\{name}"),
                    None => sign.to_string(),
                };
            }
        };
        text.to_owned()
    }

    /// A sign that stands before a name or a number.
    fn prefix(&self, sign: char) -> String {
        let blank = if self.ascii { " " } else { "" };
        self.sign(sign) + blank
    }

    fn name(&self, name: &Name) -> String {
        let text = name.text.as_str();
        let single = letters::letter(text).is_some_and(|(length, _)| length == text.len());
        let known = || self.item.contains(text) || self.module.contains(text);
        let root = text.strip_suffix("⁻¹").unwrap_or(text);
        let plain = single || is_word(root) && !is_keyword(text) && known();
        if !plain {
            return format!("`{text}`");
        }
        let text = if self.ascii {
            ascii_word(text)
        } else {
            text.to_owned()
        };
        match root.len() < name.text.len() && self.ascii {
            true => text.replace("⁻¹", "^-1"),
            false => text,
        }
    }

    fn names(&self, names: &[Name]) -> String {
        let names: Vec<String> = names.iter().map(|name| self.name(name)).collect();
        names.join(", ")
    }

    /// A name in an import, where `_` is a letter.
    fn import_name(&self, name: &Name) -> String {
        let root = name.text.strip_suffix("⁻¹").unwrap_or(&name.text);
        let plain = root.split('_').all(|part| part.is_empty() || is_word(part));
        if !plain || root.is_empty() || root.starts_with(|c: char| c.is_ascii_digit()) {
            return format!("`{}`", name.text);
        }
        let keyword = is_keyword(&name.text) || name.text == "as";
        match (keyword, self.ascii) {
            (true, _) => format!("`{}`", name.text),
            (false, true) => ascii_word(&name.text).replace("⁻¹", "^-1"),
            (false, false) => name.text.clone(),
        }
    }

    fn item(&mut self, item: &Item) -> String {
        match &item.kind {
            ItemKind::Import(node) => self.import(node),
            ItemKind::Parameters(list) => {
                let list: Vec<String> = list.iter().map(|node| self.declaration(node)).collect();
                let head = if list.len() > 1 { "where\n" } else { "" };
                head.to_owned() + &list.join("\n")
            }
            ItemKind::Function(node) => self.function(node),
            ItemKind::Definition(node) => self.definition(node, Tail::Full),
            ItemKind::Expression(node) => {
                let text = self.right_side(node, Tail::Full);
                // A leading name and a colon would be a declaration.
                match text.contains(" : ") {
                    true => format!("({text})"),
                    false => text,
                }
            }
        }
    }

    fn import(&self, node: &Import) -> String {
        let names = match &node.names {
            None => "*".to_owned(),
            Some(list) => {
                let list = list.iter().map(|import| match &import.rename {
                    None => self.import_name(&import.name),
                    Some(rename) => {
                        let name = self.import_name(&import.name);
                        format!("{name} as {}", self.import_name(rename))
                    }
                });
                list.collect::<Vec<_>>().join(", ")
            }
        };
        let module = self.import_name(&node.module);
        if node.arguments.is_empty() {
            return format!("{names} from {module}");
        }
        let arguments = node.arguments.iter().map(|name| self.import_name(name));
        let arguments: Vec<String> = arguments.collect();
        format!("{names} from {module}({})", arguments.join(", "))
    }

    fn function(&mut self, node: &Function) -> String {
        let mut text = self.name(&node.name);
        if !node.subscripts.is_empty() {
            let subscripts = node.subscripts.iter().map(|name| self.name(name));
            text += &format!("_{}", subscripts.collect::<Vec<_>>().join(","));
        }
        if let Some(parameters) = &node.parameters {
            text += &format!("({})", self.names(parameters));
        }
        text += &format!(" = {}", self.right_side(&node.body, Tail::Full));
        let declarations = node.declarations.iter();
        let declarations: Vec<String> = declarations.map(|node| self.declaration(node)).collect();
        let locals = node.locals.iter();
        let locals: Vec<String> = locals
            .map(|node| self.definition(node, Tail::Term))
            .collect();
        let described = node
            .declarations
            .iter()
            .any(|node| node.description.is_some());
        let mut parts = Vec::new();
        match described {
            // A description takes the rest of the line, so it comes last.
            true => {
                parts.extend(locals);
                parts.push(declarations.join(", "));
            }
            false => {
                parts.extend((!declarations.is_empty()).then(|| declarations.join(", ")));
                parts.extend(locals);
            }
        }
        if !parts.is_empty() {
            text += "\n    where ";
            text += &parts.join(",\n        ");
        }
        text
    }

    fn definition(&mut self, node: &Definition, tail: Tail) -> String {
        let mut targets = Vec::new();
        for target in &node.targets {
            targets.push(self.name(&target.name) + &self.subscripts(&target.subscripts));
        }
        let sign = if node.add { "+=" } else { "=" };
        let value = self.right_side(&node.value, tail);
        format!("{} {sign} {value}", targets.join(", "))
    }
}

/// Whether a text is a letter followed by letters and digits.
fn is_word(text: &str) -> bool {
    let mut rest = text;
    while !rest.is_empty() {
        let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
        let length = match letters::letter(rest) {
            Some((length, _)) => length,
            None if digits > 0 && rest.len() < text.len() => digits,
            None => return false,
        };
        rest = &rest[length..];
    }
    !text.is_empty()
}

fn is_keyword(text: &str) -> bool {
    matches!(
        text,
        "where"
            | "given"
            | "with"
            | "for"
            | "if"
            | "otherwise"
            | "and"
            | "or"
            | "from"
            | "sum"
            | "prod"
            | "int"
            | "argmin"
            | "argmax"
            | "subject"
            | "RR"
            | "ZZ"
    )
}

/// A word with its Greek letters spelt out, if no letter after them would run into their names.
pub(super) fn ascii_word(text: &str) -> String {
    let mut out = String::new();
    let mut letters = text.chars().peekable();
    while let Some(c) = letters.next() {
        let spelt = spelling::name_of(c).filter(|_| !c.is_ascii());
        let runs_on = |c: &char| c.is_ascii_alphabetic() || is_combining_mark(*c);
        let runs_on = letters.peek().is_some_and(runs_on);
        match spelt {
            Some(_) if runs_on => return text.to_owned(),
            Some(name) => out += &format!("\\{name}"),
            None => out.push(c),
        }
    }
    out
}
