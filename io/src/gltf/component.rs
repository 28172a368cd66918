//! The numbers that accessors are made of.

/// The types of a component, by the numbers of OpenGL.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Component {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl Component {
    pub(super) fn of(number: u64) -> Option<Self> {
        Some(match number {
            5120 => Self::I8,
            5121 => Self::U8,
            5122 => Self::I16,
            5123 => Self::U16,
            5125 => Self::U32,
            5126 => Self::F32,
            _ => return None,
        })
    }

    pub(super) fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::U32 | Self::F32 => 4,
        }
    }

    pub(super) fn is_unsigned(self) -> bool {
        matches!(self, Self::U8 | Self::U16 | Self::U32)
    }
}

fn bytes_of<const N: usize>(bytes: &[u8]) -> [u8; N] {
    std::array::from_fn(|i| bytes[i])
}

/// An index, from the bytes of an unsigned component.
pub(super) fn unsigned(bytes: &[u8], component: Component) -> u32 {
    match component.size() {
        1 => u32::from(bytes[0]),
        2 => u32::from(u16::from_le_bytes(bytes_of(bytes))),
        _ => u32::from_le_bytes(bytes_of(bytes)),
    }
}

/// A position, from the bytes of three components.
pub(super) fn vector(bytes: &[u8], component: Component, normalized: bool) -> [f32; 3] {
    std::array::from_fn(|i| coordinate(&bytes[i * component.size()..], component, normalized))
}

/// One coordinate; normalised integers by the formulas of glTF 2.0, section 3.11.
fn coordinate(bytes: &[u8], component: Component, normalized: bool) -> f32 {
    let (value, top) = match component {
        Component::F32 => return f32::from_le_bytes(bytes_of(bytes)),
        Component::I8 => (f32::from(bytes[0] as i8), f32::from(i8::MAX)),
        Component::I16 => (f32::from(i16::from_le_bytes(bytes_of(bytes))), f32::from(i16::MAX)),
        Component::U8 => (f32::from(bytes[0]), f32::from(u8::MAX)),
        Component::U16 | Component::U32 => {
            (f32::from(u16::from_le_bytes(bytes_of(bytes))), f32::from(u16::MAX))
        }
    };
    if normalized { (value / top).max(-1.0) } else { value }
}
