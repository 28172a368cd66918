//! The vertex nearest to a point.
