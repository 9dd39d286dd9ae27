// <program-editor>: CodeMirror in a shadow root, as the page's code in Rust sees it.
//
// It knows no language: what the parts of a line are, what is wrong and which words there are it asks the page. It keeps
// no breakpoints: the page does, and is told of every edit at once. Lines are the document's, from 0; columns count as
// in JavaScript's strings.
//
// The page sets these before start():
//   label                       the name of the text field, for a screen reader
//   classes                     names of the classes that highlight() gives by their index
//   words                       rows of the language's table of words
//   capitals                    what a keyboard on the screen does with letters: "characters" or "none"
//   highlight(line)             [from, to, class, ...] for the text of a line
//   problems()                  what is wrong with the text, asked for when it has not changed for a moment
//   edited(text, edits)         the user changed the text; edits as describe() gives them
//   cursor(line)                the cursor came to another line
//   toggle(line)                the user wants a breakpoint there, or wants it gone

import { defaultKeymap, history, historyKeymap, isolateHistory } from "@codemirror/commands";
import { highlightSelectionMatches, search, searchKeymap } from "@codemirror/search";
import { Annotation, Compartment, EditorState } from "@codemirror/state";
import { EditorView, drawSelection, dropCursor, keymap, rectangularSelection, tooltips } from "@codemirror/view";
import { help } from "./help.js";
import { highlighting } from "./highlighting.js";
import { marks, setBreakpoints, setRunning } from "./marks.js";
import { check, nextProblem, problems } from "./problems.js";
import { phrases, theme } from "./theme.js";

/** More edits than a person makes, so that undo has no end that is ever met. */
const MOST_UNDONE = 100_000;

/** Marks a change that the page itself made. */
const byPage = Annotation.define();

/**
 * Text that replaces a selection or has several lines: Chromium would give what it types there an inline style, which
 * the page's policy forbids. So the editor puts it in itself.
 */
function replaceBySelf(event, view) {
  const { state } = view;
  const text = event.data ?? "";
  const simple = state.selection.ranges.every((range) => range.empty) && !text.includes("\n");
  if (event.inputType !== "insertText" || event.isComposing || simple) {
    return false;
  }
  if (!state.readOnly) {
    view.dispatch(state.replaceSelection(text), { userEvent: "input.type", scrollIntoView: true });
  }
  return true;
}

class ProgramEditor extends HTMLElement {
  #view;
  #readOnly = new Compartment();
  #locked = EditorState.readOnly.of(false);
  #cursorLine = 0;

  constructor() {
    super();
    this.attachShadow({ mode: "open" });
  }

  /** Shows the editor with a text. */
  start(text) {
    this.#view = new EditorView({
      state: this.#state(text),
      parent: this.shadowRoot,
      root: this.shadowRoot,
    });
  }

  /** Takes the editor away. */
  stop() {
    this.#view?.destroy();
  }

  /** Shows another text; undo does not go back behind it. */
  open(text) {
    this.#view.setState(this.#state(text));
    this.#cursorLine = 0;
    this.cursor(0);
  }

  /** Changes the text, as one step that can be undone; what stays the same keeps the cursor. */
  setText(text) {
    const old = this.#view.state.doc.toString();
    const most = Math.min(old.length, text.length);
    let start = 0;
    while (start < most && old[start] === text[start]) start++;
    let end = 0;
    while (end < most - start && old[old.length - 1 - end] === text[text.length - 1 - end]) end++;
    this.#view.dispatch({
      changes: { from: start, to: old.length - end, insert: text.slice(start, text.length - end) },
      annotations: [byPage.of(true), isolateHistory.of("full")],
    });
  }

  /** Changes part of a line as the user would: as one step that can be undone, told to the page, checked at once. */
  replace(line, from, to, text) {
    if (this.#view.state.readOnly) return;
    const { from: start } = this.#line(line);
    this.#view.dispatch({
      changes: { from: start + from, to: start + to, insert: text },
      selection: { anchor: start + from + text.length },
      annotations: isolateHistory.of("full"),
      scrollIntoView: true,
    });
    check(this.#view);
    this.#view.focus();
  }

  /** Shows these lines with a breakpoint, and no others. */
  setBreakpoints(lines) {
    this.#view.dispatch({ effects: setBreakpoints.of(lines) });
  }

  /** Shows which line runs (below 0: none), and brings it into sight if asked. */
  setRunning(line, follow) {
    const effects = [setRunning.of(line)];
    if (follow && line >= 0) {
      effects.push(EditorView.scrollIntoView(this.#line(line).from, { y: "nearest", yMargin: 40 }));
    }
    this.#view.dispatch({ effects });
  }

  setReadOnly(readOnly) {
    this.#locked = EditorState.readOnly.of(readOnly);
    this.#view.dispatch({ effects: this.#readOnly.reconfigure(this.#locked) });
  }

  /** Puts the cursor into a line and gives the editor the keyboard. */
  goTo(line, column) {
    const { from, to } = this.#line(line);
    const anchor = Math.min(from + column, to);
    this.#view.dispatch({ selection: { anchor }, effects: EditorView.scrollIntoView(anchor, { y: "center" }) });
    this.#view.focus();
  }

  /** Goes to the problem behind the cursor, after the last to the first. */
  nextProblem() {
    this.#view.focus();
    nextProblem(this.#view);
  }

  /** Has a screen reader say something. */
  announce(words) {
    this.#view.dispatch({ effects: EditorView.announce.of(words) });
  }

  focus() {
    this.#view?.focus();
  }

  #line(line) {
    const { doc } = this.#view.state;
    return doc.line(Math.min(line + 1, doc.lines));
  }

  #state(text) {
    return EditorState.create({
      doc: text,
      extensions: [
        help(this),
        problems(this),
        marks(this),
        highlighting(this),
        // Tab is not among them: it leads out of the editor, as it leads through the page.
        keymap.of([...defaultKeymap, ...historyKeymap, ...searchKeymap.filter(({ key }) => key !== "Mod-Alt-g")]),
        history({ minDepth: MOST_UNDONE }),
        search({ top: true }),
        highlightSelectionMatches(),
        drawSelection({ cursorBlinkRate: matchMedia("(prefers-reduced-motion: reduce)").matches ? 0 : 1200 }),
        dropCursor(),
        rectangularSelection(),
        EditorState.allowMultipleSelections.of(true),
        this.#readOnly.of(this.#locked),
        tooltips({ position: "fixed" }),
        EditorView.contentAttributes.of({ "aria-label": this.label, autocapitalize: this.capitals, tabindex: "0" }),
        EditorView.domEventHandlers({ beforeinput: replaceBySelf }),
        EditorView.updateListener.of((update) => this.#tell(update)),
        EditorState.phrases.of(phrases),
        theme,
      ],
    });
  }

  #tell(update) {
    const { doc, selection } = update.state;
    if (update.docChanged && !update.transactions.some((transaction) => transaction.annotation(byPage))) {
      this.edited(doc.toString(), describe(update.changes, update.startState.doc));
    }
    const line = doc.lineAt(selection.main.head).number - 1;
    if (line !== this.#cursorLine) {
      this.#cursorLine = line;
      this.cursor(line);
    }
  }
}

/**
 * What became of lines, five numbers for each change from the last to the first: the line in which the replaced part
 * begins, 1 if it begins at that line's start, the line in which it ends, 1 if it ends at that line's end, and how many
 * line ends stand in what replaces it.
 */
function describe(changes, doc) {
  const edits = [];
  changes.iterChanges((from, to, _, __, inserted) => {
    const [first, last] = [doc.lineAt(from), doc.lineAt(to)];
    const edit = [first.number - 1, from === first.from, last.number - 1, to === last.to, inserted.lines - 1];
    edits.push(edit);
  });
  return Uint32Array.from(edits.reverse().flat());
}

customElements.define("program-editor", ProgramEditor);
