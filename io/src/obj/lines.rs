//! Polylines as OBJ.

use std::io::{self, Write};

use super::writer::write_positions;
use crate::Lines;
use crate::block::Block;
use crate::decimal::u64_into;

/// `v` for each point, then `l` for each line and `p` for what has one point only.
pub(crate) fn write(lines: &Lines, out: &mut dyn Write) -> io::Result<()> {
    write_positions(lines.positions(), out)?;
    let mut block = Block::new(out);
    for line in lines.iter() {
        block.bytes().push(if line.points.len() == 1 { b'p' } else { b'l' });
        let first_again = (line.is_closed && line.points.len() > 1).then_some(line.start);
        for i in (line.start..line.start + line.points.len()).chain(first_again) {
            block.bytes().push(b' ');
            u64_into(block.bytes(), i as u64 + 1);
            block.pass_on()?;
        }
        block.bytes().push(b'\n');
    }
    block.finish()
}
