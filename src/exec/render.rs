//! What a draw gives: all of its pixels, or some of them.

use super::code::Code;
use super::draw::{Draw, Stop};
use super::machine::{Machine, Tile};
use super::row::LANES;
use super::seen::Seen;
use shaderlint_math::hash;
use std::sync::atomic::{AtomicU32, Ordering};

/// What a draw gave. Rows of pixels begin at the bottom, as `gl_FragCoord` counts.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// The size in pixels.
    pub size: [u32; 2],
    /// By output, by pixel: its scalars as bits, the first four of them.
    pub outputs: Vec<Vec<[u32; 4]>>,
    /// By pixel: whether it was drawn, and not discarded.
    pub covered: Vec<bool>,
    /// By pixel: how many operations it took part in.
    pub cost: Vec<u32>,
    /// By pixel: how many operations its group of 8x4 pixels took, those counted once that several
    /// took part in.
    pub ran: Vec<u32>,
    /// By pixel: how many turns of loops it made, where these are watched.
    pub turns: Vec<u32>,
    /// What was seen on the way.
    pub seen: Seen,
}

/// What was run of a picture: four pixels for each quad, in the order of lanes.
#[derive(Clone, Debug)]
pub struct Sampled {
    /// The pixels.
    pub pixels: Vec<[u32; 2]>,
    /// By output, by pixel: its scalars as bits, the first four of them.
    pub outputs: Vec<Vec<[u32; 4]>>,
    /// By pixel: whether it was drawn, and not discarded.
    pub covered: Vec<bool>,
    /// By pixel: how many operations it took part in.
    pub cost: Vec<u32>,
    /// How many instructions were run.
    pub spent: u64,
    /// What was seen on the way.
    pub seen: Seen,
}

/// The pixels of some quads, given by their lower left ones.
fn tile_of(size: [u32; 2], quads: &[[u32; 2]]) -> Tile {
    let mut tile = Tile {
        pixels: [[0; 2]; LANES],
        wanted: 0,
    };
    for (lane, pixel) in tile.pixels.iter_mut().enumerate() {
        let (right, up) = (lane as u32 & 1, lane as u32 >> 1 & 1);
        // What is left over helps as the last quad does.
        let quad = quads.get(lane / 4);
        let [x, y] = quad.or(quads.last()).copied().unwrap_or_default();
        *pixel = [x + right, y + up];
        let is_inside = pixel[0] < size[0] && pixel[1] < size[1];
        if quad.is_some() && is_inside {
            tile.wanted |= 1 << lane;
        }
    }
    tile
}

/// At most so many quads of a picture, by their lower left pixels: spread evenly, and in no line.
/// Those that the machine runs together are neighbours, which go the same ways more often. Other seeds
/// give other places.
pub fn quads_all_over([width, height]: [u32; 2], count: usize, seed: u32) -> Vec<[u32; 2]> {
    let cells = (count.max(1) as f64 * f64::from(width) / f64::from(height.max(1))).sqrt();
    let across = (cells.round() as u32).clamp(1, (width / 2).max(1));
    let up = (count as u32 / across).clamp(1, (height / 2).max(1));
    let side = [width / across, height / up].map(|side| side.max(1));
    let all = (0..up).flat_map(|y| (0..across).map(move |x| [x, y]));
    let mut cells: Vec<[u32; 2]> = all.collect();
    cells.sort_by_key(|[x, y]| [y / 2, x / 4, *y, *x]);
    let spread = cells.into_iter().map(|[x, y]| {
        let thrown = hash(x ^ hash(y ^ hash(seed)));
        let place = |cell: u32, side: u32, by: u32| (cell * side + by % side) & !1;
        [
            place(x, side[0], thrown & 0xffff),
            place(y, side[1], thrown >> 16),
        ]
    });
    spread.collect()
}

/// The quads of a group of 8x4 pixels.
fn quads_of(size: [u32; 2], number: u32) -> Vec<[u32; 2]> {
    let across = size[0].div_ceil(8).max(1);
    let (x, y) = (number % across * 8, number / across * 4);
    let quads = (0..8).map(|q| [x + q % 4 * 2, y + q / 4 * 2]);
    quads
        .filter(|[x, y]| *x < size[0] && *y < size[1])
        .collect()
}

/// What a machine gave for pixels, in the order in which they were asked for.
#[derive(Default)]
struct Given {
    pixels: Vec<[u32; 2]>,
    outputs: Vec<Vec<[u32; 4]>>,
    covered: Vec<bool>,
    cost: Vec<u32>,
    ran: Vec<u32>,
    turns: Vec<u32>,
}

impl Given {
    fn of(code: &Code) -> Given {
        Given {
            outputs: vec![Vec::new(); code.outputs.len()],
            ..Given::default()
        }
    }

    /// Takes over the wanted pixels of a tile.
    fn take(&mut self, machine: &Machine<'_>, code: &Code, tile: &Tile, covered: u32) {
        let wanted = (0..LANES).filter(|lane| tile.wanted >> lane & 1 == 1);
        let (cost, turns) = (machine.watched.cost(), machine.watched.turns());
        for lane in wanted.clone() {
            self.pixels.extend(tile.pixels.get(lane));
            self.covered.push(covered >> lane & 1 == 1);
            self.cost.extend(cost.get(lane));
            self.ran.push(machine.watched.ran());
            self.turns.extend(turns.get(lane));
        }
        for (slot, given) in code.outputs.iter().zip(&mut self.outputs) {
            let mut rows = [[0; LANES]; 4];
            for (row, reg) in rows.iter_mut().zip(&slot.regs) {
                *row = machine.row(*reg).bits();
            }
            for lane in wanted.clone() {
                given.push(rows.map(|row| row.get(lane).copied().unwrap_or(0)));
            }
        }
    }
}

/// Draws all pixels, with this many threads.
///
/// # Errors
/// Why the run ended before its end.
pub fn draw(draw: &Draw<'_>, threads: usize) -> Result<Drawn, Stop> {
    let size = draw.size;
    let count = size.iter().map(|n| *n as usize).product();
    let tiles = size[0].div_ceil(8) * size[1].div_ceil(4);
    let next = AtomicU32::new(0);
    let work = || -> Result<(Given, Seen), Stop> {
        let mut machine = Machine::new(draw);
        let mut given = Given::of(draw.code);
        loop {
            let number = next.fetch_add(1, Ordering::Relaxed);
            if number >= tiles {
                return Ok((given, machine.finish()));
            }
            let tile = tile_of(size, &quads_of(size, number));
            let covered = machine.run(&tile)?;
            given.take(&machine, draw.code, &tile, covered);
        }
    };
    let parts = match threads.clamp(1, tiles.max(1) as usize) {
        1 => vec![work()],
        threads => std::thread::scope(|scope| {
            let handles: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
            handles.into_iter().filter_map(|h| h.join().ok()).collect()
        }),
    };
    let mut drawn = Drawn {
        size,
        outputs: vec![vec![[0; 4]; count]; draw.code.outputs.len()],
        covered: vec![false; count],
        cost: vec![0; count],
        ran: vec![0; count],
        turns: vec![0; count],
        seen: Seen::default(),
    };
    for part in parts {
        let (given, seen) = part?;
        drawn.seen.add(seen);
        drawn.place(&given);
    }
    Ok(drawn)
}

impl Drawn {
    /// Operations of a pixel, in the mean.
    pub fn mean_cost(&self) -> f64 {
        let sum: u64 = self.cost.iter().copied().map(u64::from).sum();
        sum as f64 / self.cost.len().max(1) as f64
    }

    /// Operations of the most expensive pixel.
    pub fn most_cost(&self) -> u32 {
        self.cost.iter().copied().max().unwrap_or(0)
    }

    /// Puts pixels where they belong.
    fn place(&mut self, given: &Given) {
        for (n, [x, y]) in given.pixels.iter().enumerate() {
            let at = *y as usize * self.size[0] as usize + *x as usize;
            put(&mut self.covered, at, given.covered.get(n));
            put(&mut self.cost, at, given.cost.get(n));
            put(&mut self.ran, at, given.ran.get(n));
            put(&mut self.turns, at, given.turns.get(n));
            for (all, own) in self.outputs.iter_mut().zip(&given.outputs) {
                put(all, at, own.get(n));
            }
        }
    }
}

fn put<T: Copy>(all: &mut [T], at: usize, value: Option<&T>) {
    if let (Some(slot), Some(value)) = (all.get_mut(at), value) {
        *slot = *value;
    }
}

/// Runs the quads whose lower left pixels, of even coordinates, are given.
///
/// # Errors
/// Why the run ended before its end.
pub fn sample(draw: &Draw<'_>, quads: &[[u32; 2]]) -> Result<Sampled, Stop> {
    let mut machine = Machine::new(draw);
    let mut given = Given::of(draw.code);
    for quads in quads.chunks(LANES / 4) {
        let tile = tile_of(draw.size, quads);
        let covered = machine.run(&tile)?;
        given.take(&machine, draw.code, &tile, covered);
    }
    Ok(Sampled {
        pixels: given.pixels,
        outputs: given.outputs,
        covered: given.covered,
        cost: given.cost,
        spent: machine.spent,
        seen: machine.finish(),
    })
}
