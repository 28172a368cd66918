//! Traits and algorithms for triangle-mesh topology, with no storage of their own.
#![no_std]
extern crate alloc;
