//! As much of JSON as the files of the reference set need.

use std::collections::BTreeMap;

/// A JSON value.
#[derive(Clone, Debug, PartialEq)]
pub enum Json {
    /// `null`, `true` or `false`.
    Word(String),
    /// A number.
    Number(f64),
    /// A text; escapes stay as they are written.
    Text(String),
    /// A list.
    List(Vec<Json>),
    /// An object.
    Object(BTreeMap<String, Json>),
}

impl Json {
    /// The value that a text holds.
    pub fn parse(text: &str) -> Json {
        let mut rest = text;
        let value = value(&mut rest);
        assert_eq!(rest.trim(), "", "text after the value");
        value
    }

    /// A member of an object.
    pub fn get(&self, name: &str) -> Option<&Json> {
        self.object().get(name)
    }

    /// The members of an object.
    pub fn object(&self) -> &BTreeMap<String, Json> {
        match self {
            Json::Object(members) => members,
            other => panic!("no object: {other:?}"),
        }
    }

    /// The items of a list.
    pub fn list(&self) -> &[Json] {
        match self {
            Json::List(items) => items,
            other => panic!("no list: {other:?}"),
        }
    }

    /// A number.
    pub fn number(&self) -> f64 {
        match self {
            Json::Number(value) => *value,
            other => panic!("no number: {other:?}"),
        }
    }

    /// A list of numbers.
    pub fn numbers(&self) -> Vec<f64> {
        self.list().iter().map(Json::number).collect()
    }

    /// A list of element numbers.
    pub fn ids(&self) -> Vec<u32> {
        self.list().iter().map(|x| x.number() as u32).collect()
    }
}

fn value(rest: &mut &str) -> Json {
    *rest = rest.trim_start();
    match rest.chars().next() {
        Some('{') => {
            let members = items(rest, '}', |rest| {
                let name = string(rest);
                expect(rest, ':');
                (name, value(rest))
            });
            Json::Object(members.into_iter().collect())
        }
        Some('[') => Json::List(items(rest, ']', value)),
        Some('"') => Json::Text(string(rest)),
        _ => {
            let end = rest.find([',', ']', '}', '\n']).unwrap_or(rest.len());
            let (word, after) = rest.split_at(end);
            *rest = after;
            let word = word.trim();
            word.parse()
                .map_or_else(|_| Json::Word(word.to_owned()), Json::Number)
        }
    }
}

fn items<T>(rest: &mut &str, close: char, mut item: impl FnMut(&mut &str) -> T) -> Vec<T> {
    *rest = rest[1..].trim_start();
    let mut items = Vec::new();
    while !rest.starts_with(close) {
        items.push(item(rest));
        *rest = rest.trim_start();
        if !rest.starts_with(close) {
            expect(rest, ',');
            *rest = rest.trim_start();
        }
    }
    *rest = &rest[1..];
    items
}

fn string(rest: &mut &str) -> String {
    expect(rest, '"');
    let mut escaped = false;
    let end = rest.find(|c| {
        let is_end = c == '"' && !escaped;
        escaped = c == '\\' && !escaped;
        is_end
    });
    let (text, after) = rest.split_at(end.expect("the end of a text"));
    *rest = &after[1..];
    text.to_owned()
}

fn expect(rest: &mut &str, c: char) {
    let trimmed = rest.trim_start();
    let Some(after) = trimmed.strip_prefix(c) else {
        panic!(
            "`{c}` is missing before {:?}",
            trimmed.chars().take(20).collect::<String>()
        );
    };
    *rest = after;
}
