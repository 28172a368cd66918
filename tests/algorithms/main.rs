//! Every algorithm, on every backend that has its trait, against slow search; and on real meshes against the
//! figures of an independent program.
#![allow(unreachable_pub, reason = "a test has no outside")]

mod checks;
mod figures;
#[path = "../common/real.rs"]
mod meshes;
mod real;
mod samples;
#[path = "../common/shapes.rs"]
mod shapes;
mod slow;

macro_rules! each_trait {
    ($($name:ident $text:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {$(
        mod $name {
            $(#[test]
            fn $has() {
                super::checks::$has::<$mesh>();
                super::real::$has::<$mesh>();
            })*
        }
    )+};
}
onering::with_backends!(each_trait);
