// Breakpoints in the gutter, and the line that runs.

import { RangeSet, StateEffect, StateField } from "@codemirror/state";
import { Decoration, EditorView, GutterMarker, gutter, gutterLineClass, keymap } from "@codemirror/view";

/** The lines with a breakpoint. */
export const setBreakpoints = StateEffect.define();
/** The line that runs; below 0, none. */
export const setRunning = StateEffect.define();

class Dot extends GutterMarker {
  toDOM() {
    const dot = document.createElement("span");
    dot.className = "breakpoint";
    return dot;
  }
}

class RunningCell extends GutterMarker {
  elementClass = "running";
}

const dot = new Dot();
const runningCell = new RunningCell();
const runningLine = Decoration.line({ class: "running", attributes: { "aria-current": "step" } });

/** Where lines start, for those that the document still has. */
function starts(doc, lines) {
  return Array.from(lines)
    .filter((line) => line >= 0 && line < doc.lines)
    .map((line) => doc.line(line + 1).from);
}

/** Marks at the start of lines, as the page gives them by an effect. Until it does after an edit, they move along. */
function field(effect, marked, provide) {
  return StateField.define({
    create: () => RangeSet.empty,
    update(marks, transaction) {
      for (const given of transaction.effects) {
        if (given.is(effect)) {
          return marked(transaction.newDoc, given.value);
        }
      }
      return transaction.docChanged ? marks.map(transaction.changes) : marks;
    },
    provide,
  });
}

export function marks(editor) {
  const breakpoints = field(setBreakpoints, (doc, lines) =>
    RangeSet.of(starts(doc, lines).map((start) => dot.range(start))),
  );
  const runs = field(
    setRunning,
    (doc, line) => Decoration.set(starts(doc, [line]).map((start) => runningLine.range(start))),
    (field) => [
      EditorView.decorations.from(field),
      gutterLineClass.compute([field], (state) => {
        const { value, from } = state.field(field).iter();
        return value ? RangeSet.of(runningCell.range(from)) : RangeSet.empty;
      }),
    ],
  );
  function toggle(view, at) {
    editor.toggle(view.state.doc.lineAt(at).number - 1);
    return true;
  }
  const column = gutter({
    class: "breakpoints",
    markers: (view) => view.state.field(breakpoints),
    domEventHandlers: {
      mousedown: (view, block, event) => event.button === 0 && toggle(view, block.from),
    },
  });
  const key = { key: "F9", run: (view) => toggle(view, view.state.selection.main.head), preventDefault: true };
  return [breakpoints, runs, column, keymap.of([key])];
}
