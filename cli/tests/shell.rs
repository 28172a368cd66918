//! Completions, manual pages and help: they speak of every command, every option and every format.

mod common;

use common::{fresh, onering};
use onering_io::Format;
use std::collections::BTreeSet;
use std::fs;

const COMMANDS: [&str; 11] = [
    "inspect",
    "convert",
    "compare",
    "recommend",
    "query",
    "minima",
    "region",
    "contours",
    "deform",
    "completions",
    "man",
];

/// Every `--option` that the help of a command speaks of at the start of a line.
fn options(command: &str) -> BTreeSet<String> {
    let help = onering([command, "--help"]).out;
    let starts =
        help.lines().filter_map(|line| line.trim_start().split("--").nth(1).filter(|_| is_option(line)));
    starts.map(|rest| rest.split([' ', ',', '[']).next().unwrap().to_owned()).collect()
}

fn is_option(line: &str) -> bool {
    let line = line.trim_start();
    line.starts_with("--") || line.starts_with('-') && line.contains(", --")
}

#[test]
fn options_are_found_in_the_help() {
    let found = options("convert");
    for option in ["format", "from", "to", "weld", "repair", "keep-corners", "attribute", "backend", "quiet"]
    {
        assert!(found.contains(option), "{option}: {found:?}");
    }
}

#[test]
fn completions_know_every_command_and_option() {
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let run = onering(["completions", shell]);
        assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
        for command in COMMANDS {
            assert!(run.out.contains(command), "{shell}: {command}");
            for option in options(command) {
                assert!(run.out.contains(&option), "{shell}: {command} --{option}");
            }
        }
    }
    let run = onering(["completions", "ksh"]);
    assert_eq!(run.code, Some(2));
    assert!(run.err.contains("bash") && run.err.contains("zsh"), "{run:?}");
}

/// As roff has it: every `-` that is one has a backslash.
fn in_roff(option: &str) -> String {
    format!("\\-\\-{}", option.replace('-', "\\-"))
}

#[test]
fn manual_pages_have_every_option() {
    let all = onering(["man"]);
    assert_eq!((all.code, all.err.as_str()), (Some(0), ""));
    let folder = fresh("manual", "none", "").with_file_name("pages");
    let run = onering(["man", "--out", folder.to_str().unwrap()]);
    assert_eq!((run.code, run.out.as_str(), run.err.as_str()), (Some(0), "", ""));
    let page = |name: &str| fs::read_to_string(folder.join(name)).unwrap();
    assert_eq!(fs::read_dir(&folder).unwrap().count(), COMMANDS.len() + 1);
    let mut pages = vec![("onering.1".to_owned(), page("onering.1"))];
    for command in COMMANDS {
        let name = format!("onering-{command}.1");
        let text = page(&name);
        for option in options(command) {
            assert!(text.contains(&in_roff(&option)), "{name}: {option}");
        }
        pages.push((name, text));
    }
    for (name, text) in &pages {
        let title = format!(".TH {} 1", name.trim_end_matches(".1"));
        assert!(text.lines().any(|line| line.starts_with(&title)), "{name}: {text}");
        for section in [".SH NAME", ".SH SYNOPSIS", ".SH OPTIONS"] {
            assert!(text.lines().any(|line| line == section), "{name}: {section}");
        }
        assert!(all.out.contains(text), "{name}");
    }
}

#[test]
fn a_folder_that_cannot_be_made_is_said() {
    let file = fresh("no_folder", "file", "");
    let folder = file.join("pages");
    let run = onering(["man", "--out", folder.to_str().unwrap()]);
    assert_eq!((run.code, run.err.lines().count()), (Some(1), 1), "{run:?}");
    assert!(run.err.starts_with(&format!("onering: {}: ", folder.display())), "{run:?}");
}

#[test]
fn help_lists_every_format() {
    for command in ["inspect", "convert", "compare", "recommend"] {
        let help = onering([command, "--help"]).out;
        for extension in Format::all().flat_map(Format::extensions) {
            assert!(help.contains(&format!(".{extension}")), "{command}: {extension}");
        }
    }
}
