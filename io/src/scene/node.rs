//! The nodes that matter to a mesh, by name.

/// What a node is to a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Node {
    /// Geometry that is read.
    Geometry(Kind),
    /// Geometry that is not, or that stands elsewhere, by name.
    Unread(&'static str),
    /// A node that other nodes with geometry lie in.
    Container,
    /// A list of points.
    Coordinates,
    /// Anything else.
    Other,
}

/// The geometry that is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// `IndexedFaceSet`: polygons.
    Faces,
    /// `IndexedTriangleSet`: three corners each.
    IndexedTriangles,
    /// `TriangleSet`: three points each.
    Triangles,
    /// `IndexedTriangleStripSet`.
    Strips,
    /// `IndexedTriangleFanSet`.
    Fans,
}

/// Geometry that makes no list of triangles, or only by computing it, and what stands for a file or a prototype.
const UNREAD: [&str; 25] = [
    "Inline",
    "GeoInline",
    "ProtoInstance",
    "Box",
    "Sphere",
    "Cone",
    "Cylinder",
    "ElevationGrid",
    "GeoElevationGrid",
    "Extrusion",
    "Text",
    "TriangleStripSet",
    "TriangleFanSet",
    "IndexedQuadSet",
    "QuadSet",
    "IndexedLineSet",
    "LineSet",
    "PointSet",
    "NurbsPatchSurface",
    "NurbsTrimmedSurface",
    "NurbsSweptSurface",
    "NurbsSwungSurface",
    "Disk2D",
    "Rectangle2D",
    "TriangleSet2D",
];

impl Node {
    pub(crate) fn of(name: &[u8]) -> Self {
        match name {
            b"Coordinate" | b"CoordinateDouble" => Self::Coordinates,
            b"IndexedFaceSet" => Self::Geometry(Kind::Faces),
            b"IndexedTriangleSet" => Self::Geometry(Kind::IndexedTriangles),
            b"TriangleSet" => Self::Geometry(Kind::Triangles),
            b"IndexedTriangleStripSet" => Self::Geometry(Kind::Strips),
            b"IndexedTriangleFanSet" => Self::Geometry(Kind::Fans),
            b"Shape" | b"Group" | b"StaticGroup" | b"Transform" | b"Switch" | b"LOD" | b"Collision"
            | b"Anchor" | b"Billboard" | b"GeoLOD" | b"GeoLocation" | b"GeoTransform" | b"CADAssembly"
            | b"CADFace" | b"CADLayer" | b"CADPart" => Self::Container,
            _ => match UNREAD.iter().find(|known| known.as_bytes() == name) {
                Some(known) => Self::Unread(known),
                None => Self::Other,
            },
        }
    }
}

impl Kind {
    /// The field that holds its corners.
    pub(crate) fn index_field(self) -> &'static str {
        match self {
            Self::Faces => "coordIndex",
            _ => "index",
        }
    }
}
