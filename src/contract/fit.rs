//! Whether a value fits the uniform that it is for.

use crate::interface::Declared;
use crate::library::Boxing;
use crate::shape::Shape;

/// What is wrong with a value for a uniform, in words; `None` if it fits or if that is not known.
pub fn misfit(shape: &Shape, uniform: &Declared, boxing: Boxing) -> Option<String> {
    if uniform.is_struct() || *shape == Shape::Unknown {
        return None;
    }
    let count = uniform.ty.array;
    if count > 0 {
        return misfit_of_array(shape, uniform, count);
    }
    if uniform.is_sampler() {
        // PixiJS and p5.js also accept other sources.
        let is_wrong = matches!(
            shape,
            Shape::Number | Shape::Bool | Shape::Text | Shape::Vector(..) | Shape::Matrix(..)
        );
        return (is_wrong && *shape != Shape::Text).then(|| shape.text());
    }
    let components = uniform.components()?;
    let fits = match (shape, uniform.matrix()) {
        (Shape::Numbers(None) | Shape::Record, _) => return None,
        (Shape::Text, _) => false,
        (Shape::Number | Shape::Bool, _) => components == 1,
        (Shape::Numbers(Some(length)), _) => *length == components as usize,
        (Shape::Vector(size, name), None) => {
            // Libraries read a colour's alpha only from some classes.
            let is_long_color = name.starts_with("Color") && boxing != Boxing::Boxed;
            *size == components || is_long_color && components == 4
        }
        (Shape::Matrix(size, _), Some((columns, rows))) => {
            u32::from(columns) == *size && u32::from(rows) == *size
        }
        (Shape::Texture | Shape::Vector(..) | Shape::Matrix(..), _) => false,
        (Shape::List(..) | Shape::Unknown, _) => return None,
    };
    (!fits).then(|| shape.text())
}

fn misfit_of_array(shape: &Shape, uniform: &Declared, count: u32) -> Option<String> {
    let components = uniform.components().unwrap_or(1) as usize;
    let length = count as usize;
    let fits = match shape {
        Shape::Number | Shape::Bool => length == 1,
        Shape::Text | Shape::Vector(..) | Shape::Matrix(..) => false,
        Shape::Numbers(Some(numbers)) => {
            *numbers >= length * components && numbers % components == 0
        }
        Shape::List(values, of) => {
            let fits = match &**of {
                Shape::Vector(size, _) => *size as usize == components,
                Shape::Matrix(size, _) => (*size * *size) as usize == components,
                Shape::Numbers(Some(numbers)) => *numbers == components,
                _ => true,
            };
            fits && *values >= length
        }
        _ => true,
    };
    (!fits).then(|| shape.text())
}
