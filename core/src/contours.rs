//! Contours: lines along which a scalar field has one value.
