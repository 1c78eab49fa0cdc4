//! The Rust side of a call: `use` lines and `struct Name = source;` items, up to where the language starts.
//!
//! **Invariant:** reading is total. Every error is kept beside what could be read; what comes after it is read too.

use crate::body::{Body, flat};
use crate::error::Error;
use crate::switches::{self, Switches};
use proc_macro2::{Delimiter, Ident, Span, TokenStream, TokenTree};

/// What a call says.
#[derive(Debug, Default)]
pub struct Invocation {
    /// Modules of other places that the sources of this call may import.
    pub uses: Vec<Use>,
    /// The modules that the call defines.
    pub items: Vec<Item>,
    /// What could not be read.
    pub errors: Vec<Error>,
    /// Items with a name but without a source that could be read.
    pub unread: Vec<Header>,
}

/// `use path::Module as Name;`
#[derive(Debug)]
pub struct Use {
    /// The name in `from Name`.
    pub name: Ident,
    /// The whole path.
    pub path: Vec<TokenTree>,
}

/// What stands before `=`.
#[derive(Clone, Debug)]
pub struct Header {
    /// Attributes of the user, documentation above all.
    pub attributes: TokenStream,
    /// `pub`, `pub(…)` or nothing.
    pub visibility: TokenStream,
    /// The name of the struct.
    pub name: Ident,
    /// What its attributes say to the compiler.
    pub switches: Switches,
}

/// `pub struct Name = r#"…"#;`
#[derive(Debug)]
pub struct Item {
    /// What stands before `=`.
    pub header: Header,
    /// The source.
    pub body: Body,
}

impl Header {
    /// Whether other crates may reach it.
    pub fn is_public(&self) -> bool {
        self.visibility.clone().into_iter().count() == 1
    }
}

const EXAMPLE: &str = "write `pub struct Name = r#\"…\"#;`";

/// Reads the tokens of a call.
pub fn parse(tokens: TokenStream) -> Invocation {
    let mut reader = Reader {
        tokens: flat(tokens),
        at: 0,
        found: Invocation::default(),
    };
    while reader.peek().is_some() {
        let start = reader.at;
        if let Err(error) = reader.item() {
            reader.found.errors.push(error);
            reader.skip(start);
        }
    }
    let mut found = reader.found;
    check(&mut found);
    found
}

/// What no single item shows: names that stand twice, and a call without any module.
fn check(found: &mut Invocation) {
    let mut names: Vec<&Ident> = Vec::new();
    let used = found.uses.iter().map(|u| &u.name);
    for name in used.chain(found.items.iter().map(|item| &item.header.name)) {
        if names.contains(&name) {
            let message = format!("two modules of this call are named `{name}`");
            found.errors.push(
                Error::new(name.span(), message)
                    .help("`use path::Module as Name;` gives another name"),
            );
        }
        names.push(name);
    }
    if found.items.is_empty() && found.errors.is_empty() {
        let message = "this call defines no module";
        let span = used_span(found).unwrap_or_else(Span::call_site);
        found.errors.push(Error::new(span, message).help(EXAMPLE));
    }
    // one struct of each name, or rustc would say the same thing again
    let mut seen: Vec<Ident> = Vec::new();
    found.items.retain(|item| {
        let new = !seen.contains(&item.header.name);
        seen.push(item.header.name.clone());
        new
    });
}

fn used_span(found: &Invocation) -> Option<Span> {
    found.uses.first().map(|u| u.name.span())
}

struct Reader {
    tokens: Vec<TokenTree>,
    at: usize,
    found: Invocation,
}

impl Reader {
    fn peek(&self) -> Option<&TokenTree> {
        self.tokens.get(self.at)
    }

    fn next(&mut self) -> Option<TokenTree> {
        let token = self.tokens.get(self.at).cloned();
        self.at += usize::from(token.is_some());
        token
    }

    fn is_punct(&self, character: char) -> bool {
        matches!(self.peek(), Some(TokenTree::Punct(p)) if p.as_char() == character)
    }

    fn is_word(&self, word: &str) -> bool {
        matches!(self.peek(), Some(TokenTree::Ident(ident)) if ident == word)
    }

    fn take_punct(&mut self, character: char) -> bool {
        let taken = self.is_punct(character);
        self.at += usize::from(taken);
        taken
    }

    fn take_word(&mut self, word: &str) -> bool {
        let taken = self.is_word(word);
        self.at += usize::from(taken);
        taken
    }

    /// The place of the next token, or of the last one at the end.
    fn here(&self) -> Span {
        self.peek()
            .or(self.tokens.last())
            .map_or_else(Span::call_site, TokenTree::span)
    }

    fn expected(&self, what: &str) -> Error {
        let found = match self.peek() {
            None => "the end of the call".to_string(),
            Some(TokenTree::Group(group)) => match group.delimiter() {
                Delimiter::Parenthesis => "`(`".to_string(),
                Delimiter::Brace => "`{`".to_string(),
                _ => "`[`".to_string(),
            },
            Some(TokenTree::Literal(_)) => "a literal".to_string(),
            Some(token) => format!("`{token}`"),
        };
        Error::new(self.here(), format!("expected {what}, found {found}"))
    }

    /// Goes on behind the next `;`, or at what looks like the start of an item.
    fn skip(&mut self, start: usize) {
        self.at = self.at.max(start + 1);
        while self.peek().is_some() {
            if self.take_punct(';') {
                return;
            }
            let item = ["pub", "struct", "use"]
                .iter()
                .any(|word| self.is_word(word));
            if item || self.is_punct('#') {
                return;
            }
            self.at += 1;
        }
    }

    /// One `use` line or one item.
    fn item(&mut self) -> Result<(), Error> {
        let start = self.at;
        let attributes = self.attributes()?;
        let visibility = self.visibility();
        let first = self.tokens[start].span();
        if self.is_word("use") {
            if self.at > start {
                let message = "a `use` in this call takes neither attributes nor a visibility";
                let help = "it only says where the sources of this call find a module";
                let error = Error::new(first, message).help(help);
                self.found.errors.push(error);
            }
            self.at += 1;
            return self.use_line();
        }
        if !self.take_word("struct") {
            return Err(self.not_a_struct(visibility));
        }
        let name = match self.peek() {
            Some(TokenTree::Ident(name)) => name.clone(),
            _ => return Err(self.expected("the name of the module")),
        };
        self.at += 1;
        let (attributes, switches) = switches::take(attributes, &mut self.found.errors);
        let header = Header {
            attributes,
            visibility,
            name,
            switches,
        };
        match self.rest(&header) {
            Ok(body) => {
                self.found.items.push(Item { header, body });
                self.semicolon();
                Ok(())
            }
            Err(error) => {
                self.found.unread.push(header);
                Err(error)
            }
        }
    }

    fn not_a_struct(&mut self, visibility: TokenStream) -> Error {
        let kinds = [
            "enum", "union", "mod", "fn", "trait", "type", "const", "static", "impl",
        ];
        match self.peek().cloned() {
            Some(TokenTree::Ident(kind)) if kinds.iter().any(|k| kind == k) => {
                let message = format!("a module is a `struct`, not `{kind}`");
                self.at += 1;
                if let Some(TokenTree::Ident(name)) = self.peek().cloned() {
                    self.found.unread.push(Header {
                        attributes: TokenStream::new(),
                        visibility,
                        name,
                        switches: Switches::default(),
                    });
                }
                Error::new(kind.span(), message).help(EXAMPLE)
            }
            _ => self.expected("`struct` or `use`").help(EXAMPLE),
        }
    }

    fn attributes(&mut self) -> Result<TokenStream, Error> {
        let mut attributes = Vec::new();
        while self.is_punct('#') {
            attributes.extend(self.next());
            let group = match self.peek() {
                Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Bracket => {
                    group.clone()
                }
                _ => return Err(self.expected("`[` of an attribute")),
            };
            if let Some(TokenTree::Ident(name)) = group.stream().into_iter().next()
                && name == "cfg"
            {
                let message = "`#[cfg]` cannot stand on one module of a call";
                let help = "put it on the whole `iheartmesh!` call";
                return Err(Error::new(name.span(), message).help(help));
            }
            attributes.extend(self.next());
        }
        Ok(attributes.into_iter().collect())
    }

    fn visibility(&mut self) -> TokenStream {
        let mut visibility = Vec::new();
        if self.is_word("pub") {
            visibility.extend(self.next());
            if let Some(TokenTree::Group(group)) = self.peek()
                && group.delimiter() == Delimiter::Parenthesis
            {
                visibility.extend(self.next());
            }
        }
        visibility.into_iter().collect()
    }

    /// What follows the name of a module, without the `;`.
    fn rest(&mut self, header: &Header) -> Result<Body, Error> {
        if header.name.to_string().starts_with("__ihm") {
            let message = "names that start with `__ihm` belong to this macro";
            return Err(Error::new(header.name.span(), message));
        }
        if self.is_punct('<') {
            let message = "a module has no generic parameters";
            let help = "the macro itself adds the lifetime of what the struct borrows";
            return Err(Error::new(self.here(), message).help(help));
        }
        if !self.take_punct('=') {
            let what = format!("`=` and the source of `{}`", header.name);
            return Err(self.expected(&what).help(EXAMPLE));
        }
        match self.peek().cloned() {
            Some(TokenTree::Literal(literal)) => {
                self.at += 1;
                if let Some(TokenTree::Literal(second)) = self.peek() {
                    let message = "the source of a module is one string, or several in braces";
                    let help = "write `{ \"one line\" \"next line\" }`";
                    return Err(Error::new(second.span(), message).help(help));
                }
                Body::of_literal(literal)
            }
            Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Brace => {
                self.at += 1;
                Body::of_lines(&group)
            }
            Some(TokenTree::Ident(include)) if include == "include" => {
                self.at += 1;
                match self.peek().cloned() {
                    Some(TokenTree::Literal(name)) => {
                        self.at += 1;
                        Body::of_file(name)
                    }
                    _ => Err(self.expected("the name of a file in quotes")),
                }
            }
            Some(TokenTree::Ident(name)) if self.is_call() => {
                let message = format!("`{name}!` is not expanded inside of this call");
                let help = "write the source as a string literal, or `include \"file.hlang\"`";
                Err(Error::new(name.span(), message).help(help))
            }
            _ => Err(self.expected(
                "the source: a string literal, `include \"file.hlang\"`, or lines in braces",
            )),
        }
    }

    fn is_call(&self) -> bool {
        matches!(self.tokens.get(self.at + 1), Some(TokenTree::Punct(p)) if p.as_char() == '!')
    }

    /// The `;` behind an item. Where it is missing the next item still starts at the next token.
    fn semicolon(&mut self) {
        if self.take_punct(';') {
            return;
        }
        let span = self.tokens[self.at - 1].span();
        let message = match self.found.items.last() {
            Some(item) => format!("missing `;` after the source of `{}`", item.header.name),
            None => "missing `;`".to_string(),
        };
        self.found.errors.push(Error::new(span, message));
    }

    /// What follows `use`.
    fn use_line(&mut self) -> Result<(), Error> {
        let mut path: Vec<TokenTree> = Vec::new();
        let mut name = self.path(&mut path)?;
        if self.take_word("as") {
            match self.peek().cloned() {
                Some(TokenTree::Ident(alias)) if alias != "_" => {
                    self.at += 1;
                    name = alias;
                }
                _ => return Err(self.expected("the name to use in the source")),
            }
        }
        if !self.take_punct(';') {
            return Err(self.expected("`;` after the path of a module"));
        }
        if ["crate", "self", "super"].iter().any(|word| name == word) {
            let message = format!("`{name}` is not a module written with this macro");
            return Err(Error::new(name.span(), message));
        }
        self.found.uses.push(Use { name, path });
        Ok(())
    }

    /// Adds the tokens of a path to `path` and gives its last segment.
    fn path(&mut self, path: &mut Vec<TokenTree>) -> Result<Ident, Error> {
        loop {
            if self.is_punct(':') {
                path.extend(self.next());
                if !self.is_punct(':') {
                    return Err(self.expected("`::`"));
                }
                path.extend(self.next());
            }
            match self.peek().cloned() {
                Some(TokenTree::Ident(segment)) if segment != "as" => {
                    path.extend(self.next());
                    if !self.is_punct(':') {
                        return Ok(segment);
                    }
                }
                // `$crate` of a macro around this one
                Some(TokenTree::Punct(dollar)) if dollar.as_char() == '$' => {
                    path.extend(self.next());
                }
                Some(TokenTree::Group(_) | TokenTree::Punct(_)) if !path.is_empty() => {
                    let error = self.expected("the name of a module");
                    return Err(error.help("name one module in each `use`"));
                }
                _ => return Err(self.expected("the path of a module")),
            }
        }
    }
}

#[cfg(test)]
mod tests;
