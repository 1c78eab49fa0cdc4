"""Inputs of programs: the value that NumPy computes with, and the same value as Rust text."""

import numpy as np

cases = []


class Input:
    def __init__(self, rust, value):
        self.rust = rust
        self.value = value


def number(x):
    x = float(x)
    if np.isnan(x):
        return "f64::NAN"
    if np.isinf(x):
        return "f64::INFINITY" if x > 0 else "f64::NEG_INFINITY"
    return repr(x)


def numbers(list_):
    return ", ".join(number(x) for x in list_)


def by_columns(matrix):
    return numbers(np.asarray(matrix, float).flatten("F"))


def real(x):
    return Input(f"{number(x)}_f64", float(x))


def integer(x):
    return Input(f"{int(x)}_i64", int(x))


def fixed_vector(v):
    v = np.asarray(v, float)
    n = len(v)
    if n in (2, 3, 4):
        return Input(f"DVec{n}::new({numbers(v)})", v)
    return Input(f"SVector::<f64, {n}>::from_column_slice(&[{numbers(v)}])", v)


def fixed_matrix(m):
    m = np.asarray(m, float)
    rows, columns = m.shape
    if rows == columns and rows in (2, 3, 4):
        return Input(f"DMat{rows}::from_cols_array(&[{by_columns(m)}])", m)
    kind = f"SMatrix::<f64, {rows}, {columns}>"
    return Input(f"{kind}::from_column_slice(&[{by_columns(m)}])", m)


def vector(v):
    v = np.asarray(v, float)
    return Input(f"DVector::<f64>::from_column_slice(&[{numbers(v)}])", v)


def matrix(m):
    m = np.asarray(m, float)
    rows, columns = m.shape
    text = f"DMatrix::<f64>::from_column_slice({rows}, {columns}, &[{by_columns(m)}])"
    return Input(text, m)


def integer_vector(v):
    text = ", ".join(str(int(x)) for x in v)
    return Input(f"DVector::<i64>::from_column_slice(&[{text}])", np.asarray(v))


def integer_matrix(m):
    m = np.asarray(m)
    rows, columns = m.shape
    text = ", ".join(str(int(x)) for x in m.flatten("F"))
    return Input(f"SMatrix::<i64, {rows}, {columns}>::from_column_slice(&[{text}])", m)


def sequence(items):
    text = ", ".join(item.rust for item in items)
    return Input(f"vec![{text}]", [item.value for item in items])


def integer_set(items):
    text = ", ".join(f"{i}_i64" for i in items)
    return Input(f"Set::<i64>::from_iter([{text}])", sorted(set(items)))


def real_set(items):
    return Input(f"Set::<f64>::from_iter([{numbers(items)}])", sorted(set(items)))


def pairs(items):
    text = ", ".join(f"({i}_i64, {j}_i64)" for i, j in items)
    return Input(f"Set::<(i64, i64)>::from_iter([{text}])", sorted(set(items)))


def sparse(m):
    m = np.asarray(m, float)
    rows, columns = m.shape
    entries = ", ".join(
        f"({i}, {j}, {number(m[i, j])})"
        for i in range(rows)
        for j in range(columns)
        if m[i, j] != 0
    )
    return Input(f"sparse({rows}, {columns}, &[{entries}])", m)


def rust(text):
    return Input(text, None)


def flat(value):
    if isinstance(value, (list, tuple)):
        return [x for item in value for x in flat(item)]
    if isinstance(value, np.ndarray):
        return [float(x) for x in value.flatten("F")]
    return [float(value)]


def case(name, source, inputs, **expected):
    cases.append((name, source, inputs, expected))
