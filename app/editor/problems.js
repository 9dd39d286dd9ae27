// What is wrong: underlined, explained where it stands, with the cure that the page offers.

import { diagnosticCount, forceLinting, linter, nextDiagnostic, previousDiagnostic } from "@codemirror/lint";
import { keymap } from "@codemirror/view";

/** How long the text must have rested before it is checked, in milliseconds. */
const REST = 150;

export const nextProblem = (view) => nextDiagnostic(view);

/** Checks without waiting. */
export const check = (view) => forceLinting(view);

/** Problems as the page gives them: `{line, span, severity, message, cause, cure}`. */
function placed({ state: { doc } }, editor) {
  return editor.problems().map(({ line, span, severity, message, cause, cure }) => {
    const { from: start, to: end } = doc.line(Math.min(line + 1, doc.lines));
    return {
      from: Math.min(start + span.start, end),
      to: Math.min(start + span.end, end),
      severity: severity.toLowerCase(),
      message: `${message}: ${cause}`,
      renderMessage: () => explained(message, cause),
      actions: cure
        ? [{ name: cure.label, apply: () => editor.replace(line, cure.span.start, cure.span.end, cure.replacement) }]
        : [],
    };
  });
}

/** The device's words, then plain ones. */
function explained(message, cause) {
  const words = document.createElement("span");
  words.className = "problem";
  const [said, why] = [document.createElement("b"), document.createElement("span")];
  said.textContent = message;
  why.textContent = cause;
  words.append(said, why);
  return words;
}

export function problems(editor) {
  const go = (where) => (view) => diagnosticCount(view.state) > 0 && where(view);
  return [
    linter((view) => placed(view, editor), { delay: REST }),
    keymap.of([{ key: "F8", run: go(nextDiagnostic), shift: go(previousDiagnostic), preventDefault: true }]),
  ];
}
