//! Sets and elements.

use super::{Generator, Kind, Member, Ty};

impl Generator {
    pub fn set(&mut self, member: Member, depth: usize) -> String {
        if depth == 0 {
            if let Member::Element(kind) = member
                && self.random.bool()
            {
                return match self.random.usize(0..3) {
                    0 => kind.set().to_owned(),
                    1 => format!("{{{}}}", self.leaf(Ty::Element(kind))),
                    _ => self.around(kind),
                };
            }
            return self.leaf(Ty::SetOf(member));
        }
        let d = depth - 1;
        match self.random.usize(0..10) {
            0 | 1 => {
                let sign = self.pick(&["∪", "∩", "-"]);
                format!("({} {sign} {})", self.set(member, d), self.set(member, d))
            }
            2 => {
                let n = self.random.usize(1..=3);
                let members: Vec<String> = (0..n).map(|_| self.member(member, d.min(1))).collect();
                format!("{{{}}}", members.join(", "))
            }
            3 | 4 => self.builder(member, d),
            5 | 6 => {
                let letter = self.letter();
                let over = match self.has_mesh && self.random.bool() {
                    true => Member::Element(self.kind()),
                    false => Member::Integer,
                };
                let set = self.set(over, d.min(1));
                let body = self.with(&letter, bound(over), |g| g.set(member, d));
                format!("(∪_({letter} ∈ {set}) {body})")
            }
            _ => match member {
                Member::Element(kind) => self.around(kind),
                Member::Integer => {
                    let (from, to) = (self.random.i32(-1..=1), self.integer(0));
                    let letter = self.letter();
                    // a range as a set, by way of the numbers of a vector
                    let t = self.input(Ty::Integers);
                    match self.random.bool() {
                        true => format!("{{{from}, {to}, #{t}}}"),
                        false => {
                            let set = self.leaf(Ty::SetOf(Member::Integer));
                            format!("{{ {letter} + ({from}) for {letter} ∈ {set} }}")
                        }
                    }
                }
                _ => self.leaf(Ty::SetOf(member)),
            },
        }
    }

    /// The elements around others.
    fn around(&mut self, kind: Kind) -> String {
        let other = self.kind();
        let inside = match self.random.usize(0..4) {
            0 => self.leaf(Ty::SetOf(Member::Element(other))),
            _ => self.leaf(Ty::Element(other)),
        };
        if kind == Kind::Vertex && other == Kind::Vertex && !self.chance(3) {
            return format!("VertexOneRing({inside})");
        }
        format!("{}({inside})", kind.neighbours())
    }

    fn member(&mut self, member: Member, depth: usize) -> String {
        match member {
            Member::Integer => self.integer(depth),
            Member::Real => self.exact(depth),
            Member::Pair => format!("tuple({}, {})", self.integer(depth), self.integer(0)),
            Member::Element(kind) => self.element(kind, depth),
        }
    }

    fn builder(&mut self, member: Member, depth: usize) -> String {
        let letter = self.letter();
        let over = match self.has_mesh && !self.chance(4) {
            true => match member {
                Member::Element(kind) if self.random.bool() => Member::Element(kind),
                _ => Member::Element(self.kind()),
            },
            false => Member::Integer,
        };
        let set = self.set(over, depth.min(1));
        let (body, condition) = self.with(&letter, bound(over), |g| {
            let body = match over == member && g.random.bool() {
                true => letter.clone(),
                false => g.member(member, depth.min(1)),
            };
            let condition = match g.random.usize(0..3) {
                0 => String::new(),
                _ => format!(" if {}", g.condition(depth.min(1))),
            };
            (body, condition)
        });
        format!("{{ {body} for {letter} ∈ {set}{condition} }}")
    }

    pub fn element(&mut self, kind: Kind, depth: usize) -> String {
        if depth == 0 || self.random.bool() {
            return self.leaf(Ty::Element(kind));
        }
        match self.random.usize(0..4) {
            0 if kind == Kind::Vertex => {
                let (f, v) = (
                    self.leaf(Ty::Element(Kind::Face)),
                    self.leaf(Ty::Element(Kind::Vertex)),
                );
                let next = self.pick(&["NextVertexAroundFace", "PreviousVertexAroundFace"]);
                format!("{next}({f}, {v})")
            }
            1 if kind == Kind::Edge => {
                let (a, b) = (
                    self.leaf(Ty::Element(Kind::Vertex)),
                    self.leaf(Ty::Element(Kind::Vertex)),
                );
                format!("EdgeIndex({a}, {b})")
            }
            2 => format!("({})_1", self.set(Member::Element(kind), depth - 1)),
            _ => self.leaf(Ty::Element(kind)),
        }
    }
}

fn bound(member: Member) -> Ty {
    match member {
        Member::Element(kind) => Ty::Element(kind),
        _ => Ty::Integer,
    }
}
