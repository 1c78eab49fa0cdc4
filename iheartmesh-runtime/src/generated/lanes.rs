//! Numbers of several problems side by side, which the compiler keeps in the vectors of the processor. No number depends on
//! those beside it.

use std::ops::{Add, AddAssign, Index, IndexMut, Mul, Neg, Sub, SubAssign};

/// One number for each of `L` problems.
#[derive(Clone, Copy, Debug)]
#[repr(align(16))]
pub(super) struct Lanes<const L: usize>(pub(super) [f64; L]);

/// Which of them.
pub(super) type Mask<const L: usize> = [bool; L];

impl<const L: usize> Lanes<L> {
    #[inline(always)]
    pub(super) fn splat(x: f64) -> Self {
        Self([x; L])
    }

    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self(std::array::from_fn(|k| f(self.0[k], other.0[k])))
    }

    #[inline(always)]
    pub(super) fn over(self, other: Self) -> Self {
        self.zip(other, |x, y| x / y)
    }

    #[inline(always)]
    pub(super) fn sqrt(self) -> Self {
        Self(self.0.map(f64::sqrt))
    }

    #[inline(always)]
    pub(super) fn abs(self) -> Self {
        Self(self.0.map(f64::abs))
    }

    #[inline(always)]
    pub(super) fn copysign(self, sign: Self) -> Self {
        self.zip(sign, f64::copysign)
    }

    /// The less of two numbers, the other one where one is not a number.
    #[inline(always)]
    pub(super) fn min(self, other: Self) -> Self {
        self.zip(other, |x, y| if x < y { x } else { y })
    }

    /// The greater of two numbers, the other one where one is not a number.
    #[inline(always)]
    pub(super) fn max(self, other: Self) -> Self {
        self.zip(other, |x, y| if x > y { x } else { y })
    }

    /// Where this is greater than the other one.
    #[inline(always)]
    pub(super) fn greater(self, other: Self) -> Mask<L> {
        std::array::from_fn(|k| self.0[k] > other.0[k])
    }

    /// This where the mask says so, the other one elsewhere.
    #[inline(always)]
    pub(super) fn select(mask: Mask<L>, this: Self, other: Self) -> Self {
        Self(std::array::from_fn(|k| {
            if mask[k] { this.0[k] } else { other.0[k] }
        }))
    }

    #[inline(always)]
    pub(super) fn most(self) -> f64 {
        self.0
            .into_iter()
            .fold(f64::NEG_INFINITY, |most, x| if x > most { x } else { most })
    }
}

impl<const L: usize> Add for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, |x, y| x + y)
    }
}

impl<const L: usize> Sub for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |x, y| x - y)
    }
}

impl<const L: usize> Mul for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.zip(other, |x, y| x * y)
    }
}

impl<const L: usize> Mul<f64> for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: f64) -> Self {
        Self(self.0.map(|x| x * factor))
    }
}

impl<const L: usize> Neg for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(self.0.map(|x| -x))
    }
}

impl<const L: usize> AddAssign for Lanes<L> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<const L: usize> SubAssign for Lanes<L> {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl<const L: usize> Index<usize> for Lanes<L> {
    type Output = f64;
    #[inline(always)]
    fn index(&self, lane: usize) -> &f64 {
        &self.0[lane]
    }
}

impl<const L: usize> IndexMut<usize> for Lanes<L> {
    #[inline(always)]
    fn index_mut(&mut self, lane: usize) -> &mut f64 {
        &mut self.0[lane]
    }
}
