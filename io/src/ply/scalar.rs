//! The types of numbers that PLY files are made of.

/// A type that can count and name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Integer {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scalar {
    Integer(Integer),
    F32,
    F64,
}

impl Integer {
    pub(super) fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 => 4,
        }
    }
}

impl Scalar {
    /// The type of this name, old or new.
    pub(super) fn of_name(name: &[u8]) -> Option<Self> {
        Some(match name {
            b"char" | b"int8" => Self::Integer(Integer::I8),
            b"uchar" | b"uint8" => Self::Integer(Integer::U8),
            b"short" | b"int16" => Self::Integer(Integer::I16),
            b"ushort" | b"uint16" => Self::Integer(Integer::U16),
            b"int" | b"int32" => Self::Integer(Integer::I32),
            b"uint" | b"uint32" => Self::Integer(Integer::U32),
            b"float" | b"float32" => Self::F32,
            b"double" | b"float64" => Self::F64,
            _ => return None,
        })
    }

    pub(super) fn size(self) -> usize {
        match self {
            Self::Integer(integer) => integer.size(),
            Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    pub(super) fn integer(self) -> Option<Integer> {
        match self {
            Self::Integer(integer) => Some(integer),
            Self::F32 | Self::F64 => None,
        }
    }
}
