//! What an expression is worth.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::fmt;

use nalgebra::DMatrix;

/// A value of the language.
#[derive(Clone, Debug)]
pub enum Value {
    /// A real number.
    Real(f64),
    /// An integer.
    Integer(i64),
    /// The outcome of a condition.
    Boolean(bool),
    /// A vertex, edge, face or cell, by its number from 0.
    Element(u32),
    /// A vector (one column) or matrix of real numbers; a sparse one with its zeros.
    Reals(DMatrix<f64>),
    /// A vector (one column) or matrix of integers.
    Integers(DMatrix<i64>),
    /// A vector over elements: the entries that something was added to, those that became 0 among them.
    Chain(BTreeMap<u32, i64>),
    /// The items of a sequence.
    Sequence(Vec<Value>),
    /// The members of a set, ascending, each once.
    Set(Vec<Value>),
    /// A function of the host, by its number among those that it handed in.
    Function(usize),
    /// The items of a tuple; a cellular set is one of four sets.
    Tuple(Vec<Value>),
}

impl Value {
    /// A vector of real numbers.
    pub fn vector(entries: &[f64]) -> Self {
        Value::Reals(DMatrix::from_column_slice(entries.len(), 1, entries))
    }

    /// A set: sorted, without repetitions.
    pub fn set(members: impl IntoIterator<Item = Value>) -> Self {
        let mut members: Vec<Value> = members.into_iter().map(Value::normalised).collect();
        members.sort_by(Value::order);
        members.dedup_by(|a, b| a.order(b).is_eq());
        Value::Set(members)
    }

    /// The value with each integer in it plus one.
    pub(super) fn counted(self) -> Self {
        let all = |items: Vec<Value>| items.into_iter().map(Value::counted).collect();
        match self {
            Value::Integer(k) => Value::Integer(k.saturating_add(1)),
            Value::Integers(a) => Value::Integers(a.map(|k| k.saturating_add(1))),
            Value::Sequence(items) => Value::Sequence(all(items)),
            Value::Tuple(items) => Value::Tuple(all(items)),
            Value::Set(members) => Value::set(all(members)),
            other => other,
        }
    }

    /// The form in which a set stores it: −0 is 0.
    fn normalised(self) -> Self {
        match self {
            Value::Real(x) => Value::Real(x + 0.0),
            Value::Reals(a) => Value::Reals(a.map(|x| x + 0.0)),
            Value::Tuple(items) => Value::Tuple(items.into_iter().map(Value::normalised).collect()),
            other => other,
        }
    }

    /// Whether it is a member of a sorted list.
    pub fn is_in(&self, members: &[Value]) -> bool {
        let item = self.clone().normalised();
        members.iter().any(|member| member.order(&item).is_eq())
    }

    /// The order of members of sets: numbers by size (NaN as IEEE 754 orders it), elements by their number, arrays by
    /// their shape and then entry by entry down the columns, tuples item by item.
    pub fn order(&self, other: &Self) -> Ordering {
        match (self, other) {
            (Value::Real(a), Value::Real(b)) => a.total_cmp(b),
            (Value::Integer(a), Value::Integer(b)) => a.cmp(b),
            (Value::Boolean(a), Value::Boolean(b)) => a.cmp(b),
            (Value::Element(a), Value::Element(b)) => a.cmp(b),
            (Value::Reals(a), Value::Reals(b)) => a.shape().cmp(&b.shape()).then_with(|| {
                let orders = a.iter().zip(b.iter()).map(|(x, y)| x.total_cmp(y));
                first_difference(orders)
            }),
            (Value::Integers(a), Value::Integers(b)) => {
                let orders = a.iter().zip(b.iter()).map(|(x, y)| x.cmp(y));
                a.shape()
                    .cmp(&b.shape())
                    .then_with(|| first_difference(orders))
            }
            (Value::Tuple(a), Value::Tuple(b))
            | (Value::Set(a), Value::Set(b))
            | (Value::Sequence(a), Value::Sequence(b)) => {
                let orders = a.iter().zip(b).map(|(x, y)| x.order(y));
                first_difference(orders).then(a.len().cmp(&b.len()))
            }
            // values of one type are of one kind
            (a, b) => panic!("bug in iheartmesh: {a} and {b} have no order"),
        }
    }

    /// Whether a condition compares them as equal: as numbers, where NaN differs from itself.
    pub fn equals(&self, other: &Self) -> bool {
        match (self, other) {
            (Value::Real(a), Value::Real(b)) => a == b,
            (Value::Reals(a), Value::Reals(b)) => a == b,
            (Value::Tuple(a), Value::Tuple(b)) | (Value::Sequence(a), Value::Sequence(b)) => {
                a.len() == b.len() && a.iter().zip(b).all(|(x, y)| x.equals(y))
            }
            (a, b) => a.order(b).is_eq(),
        }
    }
}

fn first_difference(mut orders: impl Iterator<Item = Ordering>) -> Ordering {
    orders.find(|o| o.is_ne()).unwrap_or(Ordering::Equal)
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let list = |f: &mut fmt::Formatter<'_>, open: &str, items: &[Value], close: &str| {
            write!(f, "{open}")?;
            for (k, item) in items.iter().enumerate() {
                write!(f, "{}{item}", if k > 0 { ", " } else { "" })?;
            }
            write!(f, "{close}")
        };
        match self {
            Value::Real(x) => write!(f, "{x:?}"),
            Value::Integer(k) => write!(f, "{k}"),
            Value::Boolean(b) => write!(f, "{b}"),
            Value::Element(id) => write!(f, "#{id}"),
            Value::Reals(a) => matrix(f, a),
            Value::Integers(a) => matrix(f, a),
            Value::Chain(entries) => {
                let entries: Vec<Value> = entries
                    .iter()
                    .map(|(id, k)| Value::Tuple(vec![Value::Element(*id), Value::Integer(*k)]))
                    .collect();
                list(f, "chain(", &entries, ")")
            }
            Value::Function(_) => write!(f, "a function"),
            Value::Sequence(items) => list(f, "sequence(", items, ")"),
            Value::Set(members) => list(f, "{", members, "}"),
            Value::Tuple(items) => list(f, "tuple(", items, ")"),
        }
    }
}

/// Row by row, as a program writes it.
fn matrix<T: fmt::Debug>(f: &mut fmt::Formatter<'_>, a: &DMatrix<T>) -> fmt::Result {
    let rows: Vec<String> = (0..a.nrows())
        .map(|i| {
            let entries: Vec<String> = (0..a.ncols()).map(|j| format!("{:?}", a[(i, j)])).collect();
            entries.join(" ")
        })
        .collect();
    write!(f, "[{}]", rows.join("; "))
}
