//! Definitions such as `g = f`, which make `g` a function where `f` is one.

use std::collections::BTreeMap;

/// The names that are defined as another name, by that one.
#[derive(Default)]
pub(super) struct Copies(BTreeMap<String, Vec<String>>);

impl Copies {
    /// Notes `name = of`.
    pub fn add(&mut self, name: String, of: String) {
        self.0.entry(of).or_default().push(name);
    }

    /// Makes functions of the names that stand for functions.
    pub fn follow(mut self, names: &mut super::names::Names) {
        let mut functions: Vec<String> = self
            .0
            .keys()
            .filter(|name| names.get(*name) == Some(&true))
            .cloned()
            .collect();
        while let Some(function) = functions.pop() {
            for copy in self.0.remove(&function).unwrap_or_default() {
                names.insert(copy.clone(), true);
                functions.push(copy);
            }
        }
    }
}
