//! In which order the children of a node wait on the stack, without a branch.
//!
//! The children are placed so that a ray whose direction has the signs o (a bit for each negative coordinate) meets them front to back
//! in the order of `place XOR o`, more or less. A table says for each o and each set of children met which lanes they come from: one shuffle
//! moves them to the front of a register, the last to be visited first, and one store puts all of them on the stack.
//!
//! # Sources
//!
//! H. Ylitie, T. Karras, S. Laine, *Efficient incoherent ray traversal on GPUs through compressed wide BVHs*, 2017, section 3.3 (the order).

use wide::u32x8;

use super::collapse::WIDTH;

/// The lanes of a set of children in the order of the stack, for rays whose direction has these signs.
#[inline(always)]
pub(super) fn in_order(octant: u32, set: u32) -> u32x8 {
    lanes_of(&LANES[(octant << 8 | set) as usize & 0x7ff])
}

/// Eight lanes from eight bytes.
#[inline(always)]
pub(super) fn lanes_of(bytes: &[u8; WIDTH]) -> u32x8 {
    let [a, b, c, d, e, f, g, h] = *bytes;
    u32x8::new([
        a.into(),
        b.into(),
        c.into(),
        d.into(),
        e.into(),
        f.into(),
        g.into(),
        h.into(),
    ])
}

/// For each octant and each set of lanes.
static LANES: [[u8; WIDTH]; 8 * 256] = lanes();

#[allow(clippy::cast_possible_truncation, reason = "lanes are below 8")]
const fn lanes() -> [[u8; WIDTH]; 8 * 256] {
    let mut table = [[0; WIDTH]; 8 * 256];
    let mut index = 0;
    while index < table.len() {
        let (octant, set) = (index >> 8, index & 0xff);
        let (mut rank, mut found) = (WIDTH, 0);
        while rank > 0 {
            rank -= 1;
            let lane = rank ^ octant;
            if set >> lane & 1 == 1 {
                table[index][found] = lane as u8;
                found += 1;
            }
        }
        index += 1;
    }
    table
}
