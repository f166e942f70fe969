//! The statement structure of a text: where statements start, and their nesting, derived from
//! brackets, semicolons and control-flow keywords, in all branches of the preprocessor.

use super::item::{FormatItem, ItemKind};
use super::request::Unformatted;
use shaderlint_syntax::set::TokenSet;
use shaderlint_syntax::{GroupDirective, TokenKind as T};
use std::ops::Range;

/// Maximum nesting of brackets, bodies without braces and preprocessor conditionals.
const MAX_DEPTH: usize = 200;

/// Words of the header of a function before its parameters.
const WORDS: TokenSet = TokenSet::of(&[
    T::Identifier,
    T::Type,
    T::Void,
    T::Highp,
    T::Mediump,
    T::Lowp,
    T::Const,
]);
/// Words with which a statement or declaration may start.
const BEGINS_STATEMENT: TokenSet = TokenSet::of(&[
    T::Identifier,
    T::Type,
    T::Void,
    T::Const,
    T::Uniform,
    T::In,
    T::Out,
    T::Struct,
    T::Highp,
    T::Mediump,
    T::Lowp,
    T::If,
    T::For,
    T::While,
    T::Return,
]);

/// The role of an item in its statement.
#[derive(Clone, Copy, Debug, Default)]
pub struct ItemRole {
    pub start: StatementStart,
    /// The indentation level of a line that starts with it.
    pub level: u32,
    /// The number of brackets around it within its statement, not counting the braces of blocks.
    pub depth: u32,
    /// The innermost of these brackets.
    pub bracket: Option<u32>,
    /// The matching bracket, if it is a bracket.
    pub partner: Option<u32>,
    /// The last item of the construct that starts here: a body, `else`, or the `while` of a `do`.
    pub end: Option<u32>,
    /// Whether it is the `:` of a label.
    pub is_label: bool,
}

/// The construct that starts at an item.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum StatementStart {
    /// None: the item continues a statement.
    #[default]
    Nothing,
    Statement,
    /// A `switch` label.
    Label,
    /// The body of an `if` or loop, without braces.
    Body,
    /// `else`, or the `while` of a `do`.
    Tail,
    /// The opening brace of a block that belongs to the code before it.
    Open,
    /// The closing brace of a block.
    Close,
    /// A comment between statements.
    Comment,
}

/// The role of each item. Functions whose brackets do not match are kept as they are, and why.
pub fn read(items: &mut [FormatItem]) -> (Vec<ItemRole>, Vec<Unformatted>) {
    let mut roles = vec![ItemRole::default(); items.len()];
    let mut left = Vec::new();
    if read_range(items, &mut roles, 0..items.len()).is_ok() {
        return (roles, left);
    }
    roles.fill(ItemRole::default());
    let mut starts = functions(items);
    starts.insert(0, 0);
    let ends = starts.iter().skip(1).copied().chain([items.len()]);
    for (from, to) in starts.iter().copied().zip(ends) {
        if let Err(why) = read_range(items, &mut roles, from..to) {
            left.push(why);
            let own = items.iter_mut().zip(&mut roles).skip(from).take(to - from);
            own.for_each(|(item, role)| {
                item.keeps = true;
                *role = ItemRole::default();
            });
        }
    }
    (roles, left)
}

/// Maximum number of items of the parameters of a function.
const MAX_PARAMETERS: usize = 500;

/// The items with which functions start, found without regard to the brackets around them.
fn functions(items: &[FormatItem]) -> Vec<usize> {
    let is_word = |i: &FormatItem| i.token().is_some_and(|kind| WORDS.contains(kind));
    let mut found = Vec::new();
    let mut word = 0;
    for (at, item) in items.iter().enumerate() {
        if is_word(item) {
            continue;
        }
        let words = at - std::mem::replace(&mut word, at + 1);
        if !item.is(T::LeftParen) || words < 2 {
            continue;
        }
        let rest = items.iter().skip(at).take(MAX_PARAMETERS);
        let mut tokens = rest.filter_map(FormatItem::token);
        let mut last = T::LeftParen;
        let end = tokens.find(|kind| {
            let is_end = matches!(kind, T::Semicolon | T::LeftBrace);
            last = if is_end { last } else { *kind };
            is_end
        });
        if (last, end) == (T::RightParen, Some(T::LeftBrace)) {
            found.push(at - words);
        }
    }
    found
}

/// Determines the role of each item in a range.
///
/// # Errors
/// A bracket is unmatched, or brackets nest too deeply.
fn read_range(
    items: &[FormatItem],
    roles: &mut [ItemRole],
    range: Range<usize>,
) -> Result<(), Unformatted> {
    let mut reader = StructureReader {
        items,
        roles,
        state: FrameState {
            frames: vec![OpenFrame::Block(OpenBlock::new(None, 0))],
        },
        branches: Vec::new(),
        comments: Vec::new(),
        last: range.start as u32,
        none: ItemRole::default(),
    };
    for (at, item) in items.iter().enumerate().take(range.end).skip(range.start) {
        let at = at as u32;
        match item.kind {
            ItemKind::Token(kind) => reader.token(at, kind)?,
            ItemKind::LineComment | ItemKind::BlockComment => reader.comment(at),
            ItemKind::Directive(directive) => reader.directive(at, directive)?,
            ItemKind::Idle => {}
        }
    }
    reader.finish()
}

#[derive(Clone)]
struct FrameState {
    /// The open blocks and brackets, innermost last; the first is the file.
    frames: Vec<OpenFrame>,
}

#[derive(Clone)]
enum OpenFrame {
    Block(OpenBlock),
    Bracket(Bracket),
}

#[derive(Clone)]
struct OpenBlock {
    open: Option<u32>,
    /// The indentation level of its statements.
    level: u32,
    /// Whether a label of this block precedes the current statement.
    is_labelled: bool,
    /// Whether the current statement consists of macro calls so far.
    is_call: bool,
    at: StatementPoint,
    /// The enclosing headers without braces: `if (a) for (;;) ...` has two.
    controls: Vec<ConstructKind>,
}

#[derive(Clone, Copy)]
enum StatementPoint {
    Between,
    /// In a statement; `declares` if its braces contain declarations and belong to it.
    Inside {
        declares: bool,
    },
    /// After a keyword that is followed by parentheses.
    Header(StatementHead),
    /// Where the body of the innermost header is expected.
    Body,
    Label {
        questions: u32,
    },
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum StatementHead {
    /// `if`, `for`, `while`, `switch`
    Body,
    /// The `while` after the body of a `do`.
    DoWhile,
}

#[derive(Clone, Copy)]
struct ConstructKind {
    kind: T,
    level: u32,
    /// The keyword, and the first item of its body.
    word: u32,
    body: Option<u32>,
}

#[derive(Clone)]
struct Bracket {
    open: u32,
    closer: T,
    /// The number of open brackets of its statement, including this one.
    depth: u32,
    head: Option<StatementHead>,
}

impl OpenBlock {
    fn new(open: Option<u32>, level: u32) -> OpenBlock {
        OpenBlock {
            open,
            level,
            is_labelled: false,
            is_call: false,
            at: StatementPoint::Between,
            controls: Vec::new(),
        }
    }

    /// The indentation level of a statement that starts here.
    fn statement_level(&self) -> u32 {
        self.level + u32::from(self.is_labelled)
    }
}

/// An open preprocessor conditional.
struct Branches {
    before: FrameState,
    /// The state at the end of its first branch.
    after_first: Option<FrameState>,
}

struct StructureReader<'a> {
    items: &'a [FormatItem],
    roles: &'a mut [ItemRole],
    state: FrameState,
    branches: Vec<Branches>,
    /// Comments between statements, indented like the code that follows.
    comments: Vec<u32>,
    last: u32,
    /// In place of the role of an item that does not exist.
    none: ItemRole,
}

impl StructureReader<'_> {
    fn error<R>(&self, at: u32, message: impl Into<String>) -> Result<R, Unformatted> {
        let item = self.items.get(at as usize);
        Err(Unformatted {
            span: item.map_or(shaderlint_text::Span::at(0), |i| i.span),
            message: message.into(),
        })
    }

    fn role(&mut self, at: u32) -> &mut ItemRole {
        self.roles.get_mut(at as usize).unwrap_or(&mut self.none)
    }

    fn finish(mut self) -> Result<(), Unformatted> {
        let open = self
            .state
            .frames
            .iter()
            .rev()
            .find_map(|frame| match frame {
                OpenFrame::Block(block) => block.open,
                OpenFrame::Bracket(bracket) => Some(bracket.open),
            });
        if let Some(open) = open {
            return self.error(open, "unclosed bracket");
        }
        self.assign_comments(0);
        self.assign(None);
        Ok(())
    }

    fn token(&mut self, at: u32, kind: T) -> Result<(), Unformatted> {
        if self.state.frames.len() + self.controls() > MAX_DEPTH {
            return self.error(at, "the code is nested too deeply");
        }
        match self.state.frames.last() {
            Some(OpenFrame::Bracket(_)) => self.in_bracket(at, kind),
            _ => self.in_block(at, kind),
        }?;
        self.last = at;
        Ok(())
    }

    fn controls(&self) -> usize {
        match self.state.frames.last() {
            Some(OpenFrame::Block(block)) => block.controls.len(),
            _ => 0,
        }
    }

    fn block(&mut self) -> Option<&mut OpenBlock> {
        let frames = self.state.frames.iter_mut().rev();
        frames.into_iter().find_map(|frame| match frame {
            OpenFrame::Block(block) => Some(block),
            OpenFrame::Bracket(_) => None,
        })
    }

    /// Records the brackets around an item that starts no construct.
    fn inner(&mut self, at: u32) {
        let (depth, innermost) = match self.state.frames.last() {
            Some(OpenFrame::Bracket(bracket)) => (bracket.depth, Some(bracket.open)),
            _ => (0, None),
        };
        let level = self.block().map_or(0, |b| b.statement_level());
        let role = self.role(at);
        (role.depth, role.bracket, role.level) = (depth, innermost, level);
    }

    fn open_bracket(&mut self, at: u32, kind: T, head: Option<StatementHead>) {
        self.inner(at);
        let closer = match kind {
            T::LeftParen => T::RightParen,
            T::LeftBracket => T::RightBracket,
            _ => T::RightBrace,
        };
        self.state.frames.push(OpenFrame::Bracket(Bracket {
            open: at,
            closer,
            depth: self.roles.get(at as usize).map_or(0, |r| r.depth) + 1,
            head,
        }));
    }

    fn in_bracket(&mut self, at: u32, kind: T) -> Result<(), Unformatted> {
        match kind {
            T::LeftParen | T::LeftBracket | T::LeftBrace => self.open_bracket(at, kind, None),
            T::RightParen | T::RightBracket | T::RightBrace => return self.close_bracket(at, kind),
            _ => self.inner(at),
        }
        Ok(())
    }

    fn close_bracket(&mut self, at: u32, kind: T) -> Result<(), Unformatted> {
        let Some(OpenFrame::Bracket(bracket)) = self.state.frames.last() else {
            return self.error(at, "unmatched closing bracket");
        };
        let (open, head) = (bracket.open, bracket.head);
        if bracket.closer != kind {
            return self.error(open, "unclosed bracket");
        }
        self.inner(at);
        self.role(at).partner = Some(open);
        self.role(open).partner = Some(at);
        self.state.frames.pop();
        if let (Some(head), Some(block)) = (head, self.block()) {
            block.at = match head {
                StatementHead::Body => StatementPoint::Body,
                StatementHead::DoWhile => StatementPoint::Inside { declares: false },
            };
        }
        Ok(())
    }

    fn in_block(&mut self, at: u32, kind: T) -> Result<(), Unformatted> {
        let Some(block) = self.block() else {
            return Ok(());
        };
        match block.at {
            StatementPoint::Between => self.start(at, kind),
            StatementPoint::Body => self.body(at, kind),
            StatementPoint::Header(head) if kind == T::LeftParen => {
                self.open_bracket(at, kind, Some(head));
                Ok(())
            }
            StatementPoint::Header(_) => {
                block.at = StatementPoint::Inside { declares: false };
                self.inside(at, kind, false)
            }
            StatementPoint::Inside { declares } => self.inside(at, kind, declares),
            StatementPoint::Label { questions } => {
                block.at = match (kind, questions) {
                    (T::Question, n) => StatementPoint::Label { questions: n + 1 },
                    (T::Colon, 0) => {
                        block.is_labelled = true;
                        StatementPoint::Between
                    }
                    (T::Colon, n) => StatementPoint::Label { questions: n - 1 },
                    _ => block.at,
                };
                let is_over = matches!(block.at, StatementPoint::Between);
                self.inside_label(at, kind)?;
                self.role(at).is_label = is_over;
                Ok(())
            }
        }
    }

    fn inside_label(&mut self, at: u32, kind: T) -> Result<(), Unformatted> {
        match kind {
            T::LeftParen | T::LeftBracket => self.open_bracket(at, kind, None),
            T::RightBrace => return self.close_block(at),
            _ => self.inner(at),
        }
        Ok(())
    }

    /// Continues a statement.
    fn inside(&mut self, at: u32, kind: T, declares: bool) -> Result<(), Unformatted> {
        if kind == T::Else || self.follows_macro(at, kind) {
            return self.start(at, kind);
        }
        match kind {
            T::LeftParen | T::LeftBracket => self.open_bracket(at, kind, None),
            T::LeftBrace if self.is_list() => self.open_bracket(at, kind, None),
            T::LeftBrace => {
                // A function header may contain a struct declaration.
                let last = self.items.get(self.last as usize);
                if last.is_some_and(|last| last.is(T::RightParen))
                    && let Some(block) = self.block()
                {
                    block.at = StatementPoint::Inside { declares: false };
                }
                let level = self.block().map_or(0, |b| b.statement_level());
                self.open_block(at, StatementStart::Open, level);
            }
            T::RightBrace => return self.close_block(at),
            T::RightParen | T::RightBracket => {
                return self.error(at, "unmatched closing bracket");
            }
            T::Semicolon => {
                self.inner(at);
                if let Some(block) = self.block() {
                    block.at = StatementPoint::Between;
                }
            }
            _ => {
                self.inner(at);
                let declares = declares || matches!(kind, T::Struct | T::Uniform | T::In | T::Out);
                if let Some(block) = self.block() {
                    block.at = StatementPoint::Inside { declares };
                }
            }
        }
        Ok(())
    }

    /// Whether a word starts a statement although no semicolon precedes it: after a statement that
    /// consists of macro calls.
    fn follows_macro(&mut self, at: u32, kind: T) -> bool {
        let (last, items) = (self.last, self.items);
        let item = |at: u32| items.get(at as usize);
        let last_is = |kind| item(last).is_some_and(|last| last.is(kind));
        let is_called = item(at + 1).is_some_and(|next| next.is(T::LeftParen));
        let starts_line = item(at).is_some_and(|i| i.breaks > 0);
        let is_first = self.role(last).start == StatementStart::Statement;
        let Some(block) = self.block() else {
            return false;
        };
        block.is_call &= kind == T::LeftParen || BEGINS_STATEMENT.contains(kind) && !is_first;
        block.is_call
            && starts_line
            && match kind {
                T::LeftParen => false,
                T::Identifier if last_is(T::Identifier) => is_called,
                _ => last_is(T::RightParen),
            }
    }

    /// Whether the current brace opens an initialiser list or the like.
    fn is_list(&self) -> bool {
        let last = self
            .items
            .get(self.last as usize)
            .and_then(FormatItem::token);
        matches!(last, Some(T::Equal | T::RightBracket))
    }

    /// Starts a construct where a statement may start.
    fn start(&mut self, at: u32, kind: T) -> Result<(), Unformatted> {
        let tail = self.assign(Some(kind));
        if let Some(level) = tail {
            self.set_start(at, StatementStart::Tail, level);
            let next = match kind {
                T::Else => StatementPoint::Body,
                _ => StatementPoint::Header(StatementHead::DoWhile),
            };
            self.control(at, kind, level, next);
            return Ok(());
        }
        let last = self.roles.get(self.last as usize);
        if kind == T::LeftBrace && last.is_some_and(|last| last.is_label) {
            // The block of a label is indented like any other block.
            let level = self.block().map_or(0, |b| b.level);
            self.open_block(at, StatementStart::Open, level);
            return Ok(());
        }
        let level = self.block().map_or(0, |b| b.statement_level());
        self.statement(at, kind, StatementStart::Statement, level)
    }

    fn set_start(&mut self, at: u32, start: StatementStart, level: u32) {
        self.inner(at);
        let role = self.role(at);
        (role.start, role.level) = (start, level);
        self.assign_comments(level);
    }

    /// Sets the level of the comments before a line.
    fn assign_comments(&mut self, level: u32) {
        for comment in std::mem::take(&mut self.comments) {
            self.role(comment).level = level;
        }
    }

    /// Opens a control-flow construct, after whose keyword `next` is expected.
    fn control(&mut self, at: u32, kind: T, level: u32, next: StatementPoint) {
        if let Some(block) = self.block() {
            block.controls.push(ConstructKind {
                kind,
                level,
                word: at,
                body: None,
            });
            block.at = next;
        }
    }

    fn statement(
        &mut self,
        at: u32,
        kind: T,
        start: StatementStart,
        level: u32,
    ) -> Result<(), Unformatted> {
        match kind {
            T::RightBrace => return self.close_block(at),
            T::Case | T::Default => return self.label(at),
            T::RightParen | T::RightBracket => {
                return self.error(at, "unmatched closing bracket");
            }
            _ => self.set_start(at, start, level),
        }
        match kind {
            T::LeftBrace => self.open_block(at, start, level),
            T::LeftParen | T::LeftBracket => {
                if let Some(block) = self.block() {
                    block.at = StatementPoint::Inside { declares: false };
                }
                self.open_bracket(at, kind, None);
                let role = self.role(at);
                (role.start, role.level) = (start, level);
            }
            T::Do => self.control(at, kind, level, StatementPoint::Body),
            T::If | T::For | T::While | T::Switch => {
                self.control(at, kind, level, StatementPoint::Header(StatementHead::Body));
            }
            T::Semicolon => {
                if let Some(block) = self.block() {
                    block.at = StatementPoint::Between;
                }
            }
            _ => {
                let declares = matches!(kind, T::Struct | T::Uniform | T::In | T::Out);
                if let Some(block) = self.block() {
                    block.is_call = kind == T::Identifier;
                    block.at = StatementPoint::Inside { declares };
                }
            }
        }
        Ok(())
    }

    fn label(&mut self, at: u32) -> Result<(), Unformatted> {
        let Some(block) = self.block() else {
            return Ok(());
        };
        let level = block.level;
        block.at = StatementPoint::Label { questions: 0 };
        self.set_start(at, StatementStart::Label, level);
        Ok(())
    }

    /// Starts the body of a control-flow construct.
    fn body(&mut self, at: u32, kind: T) -> Result<(), Unformatted> {
        let Some(block) = self.block() else {
            return Ok(());
        };
        let Some(control) = block.controls.last_mut() else {
            return self.statement(at, kind, StatementStart::Statement, 0);
        };
        control.body = Some(at);
        let ConstructKind {
            kind: word, level, ..
        } = *control;
        match (word, kind) {
            (_, T::LeftBrace) => {
                self.open_block(at, StatementStart::Open, level);
                Ok(())
            }
            (T::Else, T::If) => {
                self.inner(at);
                self.control(at, kind, level, StatementPoint::Header(StatementHead::Body));
                Ok(())
            }
            _ => self.statement(at, kind, StatementStart::Body, level + 1),
        }
    }

    fn open_block(&mut self, at: u32, start: StatementStart, level: u32) {
        self.set_start(at, start, level);
        let block = OpenBlock::new(Some(at), level + 1);
        self.state.frames.push(OpenFrame::Block(block));
    }

    fn close_block(&mut self, at: u32) -> Result<(), Unformatted> {
        let open = self.block().and_then(|b| b.open);
        let Some(open) = open else {
            return self.error(at, "unmatched closing bracket");
        };
        self.assign(None);
        let inner = self.block().map_or(0, |b| b.statement_level());
        self.assign_comments(inner);
        self.state.frames.pop();
        let level = self.role(open).level;
        self.set_start(at, StatementStart::Close, level);
        self.role(at).partner = Some(open);
        self.role(open).partner = Some(at);
        if let Some(block) = self.block() {
            block.at = match block.at {
                StatementPoint::Inside { declares: true } => {
                    StatementPoint::Inside { declares: true }
                }
                _ => StatementPoint::Between,
            };
        }
        Ok(())
    }

    /// Closes the control-flow constructs that end before the next token. Returns the level of the
    /// construct that continues with it (`else`, or the `while` of a `do`).
    fn assign(&mut self, next: Option<T>) -> Option<u32> {
        let owner = match next {
            Some(T::Else) => T::If,
            Some(T::While) => T::Do,
            _ => T::End,
        };
        let last = self.last;
        let block = self.block()?;
        let owner = block.controls.iter().rposition(|c| c.kind == owner);
        let keep = owner.unwrap_or(0);
        let over = block.controls.split_off(keep.min(block.controls.len()));
        let level = owner.and_then(|_| over.first()).map(|c| c.level);
        for control in over {
            if let Some(body) = control.body {
                self.role(body).end = Some(last);
            }
            self.role(control.word).end = Some(last);
        }
        level
    }

    fn comment(&mut self, at: u32) {
        self.inner(at);
        let is_between = match self.state.frames.last() {
            Some(OpenFrame::Block(block)) => {
                matches!(
                    block.at,
                    StatementPoint::Between | StatementPoint::Body | StatementPoint::Header(_)
                )
            }
            _ => false,
        };
        if is_between {
            self.role(at).start = StatementStart::Comment;
            self.comments.push(at);
        }
    }

    fn directive(&mut self, at: u32, directive: Option<GroupDirective>) -> Result<(), Unformatted> {
        self.inner(at);
        let level = self.role(at).level;
        self.assign_comments(level);
        match directive {
            Some(GroupDirective::Opens) if self.branches.len() > MAX_DEPTH => {
                return self.error(at, "`#if` groups are nested too deeply");
            }
            Some(GroupDirective::Opens) => self.branches.push(Branches {
                before: self.state.clone(),
                after_first: None,
            }),
            Some(GroupDirective::Alternates) => {
                if let Some(branches) = self.branches.last_mut() {
                    let end = std::mem::replace(&mut self.state, branches.before.clone());
                    branches.after_first.get_or_insert(end);
                }
            }
            Some(GroupDirective::Closes) => {
                if let Some(first) = self.branches.pop().and_then(|b| b.after_first) {
                    self.state = first;
                }
            }
            None => {}
        }
        Ok(())
    }
}
