//! Renders a draw call: the whole image, or sampled quads of it.

use super::bytecode::Bytecode;
use super::draw::{Draw, Stop};
use super::observations::Observations;
use super::row::LANES;
use super::vm::{Tile, Vm};
use shaderlint_math::hash;
use std::sync::atomic::{AtomicU32, Ordering};

/// A rendered image. Rows are ordered bottom to top, like `gl_FragCoord`.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// By output and pixel: the first four scalars, as bits.
    pub outputs: Vec<Vec<[u32; 4]>>,
    /// By pixel: whether it was drawn and not discarded.
    pub covered: Vec<bool>,
    /// By pixel: the number of operations in which it was active.
    pub cost: Vec<u32>,
    /// By pixel: the number of operations that its group of 8x4 pixels executed; an operation
    /// counts once, however many pixels are active.
    pub ran: Vec<u32>,
    /// By pixel: the number of loop iterations, if the shader was compiled with
    /// [`Watch::Flow`](crate::Watch::Flow).
    pub iterations: Vec<u32>,
    /// The statistics of the run.
    pub seen: Observations,
}

/// Sampled pixels: four per quad, in lane order.
#[derive(Clone, Debug)]
pub struct Sampled {
    /// The coordinates of each pixel.
    pub pixels: Vec<[u32; 2]>,
    /// By output and pixel: the first four scalars, as bits.
    pub outputs: Vec<Vec<[u32; 4]>>,
    /// By pixel: whether it was drawn and not discarded.
    pub covered: Vec<bool>,
    /// By pixel: the number of operations in which it was active.
    pub cost: Vec<u32>,
    /// The number of instructions executed.
    pub spent: u64,
    /// The statistics of the run.
    pub seen: Observations,
}

/// The tile of up to eight quads, given by their lower left pixels.
fn tile_of(size: [u32; 2], quads: &[[u32; 2]]) -> Tile {
    let mut tile = Tile {
        pixels: [[0; 2]; LANES],
        requested: 0,
    };
    for (lane, pixel) in tile.pixels.iter_mut().enumerate() {
        let (right, up) = (lane as u32 & 1, lane as u32 >> 1 & 1);
        // Unused lanes duplicate the last quad as helper lanes.
        let quad = quads.get(lane / 4);
        let [x, y] = quad.or(quads.last()).copied().unwrap_or_default();
        *pixel = [x + right, y + up];
        let is_inside = pixel[0] < size[0] && pixel[1] < size[1];
        if quad.is_some() && is_inside {
            tile.requested |= 1 << lane;
        }
    }
    tile
}

/// Up to `count` quads of an image, by their lower left pixels: spread evenly by jittered
/// (stratified) sampling. Quads that share a tile are neighbours, so that they diverge less. `seed`
/// varies the positions.
pub fn quads_all_over([width, height]: [u32; 2], count: usize, seed: u32) -> Vec<[u32; 2]> {
    let cells = (count.max(1) as f64 * f64::from(width) / f64::from(height.max(1))).sqrt() as u32;
    // Of the two nearest numbers of columns, the one that leaves out fewer quads.
    let used = |across: &u32| count as u32 / across.max(&1) * across;
    let columns = [cells, cells + 1].into_iter().max_by_key(used);
    let across = columns.unwrap_or(1).clamp(1, (width / 2).max(1));
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
fn quads_of(size: [u32; 2], index: u32) -> Vec<[u32; 2]> {
    let across = size[0].div_ceil(8).max(1);
    let (x, y) = (index % across * 8, index / across * 4);
    let quads = (0..8).map(|q| [x + q % 4 * 2, y + q / 4 * 2]);
    quads
        .filter(|[x, y]| *x < size[0] && *y < size[1])
        .collect()
}

/// The results of a thread, in the order of the requested pixels.
#[derive(Default)]
struct PixelResults {
    pixels: Vec<[u32; 2]>,
    outputs: Vec<Vec<[u32; 4]>>,
    covered: Vec<bool>,
    cost: Vec<u32>,
    ran: Vec<u32>,
    iterations: Vec<u32>,
}

impl PixelResults {
    fn of(code: &Bytecode) -> PixelResults {
        PixelResults {
            outputs: vec![Vec::new(); code.outputs.len()],
            ..PixelResults::default()
        }
    }

    /// Copies the wanted pixels of a tile.
    fn take(&mut self, vm: &Vm<'_>, code: &Bytecode, tile: &Tile, covered: u32) {
        let requested = (0..LANES).filter(|lane| tile.requested >> lane & 1 == 1);
        let (cost, iterations) = (vm.watched.cost(), vm.watched.iterations());
        for lane in requested.clone() {
            self.pixels.extend(tile.pixels.get(lane));
            self.covered.push(covered >> lane & 1 == 1);
            self.cost.extend(cost.get(lane));
            self.ran.push(vm.watched.ran());
            self.iterations.extend(iterations.get(lane));
        }
        for (slot, given) in code.outputs.iter().zip(&mut self.outputs) {
            let mut rows = [[0; LANES]; 4];
            for (row, reg) in rows.iter_mut().zip(&slot.regs) {
                *row = vm.row(*reg).bits();
            }
            for lane in requested.clone() {
                given.push(rows.map(|row| row.get(lane).copied().unwrap_or(0)));
            }
        }
    }
}

/// Renders all pixels with `threads` threads.
///
/// # Errors
/// Why the run was aborted.
pub fn draw(draw: &Draw<'_>, threads: usize) -> Result<Drawn, Stop> {
    let size = draw.size;
    let count = size.iter().map(|n| *n as usize).product();
    let tiles = size[0].div_ceil(8) * size[1].div_ceil(4);
    let next = AtomicU32::new(0);
    let work = || -> Result<(PixelResults, Observations), Stop> {
        let mut vm = Vm::new(draw);
        let mut given = PixelResults::of(draw.code);
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            if index >= tiles {
                return Ok((given, vm.finish()));
            }
            let tile = tile_of(size, &quads_of(size, index));
            let covered = vm.run(&tile)?;
            given.take(&vm, draw.code, &tile, covered);
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
        iterations: vec![0; count],
        seen: Observations::default(),
    };
    for part in parts {
        let (given, seen) = part?;
        drawn.seen.add(seen);
        drawn.place(&given);
    }
    Ok(drawn)
}

impl Drawn {
    /// Operations per pixel, on average.
    pub fn mean_cost(&self) -> f64 {
        let sum: u64 = self.cost.iter().copied().map(u64::from).sum();
        sum as f64 / self.cost.len().max(1) as f64
    }

    /// Operations of the most expensive pixel.
    pub fn most_cost(&self) -> u32 {
        self.cost.iter().copied().max().unwrap_or(0)
    }

    /// Copies pixels to their positions in the image.
    fn place(&mut self, given: &PixelResults) {
        for (n, [x, y]) in given.pixels.iter().enumerate() {
            let at = *y as usize * self.size[0] as usize + *x as usize;
            put(&mut self.covered, at, given.covered.get(n));
            put(&mut self.cost, at, given.cost.get(n));
            put(&mut self.ran, at, given.ran.get(n));
            put(&mut self.iterations, at, given.iterations.get(n));
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

impl Sampled {
    /// Adds more pixels of the same draw.
    pub fn add(&mut self, more: Sampled) {
        self.pixels.extend(more.pixels);
        for (own, more) in self.outputs.iter_mut().zip(more.outputs) {
            own.extend(more);
        }
        self.covered.extend(more.covered);
        self.cost.extend(more.cost);
        self.spent += more.spent;
        self.seen.add(more.seen);
    }
}

/// Runs some quads, given by their lower left pixels, which have even coordinates.
///
/// # Errors
/// Why the run was aborted.
pub fn sample(draw: &Draw<'_>, quads: &[[u32; 2]]) -> Result<Sampled, Stop> {
    let mut vm = Vm::new(draw);
    let mut given = PixelResults::of(draw.code);
    for quads in quads.chunks(LANES / 4) {
        let tile = tile_of(draw.size, quads);
        let covered = vm.run(&tile)?;
        given.take(&vm, draw.code, &tile, covered);
    }
    Ok(Sampled {
        pixels: given.pixels,
        outputs: given.outputs,
        covered: given.covered,
        cost: given.cost,
        spent: vm.spent,
        seen: vm.finish(),
    })
}
