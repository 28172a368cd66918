//! Where figures are from: those of two machines, or of two compilers, do not go into one table.

use std::fs;
use std::process::Command;

pub(crate) fn describe() -> String {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let target = if cfg!(target_feature = "avx2") { "with AVX2" } else { "for any processor" };
    format!("{}, {cores} cores, {}, {target}; {}", processor(), version("rustc"), version("c++"))
}

fn processor() -> String {
    let text = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = text.lines().find_map(|line| line.strip_prefix("model name")?.split_once(": "));
    name.map_or("a processor of unknown name", |(_, name)| name).trim().into()
}

/// The first line of `--version`.
fn version(compiler: &str) -> String {
    let output = Command::new(compiler).arg("--version").output();
    let text = output.map(|output| String::from_utf8_lossy(&output.stdout).into_owned()).unwrap_or_default();
    text.lines().next().map_or_else(|| format!("no {compiler}"), str::to_owned)
}
