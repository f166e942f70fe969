// The values of a traced pixel at the ends of the lines that wrote them.
import { StateEffect, StateField } from '@codemirror/state';
import { Decoration, EditorView, WidgetType } from '@codemirror/view';

/** Longest text at the end of a line. */
const LONGEST = 72;

class Values extends WidgetType {
  /** @param {string} text @param {boolean} isInvalid */
  constructor(text, isInvalid) {
    super();
    this.text = text.length > LONGEST ? `${text.slice(0, LONGEST - 1)}…` : text;
    this.isInvalid = isInvalid;
  }

  eq(other) {
    return other.text === this.text && other.isInvalid === this.isInvalid;
  }

  toDOM() {
    const made = document.createElement('span');
    made.className = this.isInvalid ? 'trace invalid' : 'trace';
    made.textContent = this.text;
    return made;
  }

  ignoreEvent() {
    return false;
  }
}

/**
 * The marks of a file.
 * @typedef {{ values: Map<number, { text: string, isInvalid: boolean }>, current: number | undefined }} Marks
 * `values` by line, and the line of the current step
 */

const show = StateEffect.define();

function decorations(doc, { values, current }) {
  const made = [...values].filter(([line]) => line <= doc.lines).map(([line, { text, isInvalid }]) => {
    const widget = new Values(text, isInvalid);
    return Decoration.widget({ widget, side: 1 }).range(doc.line(line).to);
  });
  if (current !== undefined && current <= doc.lines) {
    made.push(Decoration.line({ class: 'current-step' }).range(doc.line(current).from));
  }
  return Decoration.set(made, true);
}

/** Has the marks of a document. */
export const traceMarks = StateField.define({
  create: () => Decoration.none,
  update(marks, transaction) {
    const effect = transaction.effects.find((one) => one.is(show));
    if (effect) return effect.value ? decorations(transaction.newDoc, effect.value) : Decoration.none;
    return marks.map(transaction.changes);
  },
  provide: (field) => EditorView.decorations.from(field),
});

/** Shows marks in an editor; nothing removes them. @param {EditorView} view @param {Marks | null} marks */
export const mark = (view, marks) => view.dispatch({ effects: show.of(marks) });
