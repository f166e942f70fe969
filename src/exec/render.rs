//! Renders a draw call: the whole image, or sampled quads of it.

use super::bytecode::{Bytecode, OutputSlot};
use super::draw::{Draw, Stop};
use super::observations::Observations;
use super::row::LANES;
use super::vm::{Tile, Vm};
use shaderlint_math::{bits_of, hash};
use shaderlint_semantic::Scalar;
use shaderlint_text::SetAt;
use std::sync::Mutex;

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
pub(super) fn tile_of(size: [u32; 2], quads: &[[u32; 2]]) -> Tile {
    let mut tile = Tile::default();
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

/// The width and height of a group of pixels, a tile of a complete image.
const GROUP: [usize; 2] = [8, 4];

/// By row and column in a group: the lane.
#[expect(clippy::indexing_slicing, reason = "evaluated by the compiler")]
const LANE_AT: [[usize; GROUP[0]]; GROUP[1]] = {
    let mut lanes = [[0; GROUP[0]]; GROUP[1]];
    let mut at = 0;
    while at < LANES {
        let (x, y) = (at % GROUP[0], at / GROUP[0]);
        lanes[y][x] = 16 * (y / 2) + 4 * (x / 2) + 2 * (y % 2) + x % 2;
        at += 1;
    }
    lanes
};

/// The tile of the group of pixels with this lower left pixel.
fn group_at(size: [u32; 2], [left, below]: [u32; 2]) -> Tile {
    let mut tile = Tile::default();
    let is_inside = |[x, y]: [u32; 2]| x < size[0] && y < size[1];
    // Quads outside of the image duplicate the last one inside as helper lanes.
    let mut last = [left, below];
    for (lane, pixel) in (0..).zip(&mut tile.pixels) {
        let quad = [left + lane / 4 % 4 * 2, below + lane / 16 * 2];
        let offset = [lane & 1, lane >> 1 & 1];
        if is_inside(quad) {
            last = quad;
        }
        *pixel = [last[0] + offset[0], last[1] + offset[1]];
        if last == quad && is_inside(*pixel) {
            tile.requested |= 1 << lane;
        }
    }
    tile
}

/// The part of an image that a row of groups draws.
struct Band<'d> {
    /// By output.
    outputs: Vec<&'d mut [[u32; 4]]>,
    covered: &'d mut [bool],
    cost: &'d mut [u32],
    ran: &'d mut [u32],
    iterations: &'d mut [u32],
}

impl Band<'_> {
    /// Draws all groups.
    fn draw(&mut self, vm: &mut Vm<'_>, draw: &Draw<'_>, below: u32) -> Result<(), Stop> {
        for left in (0..draw.size[0]).step_by(GROUP[0]) {
            let covered = vm.run(&group_at(draw.size, [left, below]))?;
            self.take(vm, draw, left as usize, covered);
        }
        Ok(())
    }

    /// Copies the results of the group at a column.
    fn take(&mut self, vm: &Vm<'_>, draw: &Draw<'_>, left: usize, covered: u32) {
        let place = (draw.size[0] as usize, left);
        let (cost, iterations) = (vm.watched.cost(), vm.watched.iterations());
        let ran = vm.watched.ran;
        put(self.covered, place, |lane| covered >> lane & 1 == 1);
        put(self.cost, place, |lane| at(&cost, lane));
        put(self.ran, place, |_| ran);
        put(self.iterations, place, |lane| at(&iterations, lane));
        for (slot, output) in draw.code.outputs.iter().zip(&mut self.outputs) {
            let rows = scalars_of(vm, slot);
            put(output, place, |lane| {
                rows.each_ref().map(|row| at(row, lane))
            });
        }
    }
}

/// Sets the pixels of the group at a column of a band.
#[inline(always)]
fn put<T>(band: &mut [T], (width, left): (usize, usize), value: impl Fn(usize) -> T) {
    for (row, lanes) in band.chunks_mut(width).zip(&LANE_AT) {
        for (slot, lane) in row.iter_mut().skip(left).zip(lanes) {
            *slot = value(*lane);
        }
    }
}

#[inline(always)]
fn at(row: &[u32; LANES], lane: usize) -> u32 {
    row.get(lane).copied().unwrap_or(0)
}

/// The first four scalars of an output; every NaN has the same bits.
fn scalars_of(vm: &Vm<'_>, slot: &OutputSlot) -> [[u32; LANES]; 4] {
    let is_float = slot.ty.scalar_kind() == Some(Scalar::Float);
    let mut rows = [[0; LANES]; 4];
    for (row, reg) in rows.iter_mut().zip(&slot.regs) {
        *row = vm.row(*reg).0;
        if is_float {
            *row = row.map(|bits| bits_of(f32::from_bits(bits)));
        }
    }
    rows
}

/// Renders all pixels with `threads` threads.
///
/// # Errors
/// Why the run was aborted.
pub fn draw(draw: &Draw<'_>, threads: usize) -> Result<Drawn, Stop> {
    let size = draw.size;
    let count = size.iter().map(|n| *n as usize).product();
    let mut drawn = Drawn {
        size,
        outputs: vec![vec![[0; 4]; count]; draw.code.outputs.len()],
        covered: vec![false; count],
        cost: vec![0; count],
        ran: vec![0; count],
        iterations: vec![0; count],
        seen: Observations::default(),
    };
    let bands = drawn.bands();
    let threads = threads.clamp(1, bands.len().max(1));
    let next = Mutex::new((0..).step_by(GROUP[1]).zip(bands));
    let work = || -> Result<Observations, Stop> {
        let mut vm = Vm::new(draw);
        loop {
            let Some((below, mut band)) = next.lock().ok().and_then(|mut next| next.next()) else {
                return Ok(vm.finish());
            };
            if draw.is_cancelled() {
                return Err(Stop::Cancelled);
            }
            band.draw(&mut vm, draw, below)?;
        }
    };
    let parts = match threads {
        1 => vec![work()],
        threads => std::thread::scope(|scope| {
            let handles: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
            handles.into_iter().filter_map(|h| h.join().ok()).collect()
        }),
    };
    let mut seen = Observations::default();
    for part in parts {
        seen.add(part?);
    }
    drop(next);
    drawn.seen = seen;
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

    /// The bands of the image, from below.
    fn bands(&mut self) -> Vec<Band<'_>> {
        let len = (GROUP[1] * self.size[0] as usize).max(1);
        let mut outputs: Vec<_> = self.outputs.iter_mut().map(|o| o.chunks_mut(len)).collect();
        let covered = self.covered.chunks_mut(len);
        let counts = self.cost.chunks_mut(len).zip(self.ran.chunks_mut(len));
        let all = covered.zip(counts).zip(self.iterations.chunks_mut(len));
        let bands = all.map(|((covered, (cost, ran)), iterations)| Band {
            outputs: outputs.iter_mut().filter_map(Iterator::next).collect(),
            covered,
            cost,
            ran,
            iterations,
        });
        bands.collect()
    }
}

impl Sampled {
    /// Room for some pixels.
    fn with_room(code: &Bytecode, count: usize) -> Sampled {
        Sampled {
            pixels: Vec::with_capacity(count),
            outputs: vec![Vec::with_capacity(count); code.outputs.len()],
            covered: Vec::with_capacity(count),
            cost: Vec::with_capacity(count),
            spent: 0,
            seen: Observations::default(),
        }
    }

    /// The requested pixels of a tile, without statistics.
    pub(super) fn of(vm: &Vm<'_>, code: &Bytecode, tile: &Tile, covered: u32) -> Sampled {
        let mut sampled = Sampled::with_room(code, 1);
        sampled.take(vm, code, tile, covered);
        sampled
    }

    /// Adds the requested pixels of a tile.
    fn take(&mut self, vm: &Vm<'_>, code: &Bytecode, tile: &Tile, covered: u32) {
        let requested = (0..LANES).filter(|lane| tile.requested >> lane & 1 == 1);
        let cost = vm.watched.cost();
        for lane in requested.clone() {
            self.pixels.extend(tile.pixels.get(lane));
            self.covered.push(covered >> lane & 1 == 1);
            self.cost.push(at(&cost, lane));
        }
        for (slot, output) in code.outputs.iter().zip(&mut self.outputs) {
            let rows = scalars_of(vm, slot);
            let pixel = |lane: usize| rows.each_ref().map(|row| at(row, lane));
            output.extend(requested.clone().map(pixel));
        }
    }

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
    let mut sampled = Sampled::with_room(draw.code, quads.len() * 4);
    for quads in quads.chunks(LANES / 4) {
        let tile = tile_of(draw.size, quads);
        let covered = vm.run(&tile)?;
        sampled.take(&vm, draw.code, &tile, covered);
    }
    sampled.spent = vm.spent;
    sampled.seen = vm.finish();
    Ok(sampled)
}

/// Runs cases, each at its pixel: 32 at a time, or 8 if the code takes derivatives, because all
/// pixels of a quad then need the same case.
///
/// # Errors
/// Why the run was aborted.
pub fn sample_cases(draw: &Draw<'_>, pixels: &[[u32; 2]]) -> Result<Sampled, Stop> {
    let mut vm = Vm::new(draw);
    let mut sampled = Sampled::with_room(draw.code, pixels.len());
    let has_quads = draw.code.takes_derivatives();
    let lanes_per_case = if has_quads { 4 } else { 1 };
    let mut first = 0_u32;
    for chunk in pixels.chunks(LANES / lanes_per_case) {
        let mut tile = match has_quads {
            true => {
                let quads: Vec<[u32; 2]> = chunk.iter().map(|p| p.map(|c| c & !1)).collect();
                tile_of(draw.size, &quads)
            }
            false => tile_of(draw.size, &[]),
        };
        tile.requested = 0;
        let last = chunk.len().saturating_sub(1);
        for lane in 0..LANES {
            let at = (lane / lanes_per_case).min(last);
            let pixel = chunk.get(at).copied().unwrap_or_default();
            tile.cases.set_at(lane, first + at as u32);
            let own = (pixel[1] & 1) << 1 | pixel[0] & 1;
            let is_own = match has_quads {
                true => own as usize == lane % 4,
                false => {
                    tile.pixels
                        .get_mut(lane)
                        .into_iter()
                        .for_each(|p| *p = pixel);
                    true
                }
            };
            if is_own && lane / lanes_per_case < chunk.len() {
                tile.requested |= 1 << lane;
            }
        }
        let covered = vm.run(&tile)?;
        sampled.take(&vm, draw.code, &tile, covered);
        first += chunk.len() as u32;
    }
    sampled.spent = vm.spent;
    sampled.seen = vm.finish();
    Ok(sampled)
}
