//! `.ring`
mod any;
mod bytes;
mod file;
mod head;
mod problem;
mod write;

pub use any::{build, faces, triangles};
pub use file::File;
pub use head::VERSION;
pub use write::{save, write};
