//! Random numbers for tests.

/// A small deterministic generator (PCG), so that a failing case can be run again.
pub struct Random(pub u64);

impl Random {
    /// A number below `n`.
    pub fn below(&mut self, n: u32) -> u32 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        let xorshifted = (((self.0 >> 18) ^ self.0) >> 27) as u32;
        xorshifted.rotate_right((self.0 >> 59) as u32) % n
    }

    /// Some of the numbers below `n`, ascending: about one of `one_of`.
    pub fn subset(&mut self, n: u32, one_of: u32) -> Vec<u32> {
        (0..n).filter(|_| self.below(one_of) == 0).collect()
    }

    /// As many different numbers below `n`, in random order.
    pub fn distinct(&mut self, n: u32, count: usize) -> Vec<u32> {
        let mut numbers = Vec::new();
        while numbers.len() < count {
            let number = self.below(n);
            if !numbers.contains(&number) {
                numbers.push(number);
            }
        }
        numbers
    }
}
