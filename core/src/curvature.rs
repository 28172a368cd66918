//! Curvature at vertices.
