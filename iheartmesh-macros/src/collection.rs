//! The modules that a call has in hand and those that it still has to ask for.
//!
//! The macro cannot keep anything from one call to the next, so the collection travels as tokens with every question
//! and comes back with the answer.

use crate::invocation::Invocation;
use crate::module::{Module, Need, Reader, Route};
use proc_macro2::{TokenStream, TokenTree};
use quote::quote;

/// The standard modules: what the crate of standard neighbourhoods exports.
pub const STANDARD: &[&str] = &[
    "Neighborhoods",
    "PolygonNeighborhoods",
    "TetrahedronNeighborhoods",
    "TetrahderonNeighborhoods",
    "PointCloudNeighborhoods",
];

/// Stands for every module that imports a standard one.
const FOR_STANDARD: &str = "standard";
/// Stands for every module of the call: the `use` lines hold for all of them.
const FOR_CALL: &str = "call";

/// Where a call finds what does not belong to it; paths that the facade gives, so that it may be renamed.
#[derive(Clone, Debug)]
pub struct Context {
    /// What generated code runs on.
    pub krate: TokenStream,
    /// The macros of this crate.
    pub macros: TokenStream,
    /// The standard modules.
    pub standard: TokenStream,
}

/// Modules of other calls.
#[derive(Debug, Default)]
pub struct Collection {
    modules: Vec<Module>,
    links: Vec<Link>,
    /// What is still to ask; the first one is what the last question was about.
    queue: Vec<Question>,
}

/// Who calls which module by which name.
#[derive(Debug)]
struct Link {
    who: String,
    name: String,
    id: String,
}

/// A module to ask for.
#[derive(Debug)]
struct Question {
    who: String,
    name: String,
    path: TokenStream,
}

impl Context {
    /// Takes the three paths from the front of the tokens of a call.
    pub fn read(reader: &mut Reader) -> Option<Self> {
        Some(Self {
            krate: reader.group()?,
            macros: reader.group()?,
            standard: reader.group()?,
        })
    }

    fn write(&self) -> TokenStream {
        let Self {
            krate,
            macros,
            standard,
        } = self;
        quote!([#krate] [#macros] [#standard])
    }
}

impl Collection {
    /// What a call needs to ask for, before the first question.
    pub fn new(call: &Invocation, of_call: &[Module], context: &Context) -> Self {
        let mut collection = Self::default();
        for need in of_call.iter().flat_map(|m| &m.needs) {
            if let Route::Standard = need.route {
                collection.ask_standard(need, context);
            } else if let Some(used) = call.uses.iter().find(|u| u.name == need.name)
                && matches!(need.route, Route::Path(_) | Route::Closed(_))
            {
                collection.ask(FOR_CALL, &need.name, used.path.iter().cloned().collect());
            }
        }
        collection
    }

    /// The path of the module to ask for next.
    pub fn next_path(&self) -> Option<&TokenStream> {
        self.queue.first().map(|question| &question.path)
    }

    /// Everything that has to come back with the answer, ahead of the user's own tokens.
    pub fn write(&self, context: &Context) -> TokenStream {
        let context = context.write();
        let modules = self.modules.iter().map(Module::write);
        let links = self
            .links
            .iter()
            .map(|Link { who, name, id }| quote!(#who #name #id));
        let queue = self
            .queue
            .iter()
            .map(|Question { who, name, path }| quote!({ #who #name #path }));
        quote!(#context [#(#modules)*] [#(#links)*] [#(#queue)*])
    }

    /// Reads what [`Collection::write`] wrote, without the context.
    pub fn read(reader: &mut Reader) -> Option<Self> {
        let modules = Reader::new(reader.group()?).rest();
        let modules = modules.map(Module::read).collect::<Option<_>>()?;
        let mut list = Reader::new(reader.group()?);
        let mut links = Vec::new();
        while let Some(who) = list.string() {
            links.push(Link {
                who,
                name: list.string()?,
                id: list.string()?,
            });
        }
        let question = |group| {
            let mut reader = Reader::inside(group)?;
            Some(Question {
                who: reader.string()?,
                name: reader.string()?,
                path: reader.rest().collect(),
            })
        };
        let queue = Reader::new(reader.group()?).rest();
        Some(Self {
            modules,
            links,
            queue: queue.map(question).collect::<Option<_>>()?,
        })
    }

    /// Takes the answer to the first question. `own_crate` is the identity of the crate being compiled.
    pub fn accept(
        &mut self,
        answer: TokenTree,
        of_call: &[Module],
        own_crate: &str,
        context: &Context,
    ) -> Option<()> {
        let mut reader = Reader::inside(answer)?;
        let foreign = reader.string()? != own_crate;
        let bundle = reader.group()?;
        let modules = reader.rest().map(Module::read);
        let modules: Vec<Module> = modules.collect::<Option<_>>()?;
        if self.queue.is_empty() {
            return None;
        }
        let mut asked = self.queue.remove(0);
        if foreign && !bundle.is_empty() {
            asked.path = bundle;
            self.queue.insert(0, asked);
            return Some(());
        }
        self.links.push(Link {
            who: asked.who,
            name: asked.name,
            id: modules.first()?.id.clone(),
        });
        for module in modules {
            if self.module(of_call, &module.id).is_some() {
                continue;
            }
            for need in &module.needs {
                match &need.route {
                    Route::Standard => self.ask_standard(need, context),
                    Route::Path(path) => self.ask(&module.id, &need.name, path.clone()),
                    Route::Known(_) | Route::Closed(_) | Route::Unknown => {}
                }
            }
            self.modules.push(module);
        }
        Some(())
    }

    fn ask_standard(&mut self, need: &Need, context: &Context) {
        let standard = &context.standard;
        let name = quote::format_ident!("{}", need.name);
        self.ask(FOR_STANDARD, &need.name, quote!(#standard::#name));
    }

    fn ask(&mut self, who: &str, name: &str, path: TokenStream) {
        let asked = self.queue.iter().any(|q| q.who == who && q.name == name);
        if !asked && self.link(who, name).is_none() {
            self.queue.push(Question {
                who: who.to_string(),
                name: name.to_string(),
                path,
            });
        }
    }

    fn link(&self, who: &str, name: &str) -> Option<&str> {
        let mut links = self.links.iter();
        let link = links.find(|link| link.who == who && link.name == name)?;
        Some(&link.id)
    }

    fn module<'a>(&'a self, of_call: &'a [Module], id: &str) -> Option<&'a Module> {
        of_call.iter().chain(&self.modules).find(|m| m.id == id)
    }

    /// The module that `module` needs, if it is in hand.
    pub fn find<'a>(
        &'a self,
        of_call: &'a [Module],
        module: &Module,
        need: &Need,
    ) -> Option<&'a Module> {
        let id = match &need.route {
            Route::Known(id) => id,
            Route::Standard => self.link(FOR_STANDARD, &need.name)?,
            Route::Path(_) | Route::Closed(_) => {
                let of_this_call = of_call.iter().any(|m| m.id == module.id);
                let who = if of_this_call { FOR_CALL } else { &module.id };
                self.link(who, &need.name)?
            }
            Route::Unknown => return None,
        };
        self.module(of_call, id)
    }
}
