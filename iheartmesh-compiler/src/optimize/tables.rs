//! Tables with the same rows are stored once.
//!
//! ```text
//! rows of v: members of Faces(v), ⟨j⟩ ⟨k⟩     and, elsewhere,     rows of w: members of Faces(w), ⟨k⟩
//!     ⟶  one table with the columns j and k, which both read
//! ```
//!
//! Several sums over a neighbourhood, in one definition or in several, need the same rows. Whether two spaces have the same
//! is seen from the sets that their rows are the members of. A table has the columns that any of its spaces needs, but is at
//! most twice as wide as the narrowest of them: what is read beside what is needed costs time. Rows that are turned
//! (the pass `corners`) change afterwards, and keep a table of their own.

use std::collections::{BTreeMap, HashMap};

use super::binders::Binders;
use super::{Column, Plan, Rows, Space, Staged, StagedProgram, rewrite};
use crate::ir::{Arena, ExprId, Kind, VariableId};

/// The tables of a program.
#[derive(Clone, Debug, Default)]
pub struct Tables {
    /// The tables as spaces of one plan.
    pub plan: Plan,
    /// The space in it that each space of a plan is stored as.
    pub of: BTreeMap<VariableId, VariableId>,
}

/// Finds the tables of all plans. Without `unite` every space has its own.
pub fn run(staged: &mut StagedProgram, unite: bool) {
    let StagedProgram {
        program,
        functions,
        globals,
        tables,
        ..
    } = staged;
    let mut union = Union {
        arena: &mut program.arena,
        binders: Binders::default(),
        entries: Vec::new(),
        of: BTreeMap::new(),
        unite,
    };
    let functions = functions.values_mut();
    let mut codes: Vec<&mut Staged> = functions.chain(globals.values_mut()).collect();
    // what has its columns by their numbers comes first, since these then stay
    codes.sort_by_key(|code| !is_fixed(code));
    let mut moved: Vec<HashMap<(VariableId, u32), u32>> = Vec::new();
    for code in &codes {
        moved.push(union.plan(&code.plan, is_fixed(code)));
    }
    for (code, moved) in codes.iter_mut().zip(&moved) {
        union.read(code, moved);
    }
    *tables = Tables {
        plan: Plan {
            spaces: union.entries.into_iter().map(|e| e.space).collect(),
            ..Plan::default()
        },
        of: union.of,
    };
}

/// Whether something besides the bodies names columns.
fn is_fixed(code: &Staged) -> bool {
    let has_orbit = code.whole.as_ref().is_some_and(|w| w.orbit.is_some());
    has_orbit || !code.plan.locals.is_empty()
}

/// A table.
struct Entry {
    space: Space,
    /// What the rows are the members of, and the columns, as the forms of the pass `binders`.
    set: Option<ExprId>,
    columns: Vec<ExprId>,
    /// The number of columns that each of its spaces that has some needs at least.
    narrowest: usize,
    /// Whether the rows of all spaces below are numbered by those of this one.
    flat: bool,
    /// Whether no other space may be stored here.
    alone: bool,
}

struct Union<'a> {
    arena: &'a mut Arena,
    binders: Binders,
    entries: Vec<Entry>,
    of: BTreeMap<VariableId, VariableId>,
    unite: bool,
}

impl Union<'_> {
    /// Finds the tables of a plan; gives the columns whose numbers change.
    fn plan(&mut self, plan: &Plan, is_fixed: bool) -> HashMap<(VariableId, u32), u32> {
        let mut names = HashMap::new();
        let mut moved = HashMap::new();
        for space in &plan.spaces {
            if matches!(space.rows, Rows::Corners(_)) {
                continue;
            }
            let rows = match space.rows {
                Rows::Members(set) => Rows::Members(self.renamed(set, &names).0),
                rows => rows,
            };
            let own = Space {
                variable: space.variable,
                parent: space.parent.map(|p| self.of[&p]),
                rows,
                columns: Vec::new(),
            };
            let set = match rows {
                Rows::Members(set) => Some(self.binders.form(self.arena, set)),
                _ => None,
            };
            let alone = !self.unite || plan.corners.iter().any(|c| c.of == space.variable);
            let entry = Entry {
                space: own,
                set,
                columns: Vec::new(),
                narrowest: usize::MAX,
                flat: is_flat(plan, space),
                alone,
            };
            // what names the columns of such a space, too, is not told of other numbers
            let is_fixed = is_fixed || alone;
            let candidates: Vec<usize> = (0..self.entries.len())
                .filter(|k| self.entries[*k].has_rows_of(&entry))
                .collect();
            // the variable of the rows is that of the table
            let place = candidates
                .into_iter()
                .find(|k| self.takes(*k, space, &names, is_fixed))
                .unwrap_or(self.entries.len());
            if place == self.entries.len() {
                self.entries.push(entry);
            }
            if !space.columns.is_empty() {
                let entry = &mut self.entries[place];
                entry.narrowest = entry.narrowest.min(space.columns.len());
            }
            let variable = self.entries[place].space.variable;
            self.of.insert(space.variable, variable);
            names.insert(space.variable, self.arena.variable(variable));
            for (k, column) in space.columns.iter().enumerate() {
                let (value, form) = self.renamed(column.value, &names);
                let entry = &mut self.entries[place];
                let number = match is_fixed {
                    true => (k < entry.columns.len()).then_some(k),
                    false => entry.columns.iter().position(|c| *c == form),
                };
                let number = number.unwrap_or_else(|| {
                    entry.columns.push(form);
                    entry.space.columns.push(Column {
                        value,
                        may_fail: column.may_fail,
                    });
                    entry.columns.len() - 1
                });
                if number != k {
                    moved.insert((space.variable, k as u32), number as u32);
                }
            }
        }
        moved
    }

    /// Whether a table can have the columns of a space: with their numbers, where these must stay.
    fn takes(
        &mut self,
        place: usize,
        space: &Space,
        names: &HashMap<VariableId, ExprId>,
        is_fixed: bool,
    ) -> bool {
        let entry = &self.entries[place];
        let (table, narrowest) = (
            entry.space.variable,
            entry.narrowest.min(space.columns.len()),
        );
        let known = entry.columns.clone();
        let mut names = names.clone();
        names.insert(space.variable, self.arena.variable(table));
        let columns = space
            .columns
            .iter()
            .map(|column| self.renamed(column.value, &names).1);
        let columns: Vec<ExprId> = columns.collect();
        if is_fixed && (0..known.len().min(columns.len())).any(|k| known[k] != columns[k]) {
            return false;
        }
        let more = columns.iter().filter(|c| !known.contains(c)).count();
        columns.is_empty() || known.is_empty() || known.len() + more <= 2 * narrowest
    }

    /// A value in the variables of the tables, and its form.
    fn renamed(&mut self, value: ExprId, names: &HashMap<VariableId, ExprId>) -> (ExprId, ExprId) {
        let value = rewrite::put(self.arena, value, names, &mut HashMap::new());
        (value, self.binders.form(self.arena, value))
    }

    /// Makes a definition read its tables.
    fn read(&mut self, code: &mut Staged, moved: &HashMap<(VariableId, u32), u32>) {
        let mut rule = |arena: &mut Arena, e: ExprId| match *arena.kind(e) {
            Kind::Column(space, k) => match moved.get(&(space, k)) {
                Some(number) => {
                    let ty = arena.ty(e).clone();
                    let column = arena.add(Kind::Column(space, *number), ty);
                    if let Some(span) = arena.origin(e) {
                        arena.note_origin(column, span);
                    }
                    column
                }
                None => e,
            },
            _ => e,
        };
        if !moved.is_empty() {
            let mut memo = HashMap::new();
            code.body = rewrite::upward(self.arena, code.body, &mut memo, &mut rule);
            if let Some(whole) = &mut code.whole {
                whole.body = rewrite::upward(self.arena, whole.body, &mut memo, &mut rule);
            }
        }
        let parents: HashMap<VariableId, Option<VariableId>> = code
            .plan
            .spaces
            .iter()
            .map(|s| (s.variable, s.parent))
            .collect();
        for space in &mut code.plan.spaces {
            let Some(table) = self.of.get(&space.variable) else {
                continue;
            };
            let entry = self.entries.iter().find(|e| e.space.variable == *table);
            // the key of a plan that needs none of its columns does not read its row
            if let Some(entry) = entry
                && (space.rows.is_several() || !space.columns.is_empty())
            {
                let mut names = HashMap::new();
                let mut above = Some(space.variable);
                while let Some(variable) = above {
                    names.insert(self.of[&variable], self.arena.variable(variable));
                    above = parents[&variable];
                }
                let columns = entry.space.columns.iter().map(|column| Column {
                    value: rewrite::put(self.arena, column.value, &names, &mut HashMap::new()),
                    may_fail: column.may_fail,
                });
                space.columns = columns.collect();
            }
        }
    }
}

impl Entry {
    /// Whether two spaces have the same rows.
    fn has_rows_of(&self, other: &Entry) -> bool {
        let element = |rows| match rows {
            Rows::Key(element) | Rows::Universe(element) => Some(element),
            Rows::Members(_) | Rows::Corners(_) => None,
        };
        !self.alone
            && !other.alone
            && self.space.parent == other.space.parent
            && element(self.space.rows) == element(other.space.rows)
            && self.set == other.set
            && self.flat == other.flat
    }
}

/// Whether all spaces below one are directly below it.
fn is_flat(plan: &Plan, space: &Space) -> bool {
    let mut below = plan.below(Some(space.variable));
    below.all(|s| {
        matches!(s.rows, Rows::Corners(_)) || plan.below(Some(s.variable)).next().is_none()
    })
}
