//! The numbers that accessors are made of.

use ::gltf::json::accessor::ComponentType;

pub(super) fn is_unsigned(component: ComponentType) -> bool {
    matches!(component, ComponentType::U8 | ComponentType::U16 | ComponentType::U32)
}

fn bytes_of<const N: usize>(bytes: &[u8]) -> [u8; N] {
    std::array::from_fn(|i| bytes[i])
}

/// An index, from the bytes of an unsigned component.
pub(super) fn unsigned(bytes: &[u8], component: ComponentType) -> u32 {
    match component.size() {
        1 => u32::from(bytes[0]),
        2 => u32::from(u16::from_le_bytes(bytes_of(bytes))),
        _ => u32::from_le_bytes(bytes_of(bytes)),
    }
}

/// A position, from the bytes of three components.
pub(super) fn vector(bytes: &[u8], component: ComponentType, normalized: bool) -> [f32; 3] {
    std::array::from_fn(|i| coordinate(&bytes[i * component.size()..], component, normalized))
}

/// One coordinate; normalised integers by the formulas of glTF 2.0, section 3.11.
fn coordinate(bytes: &[u8], component: ComponentType, normalized: bool) -> f32 {
    let (value, top) = match component {
        ComponentType::F32 => return f32::from_le_bytes(bytes_of(bytes)),
        ComponentType::I8 => (f32::from(bytes[0] as i8), f32::from(i8::MAX)),
        ComponentType::I16 => (f32::from(i16::from_le_bytes(bytes_of(bytes))), f32::from(i16::MAX)),
        ComponentType::U8 => (f32::from(bytes[0]), f32::from(u8::MAX)),
        ComponentType::U16 | ComponentType::U32 => {
            (f32::from(u16::from_le_bytes(bytes_of(bytes))), f32::from(u16::MAX))
        }
    };
    if normalized { (value / top).max(-1.0) } else { value }
}
