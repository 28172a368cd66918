//! What every command says that looks at a mesh from above: which way is up, and what is measured.

use crate::up::Up;
use clap::builder::PossibleValuesParser;

/// Heights, and their unit.
#[derive(Debug, clap::Args)]
pub(crate) struct Heights {
    /// The axis that points up: x, y, z, -x, -y or -z [default: as the format has it: y in glTF, X3D and VRML, else z]
    #[arg(long, value_name = "AXIS", allow_hyphen_values = true)]
    pub(crate) up: Option<Up>,
    /// The coordinate to take for the field [default: the height along --up]
    #[arg(long, value_name = "COORDINATE", value_parser = PossibleValuesParser::new(["x", "y", "z"]))]
    field: Option<String>,
    /// The unit of the coordinates, to be said beside figures [default: m in glTF, X3D and VRML]
    #[arg(long, value_name = "NAME")]
    pub(crate) unit: Option<String>,
}

impl Heights {
    /// The number of the coordinate that was asked for.
    pub(crate) fn field(&self) -> Option<usize> {
        self.field.as_ref().and_then(|name| ["x", "y", "z"].iter().position(|known| known == name))
    }
}
