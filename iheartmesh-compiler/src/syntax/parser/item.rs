//! Items: imports, parameters, functions, definitions.

use std::collections::BTreeSet;

use super::super::ast::*;
use super::super::import_names::import_name;
use super::super::lexer::reserved;
use super::super::names::ItemNames;
use super::super::token::Kind;
use super::expression::make;
use super::{Context, Failed, Parsed, Parser};
use crate::diagnostic::Diagnostic;
use crate::span::Span;

impl Parser<'_> {
    pub(super) fn module(&mut self, items: &[ItemNames]) -> Module {
        let mut module = Module {
            items: Vec::new(),
            lost: BTreeSet::new(),
        };
        for item in items {
            if item.range.start < self.at {
                continue;
            }
            let before = self.count;
            self.at = item.range.start;
            self.context = Context::PLAIN;
            self.depth = 0;
            self.height = 0;
            let start = self.here();
            let read = self.item(item);
            let complete = read.is_ok() && self.at_end();
            if let Ok(kind) = read {
                let span = self.since(start);
                if !complete {
                    self.trailing(start);
                }
                if complete || !matches!(kind, ItemKind::Expression(_)) {
                    module.items.push(Item { kind, span });
                }
            }
            if !complete || self.count > before || self.is_damaged(item) {
                self.lose(item, &mut module.lost);
            }
        }
        module
    }

    fn at_end(&mut self) -> bool {
        matches!(self.kind(), Kind::Newline | Kind::End)
    }

    /// Something follows an item that is complete.
    fn trailing(&mut self, start: Span) {
        let read = start.start as usize..self.here().start as usize;
        let goes_on = self.text[read.clone()].contains('\n');
        let cases = self.text[read].contains('{');
        let help = match self.kind() {
            Kind::Assign | Kind::In | Kind::Colon if goes_on => {
                "the item goes on over the line break before this; is that line complete?"
            }
            Kind::Where | Kind::With => {
                "`where` follows a function with parameters or directly a sum; before parameters of the module it stands alone on its line"
            }
            Kind::Otherwise | Kind::If => "a piecewise value begins with `{`",
            Kind::Less | Kind::LessOrEqual | Kind::Greater | Kind::GreaterOrEqual => {
                "relations stand in conditions only"
            }
            Kind::Underscore => {
                "all subscripts stand after one `_`, separated by commas, as in `x_i,1`"
            }
            Kind::Optimise(_) => {
                "an optimisation is a whole right-hand side: give it a name on a line of its own"
            }
            Kind::Star => "products are written side by side, as in `2 a`, or with `⋅`",
            Kind::Comma | Kind::RightBrace if cases => {
                "cases stand on lines of their own or behind `;`, and no brace closes them"
            }
            Kind::Comma => {
                "each declaration stands on a line of its own; between subscripts stands a comma without blanks"
            }
            _ => {
                "each item stands on a line of its own; use parentheses to go on over a line break"
            }
        };
        let _: Parsed<()> = self.expected("the end of the item", help);
    }

    fn item(&mut self, item: &ItemNames) -> Parsed<ItemKind> {
        if item.import {
            return self.import().map(ItemKind::Import);
        }
        if self.kind() == Kind::Where {
            self.advance();
            return self.parameter_block();
        }
        if item.function {
            return self.function_item().map(ItemKind::Function);
        }
        match self.statement_sign() {
            Some(Kind::Assign | Kind::AddAssign) => {
                let definition = self.definition(false)?;
                if self.kind() == Kind::Where {
                    self.trap(&definition);
                }
                Ok(ItemKind::Definition(definition))
            }
            Some(_) => Ok(ItemKind::Parameters(vec![self.declaration()?])),
            None => {
                let value = self.right_side()?;
                if matches!(self.kind(), Kind::Assign | Kind::AddAssign) {
                    let span = value.span;
                    let message = "this cannot be defined";
                    let help = "the left side of a definition is a name, with subscripts or with \
                                parameters in parentheses; between back-ticks, a name may \
                                have any characters";
                    return self.fail(Diagnostic::error(span, message).help(help));
                }
                Ok(ItemKind::Expression(value))
            }
        }
    }

    /// The declarations after a `where` that stands alone on its line.
    fn parameter_block(&mut self) -> Parsed<ItemKind> {
        let mut list = vec![self.declaration()?];
        while self.kind() == Kind::Newline {
            let back = self.at;
            self.advance();
            let sign = self.statement_sign();
            if !matches!(sign, Some(Kind::In | Kind::Colon | Kind::Subset)) {
                self.at = back;
                break;
            }
            let start = self.here();
            match self.declaration() {
                Ok(declaration) => list.push(declaration),
                Err(Failed) => self.skip_item(),
            }
            if !self.at_end() {
                self.trailing(start);
                self.skip_item();
            }
        }
        Ok(ItemKind::Parameters(list))
    }

    fn skip_item(&mut self) {
        while !self.at_end() {
            self.advance();
        }
    }

    /// `y = 2a where a ∈ ℝ`: the reader expects a parameter, the original makes a function.
    fn trap(&mut self, definition: &Definition) {
        self.advance();
        let declares = matches!(
            self.statement_sign(),
            Some(Kind::In | Kind::Colon | Kind::Subset)
        );
        let local = match self.kind() {
            Kind::Name(id) | Kind::Function(id) => self.texts.get(id).to_owned(),
            _ => String::new(),
        };
        let span = self.here();
        let target = definition
            .targets
            .first()
            .map_or("", |t| t.name.text.as_str());
        let error = if declares {
            let message = format!("local declaration `{local}` is not a parameter of `{target}`");
            let help = match self.is_bound_before() {
                true => format!("the sum or set knows `{local}`: remove its declaration here"),
                false => format!(
                    "declare `{local}` on a line of its own to make it a parameter of the module, or \
                     write `{target}({local}) = …`"
                ),
            };
            Diagnostic::error(span, message).help(help)
        } else {
            let message = format!("`{target}` has no parameters, so it has no local definitions");
            let help = format!("define `{local}` on a line of its own");
            Diagnostic::error(span, message).help(help)
        };
        self.report(error);
        self.skip_item();
    }

    /// Whether the name here stands before an `∈` above in this item.
    fn is_bound_before(&mut self) -> bool {
        let name = self.kind();
        let mut index = self.at;
        while index > 1 && self.tokens[index - 1].kind != Kind::Newline {
            index -= 1;
            if self.tokens[index].kind == Kind::In && self.tokens[index - 1].kind == name {
                return true;
            }
        }
        false
    }

    fn import(&mut self) -> Parsed<Import> {
        if self.kind() == Kind::From {
            return self.reversed_import();
        }
        let names = match self.kind() {
            Kind::Star => {
                self.advance();
                None
            }
            _ => Some(self.import_names()?),
        };
        self.expect(Kind::From, "`from`", "write `names from Module(arguments)`")?;
        let module = self.import_word("the name of a module")?;
        let mut arguments = Vec::new();
        if self.eat(Kind::LeftParen) {
            while self.kind() != Kind::RightParen {
                arguments.push(self.import_word("a parameter of this module")?);
                if !self.eat(Kind::Comma) && !self.eat(Kind::Semicolon) {
                    break;
                }
            }
            self.expect(
                Kind::RightParen,
                "`,` or `)`",
                "close the list of arguments",
            )?;
        }
        Ok(Import {
            names,
            module,
            arguments,
        })
    }

    /// `from module: names`, `from module import names`: refused, and then understood, so that nothing follows from it.
    fn reversed_import(&mut self) -> Parsed<Import> {
        let start = self.here();
        let message = "expected a name to import, found `from`";
        let error = Diagnostic::error(start, message);
        self.advance();
        let module = import_name(&self.tokens, &self.texts, self.at);
        let separated = module.filter(|(_, next)| match self.tokens[*next].kind {
            Kind::Colon => true,
            Kind::Word(id) => self.texts.get(id) == "import",
            _ => false,
        });
        let Some((text, next)) = separated else {
            let help = "the names stand in front, as in `sin, cos from trigonometry`";
            return self.fail(error.help(help));
        };
        let first = self.here();
        self.at = next;
        let module = Name {
            text,
            span: self.since(first),
        };
        self.advance();
        let names_start = self.here();
        let names = self.import_names()?;
        let span = self.since(names_start);
        let listed = &self.text[span.start as usize..span.end as usize];
        let help = format!(
            "the names stand in front: write `{listed} from {}`",
            module.text
        );
        self.report(error.help(help));
        Ok(Import {
            names: Some(names),
            module,
            arguments: Vec::new(),
        })
    }

    fn import_names(&mut self) -> Parsed<Vec<ImportName>> {
        let mut names = Vec::new();
        loop {
            let name = self.import_word("a name to import")?;
            let renamed = match self.kind() {
                Kind::Word(id) => self.texts.get(id) == "as",
                _ => false,
            };
            let rename = match renamed {
                true => {
                    self.advance();
                    Some(self.import_word("the new name")?)
                }
                false => None,
            };
            names.push(ImportName { name, rename });
            if !self.eat(Kind::Comma) {
                return Ok(names);
            }
        }
    }

    fn import_word(&mut self, what: &str) -> Parsed<Name> {
        let start = self.here();
        let Some((text, next)) = import_name(&self.tokens, &self.texts, self.at) else {
            return self.expected(what, "write `names from Module(arguments)`");
        };
        self.at = next;
        let span = self.since(start);
        if text.starts_with("__ihm") {
            self.report(reserved(span, &text));
        }
        Ok(Name { text, span })
    }

    /// `targets = value`; in a `where` the value ends at the next comma.
    pub(super) fn definition(&mut self, local: bool) -> Parsed<Definition> {
        let start = self.here();
        let mut targets = Vec::new();
        loop {
            let help = "a definition is `name = value` or `name_i = value`";
            let name = self.name("a name", help)?;
            let subscripts = self.subscripts()?.unwrap_or_default();
            targets.push(LeftSide { name, subscripts });
            if !self.eat(Kind::Comma) {
                break;
            }
        }
        let add = self.kind() == Kind::AddAssign;
        if add {
            self.advance();
        } else {
            self.expect(Kind::Assign, "`=`", "a definition is `name = value`")?;
        }
        let value = match self.right_side() {
            Ok(value) => value,
            Err(Failed) => self.failed_value(local),
        };
        let span = self.since(start);
        Ok(Definition {
            targets,
            add,
            value,
            span,
        })
    }

    /// Goes on behind a value that could not be read.
    fn failed_value(&mut self, local: bool) -> Expr {
        let start = self.here();
        let mut depth = 0usize;
        self.context = Context::PLAIN;
        while !self.at_end() {
            match self.kind() {
                Kind::LeftParen | Kind::LeftBracket | Kind::LeftBrace => depth += 1,
                Kind::RightParen | Kind::RightBracket | Kind::RightBrace => {
                    depth = depth.saturating_sub(1);
                }
                Kind::Where if !local => break,
                Kind::Comma if local && depth == 0 => {
                    self.at += 1;
                    let begins = self.statement_sign().is_some();
                    self.at -= 1;
                    if begins {
                        break;
                    }
                }
                _ => {}
            }
            self.advance();
        }
        make(ExprKind::Error, start)
    }

    /// An expression, a piecewise value or an optimisation.
    pub(super) fn right_side(&mut self) -> Parsed<Expr> {
        match self.kind() {
            Kind::Piecewise => self.nested(Self::piecewise),
            Kind::Optimise(_) | Kind::Initial => self.nested(Self::optimise),
            _ => self.expression(),
        }
    }

    fn function_item(&mut self) -> Parsed<Function> {
        let name = self.name("the name of a function", "")?;
        let mut subscripts = Vec::new();
        for subscript in self.subscripts()?.unwrap_or_default() {
            match subscript {
                Subscript::Expr(Expr {
                    kind: ExprKind::Name(name),
                    ..
                }) => subscripts.push(name),
                Subscript::Expr(Expr { span, .. }) | Subscript::All(span) => {
                    let error = Diagnostic::error(span, "a parameter of a function is a name");
                    self.report(error.help("write a name"));
                }
            }
        }
        let parameters = match self.kind() {
            Kind::LeftParen => Some(self.parameter_names()?),
            _ => None,
        };
        self.expect(
            Kind::Assign,
            "`=`",
            "a function is `f(x) = value where x ∈ …`",
        )?;
        let body = match self.right_side() {
            Ok(body) => body,
            Err(Failed) => self.failed_value(false),
        };
        let mut function = Function {
            name,
            subscripts,
            parameters,
            body,
            declarations: Vec::new(),
            locals: Vec::new(),
        };
        let comma = self.kind() == Kind::Comma;
        if self.eat(Kind::Where) || comma && self.eat(Kind::Comma) {
            self.where_clause(&mut function);
        }
        Ok(function)
    }

    fn parameter_names(&mut self) -> Parsed<Vec<Name>> {
        self.advance();
        let mut names = Vec::new();
        while self.kind() != Kind::RightParen {
            names.push(self.name("a parameter", "parameters are names, separated by commas")?);
            if !self.eat(Kind::Comma) && !self.eat(Kind::Semicolon) {
                break;
            }
        }
        let help = "parameters are names, separated by commas; their types follow after `where`";
        self.expect(Kind::RightParen, "`,` or `)`", help)?;
        Ok(names)
    }

    fn where_clause(&mut self, function: &mut Function) {
        loop {
            let result = match self.statement_sign() {
                Some(Kind::Assign) => self.definition(true).map(|d| function.locals.push(d)),
                Some(Kind::AddAssign) => {
                    let error = Diagnostic::error(self.here(), "`+=` adds to definitions of the module only");
                    self.fail(error.help("write the whole sum in one definition"))
                }
                Some(_) => self.declaration().map(|d| function.declarations.push(d)),
                None => self.expected(
                    "a declaration or a definition",
                    "after `where` stand `x ∈ type` for the parameters and `name = value`, separated by commas",
                ),
            };
            if result.is_err() {
                self.failed_value(true);
            }
            if !self.eat(Kind::Comma) {
                return;
            }
        }
    }
}
