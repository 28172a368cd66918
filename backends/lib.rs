//! One `Topology` trait, every triangle-mesh data structure.
#![no_std]
extern crate alloc;

pub use onering_core::*;

mod build;
pub mod column;
pub mod layout;
pub mod link;
#[macro_use]
pub mod registry;
mod table;

pub use layout::*;
pub use table::Table;
