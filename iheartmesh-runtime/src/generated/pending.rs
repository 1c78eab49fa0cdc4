//! Blocks whose eigenvalues are replaced later, several together.

use super::Part;

/// So many blocks are computed side by side.
pub(super) const LANES: usize = 8;

/// So many take less time each by itself.
pub(super) const FEW: usize = 2;

/// Replaces eigenvalues of blocks, at most [`LANES`], that begin at these places of the values. No block has an effect on another.
pub(super) type Replace = fn(&mut [f64], &[usize], Part);

/// How eigenvalues are replaced: blocks for which this is the same wait together.
#[derive(Clone, Copy, Debug)]
pub(super) struct Kind {
    /// Parts of a block, and their height.
    pub(super) sizes: [usize; 2],
    pub(super) part: Part,
    pub(super) replace: Replace,
}

impl Kind {
    fn is(&self, other: &Self) -> bool {
        let key = |kind: &Self| (kind.sizes, kind.part);
        key(self) == key(other)
    }
}

/// Blocks among the values of a chunk whose eigenvalues are still to be replaced.
#[derive(Debug, Default)]
pub(super) struct Pending {
    /// Where they begin.
    places: [usize; LANES],
    count: usize,
    kind: Option<Kind>,
}

impl Pending {
    /// Another block, which begins at this place. Those that wait are replaced when they are many, or of another kind.
    #[inline(always)]
    pub(super) fn push(&mut self, values: &mut [f64], place: usize, kind: Kind) {
        if !self.kind.is_some_and(|known| known.is(&kind)) {
            self.flush(values);
            self.kind = Some(kind);
        }
        self.places[self.count] = place;
        self.count += 1;
        if self.count == LANES {
            self.flush(values);
        }
    }

    /// Replaces the eigenvalues of all that wait.
    #[inline(always)]
    pub(super) fn flush(&mut self, values: &mut [f64]) {
        if self.count > 0
            && let Some(kind) = self.kind
        {
            (kind.replace)(values, &self.places[..self.count], kind.part);
            self.count = 0;
        }
    }
}
