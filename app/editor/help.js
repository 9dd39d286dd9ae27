// The words of the language: completed while typing, explained under the pointer and with F1.

import {
  acceptCompletion,
  autocompletion,
  currentCompletions,
  moveCompletionSelection,
} from "@codemirror/autocomplete";
import { activateHover, closeHoverTooltips, hasHoverTooltips, hoverTooltip, keymap } from "@codemirror/view";

/** A word as it is typed, up to the cursor. */
const TYPED = /[A-Za-z_][A-Za-z0-9_]*[$%]?$/;
/** Letters after which a list opens by itself: names of variables are short. */
const ENOUGH = 2;
/** Words of a list that are shown at a time: so many need no scrolling, and the arrow keys bring the others. */
const MOST_OFFERED = 7;
/** Kinds of words that are rarely wanted in a program stand last. */
const RARE = new Set(["command", "not-implemented"]);
/** Kinds whose name says too little. */
const SAID = { io: "input, output", sysvar: "system variable" };
/** Where no word is completed. */
const PROSE = new Set(["comment", "text"]);

const chooseFirst = moveCompletionSelection(true);

function element(name, className, ...children) {
  const made = document.createElement(name);
  made.className = className;
  made.append(...children);
  return made;
}

/** Whether a word works here, in a sentence. */
function supported(support) {
  const [[how, why]] = typeof support === "string" ? [[support, ""]] : Object.entries(support);
  return { Full: "Simulated in full.", Partial: `Simulated in part: ${why}`, Absent: why }[how];
}

/** What is to be known about a word. */
function explained({ syntax, summary, section, support }) {
  return element(
    "div",
    "help",
    element("code", "syntax", syntax),
    element("p", "summary", summary),
    element("p", "source", `${supported(support)} Manual: ${section}.`),
  );
}

export function help(editor) {
  const rows = new Map(editor.words.map((row) => [row.word.toUpperCase(), row]));
  const options = editor.words
    .filter(({ word }) => /^[A-Z]/i.test(word))
    .map((row) => ({
      label: row.word,
      detail: row.support.Absent ? "not simulated" : (SAID[row.kind] ?? row.kind),
      boost: row.support.Absent ? -99 : RARE.has(row.kind) ? -50 : 0,
      info: () => explained(row),
    }));

  /** The part of a line that a character belongs to: `[from, to, class]` in the line. */
  function partAt(line, index) {
    const parts = editor.highlight(line);
    for (let part = 0; part < parts.length; part += 3) {
      if (parts[part] <= index && index < parts[part + 1]) {
        return [parts[part], parts[part + 1], editor.classes[parts[part + 2]]];
      }
    }
    return null;
  }

  function complete(context) {
    const line = context.state.doc.lineAt(context.pos);
    const before = line.text.slice(0, context.pos - line.from);
    const typed = before.match(TYPED)?.[0] ?? "";
    const within = partAt(line.text, before.length - 1)?.[2];
    if (PROSE.has(within) || (typed.length < ENOUGH && !context.explicit)) {
      return null;
    }
    return { from: context.pos - typed.length, options, validFor: /^\w*[$%]?$/ };
  }

  /** The help for the word that a character belongs to. */
  function helpAt({ from, text }, index) {
    const part = partAt(text, index);
    const row = part && rows.get(text.slice(part[0], part[1]).replaceAll(/\s+/g, " ").toUpperCase());
    const create = () => ({ dom: explained(row) });
    return row ? { pos: from + part[0], end: from + part[1], above: true, create } : null;
  }

  // Behind a word is still at it.
  const hover = hoverTooltip(({ state }, at) => {
    const line = state.doc.lineAt(at);
    return helpAt(line, at - line.from) ?? helpAt(line, at - line.from - 1);
  });

  /** Shows the help of the word at the cursor until the cursor moves. */
  function explain(view) {
    const until = (transaction) => transaction.docChanged || transaction.selection;
    activateHover(view, view.state.selection.main.head, 1, { tooltip: hover, until });
    return true;
  }

  function dismiss(view) {
    const shown = hasHoverTooltips(view.state);
    if (shown) view.dispatch({ effects: closeHoverTooltips });
    return shown;
  }

  /** Takes the chosen word of an open list, or its first. */
  function take(view) {
    if (currentCompletions(view.state).length === 0) {
      return false;
    }
    return acceptCompletion(view) || (chooseFirst(view) && acceptCompletion(view)) || true;
  }

  return [
    autocompletion({
      override: [complete],
      // Enter ends a line: `NEXT N` stays what it is. So a list that has just opened takes nobody by surprise.
      selectOnOpen: false,
      interactionDelay: 0,
      icons: false,
      maxRenderedOptions: MOST_OFFERED,
    }),
    hover,
    keymap.of([
      { key: "Tab", run: take },
      { key: "F1", run: explain, preventDefault: true },
      { key: "Escape", run: dismiss },
    ]),
  ];
}
