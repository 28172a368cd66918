//! One `Topology` trait, every triangle-mesh data structure.
#![no_std]
extern crate alloc;
