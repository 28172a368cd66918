//! The dual graph: faces as nodes, joined across edges.
