//! Minima, maxima and saddles of a scalar field.
