//! The table of structures in the README is what the registry says.
use onering::registry::{BACKENDS, COMPRESSED, NOT_BACKENDS, RENUMBERING};
use std::fmt::Write;

const BEGIN: &str = "<!-- made from the registry, checked by tests/readme.rs -->\n";
const END: &str = "<!-- end -->";

fn table() -> String {
    let mut table = String::from(
        "| structure | bytes | with xyz | formula | traits | holds |\n|---|---|---|---|---|---|\n",
    );
    let words = |words: &[&str]| words.join(", ").replace('_', " ");
    for (name, bytes, formula) in NOT_BACKENDS {
        let bytes_text = bytes.map_or("-".into(), |bytes| bytes.to_string());
        let with_xyz = bytes.map_or(36, |bytes| bytes + 6);
        writeln!(table, "| {name} (for comparison) | {bytes_text} | {with_xyz} | {formula} | | |").unwrap();
    }
    for entry in BACKENDS.iter().chain(RENUMBERING) {
        let (name, bytes, formula) = (entry.name, entry.bytes.per_triangle(), entry.bytes.to_string());
        let (traits, holds) = (words(entry.traits), words(entry.holds));
        writeln!(table, "| `{name}` | {bytes} | {} | {formula} | {traits} | {holds} |", bytes + 6).unwrap();
    }
    for entry in COMPRESSED {
        let ([least, most], formula) = (entry.bytes, entry.formula);
        let range = |xyz| format!("{} to {}", least + xyz, most + xyz);
        let traits = words(entry.traits);
        writeln!(table, "| `{}` | {} | {} | {formula} | {traits} |  |", entry.name, range(0), range(6))
            .unwrap();
    }
    table
}

#[test]
fn the_table_of_bytes_is_made_from_the_registry() {
    let readme = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/README.md")).unwrap();
    let (_, rest) = readme.split_once(BEGIN).expect("the README has a place for the table");
    let (written, _) = rest.split_once(END).expect("the README marks the end of the table");
    assert!(written == table(), "the README's table is not up to date; it should be:\n{}", table());
}

/// What each takes, counted by hand from its description in the papers.
#[test]
fn bytes_are_those_of_the_papers() {
    let papers = [
        ("shared-vertex", 12),
        ("che-l0", 12),
        ("che-l1", 24),
        ("che-l2", 32),
        ("che-l2-edge-table", 44),
        ("che-l3", 32),
        ("directed-edges-small", 26),
        ("directed-edges-medium", 38),
        ("directed-edges-full", 62),
        ("mate-face", 26),
        ("half-edge", 62),
        ("winged-edge", 54),
        ("vertex-graph", 14),
        ("adjacency-graph", 40),
        ("sot", 12),
    ];
    let counted = BACKENDS.iter().chain(RENUMBERING).map(|entry| (entry.name, entry.bytes.per_triangle()));
    assert_eq!(counted.collect::<Vec<_>>(), papers);
}
