//! Whether a value fits the uniform that it is for.

use crate::interface::DeclaredInput;
use crate::library::Boxing;
use crate::shape::ValueShape;

/// What is wrong with a value for a uniform, in words; `None` if it fits or if that is not known.
pub fn misfit(shape: &ValueShape, uniform: &DeclaredInput, boxing: Boxing) -> Option<String> {
    if uniform.is_struct() || *shape == ValueShape::Unknown {
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
            ValueShape::Number
                | ValueShape::Bool
                | ValueShape::Text
                | ValueShape::Vector(..)
                | ValueShape::Matrix(..)
        );
        return (is_wrong && *shape != ValueShape::Text).then(|| shape.text());
    }
    let components = uniform.components()?;
    let fits = match (shape, uniform.matrix()) {
        (ValueShape::Numbers(None) | ValueShape::Record, _) => return None,
        (ValueShape::Text, _) => false,
        (ValueShape::Number | ValueShape::Bool, _) => components == 1,
        (ValueShape::Numbers(Some(length)), _) => *length == components as usize,
        (ValueShape::Vector(size, name), None) => {
            // Libraries read a colour's alpha only from some classes.
            let is_long_color = name.starts_with("Color") && boxing != Boxing::Boxed;
            *size == components || is_long_color && components == 4
        }
        (ValueShape::Matrix(size, _), Some((columns, rows))) => {
            u32::from(columns) == *size && u32::from(rows) == *size
        }
        (ValueShape::Texture | ValueShape::Vector(..) | ValueShape::Matrix(..), _) => false,
        (ValueShape::List(..) | ValueShape::Unknown, _) => return None,
    };
    (!fits).then(|| shape.text())
}

fn misfit_of_array(shape: &ValueShape, uniform: &DeclaredInput, count: u32) -> Option<String> {
    let components = uniform.components().unwrap_or(1) as usize;
    let length = count as usize;
    let fits = match shape {
        ValueShape::Number | ValueShape::Bool => length == 1,
        ValueShape::Text | ValueShape::Vector(..) | ValueShape::Matrix(..) => false,
        ValueShape::Numbers(Some(numbers)) => {
            *numbers >= length * components && numbers % components == 0
        }
        ValueShape::List(values, of) => {
            let fits = match &**of {
                ValueShape::Vector(size, _) => *size as usize == components,
                ValueShape::Matrix(size, _) => (*size * *size) as usize == components,
                ValueShape::Numbers(Some(numbers)) => *numbers == components,
                _ => true,
            };
            fits && *values >= length
        }
        _ => true,
    };
    (!fits).then(|| shape.text())
}
