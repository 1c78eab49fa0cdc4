//! Which sources a module is compiled with, or why they cannot be had.

use crate::collection::{Collection, STANDARD};
use crate::invocation::Invocation;
use crate::module::{Module, Need, Route};
use iheartmesh_compiler::diagnostic::Diagnostic;
use iheartmesh_compiler::source::Source;
use iheartmesh_compiler::span::{SourceId, Span};
use std::collections::BTreeSet;

/// A module under the name by which it is imported.
#[derive(Debug)]
pub struct Found<'a> {
    /// The name in `from Name`.
    pub name: &'a str,
    /// The module.
    pub module: &'a Module,
}

/// Why the imports of a module cannot be had.
#[derive(Debug)]
pub struct Problem {
    /// What the user gets to see.
    pub diagnostic: Diagnostic,
    /// Of a circle, the modules on it: one circle is reported once in a call.
    pub circle: Option<BTreeSet<String>>,
}

/// Every module that `module` imports, directly or not; a module stands behind those that it imports.
pub fn of<'a>(
    module: &'a Module,
    call: &'a Invocation,
    of_call: &'a [Module],
    collection: &'a Collection,
) -> Result<Vec<Found<'a>>, Vec<Problem>> {
    let mut search = Search {
        root: module,
        call,
        of_call,
        collection,
        stack: vec![module],
        found: Vec::new(),
        problems: Vec::new(),
    };
    for need in &module.needs {
        search.follow(module, need, &need.name);
    }
    match search.problems.is_empty() {
        true => Ok(search.found),
        false => Err(search.problems),
    }
}

struct Search<'a> {
    root: &'a Module,
    call: &'a Invocation,
    of_call: &'a [Module],
    collection: &'a Collection,
    /// The modules on the way from the root.
    stack: Vec<&'a Module>,
    found: Vec<Found<'a>>,
    problems: Vec<Problem>,
}

impl<'a> Search<'a> {
    /// `first` is the import of the root that led here: diagnostics point there.
    fn follow(&mut self, from: &'a Module, need: &'a Need, first: &str) {
        let Some(target) = self.collection.find(self.of_call, from, need) else {
            return self.missing(from, need, first);
        };
        if let Some(start) = self.stack.iter().position(|m| m.id == target.id) {
            return self.circle(start, first);
        }
        let same_name = self.found.iter().find(|f| f.name == need.name);
        if let Some(other) = same_name.map(|f| f.module)
            && other.id != target.id
            && other.source.text != target.source.text
        {
            return self.clash(from, need, first);
        }
        if same_name.is_some() {
            return;
        }
        self.stack.push(target);
        for further in &target.needs {
            self.follow(target, further, first);
        }
        self.stack.pop();
        self.found.push(Found {
            name: &need.name,
            module: target,
        });
    }

    fn problem(
        &mut self,
        first: &str,
        circle: Option<BTreeSet<String>>,
        message: String,
        help: String,
    ) {
        let diagnostic = Diagnostic::error(import_span(&self.root.source, first), message);
        self.problems.push(Problem {
            diagnostic: diagnostic.help(help),
            circle,
        });
    }

    fn missing(&mut self, from: &Module, need: &Need, first: &str) {
        let name = &need.name;
        let own = from.id == self.root.id;
        let by = match own {
            true => String::new(),
            false => format!(", which `{}` imports", from.name),
        };
        let (message, help) = match &need.route {
            Route::Closed(path) if !own => (
                format!("cannot reach the module `{name}`{by}"),
                format!(
                    "`{}` names it `{path}`, which holds only there; write a path that starts with `crate`",
                    from.name
                ),
            ),
            _ => (format!("no module `{name}`{by}"), self.suggestion(name)),
        };
        self.problem(first, None, message, help);
    }

    fn suggestion(&self, name: &str) -> String {
        let of_call = self.of_call.iter().map(|m| m.name.clone());
        let used = self.call.uses.iter().map(|u| u.name.to_string());
        let known = STANDARD
            .iter()
            .map(|s| (*s).to_string())
            .chain(of_call)
            .chain(used);
        let near = known
            .filter(|candidate| *candidate != self.root.name)
            .map(|candidate| (distance(name, &candidate), candidate))
            .filter(|(distance, _)| *distance <= 1 + name.chars().count() / 4)
            .min();
        match near {
            Some((_, candidate)) => format!("there is a module `{candidate}`"),
            None => format!("`use path::{name};` in front of the `struct` says where it is"),
        }
    }

    fn circle(&mut self, start: usize, first: &str) {
        let round = &self.stack[start..];
        let circle = round.iter().map(|m| m.id.clone()).collect();
        let names: Vec<_> = round
            .iter()
            .chain(round.first())
            .map(|m| format!("`{}`", m.name))
            .collect();
        let message = match round {
            [only] => format!("`{}` imports itself", only.name),
            _ => format!(
                "modules import each other in a circle: {}",
                names.join(" → ")
            ),
        };
        let help = "move what both sides need into a module of its own".to_string();
        self.problem(first, Some(circle), message, help);
    }

    fn clash(&mut self, from: &Module, need: &Need, first: &str) {
        let name = &need.name;
        let message = format!("two different modules are imported as `{name}`");
        let help = match from.id == self.root.id {
            true => format!("`use path::{name} as Other;` gives this one another name"),
            false => format!(
                "one of them is imported by `{}`; give yours another name with `use path::{name} as Other;`",
                from.name
            ),
        };
        self.problem(first, None, message, help);
    }
}

/// Where the source says `from name`.
fn import_span(source: &Source, name: &str) -> Span {
    let text = &source.text;
    let starts_word = |at: usize| !text[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_');
    let place = text.match_indices("from").find_map(|(at, word)| {
        let rest = &text[at + word.len()..];
        let after = rest.trim_start_matches([' ', '\t', '`']);
        let ends = after.strip_prefix(name)?.chars().next();
        let whole = !ends.is_some_and(|c| c.is_alphanumeric() || c == '_');
        (whole && after.len() < rest.len() && starts_word(at)).then(|| text.len() - after.len())
    });
    let start = place.unwrap_or(0);
    Span::new(SourceId(0), start, start + place.map_or(0, |_| name.len()))
}

/// How many characters have to be changed, added or left out; capitals do not count.
fn distance(left: &str, right: &str) -> usize {
    let right: Vec<char> = right.to_lowercase().chars().collect();
    let mut row: Vec<usize> = (0..=right.len()).collect();
    for (i, a) in left.to_lowercase().chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, b) in right.iter().enumerate() {
            let replaced = diagonal + usize::from(a != *b);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[right.len()]
}

#[cfg(test)]
mod tests {
    use super::{distance, import_span};
    use iheartmesh_compiler::source::Source;

    #[test]
    fn the_import_of_a_module_is_found() {
        let source = Source::file("", "from_x = 2\nA, B from Rings2(M)\nC  from\tRings(M)");
        let at = |name| import_span(&source, name).start as usize;
        assert!(source.text[at("Rings")..].starts_with("Rings(M)"));
        assert!(source.text[at("Rings2")..].starts_with("Rings2(M)"));
        assert_eq!(at("x"), 0);
    }

    #[test]
    fn distances_count_single_changes() {
        assert_eq!(distance("Neighbourhoods", "neighborhoods"), 1);
        assert_eq!(distance("Rings", "Rigns"), 2);
        assert_eq!(distance("", "abc"), 3);
        assert_eq!(distance("abc", "abc"), 0);
    }
}
