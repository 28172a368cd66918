//! Structures that renumber: they take what is clean and name what is not, and obey the laws in the numbers of their maps.
use super::{List, naive};
use crate::renumbered::{is_of_list, renumbered};
use onering::conformance::{self as laws, Case};
use onering::*;

type Encode<M> = fn(usize, &[[u32; 3]]) -> Result<(M, Renumbering), BuildError>;

pub(super) fn encoded(list: &List, defects: &Defects) {
    obeys("sorted opposite table", Sot::encode, list, defects);
    obeys("compact stars", CompactStars::encode, list, defects);
    obeys("compact stars in order", CompactStars::encode_in_order, list, defects);
}

fn obeys<M: Incidence>(name: &'static str, encode: Encode<M>, list: &List, defects: &Defects) {
    let encoded = encode(list.vertices, &list.faces);
    let error = encoded.as_ref().err();
    assert_eq!(error.is_none(), defects.is_clean(), "{name}: {error:?}, but {defects}");
    if list.is_searched() {
        assert_eq!(error, naive::error(list.vertices, &list.faces, &[]).as_ref(), "{name}");
    }
    let Ok((mesh, maps)) = encoded else { return };
    let faces = renumbered(&list.faces, &maps);
    is_of_list(name, &mesh, list.vertices, &faces);
    if list.is_searched() {
        let case = Case::counted(name, list.vertices, faces);
        laws::topology(&case, &mesh);
        laws::adjacency(&case, &mesh);
        laws::incidence(&case, &mesh);
        laws::graph(&case, &mesh);
    }
}
