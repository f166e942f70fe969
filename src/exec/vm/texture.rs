//! Texture lookup instructions.

use super::Vm;
use crate::bytecode::{LookupQuery, LookupSite, Reg};
use crate::image::lookup::{fetch, lookup, size_of};
use crate::image::{LevelOf, Texture, TextureLookup};
use crate::row::{LANES, Row};

impl Vm<'_> {
    /// Executes a lookup.
    pub(super) fn ask(&mut self, site: u32) {
        let code = self.code;
        let Some(site) = code.lookups.get(site as usize) else {
            return;
        };
        let texture = self.draw.textures.get(site.sampler as usize);
        let answer: [[u32; LANES]; 4] = match texture.and_then(Option::as_ref) {
            Some(texture) => self.answer(site, texture),
            None => self.nothing(site),
        };
        for (reg, bits) in site.results.iter().zip(answer) {
            self.set(*reg, Row(bits));
        }
    }

    /// The result for a sampler without a texture: opaque black.
    fn nothing(&self, site: &LookupSite) -> [[u32; LANES]; 4] {
        let sampler = self.code.samplers.get(site.sampler as usize);
        let is_integer = sampler.is_some_and(|s| {
            let name = s.sampler.name();
            name.starts_with('i') || name.starts_with('u')
        });
        let one = if is_integer { 1 } else { 1.0f32.to_bits() };
        match site.query {
            LookupQuery::Size => [[1; LANES]; 4],
            _ => [[0; LANES], [0; LANES], [0; LANES], [one; LANES]],
        }
    }

    fn answer(&self, site: &LookupSite, texture: &Texture) -> [[u32; LANES]; 4] {
        let floats = |regs: &[Reg]| {
            regs.iter()
                .map(|r| self.row(*r).floats())
                .collect::<Vec<_>>()
        };
        let ints = |reg: &Reg| self.row(*reg).0.map(|n| n as i32);
        let zero = [0; LANES];
        match site.query {
            LookupQuery::Size => {
                let level = site.level.first().map_or(zero, ints);
                let [x, y, z] = size_of(texture, &level).map(|row| row.map(|n| n as u32));
                [x, y, z, [0; LANES]]
            }
            LookupQuery::Fetch => {
                let texel: Vec<_> = site.coordinates.iter().map(ints).collect();
                let level = site.level.first().map_or(zero, ints);
                fetch(texture, &texel, &level, site.offset, self.active)
            }
            LookupQuery::Implicit | LookupQuery::Explicit | LookupQuery::Gradient => {
                let coordinates = floats(&site.coordinates);
                let level = floats(&site.level);
                let reference = site.reference.map(|r| self.row(r).floats());
                let none = [0.0; LANES];
                let (x, y) = level.split_at(level.len() / 2);
                let level = match site.query {
                    LookupQuery::Implicit => LevelOf::Implicit {
                        bias: level.first(),
                    },
                    LookupQuery::Gradient => LevelOf::Gradient { x, y },
                    _ => LevelOf::Explicit(level.first().unwrap_or(&none)),
                };
                let asked = TextureLookup {
                    coordinates: &coordinates,
                    reference: reference.as_ref(),
                    level,
                    offset: site.offset,
                };
                lookup(texture, &asked, self.active)
            }
        }
    }
}
