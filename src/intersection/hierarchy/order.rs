//! In which order the children of a node wait on the stack, without a branch.
//!
//! The children are placed so that a ray whose direction has the signs o (a bit for each negative coordinate) meets them front to back
//! in the order of `place XOR o`, more or less. A table says for each o and each set of children met which lanes they come from: one shuffle
//! moves them to the front of a register, the last to be visited first, and one store puts all of them on the stack.
//!
//! # Sources
//!
//! H. Ylitie, T. Karras, S. Laine, *Efficient incoherent ray traversal on GPUs through compressed wide BVHs*, 2017, section 3.3 (the order).

use super::collapse::WIDTH;

/// For each octant and each set of lanes: the lanes in the order of the stack.
pub(super) static LANES: [[[u8; WIDTH]; 256]; 8] = lanes();

const fn lanes() -> [[[u8; WIDTH]; 256]; 8] {
    let mut table = [[[0; WIDTH]; 256]; 8];
    let mut octant = 0;
    while octant < 8 {
        let mut set = 0;
        while set < 256 {
            let (mut rank, mut found) = (8, 0);
            while rank > 0 {
                rank -= 1;
                let lane = rank ^ octant;
                if set >> lane & 1 == 1 {
                    table[octant][set][found] = lane as u8;
                    found += 1;
                }
            }
            set += 1;
        }
        octant += 1;
    }
    table
}
