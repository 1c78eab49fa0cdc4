//! Expressions that bind names, and conditions.

use super::super::ast::*;
use super::super::spelling;
use super::Printer;
use super::expression::{ATOM, Tail};

impl Printer {
    /// A whole right-hand side.
    pub(super) fn right_side(&mut self, node: &Expr, tail: Tail) -> String {
        match &node.kind {
            ExprKind::Piecewise {
                branches,
                otherwise,
            } => {
                let mut lines = Vec::new();
                for (value, test) in branches {
                    let value = self.right_side(value, Tail::Term);
                    lines.push(format!("{value} if {}", self.condition(test, 0)));
                }
                if let Some(value) = otherwise {
                    lines.push(format!("{} otherwise", self.right_side(value, Tail::Term)));
                }
                format!("{{ {}", lines.join("\n      "))
            }
            ExprKind::Optimise { .. } => self.optimise(node),
            _ => self.show(node, 0, tail),
        }
    }

    pub(super) fn big(&mut self, node: &Expr, tail: Tail) -> String {
        let ExprKind::Big {
            op,
            head,
            body,
            locals,
        } = &node.kind
        else {
            return String::new();
        };
        let sign = self.sign(match op {
            BigOp::Sum => '∑',
            BigOp::Product => '∏',
            BigOp::Union => '∪',
        });
        let head = match head {
            Head::Index(name) => self.name(name),
            Head::Filtered(name, test) => {
                let test = self.condition(test, 0);
                format!("({} for {test})", self.name(name))
            }
            Head::Members(names, range) => {
                let range = self.inside(range);
                format!("({} {} {range})", self.names(names), self.sign('∈'))
            }
            Head::Range(name, from, to) => {
                let (from, to) = (self.inside(from), self.bound(to));
                format!("({} = {from})^{to}", self.name(name))
            }
        };
        let tail = match locals.is_empty() {
            true => tail,
            false => Tail::Term,
        };
        let body = match &body.kind {
            ExprKind::Unary {
                op: UnaryOp::Negate,
                operand,
            } => format!("-{}", self.show(operand, 1, tail)),
            _ => self.show(body, 1, tail),
        };
        let mut text = format!("{sign}_{head} {body}");
        if !locals.is_empty() {
            let locals: Vec<String> = locals
                .iter()
                .map(|node| self.definition(node, Tail::Term))
                .collect();
            text += &format!(" where {}", locals.join(", "));
        }
        text
    }

    /// A bound of a sum or an integral.
    fn bound(&mut self, node: &Expr) -> String {
        match node.kind {
            ExprKind::Integer(_) | ExprKind::Name(_) | ExprKind::Pi | ExprKind::Infinity => {
                self.show(node, ATOM, Tail::None)
            }
            _ => format!("({})", self.inside(node)),
        }
    }

    pub(super) fn integral(&mut self, node: &Expr) -> String {
        let ExprKind::Integral {
            variable,
            from,
            to,
            body,
        } = &node.kind
        else {
            return String::new();
        };
        let bounds = format!("[{}, {}]", self.inside(from), self.inside(to));
        let body = self.show(body, 0, Tail::Term);
        let (sign, variable) = (self.sign('∫'), self.name(variable));
        format!("{sign}_{bounds} {body} {}{variable}", self.prefix('𝕕'))
    }

    pub(super) fn derivative(&mut self, node: &Expr) -> String {
        let ExprKind::Derivative {
            total,
            order,
            numerator,
            denominators,
        } = &node.kind
        else {
            return String::new();
        };
        let sign = if *total { '𝕕' } else { '∂' };
        let blank = if self.ascii { " " } else { "" };
        let outer = std::mem::replace(&mut self.bars, false);
        let numerator = self.show(numerator, ATOM, Tail::None);
        let above = self.sign(sign) + &self.order(*order) + blank + &numerator;
        let mut below = String::new();
        for (variable, order) in denominators {
            let variable = self.show(variable, ATOM, Tail::None);
            below += &(self.prefix(sign) + &variable + &self.order(*order));
        }
        self.bars = outer;
        format!("{above}/{below}")
    }

    fn order(&self, order: u32) -> String {
        match order {
            1 => String::new(),
            _ if self.ascii => format!("^{order}"),
            _ => spelling::superscript_number(i64::from(order)),
        }
    }

    pub(super) fn builder(&mut self, node: &Expr) -> String {
        let ExprKind::Builder {
            element,
            variables,
            range,
            condition,
        } = &node.kind
        else {
            return String::new();
        };
        let element = self.inside(element);
        let range = self.inside(range);
        let member = self.sign('∈');
        let test = condition
            .as_ref()
            .map(|node| format!(" if {}", self.condition(node, 0)));
        let (variables, test) = (self.names(variables), test.unwrap_or_default());
        format!("{{{element} for {variables} {member} {range}{test}}}")
    }

    fn optimise(&mut self, node: &Expr) -> String {
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
        let mut text = String::new();
        if !initial.is_empty() {
            let initial: Vec<String> = initial
                .iter()
                .map(|node| self.definition(node, Tail::Term))
                .collect();
            text += &format!("with initial {}\n    ", initial.join("; "));
        }
        let variables: Vec<String> = variables
            .iter()
            .map(|node| self.declaration(node))
            .collect();
        let kind = format!("{kind:?}").to_lowercase();
        let objective = self.show(objective, 0, Tail::Term);
        text += &format!("{kind}_({}) {objective}", variables.join(", "));
        if !constraints.is_empty() {
            let tests: Vec<String> = constraints
                .iter()
                .map(|node| self.condition(node, 0))
                .collect();
            text += &format!(" s.t. {}", tests.join("; "));
        }
        text
    }

    /// A condition: `or` is of strength 0, `and` of strength 1.
    fn condition(&mut self, node: &Condition, least: u8) -> String {
        let bars = std::mem::replace(&mut self.bars, false);
        let text = match &node.kind {
            ConditionKind::Or(left, right) => {
                let text = format!(
                    "{} or {}",
                    self.condition(left, 0),
                    self.condition(right, 1)
                );
                if least > 0 { format!("({text})") } else { text }
            }
            ConditionKind::And(left, right) => {
                let text = format!(
                    "{} and {}",
                    self.condition(left, 1),
                    self.condition(right, 2)
                );
                if least > 1 { format!("({text})") } else { text }
            }
            ConditionKind::Compare { op, left, right } => {
                let sign = self.sign(match op {
                    CompareOp::Equal => '=',
                    CompareOp::NotEqual => '≠',
                    CompareOp::Less => '<',
                    CompareOp::LessOrEqual => '≤',
                    CompareOp::Greater => '>',
                    CompareOp::GreaterOrEqual => '≥',
                });
                let left = self.show(left, 0, Tail::Term);
                format!("{left} {sign} {}", self.show(right, 0, Tail::Term))
            }
            ConditionKind::Member { item, negated, set } => {
                let sign = self.sign(if *negated { '∉' } else { '∈' });
                let item = self.show(item, 0, Tail::Term);
                format!("{item} {sign} {}", self.show(set, 0, Tail::Term))
            }
            ConditionKind::Error => "…".to_owned(),
        };
        self.bars = bars;
        text
    }
}
