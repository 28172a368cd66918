//! VRML97 and X3D in the classic encoding: headers, brackets, names and what is passed over.

use onering_io::{Error, Format, Place, Reason, Skipped, Triangles, read, vrml};

const FACE: &str = "Shape { geometry IndexedFaceSet { coord Coordinate { point [0 0 0, 1 0 0, 0 1 0] } coordIndex [0 1 2] } }";

fn parse(body: &str) -> Triangles {
    vrml::read(file(body).as_bytes()).unwrap_or_else(|error| panic!("{error} in {body}"))
}

fn file(body: &str) -> String {
    format!("#VRML V2.0 utf8\n{body}")
}

fn refusal(body: &str) -> (Place, Reason) {
    match vrml::read(file(body).as_bytes()) {
        Err(Error::Malformed { place, reason, .. }) => (place, reason),
        other => panic!("{other:?} for {body}"),
    }
}

#[test]
fn headers_tell_the_version() {
    for header in [
        "#VRML V2.0 utf8",
        "\u{FEFF}#VRML V2.0 utf8 a comment",
        "#X3D V3.0 utf8\nPROFILE Immersive",
        "#X3D V4.0 utf8",
    ] {
        let text = format!("{header}\n{FACE}");
        assert_eq!(read(text.as_bytes()).unwrap().faces, [[0, 1, 2]], "{header}");
        assert_eq!(Format::of_content(text.as_bytes()), Some(Format::Vrml));
    }
    let old = read(b"#VRML V1.0 ascii\nSeparator {}").unwrap_err();
    assert_eq!(old.to_string(), "VRML line 1: needs VRML 1.0, which is not supported");
    for text in ["", FACE, "#VRML V3.0 utf8\n", "# VRML V2.0 utf8"] {
        let error = vrml::read(text.as_bytes()).unwrap_err();
        assert!(matches!(error, Error::Malformed { reason: Reason::NotThisFormat { .. }, .. }), "{error}");
    }
    assert_eq!(Format::of_content(b"# made by hand\nv 0 0 0\n"), Some(Format::Obj));
}

#[test]
fn blanks_and_comments_may_be_anywhere_or_nowhere() {
    for body in [
        "Shape{geometry IndexedFaceSet{coordIndex[0 1 2]coord Coordinate{point[0 0 0 1 0 0 0 1 0]}}}",
        "IndexedFaceSet\r{,coord#{[\"\rDEF a#}\n Coordinate # c\n{point # c\n[0 0 0 # 9 9 ]\n1,0,0,0 1 0#\n]} coordIndex\n,[0,1#,3\n2]}",
        "Group { children [ Shape { geometry DEF g IndexedFaceSet { coord Coordinate { point [0 0 0 1 0 0 0 1 0] }\n\
         solid FALSE creaseAngle 0.5 coordIndex [0 1 2 -1] texCoordIndex [ 7 7 7 ] ccw TRUE } } ] }",
        "WorldInfo { title \"}]{[ # \\\" \" info [ \"]\" \"}\" ] }IndexedFaceSet{coord Coordinate{point[0 0 0 1 0 0 0 1 0]}coordIndex[0 1 2]}",
    ] {
        let mesh = parse(body);
        assert_eq!((mesh.faces, mesh.positions.len()), (vec![[0, 1, 2]], 3), "{body}");
    }
}

#[test]
fn a_single_value_needs_no_brackets() {
    let mesh = parse("IndexedFaceSet { coord Coordinate { point 1 2 3 } coordIndex 0 solid TRUE }");
    assert_eq!((mesh.positions, mesh.notes[0].count), (vec![[1.0, 2.0, 3.0]], 1));
}

#[test]
fn what_is_no_geometry_may_hold_anything() {
    let body = format!(
        "PROTO p [ field SFNode a NULL exposedField MFNode b [ Box {{ }} ] ] {{ {FACE} Box {{ }} }}\n\
         EXTERNPROTO q [ eventIn SFBool set_on ] [ \"q.wrl#]\" \"urn:x\" ]\nEXTERNPROTO r [ ] \"r.wrl\"\n\
         DEF s Script {{ url \"javascript: function f() {{ a[0] = '{{'; }}\" field SFNode n USE s directOutput TRUE\n\
           field MFFloat x [ 1 2 3 ] field MFNode y [ USE s Group {{ }} ] }}\n\
         p {{ a IS b }} Teapot {{ point [ 1 2 ] coordIndex [ x ] lid Lid {{ }} }}\n\
         Group {{ PROTO t [] {{ Sphere {{ }} }} children [ {FACE} ] }}\n\
         ROUTE s.a TO t.b\nROUTE s.a_changed TO t.set_b"
    );
    let mesh = parse(&body);
    let [note] = &mesh.notes[..] else { panic!("{:?}", mesh.notes) };
    assert_eq!(mesh.faces, [[0, 1, 2]]);
    // The node of type p.
    assert_eq!(note.to_string(), "1 element of kind `ProtoInstance` skipped, the first at line 7");
}

#[test]
fn what_stands_elsewhere_is_noted() {
    let body = "EXTERNPROTO q [ ] \"q.wrl\"\nq { }\nInline { url \"a.wrl\" } Group { children [ q { } Inline { } ] }";
    let notes: Vec<String> = parse(body).notes.iter().map(ToString::to_string).collect();
    let expected = [
        "2 elements of kind `ProtoInstance` skipped, the first at line 3",
        "2 elements of kind `Inline` skipped, the first at line 4",
    ];
    assert_eq!(notes, expected);
}

#[test]
fn a_name_is_that_of_the_last_definition_before() {
    let set = |coordinates: &str| format!("TriangleSet {{ coord {coordinates} }}\n");
    let at = |x: i32| format!("DEF a Coordinate {{ point [{x} 0 0] }}");
    let body = [set(&at(1)), set("USE a"), set(&at(2)), set("USE a")].concat();
    assert_eq!(parse(&body).positions.map_x(), [1.0, 1.0, 2.0, 2.0]);
    let early = [set("USE a"), set(&at(1))].concat();
    assert_eq!(refusal(&early), (Place::Line(2), Reason::UnknownName { name: "a".into() }));
    let other = format!("DEF a Group {{ }}\n{}", set("USE a"));
    assert_eq!(refusal(&other).1, Reason::UnknownName { name: "a".into() });
    // Names of what is no coordinates are not looked up.
    assert_eq!(parse("Shape { geometry USE a appearance USE b } USE c").faces.len(), 0);
}

trait FirstCoordinates {
    fn map_x(&self) -> Vec<f32>;
}

impl FirstCoordinates for Vec<[f32; 3]> {
    fn map_x(&self) -> Vec<f32> {
        self.iter().map(|[x, ..]| *x).collect()
    }
}

#[test]
fn whole_nodes_are_not_repeated() {
    let face = FACE.replace("Indexed", "DEF f Indexed").replace("Shape", "DEF s Shape");
    let mesh = parse(&format!("{face}\nShape {{ appearance USE a geometry USE f }} USE s"));
    let [note] = &mesh.notes[..] else { panic!("{:?}", mesh.notes) };
    assert_eq!(mesh.faces.len(), 1);
    assert_eq!(note.to_string(), "2 elements of kind `USE` skipped, the first at line 3");
    let renamed = "DEF s Shape { } DEF s Viewpoint { } USE s DEF a Appearance { } USE a";
    assert_eq!(parse(renamed), Triangles::default());
}

#[test]
fn what_is_left_out_is_noted() {
    let mesh = parse(
        "Shape { geometry Box { size 1 1 1 } }\nShape { geometry Text { string \"a\" } } Box { }\n\
         IndexedFaceSet { coordIndex [ 0 1 2 ] coord NULL }\nTriangleSet { ccw FALSE coord Coordinate { point [0 0 0 1 1 1 2 2 2] } }\n\
         IndexedFaceSet { coord GeoCoordinate { point [ 0 0 0 ] } }",
    );
    let notes: Vec<_> = mesh.notes.iter().map(|note| (note.what.clone(), note.count, note.first)).collect();
    let expected = [
        (Skipped::Elements("Box".into()), 2, Place::Line(2)),
        (Skipped::Elements("Text".into()), 1, Place::Line(3)),
        (Skipped::NoPositions, 2, Place::Line(4)),
        (Skipped::Clockwise, 1, Place::Line(5)),
    ];
    assert_eq!((notes.as_slice(), mesh.faces), (&expected[..], vec![[0, 1, 2]]));
}

#[test]
fn brackets_and_quotation_marks_match() {
    for (body, line, mark) in [
        ("Group {\n", 2, '{'),
        ("Group { children [\n", 2, '['),
        ("Group {\n children [ }", 3, '}'),
        ("\nGroup { ] }", 3, ']'),
        ("\n}", 3, '}'),
        ("Group { }\n ]", 3, ']'),
        ("WorldInfo {\n title \"a\n }", 3, '"'),
        ("WorldInfo {\n info [ 1 \" ]", 3, '"'),
        ("Coordinate {\n point [\n 0 0 }", 3, '['),
        ("PROTO p [\n ] {\n", 3, '{'),
        ("PROTO p [\n { ", 2, '['),
    ] {
        assert_eq!(refusal(body), (Place::Line(line), Reason::Unbalanced { mark }), "{body}");
    }
}

#[test]
fn errors_tell_the_line_of_the_word() {
    let body =
        "IndexedFaceSet { coord Coordinate { point [ 0 0 0\n# 1 2\n1 0 0 0 1 0 ] }\ncoordIndex [ 0\n1\n3 ] }";
    let expected = Reason::IndexOutOfRange { index: "3".into(), vertices: 3 };
    assert_eq!(refusal(body), (Place::Line(7), expected));
    let body = "Coordinate { point [ x ] }\nTriangleSet { coord Coordinate { point [\n0 0 { ] } }";
    assert_eq!(refusal(body), (Place::Line(4), Reason::BadNumber { word: "{".into() }));
}

#[test]
fn depth_does_not_exhaust_the_stack() {
    let deep = |depth: usize| format!("{}{FACE}{}", "a{b[".repeat(depth), "]}".repeat(depth));
    // Two levels each, and the face lies in three more.
    assert_eq!(parse(&deep(4_998)).faces.len(), 1);
    for depth in [4_999, 100_000, 500_000] {
        let error = vrml::read(file(&deep(depth)).as_bytes()).unwrap_err();
        assert!(matches!(error, Error::Unsupported { place: Place::Line(2), .. }), "{error}");
    }
    assert_eq!(parse(&format!("PROTO p [] {{ {} }}", deep(600_000))), Triangles::default());
}

#[test]
fn crafted_files_are_linear() {
    let notes =
        parse(&"Box{}\nIndexedFaceSet{coord Coordinate{point[0 0 0]}coordIndex[0 0]}\n".repeat(50_000));
    assert_eq!(notes.notes.iter().map(|note| note.count).collect::<Vec<_>>(), [50_000, 50_000]);
    // Kinds of notes are few, however many names the file makes up.
    let kinds: String =
        (0..50_000).map(|i| format!("PROTO p{i} [] {{}} p{i} {{}} DEF s{i} Shape {{}} USE s{i}\n")).collect();
    let notes = parse(&kinds).notes;
    assert_eq!(notes.iter().map(|note| note.count).collect::<Vec<_>>(), [50_000, 50_000]);
    let names: String = (0..100_000).map(|i| format!("DEF n{i} Coordinate{{}}\n")).collect();
    assert_eq!(parse(&names), Triangles::default());
}

#[test]
fn no_beginning_of_a_file_is_read_as_a_whole_face() {
    let text = file(&format!("WorldInfo {{ title \"a\" }} # c\n{FACE}"));
    for end in 0..text.len() {
        let result = vrml::read(&text.as_bytes()[..end]);
        assert!(result.is_err() || result.is_ok_and(|mesh| mesh.faces.is_empty()), "{}", &text[..end]);
    }
}
