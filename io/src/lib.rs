//! Mesh files in and out of onering.
