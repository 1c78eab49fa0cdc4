//! Values of parameters: as the interpreter takes them, and as Rust writes them.

use iheartmesh_compiler::interpret::Value;
use nalgebra::DMatrix;

use super::{Kind, Member, Size, Ty};

/// A mesh by its polygons.
#[derive(Clone)]
pub struct Polygons {
    pub vertices: usize,
    pub faces: Vec<Vec<u32>>,
    /// Numbers of vertices, edges and faces.
    pub counts: [usize; 3],
}

/// A value and its Rust.
#[derive(Clone)]
pub struct Datum {
    pub value: Value,
    pub rust: String,
    /// Whether it is the function of the host.
    pub is_function: bool,
}

/// Sizes of the values of a program.
#[derive(Clone, Copy)]
pub struct Sizes {
    pub n: usize,
    pub m: usize,
    pub own: usize,
    pub length: usize,
    pub elements: [usize; 3],
    /// Whether numbers have no pattern.
    pub is_rough: bool,
}

impl Sizes {
    fn of(&self, size: Size) -> usize {
        match size {
            Size::Known(n) => n,
            Size::N => self.n,
            Size::M => self.m,
            Size::Own => self.own,
        }
    }

    /// A quarter of a small integer: sums and products of a few are exact. Or one without a pattern.
    fn number(&self, random: &mut fastrand::Rng) -> f64 {
        match self.is_rough {
            true => 3.0 * random.f64() - 1.5,
            false => f64::from(random.i32(-12..=12)) / 4.0,
        }
    }
}

/// A value of a type.
pub fn datum(random: &mut fastrand::Rng, ty: Ty, sizes: &Sizes) -> Datum {
    let (value, rust) = match ty {
        Ty::Real => real(sizes.number(random)),
        Ty::Integer => integer(random.i64(-3..=6)),
        Ty::Vector(n) => vector(random, sizes, n),
        Ty::Matrix(n, m) => matrix(random, sizes, (n, m)),
        Ty::Sparse => {
            let n = sizes.n;
            let entries: Vec<f64> = (0..n * n)
                .map(|_| {
                    if random.bool() {
                        sizes.number(random)
                    } else {
                        0.0
                    }
                })
                .collect();
            let triplets: Vec<String> = (0..n * n)
                .filter(|k| entries[*k] != 0.0)
                .map(|k| format!("({}, {}, {:?})", k % n, k / n, entries[k]))
                .collect();
            (
                Value::Reals(DMatrix::from_column_slice(n, n, &entries)),
                format!("sparse({n}, &[{}])", triplets.join(", ")),
            )
        }
        Ty::Integers => {
            let entries: Vec<i64> = (0..sizes.n).map(|_| random.i64(-2..=4)).collect();
            (
                Value::Integers(DMatrix::from_column_slice(sizes.n, 1, &entries)),
                format!("DVector::<i64>::from_vec(vec!{entries:?})"),
            )
        }
        Ty::Points => {
            let items = (0..sizes.length).map(|_| vector(random, sizes, Size::Known(3)));
            sequence("glam::DVec3", items.collect())
        }
        Ty::Weights => sequence(
            "f64",
            (0..sizes.length)
                .map(|_| real(sizes.number(random)))
                .collect(),
        ),
        Ty::FieldOfPoints => {
            let n = sizes.elements[Kind::Vertex as usize];
            sequence(
                "glam::DVec3",
                (0..n)
                    .map(|_| vector(random, sizes, Size::Known(3)))
                    .collect(),
            )
        }
        Ty::Field(kind) => {
            let n = sizes.elements[kind as usize];
            sequence("f64", (0..n).map(|_| real(sizes.number(random))).collect())
        }
        Ty::Element(kind) => element(random, kind, sizes),
        Ty::SetOf(member) => {
            let members: Vec<(Value, String)> = (0..random.usize(0..5))
                .map(|_| match member {
                    Member::Integer => integer(random.i64(-1..=5)),
                    Member::Real => real(sizes.number(random)),
                    Member::Pair => {
                        let (a, b) = (random.i64(0..=2), random.i64(0..=2));
                        (
                            Value::Tuple(vec![Value::Integer(a), Value::Integer(b)]),
                            format!("({a}i64, {b}i64)"),
                        )
                    }
                    Member::Element(kind) => element(random, kind, sizes),
                })
                .collect();
            let (values, rust): (Vec<Value>, Vec<String>) = members.into_iter().unzip();
            let item = match member {
                Member::Integer => "i64",
                Member::Real => "f64",
                Member::Pair => "(i64, i64)",
                Member::Element(kind) => kind.handle(),
            };
            (
                Value::set(values),
                format!("Set::<{item}>::from(vec![{}])", rust.join(", ")),
            )
        }
        Ty::Index => panic!("an index is no parameter"),
        Ty::Function => (Value::Real(0.0), "|x: f64| x * 0.5 + 1.25".to_owned()),
    };
    Datum {
        value,
        rust,
        is_function: ty == Ty::Function,
    }
}

fn real(x: f64) -> (Value, String) {
    (Value::Real(x), format!("{x:?}f64"))
}

fn integer(k: i64) -> (Value, String) {
    (Value::Integer(k), format!("{k}i64"))
}

fn element(random: &mut fastrand::Rng, kind: Kind, sizes: &Sizes) -> (Value, String) {
    let id = random.usize(0..sizes.elements[kind as usize]) as u32;
    (Value::Element(id), format!("{}::new({id})", kind.handle()))
}

fn vector(random: &mut fastrand::Rng, sizes: &Sizes, size: Size) -> (Value, String) {
    let n = sizes.of(size);
    let entries: Vec<f64> = (0..n).map(|_| sizes.number(random)).collect();
    let rust = match size {
        Size::Known(n @ 2..=4) => format!("glam::DVec{n}::from_array({entries:?})"),
        Size::Known(n) => format!("SVector::<f64, {n}>::from_column_slice(&{entries:?})"),
        _ => format!("DVector::<f64>::from_vec(vec!{entries:?})"),
    };
    (Value::vector(&entries), rust)
}

/// A matrix; a square one has large entries on its diagonal, so that it has an inverse, most of the time.
fn matrix(
    random: &mut fastrand::Rng,
    sizes: &Sizes,
    (rows, columns): (Size, Size),
) -> (Value, String) {
    let (n, m) = (sizes.of(rows), sizes.of(columns));
    let heavy = random.u8(0..8) > 0;
    let entries: Vec<f64> = (0..n * m)
        .map(|k| {
            let diagonal = rows == columns && heavy && k % n == k / n;
            sizes.number(random) / if heavy { 2.0 } else { 1.0 } + if diagonal { 8.0 } else { 0.0 }
        })
        .collect();
    let rust = match (rows, columns) {
        (Size::Known(n @ 2..=4), Size::Known(m)) if n == m => {
            format!("glam::DMat{n}::from_cols_array(&{entries:?})")
        }
        (Size::Known(n), Size::Known(m)) => {
            format!("SMatrix::<f64, {n}, {m}>::from_column_slice(&{entries:?})")
        }
        _ => format!("DMatrix::<f64>::from_column_slice({n}, {m}, &{entries:?})"),
    };
    (
        Value::Reals(DMatrix::from_column_slice(n, m, &entries)),
        rust,
    )
}

fn sequence(item: &str, items: Vec<(Value, String)>) -> (Value, String) {
    let (values, rust): (Vec<Value>, Vec<String>) = items.into_iter().unzip();
    (
        Value::Sequence(values),
        format!("Vec::<{item}>::from([{}])", rust.join(", ")),
    )
}
