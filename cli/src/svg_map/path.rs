//! The data of a path, in as few bytes as there can be.

use std::fmt::Write;
use svg::node::element::Path;

/// Moves and lines between points of whole numbers.
#[derive(Debug, Default)]
pub(super) struct Data {
    text: String,
}

impl Data {
    /// Draws a line through the points. Each is said as the step from the one before it; what is no step is not said.
    pub(super) fn line(&mut self, points: impl Iterator<Item = [i32; 2]>, is_closed: bool) {
        let mut last: Option<[i32; 2]> = None;
        let mut has_steps = false;
        for point in points {
            match last {
                None => self.move_to(point),
                Some(last) if last == point => continue,
                Some([x, y]) => {
                    // Behind the first `l`, steps follow without a letter.
                    self.number(if has_steps { " " } else { "l" }, point[0] - x);
                    self.number(" ", point[1] - y);
                    has_steps = true;
                }
            }
            last = Some(point);
        }
        if is_closed && has_steps {
            self.text.push('z');
        } else if last.is_some() && !has_steps {
            // All in one place: round ends make it a dot.
            self.text += "h0";
        }
    }

    /// A dot, where lines have round ends.
    pub(super) fn dot(&mut self, point: [i32; 2]) {
        self.line([point].into_iter(), false);
    }

    /// A shape that is always the same, at this point.
    pub(super) fn shape(&mut self, point: [i32; 2], shape: &str) {
        self.move_to(point);
        self.text += shape;
    }

    /// A path of it; `None` where nothing is drawn.
    pub(super) fn path(self) -> Option<Path> {
        (!self.text.is_empty()).then(|| Path::new().set("d", self.text))
    }

    fn move_to(&mut self, [x, y]: [i32; 2]) {
        self.number("M", x);
        self.number(" ", y);
    }

    /// A minus divides numbers as a blank does.
    fn number(&mut self, before: &str, number: i32) {
        let before = if number < 0 && before == " " { "" } else { before };
        let _ = write!(self.text, "{before}{number}");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_short() {
        let mut data = Data::default();
        data.line([[10, 20], [13, 20], [13, 20], [12, 17]].into_iter(), true);
        data.line([[-1, 0], [0, 0]].into_iter(), false);
        data.line([[5, 5], [5, 5]].into_iter(), true);
        assert_eq!(data.text, "M10 20l3 0-1-3zM-1 0l1 0M5 5h0");
        assert!(Data::default().path().is_none());
    }
}
