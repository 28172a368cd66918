//! Soft tissue as masses and springs.
