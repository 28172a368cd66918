//! Shortest paths and distances along edges.
