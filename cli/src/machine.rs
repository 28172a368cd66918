//! What it was measured on.

use serde::Serialize;
use std::fmt;
use std::fs;

/// The machine and the build.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Machine {
    pub(crate) cpu: String,
    /// Threads that this process may run at once.
    pub(crate) cores: usize,
    pub(crate) os: String,
    pub(crate) arch: &'static str,
    /// `release` or `debug`: the latter is for testing, and its times mean little.
    pub(crate) build: &'static str,
}

impl Machine {
    pub(crate) fn this() -> Self {
        Self {
            cpu: cpu().unwrap_or_else(|| "unknown".into()),
            cores: std::thread::available_parallelism().map_or(1, usize::from),
            os: os().unwrap_or_else(|| std::env::consts::OS.into()),
            arch: std::env::consts::ARCH,
            build: if cfg!(debug_assertions) { "debug" } else { "release" },
        }
    }
}

impl fmt::Display for Machine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { cpu, cores, os, arch, build } = self;
        let s = if *cores == 1 { "" } else { "s" };
        write!(f, "{cpu}, {cores} core{s}, {os}, {arch}, {build} build")
    }
}

/// What the system tells of the processor: Linux in a file, Windows in the environment.
fn cpu() -> Option<String> {
    let from_file = fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| {
        let line = text.lines().find(|line| line.starts_with("model name") || line.starts_with("Model"))?;
        Some(line.split_once(':')?.1.trim().to_owned())
    });
    from_file.or_else(|| std::env::var("PROCESSOR_IDENTIFIER").ok())
}

fn os() -> Option<String> {
    let text = fs::read_to_string("/etc/os-release").ok()?;
    let name = text.lines().find_map(|line| line.strip_prefix("PRETTY_NAME="))?.trim_matches('"');
    let kernel = fs::read_to_string("/proc/sys/kernel/osrelease").unwrap_or_default();
    Some(format!("{name} (kernel {})", kernel.trim()))
}
