// The breakpoints of an editor: a gutter that sets them, and lines that move with the text.
import { StateEffect, StateField, RangeSet } from '@codemirror/state';
import { GutterMarker, gutter } from '@codemirror/view';

/** Removes a breakpoint, or adds one; with a condition, replaces it. */
const change = StateEffect.define();

class Dot extends GutterMarker {
  /** @param {string} condition nothing to stop always */
  constructor(condition) {
    super();
    this.condition = condition;
  }

  eq(other) {
    return other.condition === this.condition;
  }

  toDOM() {
    const made = document.createElement('span');
    made.className = this.condition ? 'breakpoint conditional' : 'breakpoint';
    return made;
  }
}

const field = StateField.define({
  create: () => RangeSet.empty,
  update(dots, transaction) {
    let moved = dots.map(transaction.changes);
    for (const effect of transaction.effects) {
      if (!effect.is(change)) continue;
      const { at, condition } = effect.value;
      let isThere = false;
      moved.between(at, at, () => { isThere = true; });
      const add = isThere && condition === undefined ? [] : [new Dot(condition ?? '').range(at)];
      moved = moved.update({ filter: (from) => from !== at, add });
    }
    return moved;
  },
});

/**
 * Sets a breakpoint at a line, or removes it; with a condition, sets that.
 * @param {import('codemirror').EditorView} view
 * @param {number} line
 * @param {string} [condition]
 */
export function changeBreakpoint(view, line, condition) {
  if (line <= view.state.doc.lines) view.dispatch({ effects: change.of({ at: view.state.doc.line(line).from, condition }) });
}

/** The breakpoints in the order of their lines. @param {import('codemirror').EditorView} view */
export function breakpointsIn({ state }) {
  const lines = new Map();
  for (const dots = state.field(field).iter(); dots.value; dots.next()) {
    lines.set(state.doc.lineAt(dots.from).number, /** @type {Dot} */ (dots.value).condition);
  }
  return [...lines].map(([line, condition]) => ({ line, ...(condition && { condition }) }));
}

/** Whether a change of an editor changed its breakpoints. @param {import('@codemirror/view').ViewUpdate} update */
export const changesBreakpoints = (update) => update.transactions.some(({ effects }) => effects.some((effect) => effect.is(change)));

/** The gutter, which is shown while the debugger is open. */
export const breakpoints = [
  field,
  gutter({
    class: 'cm-breakpoints',
    markers: (view) => view.state.field(field),
    initialSpacer: () => new Dot(''),
    domEventHandlers: {
      mousedown(view, line) {
        changeBreakpoint(view, view.state.doc.lineAt(line.from).number);
        return true;
      },
    },
  }),
];
