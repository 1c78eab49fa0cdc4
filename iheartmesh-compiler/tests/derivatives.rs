//! Derivatives of every operation, against differences of the values, first and second, checked and optimised.
//!
//! Each program is evaluated by the interpreter; `tests/derivatives.rs` of the workspace runs generated code.

use iheartmesh_compiler::interpret::{Argument, Interpreter, Value};
use iheartmesh_compiler::ir::{GlobalId, Program};
use iheartmesh_compiler::optimize::{Optimizations, StagedProgram, optimize};
use iheartmesh_compiler::source::Source;
use iheartmesh_compiler::stages;
use nalgebra::DMatrix;

const IMPORTS: &str = "trace, det, diag, vec, vec⁻¹, inv from linearalgebra
sin, cos, tan, cot, sec, csc, asin, acos, atan, sinh, cosh, tanh, asinh, acosh, atanh, atan2 from trigonometry
a ∈ ℝ
p ∈ ℝ³
P ∈ ℝ^(3×3)
u ∈ ℝ^n
B ∈ ℝ^(n×n)
w_k ∈ ℝ
";

/// Numbers without a pattern, away from 0 and from each other.
fn noise(k: usize) -> f64 {
    0.3 + ((k as f64 + 1.0) * 0.754_877_666).fract()
}

fn matrix(n: usize, m: usize, start: usize) -> DMatrix<f64> {
    let diagonal = |i, j| if i == j { 1.0 } else { 0.0 };
    DMatrix::from_fn(n, m, |i, j| diagonal(i, j) + 0.7 * noise(start + i + n * j))
}

/// A value of a declared type with these numbers, in the order of `vec`.
fn shaped(ty: &str, x: &[f64]) -> Value {
    let square = |n: usize, x: &[f64]| Value::Reals(DMatrix::from_column_slice(n, n, x));
    match ty {
        "x ∈ ℝ" => Value::Real(x[0]),
        "x ∈ ℝ³" | "x ∈ ℝ²" | "x ∈ ℝ^n" | "x ∈ ℝ^6" => Value::vector(x),
        "x ∈ ℝ^(2×2)" => square(2, x),
        "x ∈ ℝ^(3×3)" => square(3, x),
        "x ∈ ℝ^(n×n)" => square(4, x),
        "x ∈ ℝ^(3×2)" => Value::Reals(DMatrix::from_column_slice(3, 2, x)),
        "x_i ∈ ℝ" => Value::Sequence(x.iter().map(|x| Value::Real(*x)).collect()),
        "x_i ∈ ℝ³" => Value::Sequence(x.chunks(3).map(Value::vector).collect()),
        "x_i ∈ ℝ^n" => Value::Sequence(x.chunks(4).map(Value::vector).collect()),
        "x_i ∈ ℝ^(2×2)" => Value::Sequence(x.chunks(4).map(|c| square(2, c)).collect()),
        _ => panic!("no value of {ty}"),
    }
}

fn start(ty: &str) -> Vec<f64> {
    match ty {
        "x ∈ ℝ" => vec![0.6],
        "x ∈ ℝ²" => vec![0.6, 1.1],
        "x ∈ ℝ³" => vec![0.6, 1.1, -0.4],
        "x ∈ ℝ^n" | "x_i ∈ ℝ" => (0..4).map(noise).collect(),
        "x ∈ ℝ^(2×2)" => matrix(2, 2, 0).as_slice().to_vec(),
        "x ∈ ℝ^(3×3)" => matrix(3, 3, 0).as_slice().to_vec(),
        "x ∈ ℝ^(n×n)" => matrix(4, 4, 0).as_slice().to_vec(),
        "x ∈ ℝ^(3×2)" => matrix(3, 2, 0).as_slice().to_vec(),
        "x ∈ ℝ^6" => (0..6).map(noise).collect(),
        _ => (0..12).map(noise).collect(),
    }
}

struct Compiled {
    program: Program,
    staged: StagedProgram,
}

fn compiled(text: &str) -> Compiled {
    let stages = stages(
        "Test",
        Source::file("test.hlang", text),
        &[],
        Optimizations::ALL,
    );
    let messages: Vec<String> = stages
        .diagnostics
        .sorted()
        .iter()
        .map(|d| format!("{}: {:?}", d.message, d.labels))
        .collect();
    let Some(program) = stages.program else {
        panic!("{text}\n{messages:#?}");
    };
    let staged = optimize(program.clone(), Optimizations::ALL);
    Compiled { program, staged }
}

fn numbers(value: Value) -> DMatrix<f64> {
    match value {
        Value::Real(x) => DMatrix::from_element(1, 1, x),
        Value::Reals(a) => a,
        other => panic!("{other} is not of numbers"),
    }
}

impl Compiled {
    fn global(&self, name: &str) -> GlobalId {
        let found = self.program.globals.iter().position(|g| g.name == name);
        GlobalId(found.unwrap_or_else(|| panic!("no `{name}`")) as u32)
    }

    fn value(&self, name: &str, ty: &str, x: &[f64], optimized: bool) -> DMatrix<f64> {
        let given = [
            ("a", Value::Real(1.3)),
            ("p", Value::vector(&[0.2, -0.7, 0.5])),
            ("P", Value::Reals(matrix(3, 3, 20))),
            ("u", Value::vector(&[0.4, -0.3, 0.9, 0.7])),
            ("B", Value::Reals(matrix(4, 4, 40))),
            (
                "w",
                Value::Sequence((0..4).map(|k| Value::Real(noise(k + 7))).collect()),
            ),
            ("x", shaped(ty, x)),
        ];
        let arguments = given
            .into_iter()
            .map(|(name, value)| (name.to_owned(), Argument::Value(value)))
            .filter(|(name, _)| self.program.inputs.iter().any(|i| i.name == *name));
        let interpreter = match optimized {
            true => Interpreter::staged(&self.staged, arguments),
            false => Interpreter::new(&self.program, arguments),
        };
        let interpreter = interpreter.unwrap_or_else(|e| panic!("{e}"));
        match interpreter.global(self.global(name)) {
            Ok(value) => numbers(value),
            Err(fault) => panic!("`{name}`: {}", fault.reason),
        }
    }
}

/// The derivative of each entry of a value by each number, from central differences.
fn differences(program: &Compiled, name: &str, ty: &str, x: &[f64]) -> DMatrix<f64> {
    let h = 1e-5;
    let columns: Vec<DMatrix<f64>> = (0..x.len())
        .map(|k| {
            let at = |shift: f64| {
                let mut x = x.to_vec();
                x[k] += shift;
                program.value(name, ty, &x, false)
            };
            let (far, near) = (at(2.0 * h) - at(-2.0 * h), at(h) - at(-h));
            (near * 8.0 - far) / (12.0 * h)
        })
        .collect();
    DMatrix::from_fn(columns[0].len(), x.len(), |i, j| columns[j][i])
}

fn check(ty: &str, formula: &str, hessian: bool) {
    let second = if hessian { "H = ∂²y/∂x²\n" } else { "" };
    let program = compiled(&format!(
        "{IMPORTS}{ty}\ny = {formula}\ng = ∂y/∂x\n{second}"
    ));
    let x = start(ty);
    let expected = differences(&program, "y", ty, &x);
    for optimized in [false, true] {
        let found = program.value("g", ty, &x, optimized);
        // a gradient is a column, the derivative of a vector has a row for each entry
        let found = match expected.nrows() {
            1 => DMatrix::from_row_slice(1, x.len(), found.as_slice()),
            _ => found,
        };
        let error = (&found - &expected).amax() / (1.0 + expected.amax());
        assert!(
            error < 1e-8,
            "{ty}: ∂({formula})/∂x\nfound {found}expected {expected}"
        );
        if hessian {
            let found = program.value("H", ty, &x, optimized);
            let expected = differences(&program, "g", ty, &x);
            let found = DMatrix::from_column_slice(x.len(), x.len(), found.as_slice());
            let error = (&found - &expected).amax() / (1.0 + expected.amax());
            assert!(
                error < 1e-8,
                "{ty}: ∂²({formula})/∂x²\nfound {found}expected {expected}"
            );
            let asymmetry = (&found - found.transpose()).amax() / (1.0 + expected.amax());
            assert!(
                asymmetry < 1e-12,
                "{ty}: ∂²({formula})/∂x² is not symmetric: {found}"
            );
        }
    }
}

/// Numbers with first and second derivatives; all that are wrong are named.
fn check_all(table: &[(&str, &[&str])]) {
    let mut wrong = Vec::new();
    for (ty, formulas) in table {
        for formula in *formulas {
            if let Err(why) = std::panic::catch_unwind(|| check(ty, formula, true)) {
                let why = why.downcast_ref::<String>().cloned();
                wrong.push(format!("{ty}: {formula}: {}", why.unwrap_or_default()));
            }
        }
    }
    assert!(wrong.is_empty(), "wrong: {wrong:#?}");
}

#[test]
fn numbers_of_a_number() {
    check_all(&[(
        "x ∈ ℝ",
        &[
            "3.5",
            "x",
            "a x² + 2x - 1",
            "-x/(1 + x²)",
            "x^a + a^x + x^x + x^3 + x⁻¹",
            "√x + √(1 + x²)",
            "|x - 2| x",
            "sin(x) + cos(x) tan(x)",
            "cot(x) sec(x) + csc(x)",
            "asin(x) + acos(x)² + atan(x)",
            "sinh(x) cosh(x) + tanh(x)",
            "asinh(x) + acosh(1 + x) + atanh(x)",
            "exp(x) + ln(x) + log_2(x) + log_10(x)",
            "atan2(x, a) + atan2(a, x²)",
            "min(x, a)² + max(x, 2x, a)²",
            "{ x² if x > a\n      x³ if x > 0\n      0 otherwise",
            "∑_(k = 1)^4 x^k",
            "∏_(k = 1)^3 (x - k)",
            "∑_k sin(w_k x) w_k",
            "∑_(k for w_k > 0.8) w_k x²",
            "∏_k (w_k + x)",
            "‖x p‖ + ‖p + (x, x², 1)‖²",
            "det(P + x P²) + trace(x P)",
            "p ⋅ ((P + x I_3)⁻¹ p)",
            "(1, x, x²)_2 + (x p)_1",
        ],
    )]);
}

#[test]
fn numbers_of_a_vector() {
    check_all(&[
        (
            "x ∈ ℝ³",
            &[
                "x ⋅ p",
                "x_1 x_2 + x_3²",
                "‖x‖",
                "‖x‖² + ‖x‖³ + ‖x‖⁴",
                "√(x ⋅ x) + √(xᵀ x)",
                "‖x‖_1 + ‖x‖_∞² + ‖x‖_3 + ‖x‖_P",
                "(x × p) ⋅ (p × x) + ‖x × p‖",
                "p ⋅ (x/‖x‖)",
                "acos(x ⋅ p/(‖x‖ ‖p‖))",
                "xᵀ P x + ½ x ⋅ (P x)",
                "‖P⁻¹ x‖² + p ⋅ ((P + x xᵀ)⁻¹ x)",
                "‖(x, 1)‖ + ‖(p, x)‖²",
                "det([x p 2x + (1, 0, 0)]) + ‖[x p; 1 2]‖²",
                "trace(x pᵀ P) + |P + x xᵀ|",
                "‖x ∘ p ∘ x‖² + (x ⊗ x) : (p ⊗ p)",
                "max(x)² + min(x)² + sin(x) ⋅ cos(x)",
                "∑_(k = 1)^3 x_k^k",
                "∏_(k = 1)^3 x_k²",
                "∑_(k = 1)^2 (x_k - x_(k + 1))²",
                "vec(x pᵀ) ⋅ vec(P)",
            ],
        ),
        (
            "x ∈ ℝ^n",
            &[
                "x ⋅ u + ‖x‖²",
                "‖x‖ + ‖x - u‖_1² + ‖x‖_3 + ‖x‖_∞²",
                "½ xᵀ B x",
                "‖B x - u‖²",
                "∑_i x_i² u_i + x_1 x_2",
                "√(∑_i x_i²)",
                "ln(∑_i exp(x_i))",
                "∑_(i = 1)^3 (x_(i + 1) - x_i)⁴",
                "∏_i x_i",
                "∑_i ∑_j x_i x_j² B_ij",
                "(x, u, 1) ⋅ (u, x, 2)",
                "‖diag(x) B‖² + trace(diag(x))",
                "‖(B + x xᵀ)⁻¹ u‖²",
                "‖(B + x uᵀ) \\ u‖²",
                "max(x)² + sin(x) ⋅ u",
                "‖[B x; xᵀ 1]‖²",
                "{ x ⋅ x if x_1 > 0\n      0 otherwise",
            ],
        ),
        ("x ∈ ℝ^6", &["∑_i x_i³", "x_1 x_6 + ‖x‖"]),
        ("x ∈ ℝ²", &["x_1² x_2 + ‖x‖", "xᵀ x + exp(x_1)"]),
    ]);
}

#[test]
fn numbers_of_a_matrix() {
    check_all(&[
        (
            "x ∈ ℝ^(2×2)",
            &[
                "det(x) + |x|²",
                "‖x‖ + ‖x‖²",
                "trace(x² xᵀ)",
                "x_1,1 x_2,2 - x_1,2²",
                "‖x‖² + ‖x⁻¹‖²",
                "trace(x³) + x : x",
                "x_1,* ⋅ x_*,2",
            ],
        ),
        (
            "x ∈ ℝ^(3×3)",
            &[
                "det(x)",
                "‖x‖²/det(x)^(2/3)",
                "p ⋅ (x p) + ‖x⁻¹ p‖²",
                "‖x P - P xᵀ‖²",
                "trace(x⁻¹) + diag(x) ⋅ p",
                "‖x \\ P‖²",
                "vec(x) ⋅ vec(x P)",
                "‖x²‖ + x_1,* ⋅ x_*,3",
                "‖[x p; pᵀ 2]‖²",
            ],
        ),
        (
            "x ∈ ℝ^(3×2)",
            &["‖x‖²", "det(xᵀ P x)", "‖xᵀ p‖", "∑_(j = 1)^2 ‖x_*,j‖³"],
        ),
        (
            "x ∈ ℝ^(n×n)",
            &[
                "det(x)",
                "uᵀ x u + ‖x u‖²",
                "‖x⁻¹ u‖²",
                "trace(x B x)",
                "∑_i ∑_j x_ij² B_ji",
                "∑_i ‖x_i,*‖³ + ∑_j u ⋅ x_*,j",
            ],
        ),
    ]);
    check("x ∈ ℝ^(3×3)", "‖x‖_*", false);
    check("x ∈ ℝ^(3×2)", "p ⋅ (x⁺ᵀ x⁺ p) + ‖x⁺‖²", false);
    check("x ∈ ℝ^(2×2)", "‖x ⊗ x‖² + (x ⊗ x)_1,4", false);
}

#[test]
fn numbers_of_a_sequence() {
    check_all(&[
        (
            "x_i ∈ ℝ",
            &[
                "∑_i x_i³",
                "∑_i w_i x_i²",
                "(∑_i x_i)²",
                "∏_i x_i",
                "√(∑_i x_i²)",
                "x_1 x_2 + ∑_(i = 1)^3 x_i x_(i + 1)",
                "∑_i ∑_j x_i² x_j",
                "max(x)²",
                "vec(x) ⋅ vec(x)",
            ],
        ),
        (
            "x_i ∈ ℝ³",
            &[
                "∑_i ‖x_i‖² + ‖x_1 - x_3‖",
                "∑_(i = 1)^3 ‖x_(i + 1) - x_i‖³",
                "∑_i (x_i × p) ⋅ (x_1 × (P p))",
                "‖∑_i x_i‖⁴",
                "∑_i ‖x_i - c‖² where c = ¼ ∑_j x_j",
                "∑_i x_i,2² x_i,1",
                "det([x_1 x_2 x_3])",
                "vec(x) ⋅ vec(x)",
            ],
        ),
        ("x_i ∈ ℝ^n", &["∑_i ‖x_i - u‖²", "x_1 ⋅ (B x_2) + x_3,1²"]),
        (
            "x_i ∈ ℝ^(2×2)",
            &["∑_i det(x_i)²", "trace(x_1 x_2 x_3)", "x_2,1,2² x_1,1,2"],
        ),
    ]);
}

#[test]
fn vectors() {
    for (ty, formula) in [
        ("x ∈ ℝ", "x² p + (x, 1, 2x)"),
        ("x ∈ ℝ", "x² u"),
        ("x ∈ ℝ³", "P x + (x × p) ‖x‖"),
        ("x ∈ ℝ³", "x_1 u"),
        ("x ∈ ℝ³", "(x_1 x_2, x_3²)"),
        ("x ∈ ℝ^n", "B x + 2 u"),
        ("x ∈ ℝ^n", "‖x‖ x - u"),
        ("x ∈ ℝ^n", "(x_1, x_2 x_3)"),
        ("x ∈ ℝ^(2×2)", "x x (1, 2)"),
        ("x_i ∈ ℝ³", "∑_i ‖x_i‖² x_i"),
        ("x_i ∈ ℝ³", "x_1 × x_2"),
        ("x_i ∈ ℝ", "vec(x) x_1"),
    ] {
        check(ty, formula, false);
    }
}

/// What the language reference says where a function has no derivative.
#[test]
fn singular_points() {
    let table: [(&str, &str, &[f64], &[f64]); 14] = [
        ("x ∈ ℝ³", "‖x‖", &[0.0; 3], &[0.0; 3]),
        ("x ∈ ℝ³", "‖x‖²", &[0.0; 3], &[0.0; 3]),
        ("x ∈ ℝ³", "√(x ⋅ x)", &[0.0; 3], &[0.0; 3]),
        ("x ∈ ℝ^(2×2)", "‖x‖", &[0.0; 4], &[0.0; 4]),
        ("x ∈ ℝ", "|x|", &[0.0], &[0.0]),
        ("x ∈ ℝ", "√x", &[0.0], &[0.0]),
        ("x ∈ ℝ", "x^(1/2)", &[0.0], &[0.0]),
        ("x ∈ ℝ", "asin(x) + acos(-x)", &[1.0], &[0.0]),
        ("x ∈ ℝ", "acosh(x)", &[1.0], &[0.0]),
        ("x ∈ ℝ³", "atan2(x_1, x_2)", &[0.0, 0.0, 1.0], &[0.0; 3]),
        (
            "x ∈ ℝ³",
            "min(x_1, x_2)",
            &[2.0, 2.0, 1.0],
            &[1.0, 0.0, 0.0],
        ),
        (
            "x ∈ ℝ^n",
            "max(x)",
            &[1.0, 2.0, 2.0, 0.0],
            &[0.0, 0.5, 0.5, 0.0],
        ),
        (
            "x_i ∈ ℝ",
            "∏_i x_i",
            &[0.0, 2.0, 3.0, 4.0],
            &[24.0, 0.0, 0.0, 0.0],
        ),
        ("x ∈ ℝ", "{ √x if x > 0\n      0 otherwise", &[0.0], &[0.0]),
    ];
    for (ty, formula, x, expected) in table {
        let program = compiled(&format!("{IMPORTS}{ty}\ny = {formula}\ng = ∂y/∂x\n"));
        for optimized in [false, true] {
            let found = program.value("g", ty, x, optimized);
            assert_eq!(found.as_slice(), expected, "{ty}: {formula} at {x:?}");
        }
    }
}

/// A definition that is used three times by the next one, twenty times: a walk over all of its uses would have no end.
#[test]
fn what_is_used_often_is_looked_at_once() {
    let mut text = "x_i ∈ ℝ\nS(k) = `c20` where k ∈ ℤ, `c0` = ∑_(i = 1)^k x_i²".to_owned();
    for k in 1..=20 {
        text += &format!(
            ", `c{k}` = ½ (`c{0}` + √(1 + `c{0}` `c{0}`))/(1 + `c{0}`)",
            k - 1
        );
    }
    text += "\ny ∈ ℝ^2\ny_k = S(k)\ng = ∂y/∂x\n";
    let check = move || {
        let program = compiled(&text);
        let x = [0.3, -0.2];
        let slopes = differences(&program, "y", "x_i ∈ ℝ", &x);
        let found = program.value("g", "x_i ∈ ℝ", &x, true);
        assert!((found - slopes).amax() < 1e-8);
    };
    // the interpreter goes down one definition after the other
    let thread = std::thread::Builder::new().stack_size(1 << 26);
    thread.spawn(check).unwrap().join().unwrap();
}
