//! Reading values before they are needed.

use glam::{DVec2, DVec3, DVec4};

/// A value that can be read without computing with it.
pub trait Touch {
    /// Some bits of the value.
    fn bits(&self) -> u64;
}

impl Touch for f64 {
    #[inline(always)]
    fn bits(&self) -> u64 {
        self.to_bits()
    }
}

impl Touch for i64 {
    #[inline(always)]
    fn bits(&self) -> u64 {
        *self as u64
    }
}

impl Touch for DVec2 {
    #[inline(always)]
    fn bits(&self) -> u64 {
        self.x.to_bits()
    }
}

impl Touch for DVec3 {
    #[inline(always)]
    fn bits(&self) -> u64 {
        // a value may lie on two cache lines
        self.x.to_bits() ^ self.z.to_bits()
    }
}

impl Touch for DVec4 {
    #[inline(always)]
    fn bits(&self) -> u64 {
        self.x.to_bits() ^ self.w.to_bits()
    }
}

/// Reads a value.
#[inline(always)]
pub fn touch(value: &impl Touch) -> u64 {
    value.bits()
}
