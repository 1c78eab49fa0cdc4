//! A module's source with what it needs itself, and how both travel from one macro call to another.
//!
//! A macro can hand nothing but tokens to another macro. What is data goes as string literals; the paths of needed
//! modules go as tokens, since `$crate` means something only as a token.

use crate::literal::decode;
use iheartmesh_compiler::source::{Place, Source};
use proc_macro2::{Literal, TokenStream, TokenTree};
use quote::quote;

/// A module that others may import.
#[derive(Clone, Debug)]
pub struct Module {
    /// Tells it from every other module of the program.
    pub id: String,
    /// Its name where it is defined.
    pub name: String,
    /// Its source.
    pub source: Source,
    /// The modules that it imports itself, apart from the built-in ones.
    pub needs: Vec<Need>,
}

/// A module that another one imports.
#[derive(Clone, Debug)]
pub struct Need {
    /// The name in `from Name`.
    pub name: String,
    /// Where it is.
    pub route: Route,
}

/// Where a needed module is.
#[derive(Clone, Debug)]
pub enum Route {
    /// Next to the module that needs it: the id.
    Known(String),
    /// One of the standard modules, which every call knows how to reach.
    Standard,
    /// A path that holds anywhere in the crate of the module that needs it.
    Path(TokenStream),
    /// A path, such as `super::Rings`, that holds only where it is written.
    Closed(String),
    /// Nobody knows.
    Unknown,
}

impl Module {
    /// Its tokens.
    pub fn write(&self) -> TokenStream {
        let Source {
            file,
            text,
            first_line,
            indents,
            places,
        } = &self.source;
        let list = |numbers: &mut dyn Iterator<Item = u32>| {
            let numbers: Vec<String> = numbers.map(|n| n.to_string()).collect();
            numbers.join(" ")
        };
        let indents = list(&mut indents.iter().copied());
        let places = list(&mut places.iter().flat_map(|p| [p.offset, p.line, p.column]));
        let line = first_line.to_string();
        let Self { id, name, .. } = self;
        let needs = self.needs.iter().map(Need::write);
        quote!({ #id #name #file #line #indents #places #text [#(#needs)*] })
    }

    /// The module in a group of [`Module::write`].
    pub fn read(group: TokenTree) -> Option<Self> {
        let mut reader = Reader::inside(group)?;
        let (id, name, file) = (reader.string()?, reader.string()?, reader.string()?);
        let first_line = reader.string()?.parse().ok()?;
        let numbers =
            |text: String| -> Vec<u32> { text.split(' ').filter_map(|n| n.parse().ok()).collect() };
        let indents = numbers(reader.string()?);
        let places = numbers(reader.string()?)
            .chunks_exact(3)
            .map(|three| Place {
                offset: three[0],
                line: three[1],
                column: three[2],
            })
            .collect();
        let text = reader.string()?;
        let needs = Reader::inside(reader.token()?)?
            .rest()
            .map(Need::read)
            .collect::<Option<_>>()?;
        Some(Self {
            id,
            name,
            source: Source {
                file,
                text,
                first_line,
                indents,
                places,
            },
            needs,
        })
    }
}

impl Need {
    fn write(&self) -> TokenStream {
        let name = &self.name;
        match &self.route {
            Route::Known(id) => quote!({ #name known #id }),
            Route::Standard => quote!({ #name standard }),
            Route::Path(path) => quote!({ #name path #path }),
            Route::Closed(path) => quote!({ #name closed #path }),
            Route::Unknown => quote!({ #name unknown }),
        }
    }

    fn read(group: TokenTree) -> Option<Self> {
        let mut reader = Reader::inside(group)?;
        let name = reader.string()?;
        let route = match reader.token()?.to_string().as_str() {
            "known" => Route::Known(reader.string()?),
            "standard" => Route::Standard,
            "path" => Route::Path(reader.rest().collect()),
            "closed" => Route::Closed(reader.string()?),
            _ => Route::Unknown,
        };
        Some(Self { name, route })
    }
}

/// Reads what this crate wrote itself; `None` means that somebody else wrote it.
pub struct Reader {
    tokens: std::vec::IntoIter<TokenTree>,
}

impl Reader {
    /// Reads a stream from its start.
    pub fn new(tokens: TokenStream) -> Self {
        let list: Vec<_> = tokens.into_iter().collect();
        Self {
            tokens: list.into_iter(),
        }
    }

    /// Reads what a group holds.
    pub fn inside(token: TokenTree) -> Option<Self> {
        match token {
            TokenTree::Group(group) => Some(Self::new(group.stream())),
            _ => None,
        }
    }

    /// The next token.
    pub fn token(&mut self) -> Option<TokenTree> {
        self.tokens.next()
    }

    /// The text of the string literal that is next.
    pub fn string(&mut self) -> Option<String> {
        let literal: Literal = match self.token()? {
            TokenTree::Literal(literal) => literal,
            _ => return None,
        };
        Some(decode(&literal).ok()?.text)
    }

    /// What the group that is next holds.
    pub fn group(&mut self) -> Option<TokenStream> {
        match self.token()? {
            TokenTree::Group(group) => Some(group.stream()),
            _ => None,
        }
    }

    /// Everything that is left.
    pub fn rest(self) -> impl Iterator<Item = TokenTree> {
        self.tokens
    }
}

/// A short text that is different for different texts (FNV-1a).
pub fn fingerprint(parts: &[&str]) -> String {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    for part in parts {
        for byte in part.bytes().chain([0xff]) {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }
    format!("{hash:016x}")
}

#[cfg(test)]
mod tests {
    use super::{Module, Need, Place, Route, Source, fingerprint};
    use quote::quote;

    #[test]
    fn what_is_written_is_read() {
        let need = |name: &str, route| Need {
            name: name.to_string(),
            route,
        };
        let module = Module {
            id: "0".to_string(),
            name: "Rings".to_string(),
            source: Source {
                file: "a b.rs".to_string(),
                text: "x ∈ \"V\"\n\\ y\t".to_string(),
                first_line: 7,
                indents: vec![3, 4],
                places: vec![Place {
                    offset: 1,
                    line: 2,
                    column: 3,
                }],
            },
            needs: vec![
                need("A", Route::Known("1".to_string())),
                need("B", Route::Standard),
                need("C", Route::Path(quote!($crate::a::C))),
                need("D", Route::Closed("super::D".to_string())),
                need("E", Route::Unknown),
            ],
        };
        let tokens = module.write().into_iter().next().unwrap();
        let read = Module::read(tokens).unwrap();
        assert_eq!(format!("{read:?}"), format!("{module:?}"));
    }

    #[test]
    fn fingerprints_see_where_parts_end() {
        assert_ne!(fingerprint(&["ab", "c"]), fingerprint(&["a", "bc"]));
        assert_eq!(fingerprint(&["a"]), fingerprint(&["a"]));
    }
}
