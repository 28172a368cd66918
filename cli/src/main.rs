//! onering at the shell.

fn main() {}
