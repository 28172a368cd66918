//! Which way is up, and how coordinates look from there.

use onering_io::Format;
use std::fmt;
use std::str::FromStr;

/// An axis of the file, or its opposite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Up {
    /// The axes to the right, away, and up, as one who looks down from above has them: a rotation, so faces keep
    /// their orientation.
    axes: [Axis; 3],
}

/// An axis by its number, and whether it counts backwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Axis(usize, bool);

const X: usize = 0;
const Y: usize = 1;
const Z: usize = 2;

/// Every way that is up.
const ALL: [Up; 6] = [
    Up { axes: [Axis(Y, false), Axis(Z, false), Axis(X, false)] },
    Up { axes: [Axis(X, false), Axis(Z, true), Axis(Y, false)] },
    Up { axes: [Axis(X, false), Axis(Y, false), Axis(Z, false)] },
    Up { axes: [Axis(Y, false), Axis(Z, true), Axis(X, true)] },
    Up { axes: [Axis(X, false), Axis(Z, false), Axis(Y, true)] },
    Up { axes: [Axis(X, false), Axis(Y, true), Axis(Z, true)] },
];

impl Up {
    /// As the format has it: y in glTF, X3D and VRML, whose specifications say so; z where nothing does.
    pub(crate) fn of_format(format: Option<Format>) -> Self {
        ALL[if format.is_some_and(has_y_up_and_metres) { Y } else { Z }]
    }

    /// The point with its coordinates to the right, away and up. Exact: they change places and signs only.
    pub(crate) fn turned(self, point: [f32; 3]) -> [f32; 3] {
        self.axes.map(|Axis(axis, is_negative)| if is_negative { -point[axis] } else { point[axis] })
    }

    /// What is to the right, away, and up.
    pub(crate) fn names(self) -> [String; 3] {
        self.axes.map(|axis| axis.to_string())
    }
}

/// Of the formats whose specifications say what is up and how long a unit is, all say the same.
pub(crate) fn has_y_up_and_metres(format: Format) -> bool {
    matches!(format, Format::Gltf | Format::Glb | Format::X3d | Format::Vrml)
}

impl fmt::Display for Axis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(axis, is_negative) = self;
        write!(f, "{}{}", if *is_negative { "-" } else { "" }, ["x", "y", "z"][*axis])
    }
}

impl fmt::Display for Up {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.axes[2].fmt(f)
    }
}

impl FromStr for Up {
    type Err = &'static str;

    fn from_str(word: &str) -> Result<Self, Self::Err> {
        let named = |up: &Up| up.to_string() == word;
        ALL.into_iter().find(named).ok_or("not one of x, y, z, -x, -y, -z")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The determinant of a rotation is 1: nothing is mirrored.
    #[test]
    fn every_up_is_a_rotation() {
        for up in ALL {
            let [a, b, c] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|p| up.turned(p));
            let [x, y] = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2]];
            assert_eq!(a[0] * x + a[1] * y + a[2] * (b[0] * c[1] - b[1] * c[0]), 1.0, "{up}");
            assert_eq!(up.to_string().parse(), Ok(up));
        }
        assert!("w".parse::<Up>().is_err());
    }

    #[test]
    fn formats_say_what_is_up() {
        let up = |name: &str| Up::of_format(Format::of_name(name)).to_string();
        assert_eq!(["glb", "x3d", "wrl", "obj", "ply"].map(up), ["y", "y", "y", "z", "z"]);
        assert_eq!("-y".parse::<Up>().unwrap().turned([1.0, 2.0, 3.0]), [1.0, 3.0, -2.0]);
    }
}
