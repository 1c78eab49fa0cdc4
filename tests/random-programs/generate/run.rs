//! What a generated program is worth, by the interpreter.

use iheartmesh_compiler::interpret::{Argument, Fault, Interpreter, Mesh, Value};
use iheartmesh_compiler::ir::{Export, FunctionId, GlobalId, Program};
use iheartmesh_compiler::optimize::Optimizations;
use iheartmesh_compiler::render::render;
use iheartmesh_compiler::source::Source;
use iheartmesh_compiler::{Library, Stages, stages};
use iheartmesh_runtime::FaceMesh;

use super::{Generated, Polygons};

/// The name of something that was asked for, and its value as text or `fault`.
pub type Outcome = (String, String);

/// The standard neighbourhoods.
pub fn libraries() -> Vec<Library> {
    vec![Library {
        name: "Neighborhoods".to_owned(),
        source: Source::file(
            "Neighborhoods.hlang",
            include_str!("../../../neighborhoods/src/Neighborhoods.hlang"),
        ),
    }]
}

/// All stages of a program.
///
/// # Errors
/// The messages of the compiler.
pub fn compile(generated: &Generated, optimizations: Optimizations) -> Result<Stages, String> {
    let source = Source::file("random.hlang", generated.source.clone());
    let stages = stages("Random", source, &libraries(), optimizations);
    if stages.diagnostics.has_errors() {
        let messages = stages.diagnostics.sorted();
        let messages = messages.into_iter().map(|d| render(&stages.sources, d));
        return Err(messages.collect());
    }
    Ok(stages)
}

struct Complex(FaceMesh);

impl Mesh for Complex {
    fn count(&self, dimension: usize) -> usize {
        match dimension <= 2 {
            true => self.0.complex().n(dimension),
            false => 0,
        }
    }

    fn boundary(&self, dimension: usize) -> Vec<(u32, u32, i8)> {
        let columns = 0..self.0.complex().n(dimension);
        let entries = columns.flat_map(|column| {
            let (rows, signs) = self.0.complex().boundary_column(dimension, column);
            let entries = rows.iter().zip(signs);
            entries.map(move |(row, sign)| (*row, column as u32, *sign))
        });
        entries.collect()
    }
}

/// The seeds: those of `IHEARTMESH_SEEDS` (`1000` or `500..1500`), or else so many from 0.
pub fn seeds(usual: u64) -> std::ops::Range<u64> {
    let text = std::env::var("IHEARTMESH_SEEDS").unwrap_or_default();
    let (from, to) = text.split_once("..").unwrap_or(("0", &text));
    from.parse().unwrap_or(0)..to.parse().unwrap_or(usual)
}

/// Runs something on a stack that is large enough for the deepest recursion.
pub fn deep<T: Send>(f: impl FnOnce() -> T + Send) -> T {
    std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().stack_size(512 << 20);
        match thread.spawn_scoped(scope, f).map(|handle| handle.join()) {
            Ok(Ok(value)) => value,
            Ok(Err(panic)) => std::panic::resume_unwind(panic),
            Err(error) => panic!("{error}"),
        }
    })
}

/// Which form of a program is interpreted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    Checked,
    Rewritten,
    Staged,
}

/// All that is asked of a program, by the interpreter: of the program as it was checked, or after the passes, or by its
/// staged bodies. Run it inside of [`deep`].
pub fn interpret(generated: &Generated, stages: &Stages, form: Form) -> Vec<Outcome> {
    with(generated, stages, form, |program, interpreter| {
        outcomes(generated, program, interpreter)
    })
}

/// Some definitions of a program. Run it inside of [`deep`].
pub fn evaluate(
    generated: &Generated,
    stages: &Stages,
    form: Form,
    names: &[&str],
) -> Vec<Result<Value, Fault>> {
    with(generated, stages, form, |program, interpreter| {
        let values = names
            .iter()
            .map(|name| interpreter.global(global(program, name)));
        values.collect()
    })
}

/// What `f` makes of an interpreter with the parameters of a program.
fn with<T>(
    generated: &Generated,
    stages: &Stages,
    form: Form,
    f: impl FnOnce(&Program, &Interpreter<'_>) -> T,
) -> T {
    let (Some(program), Some(staged)) = (&stages.program, &stages.staged) else {
        panic!("a program with errors");
    };
    let mesh = generated.mesh.as_ref().map(
        |Polygons {
             vertices, faces, ..
         }| { Complex(FaceMesh::from_polygons(*vertices, faces).expect("a mesh")) },
    );
    let mut arguments: Vec<(String, Argument<'_>)> = Vec::new();
    if let Some(mesh) = &mesh {
        arguments.push(("M".to_owned(), Argument::Mesh(mesh)));
    }
    for (name, datum) in &generated.inputs {
        let argument = match datum.is_function {
            true => Argument::Function(Box::new(|values: &[Value]| match values {
                [Value::Real(x)] => Value::Real(x * 0.5 + 1.25),
                _ => panic!("a function of one real number"),
            })),
            false => Argument::Value(datum.value.clone()),
        };
        arguments.push((name.clone(), argument));
    }
    let (program, interpreter) = match form {
        Form::Checked => (program, Interpreter::new(program, arguments)),
        Form::Rewritten => (
            &staged.program,
            Interpreter::new(&staged.program, arguments),
        ),
        Form::Staged => (&staged.program, Interpreter::staged(staged, arguments)),
    };
    let interpreter = match interpreter {
        Ok(interpreter) => interpreter,
        Err(error) => panic!("{error}\n{}", generated.source),
    };
    f(program, &interpreter)
}

fn outcomes(
    generated: &Generated,
    program: &Program,
    interpreter: &Interpreter<'_>,
) -> Vec<Outcome> {
    let mut outcomes = Vec::new();
    for name in &generated.definitions {
        let value = interpreter.global(global(program, name));
        outcomes.push((name.clone(), text(value)));
    }
    for (name, arguments) in &generated.calls {
        let arguments: Vec<Value> = arguments.iter().map(|a| a.value.clone()).collect();
        let value = interpreter.call(function(program, name), &arguments);
        outcomes.push((format!("{name}(…)"), text(value)));
    }
    for (name, kind) in &generated.fields {
        let id = function(program, name);
        let n = generated
            .mesh
            .as_ref()
            .map_or(0, |mesh| mesh.counts[*kind as usize]);
        let values = (0..n as u32).map(|element| {
            let whole = interpreter.whole(id, element);
            whole.unwrap_or_else(|| interpreter.call(id, &[Value::Element(element)]))
        });
        let values = values.collect::<Result<Vec<Value>, Fault>>();
        outcomes.push((format!("{name}_all"), text(values.map(Value::Sequence))));
    }
    outcomes
}

fn global(program: &Program, name: &str) -> GlobalId {
    let found = program.exports.iter().find_map(|export| match export {
        Export::Global(id) if program.global(*id).name == name => Some(*id),
        _ => None,
    });
    found.unwrap_or_else(|| panic!("no definition `{name}`"))
}

fn function(program: &Program, name: &str) -> FunctionId {
    let found = program.exports.iter().find_map(|export| match export {
        Export::Function(id) if program.function(*id).name == name => Some(*id),
        _ => None,
    });
    found.unwrap_or_else(|| panic!("no function `{name}`"))
}

fn text(value: Result<Value, Fault>) -> String {
    let mut text = String::new();
    match value {
        Ok(value) => write(&value, &mut text),
        Err(_) => text.push_str("fault"),
    }
    text.trim_end().to_owned()
}

/// A value as words: what it is, its sizes, its entries. The tests write the values of generated Rust in the same way.
fn write(value: &Value, text: &mut String) {
    let mut list = |what: &str, items: &[Value]| {
        text.push_str(&format!("{what} {} ", items.len()));
        items.iter().for_each(|item| write(item, text));
    };
    match value {
        Value::Real(x) => text.push_str(&format!("{x:?} ")),
        Value::Integer(k) => text.push_str(&format!("{k} ")),
        Value::Boolean(b) => text.push_str(&format!("{b} ")),
        Value::Element(id) => text.push_str(&format!("#{id} ")),
        Value::Reals(a) => {
            text.push_str(&format!("array {} {} ", a.nrows(), a.ncols()));
            a.iter().for_each(|x| text.push_str(&format!("{x:?} ")));
        }
        Value::Integers(a) => {
            text.push_str(&format!("array {} {} ", a.nrows(), a.ncols()));
            a.iter().for_each(|x| text.push_str(&format!("{x:?} ")));
        }
        Value::Function(_) => text.push_str("function "),
        Value::Chain(entries) => text.push_str(&format!("chain {entries:?} ")),
        Value::Sequence(items) => list("sequence", items),
        Value::Set(members) => list("set", members),
        Value::Tuple(items) => list("tuple", items),
    }
}
