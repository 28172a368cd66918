//! `.ring` files: what was written comes back, and whatever else is in a file is an error or a mesh that obeys the laws.
#![cfg(target_endian = "little")]
mod consistent;
mod crafted;
mod damaged;
mod files;
mod round_trip;
mod seal;

/// Runs the law of each trait that a backend has.
macro_rules! laws {
    ($case:expr, $mesh:expr, $($law:ident)*) => { $(onering::conformance::$law($case, $mesh);)* };
}
pub(crate) use laws;

/// The file of a mesh, with positions that are its numbers.
pub(crate) fn file_of(mesh: &(impl onering::columns::Columns + ?Sized)) -> Vec<u8> {
    let positions: Vec<[f32; 3]> = (0..mesh.counts().0).map(|v| [v as f32, 0.5, -1.0]).collect();
    let mut bytes = Vec::new();
    onering::ring::write(&mut bytes, mesh, Some(&positions)).expect("a vector takes everything");
    bytes
}
