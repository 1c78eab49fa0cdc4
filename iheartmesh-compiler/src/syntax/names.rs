//! The first pass: which names an item and the whole module declare, and which of them are functions.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use super::copies::Copies;
use super::import_names::import_header;
use super::layout::{NONE, partners};
use super::letters::letter;
use super::lexer::Texts;
use super::token::{Kind, Token};
use super::{Export, ImportedNames, builtin};

/// Names with whether they are functions.
pub(super) type Names = BTreeMap<String, bool>;

/// What the first pass knows of an item.
#[derive(Clone, Debug, Default)]
pub(super) struct ItemNames {
    /// Its tokens.
    pub range: Range<usize>,
    /// Whether it defines a function.
    pub function: bool,
    /// Whether it is an import.
    pub import: bool,
    /// Names that are visible in this item only.
    pub names: Names,
}

/// What the first pass gives.
#[derive(Debug, Default)]
pub(super) struct Collected {
    pub module: Names,
    pub items: Vec<ItemNames>,
}

/// Declared names with their subscripts, up to a sign that says what they are.
struct Statement {
    targets: Vec<(String, Vec<String>)>,
    /// The sign after the targets.
    sign: Kind,
    /// Index of the token after the sign.
    next: usize,
    /// Names in parentheses after a single target.
    parameters: Option<Range<usize>>,
}

struct Collector<'a> {
    tokens: &'a [Token],
    partners: Vec<u32>,
    texts: &'a Texts,
    imports: &'a dyn ImportedNames,
    module: Names,
    item: ItemNames,
    /// Names declared by the `where` of the item.
    declared: BTreeSet<String>,
    copies: Copies,
}

/// Runs the first pass over laid-out tokens.
pub(super) fn collect(tokens: &[Token], texts: &Texts, imports: &dyn ImportedNames) -> Collected {
    let mut collector = Collector {
        tokens,
        partners: partners(tokens),
        texts,
        imports,
        module: Names::new(),
        item: ItemNames::default(),
        declared: BTreeSet::new(),
        copies: Copies::default(),
    };
    let mut items = Vec::new();
    let mut start = 0;
    for (index, token) in tokens.iter().enumerate() {
        if matches!(token.kind, Kind::Newline | Kind::End) {
            if start < index {
                collector.item(start..index);
                items.push(std::mem::take(&mut collector.item));
            }
            start = index + 1;
        }
    }
    std::mem::take(&mut collector.copies).follow(&mut collector.module);
    Collected {
        module: collector.module,
        items,
    }
}

fn add(names: &mut Names, name: &str, function: bool) {
    match names.get_mut(name) {
        Some(known) => *known |= function,
        None => drop(names.insert(name.to_owned(), function)),
    }
}

impl Collector<'_> {
    fn kind(&self, index: usize) -> Kind {
        self.tokens.get(index).map_or(Kind::End, |token| token.kind)
    }

    fn tight(&self, index: usize) -> bool {
        self.tokens.get(index).is_some_and(|token| !token.space)
    }

    fn item(&mut self, range: Range<usize>) {
        self.item = ItemNames {
            range: range.clone(),
            ..ItemNames::default()
        };
        self.declared.clear();
        let tokens = &self.tokens[range.clone()];
        if tokens.iter().any(|token| token.kind == Kind::From) {
            self.item.import = true;
            return self.import(range);
        }
        let heads = matches!(self.kind(range.start), Kind::Where);
        let start = range.start + heads as usize;
        match self.statement(start, range.end) {
            Ok(statement) => self.module_statement(statement, range),
            Err(_) => self.inside(start..range.end),
        }
    }

    fn module_statement(&mut self, statement: Statement, range: Range<usize>) {
        if !matches!(statement.sign, Kind::Assign | Kind::AddAssign) {
            let function = self.declared_type(statement.next, range.end, true);
            for (name, subscripts) in &statement.targets {
                add(&mut self.module, name, function);
                self.add_units(subscripts);
            }
            return self.inside(statement.next..range.end);
        }
        self.inside(statement.next..range.end);
        self.note_copy(&statement, range.end);
        let mut function = statement.parameters.is_some();
        if let Some(parameters) = statement.parameters.clone() {
            for index in parameters {
                if let Some((name, _)) = self.name(index) {
                    self.item.names.entry(name).or_insert(false);
                }
            }
        }
        if let [(_, subscripts)] = statement.targets.as_slice() {
            let units = subscripts.iter().flat_map(|run| self.units(run));
            function |= units.into_iter().any(|name| self.declared.contains(&name));
        }
        for (name, subscripts) in &statement.targets {
            self.add_units(subscripts);
            let function = function && statement.targets.len() == 1;
            add(&mut self.module, name, function);
        }
        self.item.function = function && statement.targets.len() == 1;
    }

    /// `g = f`: a function if `f` is one.
    fn note_copy(&mut self, statement: &Statement, end: usize) {
        if let ([(name, subscripts)], None, Some((of, next))) = (
            statement.targets.as_slice(),
            &statement.parameters,
            self.name(statement.next),
        ) && next == end
            && subscripts.is_empty()
        {
            self.copies.add(name.clone(), of);
        }
    }

    /// The names that a run of subscript letters stands for: itself if it is declared, its letters otherwise.
    fn units(&self, run: &str) -> Vec<String> {
        if self.declared.contains(run) {
            return vec![run.to_owned()];
        }
        let mut units = Vec::new();
        let mut rest = run;
        while !rest.is_empty() {
            let length = match letter(rest) {
                Some((length, unit)) => {
                    units.push(unit);
                    length
                }
                None => rest.chars().next().map_or(1, char::len_utf8),
            };
            rest = &rest[length..];
        }
        units
    }

    fn add_units(&mut self, subscripts: &[String]) {
        for run in subscripts {
            for unit in self.units(run) {
                self.item.names.entry(unit).or_insert(false);
            }
        }
    }

    /// A name at this place, with the index after it.
    fn name(&self, index: usize) -> Option<(String, usize)> {
        match self.kind(index) {
            Kind::Word(id) | Kind::Quoted(id) => Some((self.texts.get(id).to_owned(), index + 1)),
            Kind::Partial if self.tight(index + 1) => match self.kind(index + 1) {
                Kind::SuperscriptNumber(number) => Some((partial_name(number), index + 2)),
                _ => None,
            },
            _ => None,
        }
    }

    /// The runs of letters in the subscripts that follow a name.
    fn subscripts(&self, mut index: usize) -> (Vec<String>, usize) {
        let mut found = Vec::new();
        while let Kind::SubscriptLetter(_) | Kind::SubscriptNumber(_) = self.kind(index)
            && self.tight(index)
        {
            if let Kind::SubscriptLetter(id) = self.kind(index) {
                found.push(self.texts.get(id).to_owned());
            }
            index += 1;
            let next = self.kind(index + 1);
            let sub = matches!(next, Kind::SubscriptLetter(_) | Kind::SubscriptNumber(_));
            if self.kind(index) == Kind::Comma && sub && self.tight(index) && self.tight(index + 1)
            {
                index += 1;
            }
        }
        if self.kind(index) != Kind::Underscore || !self.tight(index) {
            return (found, index);
        }
        if self.kind(index + 1) == Kind::LeftParen {
            let partner = self.partners[index + 1];
            return match partner {
                NONE => (found, index),
                partner => (found, partner as usize + 1),
            };
        }
        index += 1;
        while self.tight(index) {
            let comma = self.kind(index) == Kind::Comma && self.tight(index + 1);
            // `p_i,q_i`: what has a subscript of its own is no subscript
            if comma && self.kind(index + 2) == Kind::Underscore && self.tight(index + 2) {
                break;
            }
            match self.kind(index + comma as usize) {
                Kind::Word(id) | Kind::Quoted(id) => found.push(self.texts.get(id).to_owned()),
                Kind::Integer(_) | Kind::Star => {}
                _ => break,
            }
            index += 1 + comma as usize;
        }
        (found, index)
    }

    /// `targets =`, `targets ∈`, or `name(parameters) =`; otherwise where it fails.
    fn statement(&self, start: usize, end: usize) -> Result<Statement, usize> {
        let mut targets = Vec::new();
        let mut index = start;
        loop {
            let Some((name, next)) = self.name(index).filter(|_| index < end) else {
                return Err(index);
            };
            let (subscripts, next) = self.subscripts(next);
            targets.push((name, subscripts));
            index = next;
            let sign = self.kind(index);
            match sign {
                Kind::Comma => index += 1,
                Kind::Assign | Kind::AddAssign | Kind::In | Kind::Colon | Kind::Subset => {
                    return Ok(Statement {
                        targets,
                        sign,
                        next: index + 1,
                        parameters: None,
                    });
                }
                Kind::LeftParen if targets.len() == 1 && self.tight(index) => {
                    let partner = self.partners[index] as usize;
                    if self.partners[index] == NONE || self.kind(partner + 1) != Kind::Assign {
                        return Err(index);
                    }
                    return Ok(Statement {
                        targets,
                        sign: Kind::Assign,
                        next: partner + 2,
                        parameters: Some(index + 1..partner),
                    });
                }
                _ => return Err(index),
            }
        }
    }

    /// Collects the words of a type; says whether it is the type of a function.
    fn declared_type(&mut self, start: usize, end: usize, module: bool) -> bool {
        let mut first = start;
        while self.kind(first) == Kind::LeftParen && first < end {
            first += 1;
        }
        let arrow = self.kind(first + 1 + (first - start)) == Kind::Arrow;
        let mapping = matches!(self.kind(first), Kind::Word(_) | Kind::Quoted(_)) && arrow;
        let mut index = start;
        let mut depth = 0usize;
        while index < end {
            match self.kind(index) {
                Kind::LeftParen => depth += 1,
                Kind::RightParen => depth = depth.saturating_sub(1),
                Kind::Word(id) | Kind::Quoted(id) => {
                    let name = self.texts.get(id);
                    let known = !module && self.module.contains_key(name);
                    let names = match module {
                        true => &mut self.module,
                        false => &mut self.item.names,
                    };
                    if !known && !builtin::TYPE_WORDS.contains(&name) {
                        names.entry(name.to_owned()).or_insert(false);
                    }
                }
                Kind::Arrow => return !mapping,
                Kind::Comma
                    if depth == 0
                        && matches!(self.kind(index + 1), Kind::Word(_) | Kind::Quoted(_)) =>
                {
                    return false;
                }
                Kind::Assign | Kind::In | Kind::Description | Kind::Where | Kind::With => {
                    return false;
                }
                _ => {}
            }
            index += 1;
        }
        false
    }

    /// Collects what an item declares after its left side: `where`, bound variables.
    fn inside(&mut self, range: Range<usize>) {
        let mut index = range.start;
        let mut depth = 0usize;
        let mut clause = false;
        while index < range.end {
            let mut next = index + 1;
            match self.kind(index) {
                Kind::LeftParen | Kind::LeftBracket | Kind::LeftBrace => depth += 1,
                Kind::RightParen | Kind::RightBracket | Kind::RightBrace => {
                    depth = depth.saturating_sub(1);
                }
                Kind::Where | Kind::With | Kind::Initial => {
                    clause = true;
                    next = self.local(index + 1, range.end);
                }
                Kind::Branch | Kind::Comma if clause && depth == 0 => {
                    next = self.local(index + 1, range.end);
                }
                Kind::For | Kind::Bar => next = self.bound(index + 1),
                Kind::Sum | Kind::Product | Kind::Union | Kind::Integral => self.head(index + 1),
                Kind::Optimise(_) => {
                    let close = self.partners.get(index + 2).copied().unwrap_or(NONE);
                    if close != NONE {
                        self.variables(index + 3, close as usize);
                    }
                }
                Kind::Total if self.kind(index + 2) != Kind::Slash => {
                    if let Some((name, _)) = self.name(index + 1) {
                        self.bind(name);
                    }
                }
                _ => {}
            }
            index = next;
        }
    }

    /// A declaration or definition after `where`; gives the index to go on from.
    fn local(&mut self, start: usize, end: usize) -> usize {
        let statement = match self.statement(start, end) {
            Ok(statement) => statement,
            Err(index) => return index.max(start),
        };
        let defines = matches!(statement.sign, Kind::Assign | Kind::AddAssign);
        let function = !defines && self.declared_type(statement.next, end, false);
        for (name, subscripts) in &statement.targets {
            if !defines {
                self.declared.insert(name.clone());
            }
            add(&mut self.item.names, name, function);
            self.add_units(subscripts);
        }
        statement.next
    }

    /// The variables of an optimisation.
    fn variables(&mut self, start: usize, close: usize) {
        let mut index = start;
        while index < close {
            match self.statement(index, close) {
                Ok(statement) => {
                    // the type, or the set, ends at the next comma
                    index = statement.next;
                    while index < close && self.kind(index) != Kind::Comma {
                        let partner = self.partners[index];
                        let jumps = partner != NONE && partner as usize > index;
                        index = if jumps { partner as usize } else { index } + 1;
                    }
                    let is_type = matches!(self.kind(statement.next), Kind::Reals | Kind::Integers);
                    let function = is_type && self.declared_type(statement.next, index, false);
                    for (name, _) in statement.targets {
                        add(&mut self.item.names, &name, function);
                    }
                    index += 1;
                }
                Err(_) => return,
            }
        }
    }

    /// Names up to `∈`: the variables of a set builder.
    fn bound(&mut self, start: usize) -> usize {
        let (names, index) = self.bound_names(start);
        if self.kind(index) == Kind::In {
            names.into_iter().for_each(|name| self.bind(name));
        }
        index.max(start)
    }

    /// The names from here on, in parentheses or not, and the index after them.
    fn bound_names(&self, start: usize) -> (Vec<String>, usize) {
        let mut names = Vec::new();
        let wrapped = self.kind(start) == Kind::LeftParen;
        let mut index = start + wrapped as usize;
        while let Some((name, next)) = self.name(index) {
            names.push(name);
            index = next + (self.kind(next) == Kind::Comma) as usize;
        }
        if wrapped && self.kind(index) == Kind::RightParen {
            index += 1;
        }
        (names, index)
    }

    /// The index of a big operator.
    fn head(&mut self, start: usize) {
        let start = start + (self.kind(start) == Kind::Underscore) as usize;
        if self.kind(start) != Kind::LeftParen {
            if self.kind(start.saturating_sub(1)) == Kind::Underscore
                && let Some((name, _)) = self.name(start)
            {
                self.bind(name);
            }
            return;
        }
        let (names, index) = self.bound_names(start + 1);
        if matches!(self.kind(index), Kind::In | Kind::For | Kind::Assign) {
            names.into_iter().for_each(|name| self.bind(name));
        }
    }

    /// A bound variable becomes a word of the item; it does not hide a function elsewhere in the item.
    fn bind(&mut self, name: String) {
        let single = letter(&name).is_some_and(|(length, _)| length == name.len());
        if !single || !self.module.contains_key(&name) {
            self.item.names.entry(name).or_insert(false);
        }
    }

    fn import(&mut self, range: Range<usize>) {
        let header = import_header(self.tokens, self.texts, range);
        let exports: Option<Vec<Export>> = match builtin::exports(&header.module) {
            Some(exports) => Some(exports),
            None => self.imports.exports(&header.module),
        };
        let Some(names) = header.names else {
            for export in exports.unwrap_or_default() {
                add(&mut self.module, &export.name, export.function);
            }
            return;
        };
        for (name, rename) in names {
            let found = exports.iter().flatten().find(|export| export.name == name);
            let function = found.is_none_or(|export| export.function);
            add(&mut self.module, rename.as_ref().unwrap_or(&name), function);
        }
    }
}

/// The name of an unquoted boundary matrix.
pub(super) fn partial_name(number: i64) -> String {
    format!("∂{}", super::spelling::superscript_number(number))
}
