//! A readable tree without spans: one line for each part of an item, operators in prefix form.

use super::ast::*;

/// The tree of a module, for `--emit ast` and for tests.
pub fn dump(module: &Module) -> String {
    module.items.iter().map(item).collect()
}

fn item(item: &Item) -> String {
    match &item.kind {
        ItemKind::Import(node) => format!("import {}\n", import(node)),
        ItemKind::Parameters(list) => {
            let list = list
                .iter()
                .map(|node| format!("parameter {}\n", declaration(node)));
            list.collect()
        }
        ItemKind::Function(node) => function(node),
        ItemKind::Definition(node) => format!("define {}\n", definition(node)),
        ItemKind::Expression(node) => format!("expression {}\n", expr(node)),
    }
}

fn join<T>(list: &[T], separator: &str, show: impl Fn(&T) -> String) -> String {
    let list: Vec<String> = list.iter().map(show).collect();
    list.join(separator)
}

fn names(list: &[Name]) -> String {
    join(list, ", ", name)
}

fn name(name: &Name) -> String {
    let plain = !name
        .text
        .chars()
        .any(|c| c.is_whitespace() || "()[]{},".contains(c));
    match plain {
        true => name.text.clone(),
        false => format!("`{}`", name.text),
    }
}

fn import(import: &Import) -> String {
    let list = match &import.names {
        None => "*".to_owned(),
        Some(list) => join(list, ", ", |import| match &import.rename {
            None => name(&import.name),
            Some(rename) => format!("{} as {}", name(&import.name), name(rename)),
        }),
    };
    let arguments = names(&import.arguments);
    format!("{list} from {}({arguments})", name(&import.module))
}

fn function(function: &Function) -> String {
    let mut text = format!("function {}", name(&function.name));
    if !function.subscripts.is_empty() {
        text += &format!("[{}]", names(&function.subscripts));
    }
    if let Some(parameters) = &function.parameters {
        text += &format!("({})", names(parameters));
    }
    text += &format!("\n  = {}\n", expr(&function.body));
    for node in &function.declarations {
        text += &format!("  where {}\n", declaration(node));
    }
    for node in &function.locals {
        text += &format!("  local {}\n", definition(node));
    }
    text
}

fn declaration(node: &Declaration) -> String {
    let targets = join(&node.targets, ", ", |target| match &target.subscript {
        None => name(&target.name),
        Some(subscript) => format!("{}[{}]", name(&target.name), name(subscript)),
    });
    let relation = match node.relation {
        Relation::Member => "∈",
        Relation::Colon => ":",
        Relation::Subset => "⊂",
    };
    let mut text = format!("{targets} {relation} {}", ty(&node.ty));
    if let Some((attribute, _)) = node.attribute {
        text += &format!(" {attribute:?}");
    }
    if let Some(description) = &node.description {
        text += &format!(" {description:?}");
    }
    text
}

fn ty(node: &Type) -> String {
    let number = |number: Number| match number {
        Number::Real => "ℝ",
        Number::Integer => "ℤ",
    };
    let sparse = |sparse: bool| if sparse { " sparse" } else { "" };
    match &node.kind {
        TypeKind::Scalar(of) => number(*of).to_owned(),
        TypeKind::Vector {
            number: of,
            length,
            sparse: few,
        } => format!("{}[{}]{}", number(*of), expr(length), sparse(*few)),
        TypeKind::Matrix {
            number: of,
            rows,
            columns,
            sparse: few,
        } => format!(
            "{}[{}, {}]{}",
            number(*of),
            expr(rows),
            expr(columns),
            sparse(*few)
        ),
        TypeKind::Set(parts) => format!("{{{}}}", join(parts, " × ", ty)),
        TypeKind::SetOfAlternatives(parts) => format!("{{{}}}", join(parts, " ∨ ", ty)),
        TypeKind::Tuple(parts) => format!("({})", join(parts, " × ", ty)),
        TypeKind::Function {
            parameters,
            results,
        } => format!(
            "({} → {})",
            join(parameters, ", ", ty),
            join(results, ", ", ty)
        ),
        TypeKind::Mapping { from, to } => format!("({} ↦ {})", name(from), ty(to)),
        TypeKind::Mesh(kind) => format!("{kind:?}"),
        TypeKind::ElementSet(kind) => format!("{kind:?}Set"),
        TypeKind::CellularSet => "CellularSet".to_owned(),
        TypeKind::Named(set) => name(set),
        TypeKind::Members(set) => expr(set),
    }
}

fn definition(node: &Definition) -> String {
    let targets = join(&node.targets, ", ", |target| {
        let subscripts = join(&target.subscripts, " ", subscript);
        match target.subscripts.is_empty() {
            true => name(&target.name),
            false => format!("{}[{subscripts}]", name(&target.name)),
        }
    });
    let sign = if node.add { "+=" } else { "=" };
    format!("{targets} {sign} {}", expr(&node.value))
}

fn subscript(node: &Subscript) -> String {
    match node {
        Subscript::Expr(node) => expr(node),
        Subscript::All(_) => "*".to_owned(),
    }
}

fn list(head: &str, parts: &[Expr]) -> String {
    let mut text = format!("({head}");
    for part in parts {
        text += " ";
        text += &expr(part);
    }
    text + ")"
}

fn locals(nodes: &[Definition]) -> String {
    let nodes = nodes
        .iter()
        .map(|node| format!(" where {}", definition(node)));
    nodes.collect()
}

/// The tree of an expression. Long rows of operators need little of the stack.
pub(crate) fn expr(node: &Expr) -> String {
    match &node.kind {
        ExprKind::Unary { .. } | ExprKind::Binary { .. } => operation(node),
        _ => other(node),
    }
}

fn operation(node: &Expr) -> String {
    match &node.kind {
        ExprKind::Unary { op, operand } => {
            let op = match op {
                UnaryOp::Negate => "neg",
                UnaryOp::SquareRoot => "√",
                UnaryOp::Transpose => "transpose",
                UnaryOp::Inverse => "inv",
                UnaryOp::PseudoInverse => "pinv",
                UnaryOp::Size => "#",
            };
            ["(", op, " ", &expr(operand), ")"].concat()
        }
        ExprKind::Binary {
            op, left, right, ..
        } => {
            let op = match op {
                BinaryOp::Add => "+",
                BinaryOp::Subtract => "-",
                BinaryOp::PlusMinus => "±",
                BinaryOp::Juxtapose => "*",
                BinaryOp::Dot => ".",
                BinaryOp::Divide => "/",
                BinaryOp::Cross => "×",
                BinaryOp::Hadamard => "∘",
                BinaryOp::Kronecker => "⊗",
                BinaryOp::Frobenius => ":",
                BinaryOp::Solve => "solve",
                BinaryOp::Union => "∪",
                BinaryOp::Intersection => "∩",
                BinaryOp::Power => "^",
            };
            ["(", op, " ", &expr(left), " ", &expr(right), ")"].concat()
        }
        _ => String::new(),
    }
}

fn other(node: &Expr) -> String {
    match &node.kind {
        ExprKind::Integer(number) => number.to_string(),
        ExprKind::Real(number) => format!("{number:?}"),
        ExprKind::Pi => "π".to_owned(),
        ExprKind::Infinity => "∞".to_owned(),
        ExprKind::Name(node) => name(node),
        ExprKind::Subscript { base, subscripts } => {
            format!("{}[{}]", expr(base), join(subscripts, " ", subscript))
        }
        ExprKind::Call {
            function,
            subscripts,
            arguments,
        } => {
            let mut head = format!("call {}", name(function));
            if !subscripts.is_empty() {
                head += &format!("[{}]", join(subscripts, " ", expr));
            }
            list(&head, arguments)
        }
        ExprKind::Unary { .. } | ExprKind::Binary { .. } => operation(node),
        ExprKind::Norm {
            double,
            operand,
            subscript,
        } => {
            let bars = if *double { "‖" } else { "|" };
            let subscript = match subscript {
                None => String::new(),
                Some(NormSubscript::Expr(node)) => format!("_{}", expr(node)),
                Some(NormSubscript::Infinity) => "_∞".to_owned(),
                Some(NormSubscript::Nuclear) => "_*".to_owned(),
            };
            format!("{bars}{}{bars}{subscript}", expr(operand))
        }
        ExprKind::Inner {
            left,
            right,
            weight,
        } => {
            let weight = weight.as_ref().map(|node| format!(" {}", expr(node)));
            let weight = weight.unwrap_or_default();
            format!("(inner {} {}{weight})", expr(left), expr(right))
        }
        ExprKind::Vector(parts) => list("vector", parts),
        ExprKind::Matrix(rows) => {
            format!("[{}]", join(rows, "; ", |row| join(row, ", ", expr)))
        }
        ExprKind::Set(parts) => format!("{{{}}}", join(parts, ", ", expr)),
        ExprKind::Builder {
            element,
            variables,
            range,
            condition: test,
        } => {
            let test = test.as_ref().map(|node| format!(" if {}", condition(node)));
            let (variables, test) = (names(variables), test.unwrap_or_default());
            format!(
                "{{{} for {variables} ∈ {}{test}}}",
                expr(element),
                expr(range)
            )
        }
        ExprKind::NumberMatrix {
            ones,
            rows,
            columns,
        } => {
            let columns = columns.as_ref().map(|node| format!(" {}", expr(node)));
            let head = if *ones { "ones" } else { "zeros" };
            format!("({head} {}{})", expr(rows), columns.unwrap_or_default())
        }
        ExprKind::Big { .. } => big(node),
        ExprKind::Piecewise {
            branches,
            otherwise,
        } => {
            let mut text = "{".to_owned();
            for (value, test) in branches {
                text += &format!("{} if {}; ", expr(value), condition(test));
            }
            match otherwise {
                Some(value) => text + &format!("{} otherwise", expr(value)),
                None => text.trim_end_matches("; ").to_owned(),
            }
        }
        ExprKind::Optimise { .. } => optimise(node),
        ExprKind::Integral {
            variable,
            from,
            to,
            body,
        } => {
            let bounds = format!("{} {}", expr(from), expr(to));
            format!("(∫ {} {bounds} {})", name(variable), expr(body))
        }
        ExprKind::Derivative {
            total,
            order,
            numerator,
            denominators,
        } => {
            let sign = if *total { "𝕕" } else { "∂" };
            let by = join(denominators, "", |(variable, order)| match order {
                1 => format!(" {}", expr(variable)),
                _ => format!(" {}^{order}", expr(variable)),
            });
            format!("({sign}{order} {} /{by})", expr(numerator))
        }
        ExprKind::Gradient { variable, operand } => {
            let variable = variable.as_ref().map(|node| format!("_{}", expr(node)));
            format!("(∇{} {})", variable.unwrap_or_default(), expr(operand))
        }
        ExprKind::Laplacian(operand) => format!("(Δ {})", expr(operand)),
        ExprKind::Divergence(operand) => format!("(∇⋅ {})", expr(operand)),
        ExprKind::Error => "error".to_owned(),
    }
}

fn big(node: &Expr) -> String {
    let ExprKind::Big {
        op,
        head,
        body,
        locals: definitions,
    } = &node.kind
    else {
        return String::new();
    };
    let op = match op {
        BigOp::Sum => "∑",
        BigOp::Product => "∏",
        BigOp::Union => "⋃",
    };
    let head = match head {
        Head::Index(index) => name(index),
        Head::Filtered(index, test) => format!("({} for {})", name(index), condition(test)),
        Head::Members(indices, range) => format!("({} ∈ {})", names(indices), expr(range)),
        Head::Range(index, from, to) => {
            format!("({} = {} to {})", name(index), expr(from), expr(to))
        }
    };
    format!("({op} {head} {}{})", expr(body), locals(definitions))
}

fn optimise(node: &Expr) -> String {
    let ExprKind::Optimise {
        kind,
        variables,
        objective,
        constraints,
        initial,
    } = &node.kind
    else {
        return String::new();
    };
    let kind = format!("{kind:?}").to_lowercase();
    let variables = join(variables, ", ", declaration);
    let tests = constraints
        .iter()
        .map(|node| format!(" s.t. {}", condition(node)));
    let tests: String = tests.collect();
    let initial = initial
        .iter()
        .map(|node| format!(" initial {}", definition(node)));
    let initial: String = initial.collect();
    format!("({kind} ({variables}) {}{tests}{initial})", expr(objective))
}

fn condition(node: &Condition) -> String {
    match &node.kind {
        ConditionKind::And(left, right) => {
            format!("(and {} {})", condition(left), condition(right))
        }
        ConditionKind::Or(left, right) => format!("(or {} {})", condition(left), condition(right)),
        ConditionKind::Compare { op, left, right } => {
            let op = match op {
                CompareOp::Equal => "=",
                CompareOp::NotEqual => "≠",
                CompareOp::Less => "<",
                CompareOp::LessOrEqual => "≤",
                CompareOp::Greater => ">",
                CompareOp::GreaterOrEqual => "≥",
            };
            format!("({op} {} {})", expr(left), expr(right))
        }
        ConditionKind::Member { item, negated, set } => {
            let op = if *negated { "∉" } else { "∈" };
            format!("({op} {} {})", expr(item), expr(set))
        }
        ConditionKind::Error => "error".to_owned(),
    }
}
