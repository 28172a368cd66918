//! Whose turn it is among threads that each read a part of a file.

use std::sync::{Condvar, Mutex};

use super::Reader;
use super::lists::{Rooms, Share};

/// Who comes next.
pub(super) struct Turns<'r, 'a> {
    state: Mutex<State<'r, 'a>>,
    change: Condvar,
}

struct State<'r, 'a> {
    /// Parts that have their places.
    placed: usize,
    outlook: Outlook,
    rooms: &'r mut Rooms<'a>,
    /// What is known of them, but for the lists.
    all: &'r mut Reader,
}

#[derive(PartialEq)]
enum Outlook {
    Room,
    /// The next part needs more room than there is.
    Full,
    Wrong,
}

impl<'r, 'a> Turns<'r, 'a> {
    pub(super) fn new(placed: usize, rooms: &'r mut Rooms<'a>, all: &'r mut Reader) -> Self {
        let state = State { placed, outlook: Outlook::Room, rooms, all };
        Self { state: Mutex::new(state), change: Condvar::new() }
    }

    /// `None` once there is too little room, or something wrong.
    pub(super) fn go_on(&self) -> Option<()> {
        (self.state.lock().ok()?.outlook == Outlook::Room).then_some(())
    }

    /// The share of this part, when all before it have theirs: some thread is about each of them.
    pub(super) fn share(&self, number: usize, part: &Reader) -> Option<Share<'a>> {
        let is_early = |state: &mut State<'_, '_>| state.outlook == Outlook::Room && state.placed != number;
        let mut state = self.change.wait_while(self.state.lock().ok()?, is_early).ok()?;
        if state.outlook != Outlook::Room {
            return None;
        }
        let share = state.rooms.take(part);
        match &share {
            Some(_) => {
                state.all.count(part);
                state.placed += 1;
            }
            // More room would be of no use.
            None if !state.rooms.has_numbers() => state.outlook = Outlook::Wrong,
            None => state.outlook = Outlook::Full,
        }
        drop(state);
        self.change.notify_all();
        share
    }

    /// How many parts have their places, and whether there is room left; `None` if something is wrong.
    pub(super) fn end(self) -> Option<(usize, bool)> {
        let State { placed, outlook, .. } = self.state.into_inner().ok()?;
        (outlook != Outlook::Wrong).then_some((placed, outlook == Outlook::Room))
    }

    /// Tells all if something is wrong.
    pub(super) fn right<T>(&self, result: Option<T>) -> Option<T> {
        if result.is_none() {
            // A lock that was left by a panic is as bad, and tells by itself.
            if let Ok(mut state) = self.state.lock() {
                state.outlook = Outlook::Wrong;
            }
            self.change.notify_all();
        }
        result
    }
}

/// Tells all if its thread panics: others would wait for the part that it was about, and for ever.
pub(super) struct Alarm<'t, 'r, 'a>(pub(super) &'t Turns<'r, 'a>);

impl Drop for Alarm<'_, '_, '_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            self.0.right(None::<()>);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::lists::{Lists, Needed};
    use super::super::numbering::Numbering;
    use super::*;
    use std::sync::mpsc;
    use std::time::Duration;

    /// Part 0 is never placed, as the thread that is about it panics: the one about part 1 is not left waiting.
    #[test]
    fn a_panic_stops_all() {
        let (tell, told) = mpsc::channel();
        // On a thread of its own, which nobody waits for: who is left waiting is so for ever.
        std::thread::spawn(move || tell.send(share_after_a_panic()));
        let share = told.recv_timeout(Duration::from_secs(60)).expect("part 1 has its answer in a minute");
        assert!(!share);
    }

    /// Whether part 1 gets its share.
    fn share_after_a_panic() -> bool {
        let (mut all, mut lists) = (Reader::new(Numbering::of_file(u32::MAX)), Lists::default());
        let part = Reader::new(Numbering::of_part());
        let share = lists.with_room(&Needed::default(), |rooms| {
            let turns = Turns::new(0, rooms, &mut all);
            std::thread::scope(|scope| {
                let waiting = scope.spawn(|| turns.share(1, &part).is_some());
                let about_part_0 = scope.spawn(|| {
                    let _alarm = Alarm(&turns);
                    panic!("in part 0");
                });
                assert!(about_part_0.join().is_err());
                waiting.join().unwrap()
            })
        });
        share.unwrap()
    }
}
