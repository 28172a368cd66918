//! `heap_bytes` is what a backend really takes: its live allocations are counted. Where one is refused, that is an error.
#![allow(
    unsafe_code,
    reason = "a global allocator is an unsafe trait; this one hands every call on to the system's"
)]
use onering::conformance::{self as laws, Flaw};
use onering::repair::RepairError;
use onering::*;
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

thread_local! {
    /// Bytes that this thread has allocated and not freed. Tests run each on a thread of its own.
    static LIVE: Cell<isize> = const { Cell::new(0) };
    /// The most that there were since this was last set.
    static PEAK: Cell<isize> = const { Cell::new(0) };
    /// Bytes that were asked for since this was last set, whether or not they were freed.
    static ASKED: Cell<isize> = const { Cell::new(0) };
    /// How many more times this thread is given memory.
    static GRANTED: Cell<usize> = const { Cell::new(usize::MAX) };
}

struct Counting;

#[global_allocator]
static COUNTING: Counting = Counting;

fn count(bytes: isize) {
    // A thread that ends frees memory after its counter is gone.
    let _ = LIVE.try_with(|live| {
        live.set(live.get() + bytes);
        PEAK.with(|peak| peak.set(peak.get().max(live.get())));
        ASKED.with(|asked| asked.set(asked.get() + bytes.max(0)));
    });
}

/// Whether memory is given once more.
fn is_granted() -> bool {
    let next = |granted: &Cell<usize>| {
        let left = granted.get();
        // All that there are is for ever.
        granted.set(if left == usize::MAX { left } else { left.saturating_sub(1) });
        left > 0
    };
    GRANTED.try_with(next).unwrap_or(true)
}

// SAFETY: every call goes to `System` as it came or is refused, and the counters do not allocate.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        if !is_granted() {
            return std::ptr::null_mut();
        }
        count(layout.size() as isize);
        // SAFETY: the caller's promise.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        count(-(layout.size() as isize));
        // SAFETY: the caller's promise.
        unsafe { System.dealloc(block, layout) }
    }

    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        if !is_granted() {
            return std::ptr::null_mut();
        }
        count(size as isize - layout.size() as isize);
        // SAFETY: the caller's promise.
        unsafe { System.realloc(block, layout, size) }
    }
}

/// What `make` gives, and how many more bytes are live after it.
fn counted<T>(make: impl FnOnce() -> T) -> (T, usize) {
    let before = LIVE.get();
    let made = make();
    (made, (LIVE.get() - before).try_into().expect("nothing is freed but what was made"))
}

/// The same for the most bytes at a time while it was made.
fn peak<T>(make: impl FnOnce() -> T) -> (T, usize) {
    let before = LIVE.get();
    PEAK.set(before);
    let made = make();
    (made, (PEAK.get() - before).try_into().expect("a peak is no less than what was there"))
}

/// Builds each case that a backend holds, and a larger mesh.
fn counts_what_it_takes<M: FromFaces + Footprint + Clone>(holds: &[&str]) {
    let holds = Flaw::named(holds);
    let torus = laws::Case::counted("a larger torus", 120, laws::torus(12, 10));
    for case in laws::corpus().into_iter().chain([torus]).filter(|case| case.refusal(&holds).is_none()) {
        let (mesh, live) = counted(|| M::from_faces(case.vertices, &case.faces));
        let mesh = mesh.unwrap();
        assert_eq!(live, mesh.heap_bytes(), "{}: built", case.name);
        let (copy, live) = counted(|| mesh.clone());
        assert_eq!(live, copy.heap_bytes(), "{}: copied", case.name);
    }
}

/// A list with room to spare, or of another size than its column, is not kept as it is.
fn counts_what_it_keeps<M: FromFaces + Footprint>() {
    let faces = laws::torus(12, 10);
    let (mesh, live) = counted(|| {
        let mut roomy = Vec::with_capacity(1000);
        roomy.extend_from_slice(&faces);
        M::from_face_vec(120, roomy).unwrap()
    });
    assert_eq!(live, mesh.heap_bytes());
    let (refused, live) = counted(|| M::from_faces(100, &faces));
    assert!(refused.is_err());
    assert_eq!(live, 0, "a mesh that is refused leaves nothing behind");
}

macro_rules! backends {
    ($($name:ident $text:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {
        mod heap_bytes {
            use super::*;

            $(#[test]
            fn $name() {
                counts_what_it_takes::<$mesh>(&[$(stringify!($holds)),*]);
                counts_what_it_keeps::<$mesh>();
            })+
        }
    };
}
onering::with_backends!(backends);

/// On a mesh in order, at most a quarter more than what stays is taken while building.
macro_rules! peaks {
    ($($mesh:ty)+) => {
        #[test]
        fn building_takes_little_more_than_what_stays() {
            let faces = laws::torus(120, 100);
            $(
                let (mesh, most) = peak(|| <$mesh>::from_faces(12_000, &faces).unwrap());
                assert!(most * 4 <= mesh.heap_bytes() * 5, "{mesh:?}: {most} of {}", mesh.heap_bytes());
            )+
        }
    };
}
peaks!(CheL1 CheL2 CheL3 DirectedEdgesSmall DirectedEdgesMedium DirectedEdgesFull MateFace);

/// A mesh in order takes no memory but that of the one before it of the same size, whatever its faces are: only a list of
/// the few vertices that the chain is in doubt about, less than a page.
macro_rules! rebuilds {
    ($($mesh:ty)+) => {
        #[test]
        fn building_again_takes_next_to_nothing() {
            let (faces, turned) = (laws::torus(120, 100), laws::torus(100, 120));
            $(
                let mut builder = Builder::new();
                let mesh: $mesh = builder.build(12_000, &faces).unwrap();
                builder.recycle(mesh);
                let live = LIVE.get();
                for faces in [&faces, &turned, &faces] {
                    ASKED.set(0);
                    let mesh: $mesh = builder.build(12_000, faces).unwrap();
                    builder.recycle(mesh);
                    assert!(ASKED.get() < 4096, "{}: {}", stringify!($mesh), ASKED.get());
                }
                assert_eq!(LIVE.get(), live, "{}: what is spare does not grow", stringify!($mesh));
            )+
        }
    };
}
rebuilds!(SharedVertex CheL0 CheL1 CheL2 CheL2EdgeTable DirectedEdgesSmall DirectedEdgesMedium DirectedEdgesFull
    MateFace);

/// For what is made by a function of its own, which gives maps as well.
fn counts_what_is_encoded<M: Clone>(
    encode: impl Fn(usize, &[[u32; 3]]) -> Result<M, BuildError>,
    heap_bytes: impl Fn(&M) -> usize,
) {
    let torus = laws::Case::counted("a larger torus", 120, laws::torus(12, 10));
    for case in laws::corpus().into_iter().chain([torus]) {
        let (encoded, live) = counted(|| encode(case.vertices, &case.faces));
        let Ok(mesh) = encoded else {
            assert_eq!(live, 0, "{}: a mesh that is refused leaves nothing behind", case.name);
            continue;
        };
        assert_eq!(live, heap_bytes(&mesh), "{}: encoded", case.name);
        let (copy, live) = counted(|| mesh.clone());
        assert_eq!(live, heap_bytes(&copy), "{}: copied", case.name);
    }
}

#[test]
fn sot() {
    counts_what_is_encoded(|n, faces| Sot::encode(n, faces).map(|(mesh, _)| mesh), Sot::heap_bytes);
}

#[test]
fn compact_stars() {
    let encode = |n, faces: &[_]| CompactStars::encode(n, faces).map(|(mesh, _)| mesh);
    counts_what_is_encoded(encode, CompactStars::heap_bytes);
}

#[test]
fn adaptors() {
    let faces = laws::torus(12, 10);
    let soup = SharedVertex::from_faces(120, &faces).unwrap();
    let (mesh, live) = counted(|| WithOpposites::new(soup.clone()).unwrap());
    assert_eq!(live, mesh.heap_bytes());
    // 240 faces of three corners and three opposites; then an outgoing half-edge for each of 120 vertices.
    assert_eq!(mesh.heap_bytes(), 240 * (3 + 3) * 4);
    let (mesh, live) = counted(|| WithOutgoing::new(mesh.clone()).unwrap());
    assert_eq!(live, mesh.heap_bytes());
    assert_eq!(mesh.heap_bytes(), 240 * (3 + 3) * 4 + 120 * 4);
}

/// Runs `work` with its first allocation refused, then with its second, and so on until none is; gives how many it has.
/// What allocates as if there always were memory ends the process here.
fn refused_each<T>(mut work: impl FnMut() -> Result<T, BuildError>) -> usize {
    for granted in 0.. {
        let live = LIVE.get();
        GRANTED.set(granted);
        let done = work();
        let left = GRANTED.replace(usize::MAX);
        match done {
            Ok(_) if left > 0 => return granted - left,
            Ok(_) => {}
            Err(BuildError::OutOfMemory { .. }) => {
                drop(done);
                assert_eq!(LIVE.get(), live, "allocation {granted}: what had been taken is freed");
            }
            Err(error) => panic!("allocation {granted}: {error}"),
        }
    }
    unreachable!()
}

/// Every kind of defect, so many that lists of them grow; and the same with numbers far beyond the faces.
fn defective() -> [(usize, Vec<[u32; 3]>); 2] {
    let torus = laws::torus(12, 10);
    // Six faces more on an edge of each face of the torus, every other one turned.
    let fins = torus.iter().flat_map(|&[a, b, _]| {
        (0..6).map(move |i| if i % 2 == 0 { [a, b, 120 + i] } else { [b, a, 120 + i] })
    });
    let again = torus.iter().take(20).copied();
    let improper = (0..20).flat_map(|i| [[i, i, 0], [i, 0, 1_000_000]]);
    let moebius = [[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 0], [4, 0, 1]].map(|face| face.map(|v| v + 200));
    let faces: Vec<_> =
        torus.iter().copied().chain(again).chain(fins).chain(improper).chain(moebius).collect();
    let far = faces.iter().map(|face| face.map(|v| v * 4000)).collect();
    [(300, faces), (300 * 4000, far)]
}

#[test]
fn defects_are_found_or_there_is_no_memory() {
    assert_eq!(refused_each(|| Defects::of(0, &[])), 0);
    for (vertex_count, faces) in defective() {
        assert!(refused_each(|| Defects::of(vertex_count, &faces)) > 20);
    }
}

#[test]
fn defects_are_mended_or_there_is_no_memory() {
    let positions: Vec<_> = (0..300).map(|v| [(v / 2) as f32; 3]).collect();
    let [(_, faces), far] = defective();
    let mended = |vertex_count, faces: &[_], weld| {
        let options = RepairOptions { weld };
        refused_each(|| {
            repair(vertex_count, faces, &options).map_err(|error| match error {
                RepairError::Limit(error) => error,
                other => panic!("{other}"),
            })
        })
    };
    assert!(mended(300, &faces, Some(&positions)) > 20);
    assert!(mended(far.0, &far.1, None) > 20);
}
