//! Where a value was copied from, bit for bit; and whether two expressions are written alike.

use super::Evaluator;
use super::places::{PlaceId, Written, swizzle};
use crate::semantic::{BuiltinId, Program, Resolution};
use crate::syntax::ast::*;
use rustc_hash::FxHashSet;
use std::rc::Rc;

/// Most copies that are followed for one question, and most writes to one place.
const MAX_COPIES: usize = 200;

/// Where a value comes from when all copies are taken back.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum Origin {
    /// A constant, by its bits.
    Constant(u32),
    /// A component of a variable or member.
    Place(PlaceId, u8),
    /// A component of what a texture holds.
    Texture,
}

/// All that a value may be a copy of.
pub(super) type Origins = FxHashSet<Origin>;

impl Evaluator<'_> {
    /// Whether two numbers may be copies of one value, so that comparing them is exact: a variable
    /// and a constant that was put into it, or the least of two distances and one of the two.
    pub fn may_be_copies(&self, a: ExprId, b: ExprId, component: u8) -> bool {
        let left = self.origins(a, component);
        let right = self.origins(b, component);
        let is_whole = |o: &Origin| matches!(o, Origin::Constant(bits) if f32::from_bits(*bits).fract() == 0.0);
        // A flag that another pass or the keyboard has put into a texture.
        let stored = |x: &Origins, y: &Origins| {
            x.contains(&Origin::Texture) && (y.iter().any(is_whole) || y.contains(&Origin::Texture))
        };
        let exact = |e| self.component(e, component).exact;
        !left.is_disjoint(&right)
            || stored(&left, &right)
            || stored(&right, &left)
            || (left.contains(&Origin::Texture) && exact(b))
            || (right.contains(&Origin::Texture) && exact(a))
    }

    /// What an expression may be a copy of. Of a place it is found out once: many questions are
    /// about the same one.
    fn origins(&self, expr: ExprId, component: u8) -> Rc<Origins> {
        let Some(key) = self.place_of(expr, component) else {
            return Rc::new(self.copied(expr, component));
        };
        let known = self.ranges.origins.borrow().get(&key).cloned();
        known.unwrap_or_else(|| {
            let found = Rc::new(self.copied(expr, component));
            self.ranges.origins.borrow_mut().insert(key, found.clone());
            found
        })
    }

    /// The place, and its component, whose value an expression is; `None` for a known constant.
    fn place_of(&self, expr: ExprId, component: u8) -> Option<(PlaceId, u8)> {
        let program = self.program;
        if !program.values(expr).is_empty() {
            return None;
        }
        let component = match program.ty(expr).element().components() {
            1 => 0,
            _ => component,
        };
        match self.ranges.places.named(program, expr)? {
            (place, None) => Some((place, component)),
            (place, Some(components)) => Some((place, components.at(component)?)),
        }
    }

    fn copied(&self, expr: ExprId, component: u8) -> Origins {
        let mut found = FxHashSet::default();
        let mut seen = FxHashSet::default();
        let mut todo = vec![(expr, component)];
        while let Some(next) = todo.pop() {
            if seen.len() > MAX_COPIES {
                break;
            }
            if !seen.insert(next) {
                continue;
            }
            self.origin(next.0, next.1, &mut todo, &mut found);
        }
        found
    }

    fn origin(
        &self,
        expr: ExprId,
        component: u8,
        todo: &mut Vec<(ExprId, u8)>,
        found: &mut Origins,
    ) {
        let program = self.program;
        let component = match program.ty(expr).element().components() {
            1 => 0,
            _ => component,
        };
        let values = program.values(expr);
        if let Some(value) = values.get(component as usize) {
            let value = value.as_float();
            // 0.0 and -0.0 are equal.
            found.insert(Origin::Constant((value + 0.0).to_bits()));
            return;
        }
        match program.tree.expr(expr).kind {
            ExprKind::Paren(inner) | ExprKind::Assign(None, _, inner) => {
                todo.push((inner, component));
            }
            ExprKind::Ternary(_, a, b) => todo.extend([(a, component), (b, component)]),
            ExprKind::Member(object, name) => match swizzle(program, object, name) {
                Some(components) => todo.extend(components.at(component).map(|c| (object, c))),
                None => {
                    let place = self.ranges.places.field(program, object, name);
                    self.place_origin(place, component, todo, found);
                }
            },
            ExprKind::Name(_) => {
                let place = program.variable_of(expr).map(|v| PlaceId(v.0));
                self.place_origin(place, component, todo, found);
            }
            ExprKind::Index(object, _) if program.ty(object).is_array() => {
                todo.push((object, component));
            }
            ExprKind::Index(object, _) => todo.extend((0..4).map(|c| (object, c))),
            ExprKind::Construct(_, args) => {
                let mut before = 0;
                let args = program.tree.args(args);
                for &arg in args {
                    let count = program.ty(arg).components();
                    let at = component as u32;
                    if program.ty(expr).is_array() || (args.len() == 1 && count == 1) {
                        todo.push((arg, component));
                    } else if before <= at && at < before + count {
                        todo.push((arg, (at - before) as u8));
                    }
                    before += count;
                }
            }
            ExprKind::Call(_, args) => match program.expr(expr).resolution {
                Resolution::Function(callee) => {
                    let returns = self.ranges.places.returns(callee).iter();
                    todo.extend(returns.map(|&e| (e, component)));
                }
                Resolution::Builtin(_) => {
                    let args = program.tree.args(args);
                    match program.builtin_called(expr) {
                        Some(BuiltinId::Min | BuiltinId::Max | BuiltinId::Clamp) => {
                            todo.extend(args.iter().map(|&a| (a, component)));
                        }
                        Some(BuiltinId::Mix) => {
                            todo.extend(args.iter().take(2).map(|&a| (a, component)));
                        }
                        Some(BuiltinId::Abs | BuiltinId::Sign | BuiltinId::Step) => {
                            todo.extend(args.last().map(|&a| (a, component)))
                        }
                        Some(function) if function.kind().is_texture() => {
                            found.insert(Origin::Texture);
                        }
                        _ => {}
                    }
                }
                _ => {}
            },
            _ => {}
        }
    }

    fn place_origin(
        &self,
        place: Option<PlaceId>,
        component: u8,
        todo: &mut Vec<(ExprId, u8)>,
        found: &mut Origins,
    ) {
        let Some(place) = place else { return };
        // What an out argument takes back is the callee's parameter.
        let mut places = vec![place];
        while let Some(place) = places.pop() {
            if found.len() > MAX_COPIES || !found.insert(Origin::Place(place, component)) {
                continue;
            }
            let writes = self.ranges.places.writes(place);
            let passed_by = writes.len().saturating_sub(MAX_COPIES);
            for write in writes.iter().skip(passed_by) {
                let at = match write.to {
                    Some(to) => to.position(component),
                    None => Some(component),
                };
                match (write.value, at) {
                    (Written::Value(value), Some(at)) => todo.push((value, at)),
                    (Written::Copy(from), Some(_)) => places.push(from),
                    _ => {}
                }
            }
        }
    }
}

/// See [`super::is_same`]; `budget` is how many nodes may be looked at.
pub fn is_same(program: &Program, a: ExprId, b: ExprId, budget: &mut u32) -> bool {
    let (a, b) = (program.tree.unparen(a), program.tree.unparen(b));
    if *budget == 0 {
        return false;
    }
    *budget -= 1;
    let mut same = |a: ExprId, b: ExprId| is_same(program, a, b, budget);
    match (program.tree.expr(a).kind, program.tree.expr(b).kind) {
        (ExprKind::Name(_), ExprKind::Name(_)) => {
            program.variable_of(a).is_some() && program.variable_of(a) == program.variable_of(b)
        }
        (ExprKind::Int(a), ExprKind::Int(b)) => a == b,
        (ExprKind::Uint(a), ExprKind::Uint(b)) => a == b,
        (ExprKind::Float(a), ExprKind::Float(b)) => a.to_bits() == b.to_bits(),
        (ExprKind::Unary(op, a), ExprKind::Unary(other, b)) => {
            op == other && !op.assigns() && same(a, b)
        }
        (ExprKind::Binary(op, a, b), ExprKind::Binary(other, c, d)) => {
            op == other && same(a, c) && same(b, d)
        }
        (ExprKind::Member(a, name), ExprKind::Member(b, other)) => name == other && same(a, b),
        (ExprKind::Index(a, i), ExprKind::Index(b, j)) => same(a, b) && same(i, j),
        (ExprKind::Call(_, args), ExprKind::Call(_, others)) => {
            let is_pure = matches!(program.expr(a).resolution, Resolution::Builtin(_));
            let resolution = program.expr(a).resolution == program.expr(b).resolution;
            let (args, others) = (program.tree.args(args), program.tree.args(others));
            is_pure
                && resolution
                && args.len() == others.len()
                && args.iter().zip(others).all(|(&a, &b)| same(a, b))
        }
        _ => false,
    }
}
