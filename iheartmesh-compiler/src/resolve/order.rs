//! Puts the definitions of a module in an order in which each follows what it depends on, and finds cycles.
//!
//! Functions may call each other and themselves; a definition without parameters may not need its own value.

use std::collections::BTreeMap;

use super::symbols::{Walked, item_span, walk_definition, walk_function};
use super::{Meaning, Module};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::syntax::ast::{ItemKind, Name};

/// The items of a module that define something, each after those that it depends on; of several that are
/// possible the first in the text.
pub fn order(module: &Module, diagnostics: &mut Diagnostics) -> Vec<usize> {
    let mut needs: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (index, item) in module.syntax.items.iter().enumerate() {
        let mut list = Vec::new();
        let mut found = |name: &Name| {
            for meaning in module
                .symbols
                .get(&name.text)
                .iter()
                .flat_map(|s| &s.meanings)
            {
                match meaning {
                    Meaning::Definition { item, .. } => list.push(*item),
                    Meaning::Functions(items) => list.extend(items),
                    _ => {}
                }
            }
        };
        match &item.kind {
            ItemKind::Function(f) => walk_function(f, &mut found),
            ItemKind::Definition(d) => walk_definition(d, &mut found),
            ItemKind::Expression(e) => {
                super::names::FreeNames::new(Vec::new(), &mut found).expr(e);
                Walked::default()
            }
            ItemKind::Import(_) | ItemKind::Parameters(_) => continue,
        };
        needs.insert(index, list);
    }
    // what defines entries of a value or adds to it belongs to its definition, and sees what stands above
    for (name, further) in &module.further {
        let symbol = module.symbols.get(name).and_then(|s| s.meanings.first());
        let Some(Meaning::Definition { item: first, .. }) = symbol else {
            continue;
        };
        for item in further {
            let own = needs.insert(*item, vec![*first]).unwrap_or_default();
            let all = needs.entry(*first).or_default();
            all.extend(own.into_iter().filter(|need| need != first));
        }
    }
    let mut visit = Visit {
        module,
        needs: &needs,
        state: BTreeMap::new(),
        path: Vec::new(),
        order: Vec::new(),
        diagnostics,
    };
    for &item in needs.keys() {
        visit.item(item);
    }
    visit.order
}

#[derive(Clone, Copy, PartialEq)]
enum State {
    Open,
    Done,
}

struct Visit<'a> {
    module: &'a Module,
    needs: &'a BTreeMap<usize, Vec<usize>>,
    state: BTreeMap<usize, State>,
    path: Vec<usize>,
    order: Vec<usize>,
    diagnostics: &'a mut Diagnostics,
}

impl Visit<'_> {
    fn item(&mut self, item: usize) {
        match self.state.get(&item) {
            Some(State::Done) => return,
            Some(State::Open) => {
                self.cycle(item);
                return;
            }
            None => {}
        }
        self.state.insert(item, State::Open);
        self.path.push(item);
        for &need in self.needs.get(&item).into_iter().flatten() {
            self.item(need);
        }
        self.path.pop();
        self.state.insert(item, State::Done);
        self.order.push(item);
    }

    fn cycle(&mut self, item: usize) {
        let start = self.path.iter().position(|p| *p == item).unwrap_or(0);
        let cycle = &self.path[start..];
        let is_function =
            |i: &usize| matches!(self.module.syntax.items[*i].kind, ItemKind::Function(_));
        let Some(definition) = cycle.iter().find(|i| !is_function(i)) else {
            return;
        };
        let name = |i: &usize| match &self.module.syntax.items[*i].kind {
            ItemKind::Function(f) => f.name.text.clone(),
            ItemKind::Definition(d) => d
                .targets
                .first()
                .map_or(String::new(), |t| t.name.text.clone()),
            _ => String::new(),
        };
        // shown from the definition on
        let first = cycle.iter().position(|i| i == definition).unwrap_or(0);
        let cycle: Vec<usize> = [&cycle[first..], &cycle[..first]].concat();
        let mut names: Vec<String> = cycle.iter().map(|i| format!("`{}`", name(i))).collect();
        names.push(names[0].clone());
        let message = format!("the value of {} depends on itself", names[0]);
        let place = |i: &usize| item_span(&self.module.syntax, *i);
        let mut diagnostic = Diagnostic::error(place(definition), message);
        if let [_] = cycle.as_slice() {
            let help = "only functions may use themselves; give this value another name";
            self.diagnostics.push(diagnostic.help(help));
            return;
        }
        diagnostic = diagnostic.here(format!("needs {}", names[1]));
        for (k, item) in cycle.iter().enumerate().skip(1) {
            diagnostic = diagnostic.label(place(item), format!("needs {}", names[k + 1]));
        }
        self.diagnostics
            .push(diagnostic.help(format!("the circle is {}", names.join(" → "))));
    }
}
