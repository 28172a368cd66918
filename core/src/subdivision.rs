//! Finer triangles: Loop and midpoint subdivision.
