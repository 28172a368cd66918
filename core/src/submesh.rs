//! A part of a mesh as a mesh of its own.
