//! Boundary curves filled with triangles.
