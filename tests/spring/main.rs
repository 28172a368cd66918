//! Masses and springs: against analytic solutions, conservation laws, and slow sums over the edges, on every backend
//! that knows the ring of a vertex.
#![allow(unreachable_pub, reason = "a test has no outside")]

mod analytic;
mod backends;
mod errors;
mod laws;
#[path = "../common/shapes.rs"]
mod shapes;
mod slow;

macro_rules! each_incidence {
    ($($name:ident $text:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {$(
        mod $name {
            $(each_incidence!(@ $has $mesh);)*
        }
    )+};
    (@ incidence $mesh:ty) => {
        #[test]
        fn moves_as_the_edges_say() {
            super::backends::moves_as_the_edges_say::<$mesh>();
        }

        #[test]
        fn rests_where_the_edges_say() {
            super::backends::rests_where_the_edges_say::<$mesh>();
        }
    };
    (@ $other:ident $mesh:ty) => {};
}
onering::with_backends!(each_incidence);
