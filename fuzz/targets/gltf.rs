#![no_main]
use onering_fuzz::{Format, reads};
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| reads(bytes, Format::Gltf));
