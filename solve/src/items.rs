//! Sequences as one vector, in the order of derivatives.

use std::fmt;

use iheartmesh_runtime::glam::{DMat2, DMat3, DMat4, DVec2, DVec3, DVec4};
use iheartmesh_runtime::nalgebra::DVector;

/// What a sequence of variables consists of: a number, a vector, or a square matrix, of which the entries stand column
/// by column.
pub trait Item: Copy {
    /// How many numbers it has.
    const SIZE: usize;

    /// Writes its numbers to a slice of [`Item::SIZE`] numbers.
    fn write(self, numbers: &mut [f64]);

    /// The item with these numbers, of which there are [`Item::SIZE`].
    fn read(numbers: &[f64]) -> Self;
}

impl Item for f64 {
    const SIZE: usize = 1;

    fn write(self, numbers: &mut [f64]) {
        numbers[0] = self;
    }

    fn read(numbers: &[f64]) -> Self {
        numbers[0]
    }
}

macro_rules! item {
    ($($type:ty, $size:literal, $write:ident, $read:path;)*) => {
        $(impl Item for $type {
            const SIZE: usize = $size;

            fn write(self, numbers: &mut [f64]) {
                self.$write(numbers);
            }

            fn read(numbers: &[f64]) -> Self {
                $read(numbers)
            }
        })*
    };
}

item! {
    DVec2, 2, write_to_slice, DVec2::from_slice;
    DVec3, 3, write_to_slice, DVec3::from_slice;
    DVec4, 4, write_to_slice, DVec4::from_slice;
    DMat2, 4, write_cols_to_slice, DMat2::from_cols_slice;
    DMat3, 9, write_cols_to_slice, DMat3::from_cols_slice;
    DMat4, 16, write_cols_to_slice, DMat4::from_cols_slice;
}

/// The numbers of a sequence one after the other: `vec(x)` of the language, the order in which derivatives by `x` have
/// their entries.
///
/// ```
/// use iheartmesh_runtime::glam::DVec2;
/// let u = iheartmesh_solve::vec(&[DVec2::new(1.0, 2.0), DVec2::new(3.0, 4.0)]);
/// assert_eq!(u.as_slice(), [1.0, 2.0, 3.0, 4.0]);
/// ```
pub fn vec<T: Item>(items: &[T]) -> DVector<f64> {
    let mut all = DVector::zeros(T::SIZE * items.len());
    let numbers = all.as_mut_slice().chunks_exact_mut(T::SIZE);
    items
        .iter()
        .zip(numbers)
        .for_each(|(item, numbers)| item.write(numbers));
    all
}

/// The sequence whose [`vec()`] is `numbers`: `vec⁻¹_x` of the language.
///
/// # Errors
/// If the numbers are not those of whole items.
///
/// ```
/// use iheartmesh_runtime::glam::DVec2;
/// let x = iheartmesh_solve::inverse_vec::<DVec2>(&[1.0, 2.0, 3.0, 4.0])?;
/// assert_eq!(x, [DVec2::new(1.0, 2.0), DVec2::new(3.0, 4.0)]);
/// assert!(iheartmesh_solve::inverse_vec::<DVec2>(&[1.0, 2.0, 3.0]).is_err());
/// # Ok::<(), iheartmesh_solve::WrongLength>(())
/// ```
pub fn inverse_vec<T: Item>(numbers: &[f64]) -> Result<Vec<T>, WrongLength> {
    let items = numbers.chunks_exact(T::SIZE);
    match items.remainder() {
        [] => Ok(items.map(T::read).collect()),
        _ => Err(WrongLength {
            found: numbers.len(),
            size: T::SIZE,
        }),
    }
}

/// Numbers that are no sequence of whole items.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WrongLength {
    /// How many numbers there are.
    pub found: usize,
    /// How many numbers an item has.
    pub size: usize,
}

impl fmt::Display for WrongLength {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} numbers are no items of {} numbers each",
            self.found, self.size
        )
    }
}

impl std::error::Error for WrongLength {}
