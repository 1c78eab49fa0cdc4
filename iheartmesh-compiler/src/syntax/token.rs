//! Tokens: what the lexer makes of the text, and what the parser reads after layout and names are settled.

use super::ast::OptimiseKind;

/// Index of a text in the table of the lexer.
pub(super) type TextId = u32;

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    /// A maximal run of letters and digits, before it is split.
    Word(TextId),
    /// A name in back-ticks, before it is looked up.
    Quoted(TextId),
    /// A name that is not a function.
    Name(TextId),
    /// The name of a function.
    Function(TextId),
    /// A run of letters that means nothing; its diagnostic has been given.
    Unknown,
    Integer(i64),
    Real(f64),
    SubscriptNumber(i64),
    SubscriptLetter(TextId),
    SuperscriptNumber(i64),
    SuperscriptLetter(TextId),
    Transpose,
    Inverse,
    PseudoInverse,
    Where,
    With,
    /// `with initial`.
    Initial,
    For,
    If,
    Otherwise,
    And,
    Or,
    From,
    SuchThat,
    Sum,
    Product,
    Union,
    Integral,
    Optimise(OptimiseKind),
    In,
    NotIn,
    Subset,
    Colon,
    Comma,
    Semicolon,
    Assign,
    AddAssign,
    EqualEqual,
    NotEqual,
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
    Plus,
    Minus,
    PlusMinus,
    Slash,
    Dot,
    Cross,
    Hadamard,
    Kronecker,
    Backslash,
    Intersection,
    Caret,
    Underscore,
    Star,
    Bar,
    DoubleBar,
    LeftAngle,
    RightAngle,
    LeftParen,
    RightParen,
    LeftBracket,
    RightBracket,
    LeftBrace,
    RightBrace,
    /// The brace that opens a piecewise value and is never closed.
    Piecewise,
    Hash,
    Root,
    Partial,
    Nabla,
    Laplace,
    Total,
    Pi,
    Infinity,
    Ones,
    Reals,
    Integers,
    Arrow,
    Empty,
    Vee,
    Top,
    /// A line break in the text; after layout, the end of an item.
    Newline,
    /// Between two rows of a matrix.
    Row,
    /// Between two branches of a piecewise value, two constraints, or two initial values.
    Branch,
    /// Free text after the second colon of a declaration.
    Description,
    /// A character that means nothing here.
    Stray,
    End,
}

/// A token with its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Token {
    pub kind: Kind,
    pub start: u32,
    pub end: u32,
    /// Whether a blank or a line break stands before it.
    pub space: bool,
}

impl Kind {
    /// The comparison signs, without `=`, which also defines.
    pub fn is_strict_relation(self) -> bool {
        use Kind::*;
        matches!(
            self,
            EqualEqual | NotEqual | Less | LessOrEqual | Greater | GreaterOrEqual
        )
    }

    /// The comparison signs and the signs of membership.
    pub fn is_relation(self) -> bool {
        self.is_strict_relation() || matches!(self, Kind::Assign | Kind::In | Kind::NotIn)
    }

    /// A statement goes on after a line break that follows this token.
    pub fn continues(self) -> bool {
        use Kind::*;
        self.is_relation() && self != Greater
            || matches!(
                self,
                Comma
                    | AddAssign
                    | Plus
                    | Minus
                    | PlusMinus
                    | Slash
                    | Dot
                    | Cross
                    | Hadamard
                    | Kronecker
                    | Backslash
                    | Union
                    | Intersection
                    | Caret
                    | And
                    | Or
                    | For
                    | If
                    | Subset
                    | Arrow
                    | SuchThat
                    | Where
                    | With
                    | Initial
                    | Piecewise
                    | Root
            )
    }

    /// Words that cannot be names without back-ticks.
    pub fn is_word(self) -> bool {
        use Kind::*;
        matches!(
            self,
            Where | With | For | If | Otherwise | And | Or | From | Reals | Integers
        )
    }

    /// How a message calls this kind of token; `None` when its own text says it best.
    pub fn description(self) -> Option<&'static str> {
        match self {
            Kind::Newline | Kind::Row => Some("the end of the line"),
            Kind::Branch => Some("the end of the branch"),
            Kind::End => Some("the end of the text"),
            Kind::Description => Some("a description"),
            _ => None,
        }
    }
}
