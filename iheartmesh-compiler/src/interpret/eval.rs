//! One case for each kind of expression.

use std::collections::BTreeMap;

use nalgebra::DMatrix;

use super::array::{
    block_matrix, compare, element, from_one, integer, numbers, reals, shape, size,
};
use super::{Fault, Interpreter, Scope, Value, mesh};
use crate::ir::{ExprId, Kind, SetOp};
use crate::types::{Element, Type, element_dimension};

type Result<T> = std::result::Result<T, Fault>;

impl<'a> Interpreter<'a> {
    /// The value of an expression.
    pub(super) fn eval(&self, scope: &mut Scope<'a>, e: ExprId) -> Result<Value> {
        if self.is_leaf(e) {
            return self.compute(scope, e);
        }
        let free = self.program.arena.node(e).free.iter();
        let bound: Vec<u64> = match scope.plan {
            // columns have values by more than their own variable
            Some(_) => vec![scope.binds],
            None => free.map(|v| scope.bound[v]).collect(),
        };
        if let Some((then, value)) = scope.known.get(&e)
            && *then == bound
        {
            return Ok(value.clone());
        }
        let value = self.compute(scope, e)?;
        scope.known.insert(e, (bound, value.clone()));
        Ok(value)
    }

    /// Whether a value is at hand anyway.
    fn is_leaf(&self, e: ExprId) -> bool {
        matches!(
            self.program.arena.kind(e),
            Kind::Integer(_)
                | Kind::Real(_)
                | Kind::Boolean(_)
                | Kind::Variable(_)
                | Kind::Input(_)
                | Kind::Global(_)
        )
    }

    fn compute(&self, scope: &mut Scope<'a>, e: ExprId) -> Result<Value> {
        let ty = self.ty(e);
        Ok(match self.program.arena.kind(e) {
            Kind::Integer(k) => Value::Integer(*k),
            Kind::Real(bits) => Value::Real(f64::from_bits(*bits)),
            Kind::Boolean(b) => Value::Boolean(*b),
            Kind::Variable(v) => scope.variables[v].clone(),
            Kind::Input(id) => self.values[id].clone(),
            Kind::Global(id) => self.global(*id)?,
            Kind::AllElements(element) => {
                let n = self.meshes[&element.mesh].count(element_dimension(element.kind));
                Value::Set((0..n as u32).map(Value::Element).collect())
            }
            Kind::Boundary(boundary) => {
                let mesh = self.meshes[&boundary.mesh];
                let (rows, columns) = mesh::shape(mesh, *boundary);
                let mut matrix = DMatrix::zeros(rows, columns);
                for (row, column, entry) in mesh::entries(mesh, *boundary) {
                    matrix[(row as usize, column as usize)] = entry as f64;
                }
                Value::Reals(matrix)
            }
            Kind::Call(id, arguments) => {
                let arguments = self.list(scope, arguments)?;
                self.apply(*id, arguments)?
            }
            Kind::Unary(op, a) => match (self.eval(scope, *a)?, self.space(*a)) {
                (Value::Chain(entries), Some(space)) => {
                    let entry = |id| entries.get(&id).map_or(0.0, |entry| *entry as f64);
                    let all: Vec<f64> = (0..self.count(space) as u32).map(entry).collect();
                    Value::vector(&all)
                }
                (value, _) => self.unary(e, *op, value)?,
            },
            Kind::Binary(op, a, b) => {
                let (left, right) = (self.eval(scope, *a)?, self.eval(scope, *b)?);
                self.binary(e, *op, left, right)?
            }
            Kind::Compare(op, a, b) => {
                let (left, right) = (self.eval(scope, *a)?, self.eval(scope, *b)?);
                Value::Boolean(compare(*op, &left, &right))
            }
            Kind::And(a, b) => Value::Boolean(self.holds(scope, *a)? && self.holds(scope, *b)?),
            Kind::Or(a, b) => Value::Boolean(self.holds(scope, *a)? || self.holds(scope, *b)?),
            Kind::Not(a) => Value::Boolean(!self.holds(scope, *a)?),
            Kind::Vector(items) => {
                let items = self.list(scope, items)?;
                numbers(ty, items.len(), 1, |i, _| &items[i])
            }
            Kind::Component(vector, index) => {
                let (vector, index) = (self.eval(scope, *vector)?, self.number(scope, *index)?);
                self.entry(e, &vector, index, 1)?
            }
            Kind::Item(sequence, index) => {
                let sequence = self.items(scope, *sequence)?;
                let place = match self.eval(scope, *index)? {
                    Value::Element(id) => Some(id as usize),
                    other => from_one(integer(other), sequence.len()),
                };
                let item = place.and_then(|place| sequence.into_iter().nth(place));
                item.ok_or_else(|| self.fault(e))?
            }
            Kind::Extent(a, axis) => Value::Integer(match self.eval(scope, *a)? {
                Value::Sequence(items) => items.len() as i64,
                other => {
                    let (rows, columns) = shape(&other);
                    (if *axis == 0 { rows } else { columns }) as i64
                }
            }),
            Kind::Size(dimension) => match self.size(scope, dimension) {
                Some(size) => Value::Integer(size),
                None => return Err(self.fault(e)),
            },
            Kind::At(a, i, j) => {
                let matrix = self.eval(scope, *a)?;
                let (i, j) = (self.number(scope, *i)?, self.number(scope, *j)?);
                self.entry(e, &matrix, i, j)?
            }
            Kind::RowOf(a, i) => {
                let (matrix, i) = (self.eval(scope, *a)?, self.number(scope, *i)?);
                let row = from_one(i, shape(&matrix).0).ok_or_else(|| self.fault(e))?;
                match matrix {
                    Value::Reals(a) => Value::Reals(a.rows(row, 1).transpose()),
                    Value::Integers(a) => Value::Integers(a.rows(row, 1).transpose()),
                    other => panic!("bug in iheartmesh: {other} has no rows"),
                }
            }
            Kind::ColumnOf(a, j) => {
                let (matrix, j) = (self.eval(scope, *a)?, self.number(scope, *j)?);
                let column = from_one(j, shape(&matrix).1).ok_or_else(|| self.fault(e))?;
                match matrix {
                    Value::Reals(a) => Value::Reals(a.columns(column, 1).into_owned()),
                    Value::Integers(a) => Value::Integers(a.columns(column, 1).into_owned()),
                    other => panic!("bug in iheartmesh: {other} has no columns"),
                }
            }
            Kind::Blocks(rows) => {
                let mut blocks = Vec::new();
                for row in rows {
                    let row = self.list(scope, row)?;
                    blocks.push(row.into_iter().map(reals).collect::<Vec<_>>());
                }
                Value::Reals(block_matrix(&blocks).ok_or_else(|| self.fault(e))?)
            }
            Kind::Filled(value, sizes) => {
                let value = self.eval(scope, *value)?;
                let sizes = self.sizes(scope, sizes)?;
                numbers(ty, sizes[0], sizes.get(1).copied().unwrap_or(1), |_, _| {
                    &value
                })
            }
            Kind::Identity(n) => {
                let n = size(self.number(scope, *n)?);
                Value::Reals(DMatrix::identity(n, n))
            }
            Kind::Tabulate {
                layout,
                variables,
                sizes,
                body,
            } => self.tabulate(scope, e, *layout, variables, sizes, *body)?,
            Kind::Stored(matrix, axis, index) => {
                let matrix = reals(self.eval(scope, *matrix)?);
                let matrix = if *axis == 0 {
                    matrix
                } else {
                    matrix.transpose()
                };
                let row = from_one(self.number(scope, *index)?, matrix.nrows());
                let row = matrix.row(row.ok_or_else(|| self.fault(e))?);
                let stored = (1..).zip(row.iter()).filter(|(_, entry)| **entry != 0.0);
                Value::set(stored.map(|(k, _)| Value::Integer(k)).collect::<Vec<_>>())
            }
            Kind::Scatter {
                variable,
                set,
                sizes,
                place,
                body,
            } => self.scatter(scope, e, (*variable, *set), *sizes, *place, *body)?,
            Kind::Update(base, entries) => self.update(scope, e, *base, entries)?,
            Kind::Assemble { sizes, blocks } => self.assemble(scope, e, sizes, blocks)?,
            Kind::Sequence(items) => Value::Sequence(self.list(scope, items)?),
            Kind::SequenceOf(set) => Value::Sequence(self.members(scope, *set)?),
            Kind::HostCall(function, arguments) => match self.eval(scope, *function)? {
                Value::Function(k) => self.functions[k](&self.list(scope, arguments)?),
                other => panic!("bug in iheartmesh: {other} is no function"),
            },
            Kind::Agree(a, b, value) => {
                if self.number(scope, *a)? != self.number(scope, *b)? {
                    return Err(self.fault(e));
                }
                self.eval(scope, *value)?
            }
            Kind::Tuple(items) => Value::Tuple(self.list(scope, items)?),
            Kind::Project(tuple, k) => match self.eval(scope, *tuple)? {
                Value::Tuple(items) => items[*k as usize].clone(),
                other => panic!("bug in iheartmesh: {other} is no tuple"),
            },
            Kind::Set(members) => Value::set(self.list(scope, members)?),
            Kind::SetOp(op, a, b) => {
                let (a, b) = (self.members(scope, *a)?, self.members(scope, *b)?);
                match op {
                    SetOp::Union => Value::set(a.into_iter().chain(b)),
                    SetOp::Intersection => Value::set(a.into_iter().filter(|m| m.is_in(&b))),
                    SetOp::Difference => Value::set(a.into_iter().filter(|m| !m.is_in(&b))),
                }
            }
            Kind::Cardinality(set) => Value::Integer(self.members(scope, *set)?.len() as i64),
            Kind::SetItem(set, index) => {
                let (members, index) = (self.members(scope, *set)?, self.number(scope, *index)?);
                let place = from_one(index, members.len()).ok_or_else(|| self.fault(e))?;
                members[place].clone()
            }
            Kind::Neighbor(neighbor, a, b) => {
                let a = element(self.eval(scope, *a)?);
                let b = element(self.eval(scope, *b)?);
                let found = mesh::neighbor(&self.meshes, *neighbor, a, b);
                Value::Element(found.ok_or_else(|| self.fault(e))?)
            }
            Kind::Sized(set, n) => {
                let members = self.members(scope, *set)?;
                if members.len() != *n as usize {
                    return Err(self.fault(e));
                }
                Value::Set(members)
            }
            Kind::Member(item, set) => {
                let (item, members) = (self.eval(scope, *item)?, self.members(scope, *set)?);
                Value::Boolean(item.is_in(&members))
            }
            Kind::Indicator(set) => {
                let members = self.members(scope, *set)?.into_iter();
                Value::Chain(members.map(|member| (element(member), 1)).collect())
            }
            Kind::Apply(boundary, a) => {
                let chain = self.chain(scope, *a)?;
                let product = mesh::product(self.meshes[&boundary.mesh], *boundary, &chain);
                Value::Chain(product.ok_or_else(|| self.fault(e))?)
            }
            Kind::NonZeros(a) => mesh::where_entry(&self.chain(scope, *a)?, |entry| entry != 0),
            Kind::ValueSet(a, value) => {
                let (chain, value) = (self.chain(scope, *a)?, self.number(scope, *value)?);
                let Some(space) = self.space(*a) else {
                    return Err(self.fault(e));
                };
                let n = self.count(space);
                let entry = |id: &u32| chain.get(id).copied().unwrap_or(0);
                let found = (0..n as u32).filter(|id| entry(id) == value);
                Value::set(found.map(Value::Element))
            }
            Kind::Traverse(boundary, set) => {
                let members = self.members(scope, *set)?;
                let entries = mesh::entries(self.meshes[&boundary.mesh], *boundary).into_iter();
                let found =
                    entries.filter(|(_, column, _)| Value::Element(*column).is_in(&members));
                Value::set(found.map(|(row, _, _)| Value::Element(row)))
            }
            Kind::Entry(boundary, row, column) => {
                let row = element(self.eval(scope, *row)?);
                let column = element(self.eval(scope, *column)?);
                let entries = mesh::entries(self.meshes[&boundary.mesh], *boundary);
                let found = entries.iter().find(|(r, c, _)| (*r, *c) == (row, column));
                Value::Integer(found.map_or(0, |(_, _, entry)| *entry))
            }
            Kind::Fold {
                op,
                variable,
                range,
                condition,
                body,
            } => {
                let mut values = Vec::new();
                for value in self.range(scope, e, *variable, range)? {
                    scope.bind(*variable, value);
                    let taken = match condition {
                        Some(condition) => self.holds(scope, *condition)?,
                        None => true,
                    };
                    if taken {
                        values.push(self.eval(scope, *body)?);
                    }
                }
                self.fold(scope, e, *op, values)?
            }
            Kind::If(condition, a, b) => match self.holds(scope, *condition)? {
                true => self.eval(scope, *a)?,
                false => self.eval(scope, *b)?,
            },
            Kind::Optimum { .. } | Kind::Integral { .. } => {
                return Err(Fault {
                    expression: Some(e),
                    reason: "the interpreter has no numerical methods,".to_owned(),
                });
            }
            Kind::Fail => return Err(self.fault(e)),
            Kind::Column(space, k) => {
                let column = scope
                    .plan
                    .and_then(|plan| plan.space(*space))
                    .and_then(|space| space.columns.get(*k as usize));
                match column {
                    Some(column) => self.eval(scope, column.value)?,
                    None => panic!("bug in iheartmesh: a column without a plan"),
                }
            }
            Kind::Field(id, a) => {
                let element = self.eval(scope, *a)?;
                self.apply(*id, vec![element])?
            }
        })
    }

    fn list(&self, scope: &mut Scope<'a>, list: &[ExprId]) -> Result<Vec<Value>> {
        list.iter().map(|e| self.eval(scope, *e)).collect()
    }

    pub(super) fn sizes(&self, scope: &mut Scope<'a>, list: &[ExprId]) -> Result<Vec<usize>> {
        list.iter()
            .map(|e| Ok(size(self.number(scope, *e)?)))
            .collect()
    }

    fn holds(&self, scope: &mut Scope<'a>, e: ExprId) -> Result<bool> {
        match self.eval(scope, e)? {
            Value::Boolean(holds) => Ok(holds),
            other => panic!("bug in iheartmesh: {other} is no condition"),
        }
    }

    pub(super) fn number(&self, scope: &mut Scope<'a>, e: ExprId) -> Result<i64> {
        Ok(integer(self.eval(scope, e)?))
    }

    /// Of which elements a value is a vector.
    fn space(&self, e: ExprId) -> Option<Element> {
        match self.ty(e) {
            Type::Vector { space, .. } => *space,
            _ => None,
        }
    }

    pub(super) fn members(&self, scope: &mut Scope<'a>, e: ExprId) -> Result<Vec<Value>> {
        match self.eval(scope, e)? {
            Value::Set(members) => Ok(members),
            other => panic!("bug in iheartmesh: {other} is no set"),
        }
    }

    fn items(&self, scope: &mut Scope<'a>, e: ExprId) -> Result<Vec<Value>> {
        match self.eval(scope, e)? {
            Value::Sequence(items) => Ok(items),
            other => panic!("bug in iheartmesh: {other} is no sequence"),
        }
    }

    fn chain(&self, scope: &mut Scope<'a>, e: ExprId) -> Result<BTreeMap<u32, i64>> {
        match self.eval(scope, e)? {
            Value::Chain(entries) => Ok(entries),
            other => panic!("bug in iheartmesh: {other} is no vector over elements"),
        }
    }

    /// An entry by its numbers from 1.
    fn entry(&self, e: ExprId, array: &Value, row: i64, column: i64) -> Result<Value> {
        let (rows, columns) = shape(array);
        match (from_one(row, rows), from_one(column, columns), array) {
            (Some(i), Some(j), Value::Reals(a)) => Ok(Value::Real(a[(i, j)])),
            (Some(i), Some(j), Value::Integers(a)) => Ok(Value::Integer(a[(i, j)])),
            _ => Err(self.fault(e)),
        }
    }
}
