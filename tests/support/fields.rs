//! Values of a function on all elements, computed in every way that there is.

use iheartmesh::glam::DVec3;

/// A value that can be compared with another one.
pub trait Close: Copy + std::fmt::Debug {
    /// Length of the difference.
    fn distance(self, other: Self) -> f64;

    /// Length of the value.
    fn size(self) -> f64;
}

impl Close for f64 {
    fn distance(self, other: Self) -> f64 {
        (self - other).abs()
    }

    fn size(self) -> f64 {
        self.abs()
    }
}

impl Close for DVec3 {
    fn distance(self, other: Self) -> f64 {
        DVec3::distance(self, other)
    }

    fn size(self) -> f64 {
        self.length()
    }
}

/// The whole field of the optimised module, after comparison with its single values, with the whole field of the plain
/// module, and with single values of that one, which are slow: on large meshes not all of them.
pub fn agree<T: Close>(
    name: &str,
    whole: Vec<T>,
    single: Vec<T>,
    plain: Vec<T>,
    mut plain_single: impl FnMut(usize) -> T,
) -> Vec<T> {
    // values that nearly cancel, such as angles near 0, keep the precision of the largest ones
    let largest = whole.iter().fold(1.0_f64, |m, x| m.max(x.size()));
    let check = |place: usize, way: &str, other: T| {
        let value = whole[place];
        assert!(
            value.distance(other) <= 1e-13 * largest,
            "{name} at {place}: {value:?}, {way}: {other:?}"
        );
    };
    assert_eq!(
        (whole.len(), whole.len()),
        (single.len(), plain.len()),
        "{name}"
    );
    for (place, (a, b)) in single.into_iter().zip(plain).enumerate() {
        check(place, "single", a);
        check(place, "plain", b);
    }
    for place in (0..whole.len()).step_by(1 + whole.len() / 500) {
        check(place, "plain and single", plain_single(place));
    }
    whole
}

/// The field of a function: `field!(optimised, plain, elements, K, K_all)`.
#[macro_export]
macro_rules! field {
    ($optimised:expr, $plain:expr, $elements:expr, $f:ident, $all:ident) => {
        $crate::support::fields::agree(
            stringify!($f),
            $optimised.$all(),
            $elements.map(|element| $optimised.$f(element)).collect(),
            $plain.$all(),
            |place| $plain.$f($elements.nth(place).unwrap()),
        )
    };
}
