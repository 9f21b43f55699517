//! How the points of refined vertices are numbered, and the faces between them.

use super::super::Connectivity;
use super::faces::for_each_face;
use super::index_of;
use super::patches::{LANES, grouped};
use super::quads::Progression;

/// A mesh whose vertices become blocks of `side` x `side` points each.
///
/// A block has four sides, anticlockwise: to the east (the last column), north (the last row), west and south, and four corners: each is the last
/// point of the side of the same number. Side i faces the vertex's i-th edge, and corner i lies in its i-th face, as
/// [`Connectivity::around`] counts them; a boundary vertex has nothing on its other sides.
///
/// Points are numbered block by block, each row by row. Where blocks are small, `LANES` of them take turns: the first point of each, the second
/// of each, and so on.
#[derive(Clone, Debug)]
pub(super) struct BlockNumbering {
    block_count: usize,
    pub(super) side: u32,
    /// The two sides that each edge joins, as `4 · block + side`.
    strips: Vec<[u32; 2]>,
    /// The corners around each face of four, as `4 · block + corner`.
    centres: Vec<[u32; 4]>,
    /// The same for all other faces, one after the other, and where each ends.
    polygon_corners: Vec<u32>,
    polygon_ends: Vec<u32>,
}

/// Which of the half-edges around its origin each half-edge is.
pub(super) fn places(connectivity: &Connectivity) -> Vec<u8> {
    let mut places = vec![0; connectivity.half_edge_count()];
    for vertex in 0..index_of(connectivity.vertex_count()) {
        for (place, h) in (0..).zip(connectivity.around(vertex)) {
            places[h as usize] = place;
        }
    }
    places
}

impl BlockNumbering {
    /// The numbering where each vertex has four edges, or is on a boundary and has at most three.
    pub(super) fn new(connectivity: &Connectivity, places: &[u8], side: u32) -> Self {
        let outgoing = |h: u32| 4 * connectivity.origin(h) + u32::from(places[h as usize]);
        let edges = 0..index_of(connectivity.edge_count());
        let strips = edges.map(|edge| {
            let h = connectivity.half_edge_of(edge);
            let far = connectivity.twin(h).map_or_else(
                || {
                    let end = connectivity.target(h);
                    4 * end + index_of(connectivity.around(end).count())
                },
                outgoing,
            );
            [outgoing(h), far]
        });
        let mut numbering = Self {
            block_count: connectivity.vertex_count(),
            side,
            strips: strips.collect(),
            centres: Vec::new(),
            polygon_corners: Vec::new(),
            polygon_ends: Vec::new(),
        };
        for face in 0..index_of(connectivity.face_count()) {
            let corners = connectivity.half_edges_of(face).map(outgoing);
            if corners.len() == 4 {
                let mut centre = [0; 4];
                centre
                    .iter_mut()
                    .zip(corners)
                    .for_each(|(to, from)| *to = from);
                numbering.centres.push(centre);
            } else {
                numbering.polygon_corners.extend(corners);
                let end = index_of(numbering.polygon_corners.len());
                numbering.polygon_ends.push(end);
            }
        }
        numbering
    }

    pub(super) fn block_count(&self) -> usize {
        self.block_count
    }

    pub(super) fn points_per_block(&self) -> usize {
        self.side as usize * self.side as usize
    }

    pub(super) fn vertex_count(&self) -> usize {
        self.block_count * self.points_per_block()
    }

    fn quads_per_strip(&self) -> usize {
        self.side as usize - 1
    }

    fn quads_per_block(&self) -> usize {
        self.quads_per_strip() * self.quads_per_strip()
    }

    pub(super) fn quad_count(&self) -> usize {
        self.block_count * self.quads_per_block()
            + self.strips.len() * self.quads_per_strip()
            + self.centres.len()
    }

    pub(super) fn grouped(&self) -> usize {
        grouped(self.block_count, self.side)
    }

    pub(super) fn bytes(&self) -> usize {
        let faces = self.centres.capacity() * size_of::<[u32; 4]>()
            + (self.polygon_corners.capacity() + self.polygon_ends.capacity()) * size_of::<u32>();
        self.strips.capacity() * size_of::<[u32; 2]>() + faces
    }

    /// All points of a block, row by row.
    // ANCHOR: block
    fn block(&self, block: u32) -> Progression {
        let (block, size) = (block as usize, self.points_per_block());
        let [first, step] = if block < self.grouped() {
            let lane = block % LANES;
            [(block - lane) * size + lane, LANES]
        } else {
            [block * size, 1]
        };
        Progression {
            first: index_of(first),
            step: index_of(step),
        }
    }

    /// The points along a side, anticlockwise.
    fn along(&self, [block, side]: [u32; 2]) -> Progression {
        let points = self.block(block);
        let last = self.side - 1;
        let [start, stride] = match side {
            0 => [last, self.side],
            1 => [self.side * self.side - 1, 1_u32.wrapping_neg()],
            2 => [last * self.side, self.side.wrapping_neg()],
            _ => [0, 1],
        };
        Progression {
            first: points.at(start),
            step: points.step.wrapping_mul(stride),
        }
    }
    // ANCHOR_END: block

    pub(super) fn vertex(&self, block: u32, row: u32, column: u32) -> u32 {
        self.block(block).at(row * self.side + column)
    }

    fn corner(&self, packed: u32) -> u32 {
        self.along([packed / 4, packed % 4]).at(self.side - 1)
    }

    /// The polygons of other than four corners.
    pub(super) fn polygons(&self) -> impl Iterator<Item = Vec<u32>> {
        let mut start = 0;
        self.polygon_ends.iter().map(move |&end| {
            let corners = &self.polygon_corners[start..end as usize];
            start = end as usize;
            corners.iter().map(|&packed| self.corner(packed)).collect()
        })
    }

    /// Writes the quadrilaterals: those of the blocks, those along the edges, those in the faces.
    // ANCHOR: faces
    pub(super) fn write_quads(&self, out: &mut [[u32; 4]]) {
        let (in_blocks, rest) = out.split_at_mut(self.block_count * self.quads_per_block());
        let (along_edges, in_faces) = rest.split_at_mut(self.strips.len() * self.quads_per_strip());
        if self.side > 1 {
            for_each_face(in_blocks, self.quads_per_block(), |block, quads| {
                self.write_block(block, quads);
            });
            for_each_face(along_edges, self.quads_per_strip(), |strip, quads| {
                self.write_strip(self.strips[strip as usize], quads);
            });
        }
        for (quad, corners) in in_faces.iter_mut().zip(&self.centres) {
            *quad = corners.map(|packed| self.corner(packed));
        }
    }

    fn write_block(&self, block: u32, quads: &mut [[u32; 4]]) {
        let points = self.block(block);
        let row = |row: u32| Progression {
            first: points.at(row * self.side),
            ..points
        };
        let rows = quads.chunks_exact_mut(self.quads_per_strip());
        for (index, quads) in (0..).zip(rows) {
            between(row(index), row(index + 1), quads);
        }
    }

    fn write_strip(&self, strip: [u32; 2], quads: &mut [[u32; 4]]) {
        let [near, far] = strip.map(|packed| self.along([packed / 4, packed % 4]));
        between(far.reversed(self.side), near, quads);
    }
    // ANCHOR_END: faces
}

/// The quadrilaterals between two rows, the upper one on the left of the lower one's direction.
fn between(low: Progression, high: Progression, quads: &mut [[u32; 4]]) {
    for (t, quad) in (0..).zip(quads) {
        *quad = [low.at(t), low.at(t + 1), high.at(t + 1), high.at(t)];
    }
}
