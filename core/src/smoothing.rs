//! Laplacian smoothing.
