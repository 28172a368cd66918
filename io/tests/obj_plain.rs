//! Plain lines are read in a way of their own: it gives what the words of the lines give.

use onering_io::{Triangles, obj};
use proptest::prelude::*;

fn read(text: &str) -> Result<Triangles, String> {
    obj::read(text.as_bytes()).map_err(|error| error.to_string())
}

/// NaN is not equal to itself, so positions are compared as bits.
fn bits(mesh: &Triangles) -> Vec<[u32; 3]> {
    mesh.positions.iter().map(|position| position.map(f32::to_bits)).collect()
}

/// A tab behind the keyword makes a line unusual enough to be read word by word.
fn check(text: &str) {
    let unusual: String = text.split_inclusive('\n').map(|line| line.replacen(' ', "\t", 1)).collect();
    match (read(text), read(&unusual)) {
        (Ok(plain), Ok(words)) => {
            assert_eq!(bits(&plain), bits(&words), "{text:?}");
            assert_eq!((plain.faces, plain.polygon_sizes), (words.faces, words.polygon_sizes), "{text:?}");
            assert_eq!((plain.polygon_starts, plain.notes), (words.polygon_starts, words.notes), "{text:?}");
        }
        (plain, words) => assert_eq!(plain.map(|_| ()), words.map(|_| ()), "{text:?}"),
    }
}

#[test]
fn lines_on_the_verge_of_being_plain() {
    let corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
    for line in [
        "v 0.1234567 -0.12345678 +0.123456789",
        "v 0.1234567890123456 1234567890123456.5 12345678901234567890.5",
        "v 0.000000000000000000000000000001 00000000000000000000000001 1.00000017881393432617187500",
        "v 1. .5 -.25",
        "v . 1 2",
        "v 1 2 -",
        "v 1e3 2E-1 3",
        "v 1.5e3 2 3",
        "v nan inf 1",
        "v 1 2 3 4 5 6",
        "v  1  2\t3 ",
        "v 1 2",
        "v 1 2 3\\",
        "v 1 2 3 \\",
        "v 1 2 \\",
        "v 1 2 3#4",
        "v 1 2 3 #4",
        "v 1 2 3x",
        "v 9007199254740993 9007199254740992 4294967296.0000001",
        "f 1 2 3 ",
        "f 1/1/1 2//2 3/",
        "f 1/-1 2/+2 3/3/3/3 ",
        "f 1/a 2 3",
        "f 1/1.0 2 3",
        "f 1/1,0 2 3",
        "f 1 2 3 1 2 3 1 2",
        "f 1 2 3 1 2 3 1 2 3",
        "f -1 -2 -3",
        "f -1 -2 -4",
        "f -0 1 2",
        "f 0 1 2",
        "f 1 2",
        "f 1 2 00000000000000000000003",
        "f 1 2 000000003",
        "f 1 2 4294967295",
        "f 1 2 4294967296",
        "f 1 2 4294967297",
        "f 1 2 18446744073709551617",
        "f 1 2 -18446744073709551617",
        "f 1 2 3 #4",
        "f 1 2 3#4",
        "f 1 2 \\",
        "f 1 2 3\\",
        "f 1 2 3 \\",
        "vn 1 2 \\",
        "vt 1",
    ] {
        for end in ["\n", "\r\n", "\r", " \n", ""] {
            check(&format!("{corners}{line}{end}"));
            check(&format!("{corners}{line}{end}f 1 2 3\nv 7 8 9\nl 1\n# {}\n", "-".repeat(16)));
        }
    }
}

proptest! {
    #[test]
    fn plain_lines_give_what_their_words_give(
        lines in prop::collection::vec(r"(v( -?[0-9]{0,10}(\.[0-9]{0,18})?(e-?[0-9])?){3}|f( -?[0-3](/-?[0-9]{0,9}){0,2}){2,9}|v[nt] 1 2)[ \\]{0,2}\r?\n", 0..8)
    ) {
        check(&("v 0 0 0\n".repeat(3) + &lines.concat()));
    }

    #[test]
    fn plain_numbers_are_the_nearest(numbers in prop::collection::vec(r"-?[0-9]{1,9}(\.[0-9]{1,16})?", 3)) {
        let mesh = read(&format!("v {}\n# the end is far\n", numbers.join(" "))).unwrap();
        let expected: Vec<u32> = numbers.iter().map(|number| number.parse::<f32>().unwrap().to_bits()).collect();
        prop_assert_eq!(bits(&mesh).concat(), expected);
    }
}
