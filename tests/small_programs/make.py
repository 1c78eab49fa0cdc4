"""Writes `programs.rs`: small programs with the values that NumPy and SciPy compute for them.

Needs NumPy and SciPy. The tests read only what it wrote.
"""

import pathlib

import programs  # noqa: F401, fills the list of cases
from values import cases, flat, numbers


def camel(name):
    return "".join(word.capitalize() for word in name.split("_"))


lines = ["programs! {"]
for name, source, _, _ in cases:
    lines += [f'{camel(name)}, Plain{camel(name)} = r##"{source}"##;', ""]
lines += ["}", "", "for_both! {"]
for name, _, inputs, expected in cases:
    arguments = ", ".join(value.rust for value in inputs)
    lines += [
        "#[test]",
        f"fn {name}() {{",
        f"    let module = {camel(name)}::new({arguments}).unwrap();",
    ]
    for method, value in expected.items():
        # the call of a function comes with its arguments
        call = method if method.endswith(")") else f"{method}()"
        lines.append(
            f'    check("{method}", &module.{call}, &[{numbers(flat(value))}]);'
        )
    lines += ["}", ""]
lines += ["}", ""]
pathlib.Path(__file__).with_name("programs.rs").write_text("\n".join(lines))
print(len(cases), "programs")
