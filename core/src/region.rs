//! Regions: faces grown from a seed.
