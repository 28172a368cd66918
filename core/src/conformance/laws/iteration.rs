//! The law of iterators: every way to run one gives the same.
use alloc::vec::Vec;
use core::fmt::Debug;

/// What the iterators that `make` gives run through. Panics where `fold`, from wherever, does not agree with `next`,
/// or the size hint is wrong.
#[expect(clippy::while_let_on_iterator, reason = "`for` might run something else than `next`")]
pub(super) fn all<I: Iterator<Item: PartialEq + Debug>>(what: &str, make: impl Fn() -> I) -> Vec<I::Item> {
    let mut items = Vec::new();
    let mut iterator = make();
    while let Some(item) = iterator.next() {
        items.push(item);
    }
    for begun in 0..=items.len() {
        let mut rest = make();
        (0..begun).for_each(|_| drop(rest.next()));
        let (least, most) = rest.size_hint();
        let mut folded = Vec::new();
        rest.for_each(|item| folded.push(item));
        assert_eq!(folded, items[begun..], "{what}: `fold` after {begun} times `next`");
        assert!(least <= folded.len(), "{what}: size hint is at least {least}");
        assert!(most.is_none_or(|most| folded.len() <= most), "{what}: size hint is at most {most:?}");
    }
    items
}
