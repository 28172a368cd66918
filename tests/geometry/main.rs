//! What positions give: normals, areas, curvature, smoothing, shortest paths. On every backend that has the trait,
//! against analytic answers and slow search; whatever the positions, nothing that is no number comes of numbers.
#![allow(unreachable_pub, reason = "a test has no outside")]

mod checks;
mod curvature;
mod distance;
mod measure;
#[path = "../common/real.rs"]
mod meshes;
mod normals;
#[path = "../common/random.rs"]
mod random;
mod samples;
#[path = "../common/shapes.rs"]
mod shapes;
mod smoothing;
mod solids;
mod wild;

/// Names for edges and boundary curves are asked for by nothing here.
macro_rules! check {
    (edge_map $mesh:ty) => {};
    (boundaries $mesh:ty) => {};
    ($has:ident $mesh:ty) => {
        #[test]
        fn $has() {
            crate::checks::$has::<$mesh>();
        }
    };
}

macro_rules! each_trait {
    ($($name:ident $text:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {$(
        mod $name {
            $(check!($has $mesh);)*
        }
    )+};
}
onering::with_backends!(each_trait);
