//! Words: what is said of what does not fit, and the edit that mends it.
//!
//! The checker decides; what stands here reads what it found out so far, and changes nothing of it.

mod arguments;
mod foreign;
mod mismatch;
mod names;
mod overload;
mod place;
mod resize;

use super::builtins::{Builtins, MAX_PARAMS, Stage};
use super::checker::{Checker, Misfit};
use super::host::Entry;
use super::program::*;
use super::scope::Binding;
use super::types::*;
use crate::diagnostic::{Diagnostic, Fix, error};
use crate::syntax::ast::*;
use crate::syntax::{Feature, Name, Token, TokenKind, Version};
use crate::text::{Edit, Span};
