//! Looking ahead: which kind of statement begins here.

use super::super::token::Kind;
use super::{NONE, Parser};

impl Parser<'_> {
    /// The sign after a list of names with subscripts: what kind of statement begins here.
    pub(super) fn statement_sign(&mut self) -> Option<Kind> {
        let mut index = 0;
        while index < 256 {
            if !self.is_name(index) {
                return None;
            }
            index += 1;
            while matches!(
                self.ahead(index),
                Kind::SubscriptLetter(_) | Kind::SubscriptNumber(_)
            ) {
                index += 1;
            }
            if self.ahead(index) == Kind::Underscore {
                index += 1;
                if self.ahead(index) == Kind::LeftParen {
                    let partner = self.partners.get(self.at + index).copied();
                    let partner = partner.filter(|p| *p != NONE)? as usize;
                    index = partner + 1 - self.at;
                }
                loop {
                    let comma = self.ahead(index) == Kind::Comma;
                    let comma = (comma && self.tight(index + 1)) as usize;
                    // `p_i,q_i`: what has a subscript of its own is no subscript
                    if comma == 1
                        && self.ahead(index + 2) == Kind::Underscore
                        && self.tight(index + 2)
                    {
                        break;
                    }
                    let kind = self.ahead(index + comma);
                    let part = matches!(
                        kind,
                        Kind::Name(_)
                            | Kind::Function(_)
                            | Kind::Integer(_)
                            | Kind::Star
                            | Kind::Unknown
                    );
                    if !part || !self.tight(index) {
                        break;
                    }
                    index += 1 + comma;
                }
            }
            match self.ahead(index) {
                Kind::Comma => index += 1,
                sign @ (Kind::Assign | Kind::AddAssign | Kind::In | Kind::Colon | Kind::Subset) => {
                    return Some(sign);
                }
                _ => return None,
            }
        }
        None
    }
}
