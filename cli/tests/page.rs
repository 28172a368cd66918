//! `onering compare --html`: what is on the page, and that nothing else is needed to read it.

mod common;

use common::{FAN, SQUARE, fresh, onering, renumbering};
use onering::registry::BACKENDS;
use quick_xml::Reader;
use quick_xml::events::Event;
use serde_json::Value;
use std::path::{Path, PathBuf};

/// An octahedron, with a name that has to be escaped.
const OCTAHEDRON: &str = "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n\
    f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n";

fn write(page: &Path, files: &[&Path], more: &[&str]) -> common::Run {
    let mut args = vec!["compare".as_ref(), "--budget=0".as_ref(), "--html".as_ref(), page.as_os_str()];
    args.extend(files.iter().map(|file| file.as_os_str()));
    args.extend(more.iter().map(AsRef::<std::ffi::OsStr>::as_ref));
    onering(args)
}

fn page(test: &str, files: &[(&str, &str)], more: &[&str]) -> String {
    let page = fresh(test, "page.html", "old");
    let files: Vec<PathBuf> = files
        .iter()
        .map(|(name, text)| {
            let path = page.with_file_name(name);
            std::fs::write(&path, text).unwrap();
            path
        })
        .collect();
    let run = write(&page, &files.iter().map(PathBuf::as_path).collect::<Vec<_>>(), more);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    std::fs::read_to_string(page).unwrap()
}

/// The names of all elements, in their order; every one is closed by its own end.
fn elements(page: &str) -> Vec<String> {
    let mut reader = Reader::from_str(page);
    // Elements of HTML that have no end.
    reader.config_mut().check_end_names = false;
    let (mut all, mut open) = (Vec::new(), Vec::new());
    loop {
        match reader.read_event().unwrap_or_else(|error| panic!("{error} at {}", reader.error_position())) {
            Event::Start(start) => {
                start.attributes().for_each(|attribute| drop(attribute.unwrap()));
                let name = start.name().as_ref().to_owned();
                all.push(name.clone());
                if name != "meta" {
                    open.push(name);
                }
            }
            Event::Empty(start) => {
                start.attributes().for_each(|attribute| drop(attribute.unwrap()));
                all.push(start.name().as_ref().to_owned());
            }
            Event::End(end) => assert_eq!(open.pop(), Some(end.name().as_ref().to_owned())),
            Event::Eof => break,
            _ => {}
        }
    }
    assert!(open.is_empty(), "{open:?}");
    all
}

fn count(page: &str, what: &str) -> usize {
    page.matches(what).count()
}

#[test]
fn the_page_needs_nothing_but_itself() {
    let page = page("alone", &[("a & <b>.obj", OCTAHEDRON)], &[]);
    let addresses = page.replace("xmlns=\"http://www.w3.org/2000/svg\"", "");
    for word in ["http:", "https:", "<script", "<link", "<img", "src=", "@import", "url("] {
        assert!(!addresses.contains(word), "{word}");
    }
    assert!(page.starts_with("<!DOCTYPE html><html lang=\"en\">"));
    assert!(page.contains("name=\"viewport\""));
    assert!(page.contains("a &amp; &lt;b&gt;.obj") && !page.contains("<b>"));
    for word in ["prefers-color-scheme:dark", "@media print", env!("CARGO_PKG_VERSION"), " UTC", "seed 2016"]
    {
        assert!(page.contains(word), "{word}");
    }
    assert!(page.contains("<code>onering compare --budget=0 --html "), "{page}");
    // No colour but those of the style sheet.
    let body = page.split_once("</style>").unwrap().1;
    for word in ["fill=\"#", "stroke=\"#", "style=\""] {
        assert!(!body.contains(word), "{word}");
    }
}

#[test]
fn each_mesh_has_its_plots_each_with_names_and_a_table() {
    let page = page("plots", &[("one.obj", OCTAHEDRON), ("two.obj", SQUARE)], &[]);
    let all = elements(&page);
    let found = |name: &str| all.iter().filter(|element| *element == name).count();
    // Four of each mesh, and two against size; random queries have a table alone.
    assert_eq!((found("svg"), found("desc"), found("figcaption"), found("table")), (10, 10, 10, 12));
    for plot in ["memory", "build", "rings", "orders"] {
        for mesh in 0..2 {
            let id = format!("mesh-{mesh}-{plot}");
            assert!(page.contains(&format!("aria-labelledby=\"{id}-title {id}-desc\"")), "{id}");
            assert_eq!(count(&page, &format!("<title id=\"{id}-title\"")), 1, "{id}");
        }
    }
    for id in ["growth-build", "growth-rings"] {
        assert_eq!(count(&page, &format!("<desc id=\"{id}-desc\"")), 1, "{id}");
    }
    assert!(page.contains("On the line, filled: "));
    // In each plot of rings of each mesh, against size, and in the tables.
    let entries = BACKENDS.iter().map(|entry| (entry.name, entry.traits));
    for (name, traits) in entries.chain(renumbering()) {
        let in_tables = count(&page, &format!("<th scope=\"row\">{name}</th>"));
        assert!(in_tables >= 8, "{name}: {in_tables}");
        if traits.contains(&"incidence") {
            let in_plots = count(&page, &format!(">\n{name}\n</text>"));
            assert_eq!(in_plots, 10, "{name}");
        }
    }
}

#[test]
fn sizes_grow_and_are_in_the_json_too() {
    let html = fresh("growth", "page.html", "");
    let json = html.with_file_name("all.json");
    let run = write(&html, &[], &["--json", json.to_str().unwrap(), "--backend", "che-l2", "shared-vertex"]);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    let result: Value = serde_json::from_str(&std::fs::read_to_string(json).unwrap()).unwrap();
    assert_eq!(result["growth"]["triangles"], serde_json::json!([320, 1280]));
    let names: Vec<&Value> =
        result["growth"]["backends"].as_array().unwrap().iter().map(|grown| &grown["name"]).collect();
    assert_eq!(names, ["shared-vertex", "che-l2"]);
    for (i, rings) in [(0, false), (1, true)] {
        let points = result["growth"]["backends"][i]["points"].as_array().unwrap();
        assert_eq!(points.len(), 2);
        assert!(
            points.iter().all(|point| point["build"]["runs"] == 1 && point["sweep"].is_object() == rings)
        );
    }
    assert!(result["command"].as_str().unwrap().starts_with("onering compare --budget=0 --html "));
    let date = result["date"].as_str().unwrap();
    assert!(date.starts_with("20") && date.ends_with(" UTC") && date.len() == 20, "{date}");
}

#[test]
fn defects_files_without_faces_and_unread_ones_are_on_the_page() {
    let target = fresh("defects", "page.html", "old");
    let [fan, points, missing] =
        ["fan.obj", "points.obj", "missing.obj"].map(|name| target.with_file_name(name));
    std::fs::write(&fan, FAN).unwrap();
    std::fs::write(&points, "v 0 0 0\n").unwrap();
    let run = write(&target, &[&fan, &points, &missing], &[]);
    assert_eq!((run.code, run.err.lines().count()), (Some(1), 1), "{run:?}");
    let page = std::fs::read_to_string(target).unwrap();
    elements(&page);
    for words in [
        "1 non-manifold edge",
        "1 edge cut",
        "nothing to measure on",
        "missing.obj",
        "che-l2, repaired: 3 faces",
    ] {
        assert!(page.contains(words), "{words}");
    }
}

#[cfg(unix)]
#[test]
fn what_a_name_would_do_to_a_terminal_is_on_no_page_either() {
    let target = fresh("control", "page.html", "old");
    let [square, points] =
        ["square", "points"].map(|name| target.with_file_name(format!("{name}\u{1B}[31m\u{202E}\n.obj")));
    std::fs::write(&square, SQUARE).unwrap();
    std::fs::write(&points, "v 0 0 0\n").unwrap();
    let run = write(&target, &[&square, &points, &square.with_file_name("\u{1B}.obj")], &[]);
    assert_eq!((run.code, run.err.lines().count()), (Some(1), 1), "{run:?}");
    let page = std::fs::read_to_string(target).unwrap();
    for text in [&page, &run.out, &run.err] {
        assert!(!text.contains(['\u{1B}', '\u{202E}']), "{text:?}");
    }
    for name in ["square\u{FFFD}[31m\u{FFFD}\u{FFFD}.obj", "points\u{FFFD}[31m\u{FFFD}\u{FFFD}.obj"] {
        assert!(page.contains(&format!("{name}</h2>")) && run.out.contains(&format!("{name}: ")), "{run:?}");
    }
}

#[test]
fn the_page_never_takes_the_place_of_a_mesh() {
    let mesh = fresh("precious", "square.mesh", SQUARE);
    for target in [mesh.clone(), mesh.with_file_name("new.obj"), mesh.with_file_name("none").join("x.html")] {
        let run = write(&target, &[&mesh], &[]);
        assert_eq!((run.code, run.out.as_str(), run.err.lines().count()), (Some(2), "", 1), "{run:?}");
    }
    let same = mesh.with_file_name("same");
    let run = write(&same, &[&mesh], &["--json", same.to_str().unwrap()]);
    assert_eq!((run.code, run.out.as_str()), (Some(2), ""), "{run:?}");
    for (html, json) in [("./same", "same"), ("../precious/same", "same")] {
        let [html, json] = [html, json].map(|name| mesh.parent().unwrap().join(name));
        let run = write(&html, &[&mesh], &["--json", json.to_str().unwrap()]);
        assert_eq!((run.code, run.out.as_str(), run.err.lines().count()), (Some(2), "", 1), "{run:?}");
    }
    assert_eq!(std::fs::read_to_string(&mesh).unwrap(), SQUARE);
    assert_eq!(std::fs::read_dir(mesh.parent().unwrap()).unwrap().count(), 1, "something was left behind");
    assert_eq!(onering(["compare", "--deform", "--html", "x.html"]).code, Some(2));
}
