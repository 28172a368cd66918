//! X3D as XML: documents as a whole, names, references and what is refused.

use onering_io::{Error, Format, Place, Reason, Skipped, Triangles, read, x3d};

const FACE: &str = "<Shape><IndexedFaceSet coordIndex='0 1 2'><Coordinate point='0 0 0 1 0 0 0 1 0'/></IndexedFaceSet></Shape>";

fn parse(text: &str) -> Triangles {
    x3d::read(text.as_bytes()).unwrap_or_else(|error| panic!("{error} in {text}"))
}

fn scene(content: &str) -> String {
    format!("<X3D><Scene>{content}</Scene></X3D>")
}

fn refusal(text: &str) -> (Place, Reason) {
    match x3d::read(text.as_bytes()) {
        Err(Error::Malformed { place, reason, .. }) => (place, reason),
        other => panic!("{other:?} for {text}"),
    }
}

/// The line for which a text is refused as bad XML, and why.
fn bad_xml(text: &str) -> (usize, String) {
    match refusal(text) {
        (Place::Line(line), Reason::Xml { message }) => (line, message),
        other => panic!("{other:?} for {text}"),
    }
}

fn unsupported(bytes: &[u8]) -> String {
    match x3d::read(bytes) {
        Err(error @ Error::Unsupported { .. }) => error.to_string(),
        other => panic!("{other:?}"),
    }
}

#[test]
fn documents_begin_in_many_ways() {
    let body = scene(FACE);
    for start in [
        "",
        "\n ",
        "\u{FEFF}",
        "<?xml version='1.0'?>",
        "\u{FEFF}<?xml version=\"1.0\" encoding=\"utf-8\"?>\n",
        "<?xml version='1.0' encoding='US-ASCII' standalone='no'?><!-- <a> -->",
        "<!DOCTYPE X3D PUBLIC \"ISO//Web3D//DTD X3D 3.0//EN\" \"http://nowhere.invalid/x3d.dtd\">",
        "<!DOCTYPE X3D SYSTEM '/etc/passwd' [ <!ATTLIST X3D a CDATA #IMPLIED> ]>",
        "<?a b?>",
    ] {
        let text = format!("{start}{body}\n<!-- end -->\n");
        assert_eq!(parse(&text).faces, [[0, 1, 2]], "{text}");
        assert_eq!(read(text.as_bytes()).unwrap().faces.len(), 1, "{text}");
    }
    assert_eq!(parse(&body.replace('<', "<x:").replace("<x:/", "</x:")).faces.len(), 1);
}

#[test]
fn only_one_root_and_only_x3d() {
    for text in ["", " ", "<html><body/></html>", "<!-- X3D -->", "<x3d/>"] {
        assert!(matches!(refusal(text).1, Reason::NotThisFormat { .. }), "{text}");
    }
    let html = b"<!DOCTYPE html><html></html>";
    assert!(matches!(read(html), Err(Error::Malformed { format: Format::X3d, .. })));
    assert_eq!(bad_xml("<X3D/>\n<X3D/>"), (2, "there is more than one root element".into()));
    for text in ["<X3D/>\ntext", "<X3D/>\n&amp;", "<X3D/>\n<![CDATA[]]>", "text<X3D/>"] {
        assert_eq!(bad_xml(text).1, "there is text outside the root element");
    }
    assert_eq!(parse("<X3D/>"), Triangles::default());
}

#[test]
fn broken_xml_is_told_with_its_line() {
    for (text, line, part) in [
        ("<X3D>\n<Scene>\n</X3D>", 3, "Scene"),
        ("<X3D>\n<Scene a='\n\n'>\n\n", 2, "`<Scene>` is never closed"),
        ("<X3D>\n<Scene", 2, ""),
        ("<X3D>\n<Scene a='", 2, ""),
        ("<X3D/>\n</X3D>", 2, "X3D"),
        ("<X3D>\n<!-- ", 2, ""),
        ("<X3D>\n<Scene a=b/></X3D>", 2, ""),
        ("<X3D>\n<Scene a/></X3D>", 2, ""),
        ("<X3D>\n<Scene a='1'\na='2'/></X3D>", 3, "duplicate"),
        ("<X3D>\n<Scene a='\n<Shape b='/></X3D>", 3, "`<` in the value of an attribute"),
        ("<X3D>\n<Scene a='1\n&no;'/></X3D>", 3, "`&no;` is no entity of XML's own"),
        ("<X3D>\n<Scene a='&amp'/></X3D>", 2, "`&amp` has no `;`"),
        ("<X3D>\n<Scene a='&#xD800;'/></X3D>", 2, "`&#xD800;` is no character"),
        ("<X3D>\n&no;</X3D>", 2, "`&no;` is no entity of XML's own"),
    ] {
        let (found, message) = bad_xml(text);
        assert!(found == line && message.contains(part), "line {found}: {message} for {text}");
    }
    let long = format!("<X3D></{}>", "x\u{1b}".repeat(10_000));
    assert!(bad_xml(&long).1.len() < 100 && !bad_xml(&long).1.contains('\u{1b}'));
}

#[test]
fn entities_are_not_declared() {
    let bomb = "<!DOCTYPE X3D [\n<!ENTITY a '0 0 0 '>\n]>\n<X3D/>";
    assert!(unsupported(bomb.as_bytes()).contains("line 1: needs entities of its own"));
}

#[test]
fn other_encodings_are_refused() {
    let latin = b"<?xml version='1.0' encoding='ISO-8859-1'?><X3D/>";
    assert!(unsupported(latin).contains("needs the encoding ISO-8859-1"));
    let wide: Vec<u8> = "<X3D/>".encode_utf16().flat_map(u16::to_le_bytes).collect();
    assert!(unsupported(&wide).contains("UTF-16"));
    assert!(unsupported(&[b"\xFF\xFE", &wide[..]].concat()).contains("UTF-16"));
    let bad = x3d::read(b"<X3D>\n<!-- \xE4 --></X3D>").unwrap_err().to_string();
    assert_eq!(bad, "X3D line 2: bad XML: it is not UTF-8");
}

#[test]
fn character_references_are_resolved() {
    let text = scene(
        "<IndexedFaceSet coordIndex='0&#x20;1&#44;2&#10;&#45;1 2 1 0'>\
         <Coordinate DEF='a&amp;b' point='0 0 0&#10;1 0 0 0 &#49; 0'/></IndexedFaceSet>\
         <TriangleSet><Coordinate USE='&#97;&#38;b'/></TriangleSet>",
    );
    let mesh = parse(&text);
    assert_eq!(mesh.positions[1..3], [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    assert_eq!(mesh.faces, [[0, 1, 2], [2, 1, 0], [3, 4, 5]]);
    let bad = scene("\n<TriangleSet>\n<Coordinate point='0&#32;\n\nx'/></TriangleSet>");
    assert_eq!(refusal(&bad), (Place::Line(3), Reason::BadNumber { word: "x".into() }));
}

#[test]
fn names_may_be_defined_later_and_the_last_one_holds() {
    let set = |coordinates: &str| format!("<TriangleSet>{coordinates}</TriangleSet>");
    let at = |name: &str, x: i32| format!("<Coordinate DEF='{name}' point='{x} 0 0'/>");
    let text = scene(&[set("<Coordinate USE='a'/>"), set(&at("a", 1)), at("a", 2)].concat());
    assert_eq!(parse(&text).positions, [[2.0, 0.0, 0.0], [1.0, 0.0, 0.0]]);
    let double = scene(&set("<CoordinateDouble point='4 0 0'/><Coordinate point='5 0 0'/>"));
    assert_eq!(parse(&double).positions, [[4.0, 0.0, 0.0]]);
    let other = scene(&format!("<Group DEF='g'/>{}", set("<Coordinate USE='g'/>")));
    assert_eq!(refusal(&other).1, Reason::UnknownName { name: "g".into() });
}

#[test]
fn whole_nodes_are_not_repeated() {
    let text = scene(&format!(
        "{}<Shape USE='s'/><Shape><IndexedFaceSet USE='f'/><Box USE='b'/></Shape>",
        FACE.replace("<IndexedFaceSet", "<IndexedFaceSet DEF='f'").replace("<Shape>", "<Shape DEF='s'>")
    ));
    let mesh = parse(&text);
    assert_eq!((mesh.positions.len(), mesh.faces.len()), (3, 1));
    let [note] = &mesh.notes[..] else { panic!("{:?}", mesh.notes) };
    assert_eq!(note.to_string(), "3 elements of kind `USE` skipped, the first at line 1");
    let other = "<Shape><Appearance USE='a'><Material USE='m'/></Appearance></Shape><Viewpoint USE='v'/>";
    assert_eq!(parse(&scene(other)), Triangles::default());
}

#[test]
fn what_stands_elsewhere_is_noted() {
    let text = "\n<Inline url='a.x3d'/>\n<ProtoInstance name='p'/><Group><Inline url='b.x3d'/></Group>";
    let notes = parse(&scene(text)).notes;
    let notes: Vec<String> = notes.iter().map(ToString::to_string).collect();
    let expected = [
        "2 elements of kind `Inline` skipped, the first at line 2",
        "1 element of kind `ProtoInstance` skipped, the first at line 3",
    ];
    assert_eq!(notes, expected);
}

#[test]
fn prototypes_are_passed_over() {
    let proto = format!(
        "<ProtoDeclare name='p'><ProtoBody>{FACE}<Box/><ProtoDeclare/></ProtoBody></ProtoDeclare><ExternProtoDeclare/>"
    );
    let mesh = parse(&scene(&format!("{proto}<Group>{FACE}</Group>")));
    assert_eq!((mesh.faces.len(), mesh.notes.len()), (1, 0));
}

#[test]
fn what_is_left_out_is_noted() {
    let text = scene(
        "\n<Shape><Box/></Shape>\n<Text string='\"a\"'/><Box/>\n<IndexedFaceSet coordIndex='0 1 2'/>\n\
         <TriangleSet ccw=' FALSE'><Group><Coordinate point='9 9 9'/></Group><Coordinate point='0 0 0 1 1 1 2 2 2'/></TriangleSet>",
    );
    let mesh = parse(&text);
    let notes: Vec<_> = mesh.notes.iter().map(|note| (note.what.clone(), note.count, note.first)).collect();
    let expected = [
        (Skipped::Elements("Box".into()), 2, Place::Line(2)),
        (Skipped::Elements("Text".into()), 1, Place::Line(3)),
        (Skipped::NoPositions, 1, Place::Line(4)),
        (Skipped::Clockwise, 1, Place::Line(5)),
    ];
    assert_eq!(notes, expected);
    let text = mesh.notes[3].to_string();
    assert_eq!(text, "1 field `ccw FALSE` (winding is as listed) skipped, the first at line 5");
    assert_eq!(mesh.faces, [[0, 1, 2]]);
}

#[test]
fn depth_does_not_exhaust_the_stack() {
    let deep = |depth: usize| scene(&format!("{}{FACE}{}", "<a>".repeat(depth), "</a>".repeat(depth)));
    // Around them are X3D and Scene, and the face lies in two more.
    assert_eq!(parse(&deep(9_995)).faces.len(), 1);
    for depth in [9_996, 100_000, 1_000_000] {
        let error = unsupported(deep(depth).as_bytes());
        assert!(error.contains("more than 10000 nodes within one another"), "{depth}: {error}");
    }
}

/// Many attributes, many notes and many names cost no more than their length.
#[test]
fn crafted_documents_are_linear() {
    let attributes: String = (0..200_000).map(|i| format!(" a{i}=''")).collect();
    assert_eq!(parse(&scene(&format!("<Group{attributes}/>"))), Triangles::default());
    let notes = parse(&scene(
        &"<IndexedFaceSet coordIndex='0 0'><Coordinate point='0 0 0'/></IndexedFaceSet>\n".repeat(50_000),
    ));
    assert_eq!(notes.notes[0].count, 50_000);
    let references = "&#48; ".repeat(300_000);
    let mesh = parse(&scene(&format!("<TriangleSet><Coordinate point='{references}'/></TriangleSet>")));
    assert_eq!(mesh.positions.len(), 100_000);
}

#[test]
fn no_beginning_of_a_document_is_read_as_a_whole_one() {
    let text = format!(
        "<?xml version='1.0'?>\n<!DOCTYPE X3D><X3D><!-- c --><Scene>{FACE}</Scene><![CDATA[a]]></X3D>"
    );
    for end in 0..text.len() {
        assert!(x3d::read(&text.as_bytes()[..end]).is_err(), "{}", &text[..end]);
    }
    assert_eq!(parse(&text).faces.len(), 1);
}
