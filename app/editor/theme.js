// How the editor looks: the page's tokens, which the shadow root inherits; and its words.

import { EditorView } from "@codemirror/view";

/** Labels of the search panel. */
export const phrases = {
  next: "Next",
  previous: "Previous",
  all: "All",
  "match case": "Case",
  regexp: "Regexp",
  "by word": "Words",
  replace: "Replace",
  "replace all": "Replace all",
  close: "Close",
};

const border = "1px solid var(--line)";
const control = {
  margin: "0",
  minHeight: "var(--code-control)",
  padding: "0 .75rem",
  border,
  borderRadius: "6px",
  background: "var(--surface)",
  color: "var(--ink)",
  font: "inherit",
};
const focus = { outline: "2px solid var(--accent)", outlineOffset: "2px" };
/** A colour seen through: so faintly that every text on it keeps its contrast. */
const tint = (token, percent) => `color-mix(in srgb, var(${token}) ${percent}%, transparent)`;
const wavy = (token) => ({ backgroundImage: "none", textDecoration: `underline wavy var(${token}) 1px`, textUnderlineOffset: "3px" });

const text = {
  "&": { height: "100%", background: "var(--surface)", color: "var(--ink)", fontSize: "var(--code-size)" },
  "&.cm-focused": { outline: "none" },
  ".cm-scroller": { fontFamily: "var(--mono)", lineHeight: "var(--code-line)", scrollbarWidth: "thin" },
  ".cm-content": { padding: ".5rem 0", caretColor: "var(--ink)" },
  ".cm-line": { padding: "0 .75rem 0 var(--code-indent)" },
  ".cm-cursor, .cm-dropCursor": { borderLeftColor: "var(--ink)", borderLeftWidth: "1.5px" },
  ".cm-selectionBackground": { background: tint("--muted", 20) },
  "&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground": { background: tint("--accent", 22) },
  ".cm-selectionMatch": { backgroundColor: tint("--muted", 15) },
  ".line-number": { color: "var(--muted)" },
  ".keyword, .function": { color: "var(--code-keyword)" },
  ".number": { color: "var(--code-number)" },
  ".text": { color: "var(--code-text)" },
  ".comment": { color: "var(--muted)" },
  ".error": { color: "var(--code-error)" },
};

const marks = {
  ".cm-gutters": { background: "var(--surface)", border: "none !important" },
  ".breakpoints": { width: "var(--code-gutter)", cursor: "pointer" },
  ".breakpoints .cm-gutterElement": { display: "flex", justifyContent: "center", alignItems: "center" },
  ".breakpoint, .breakpoints .cm-gutterElement:empty:hover::before": {
    width: ".625rem",
    height: ".625rem",
    borderRadius: "50%",
    background: "var(--ink)",
    content: "''",
  },
  ".breakpoints .cm-gutterElement:empty:hover::before": { background: "var(--line)" },
  ".cm-line.running, .cm-gutterElement.running": { background: tint("--accent", 16) },
};

const tips = {
  ".cm-tooltip": { maxWidth: "min(28rem, 92vw)", border, borderRadius: "6px", background: "var(--surface)", color: "var(--ink)" },
  ".cm-tooltip-section:not(:first-child)": { borderTop: border },
  ".help": { padding: ".5rem .75rem", font: ".8125rem/1.25rem var(--system)", whiteSpace: "normal" },
  ".help .syntax": { fontFamily: "var(--mono)", fontWeight: "600" },
  ".help p": { margin: ".25rem 0 0" },
  ".help .source": { color: "var(--muted)", fontSize: ".75rem" },
  ".cm-tooltip.cm-tooltip-autocomplete > ul": { maxHeight: "none", font: "inherit", fontFamily: "var(--mono)" },
  ".cm-tooltip.cm-tooltip-autocomplete > ul > li": {
    display: "flex",
    gap: "1rem",
    justifyContent: "space-between",
    alignItems: "center",
    minHeight: "var(--code-option)",
    padding: "0 .75rem",
  },
  ".cm-tooltip-autocomplete ul li[aria-selected]": { background: "var(--accent)", color: "var(--on-fill)" },
  ".cm-completionMatchedText": { fontWeight: "600", textDecoration: "none" },
  ".cm-completionDetail": { color: "var(--muted)", font: "normal .75rem var(--system)" },
  "li[aria-selected] .cm-completionDetail": { color: "inherit" },
  ".cm-tooltip.cm-completionInfo": { padding: "0", maxWidth: "22rem" },
};

const faults = {
  ".cm-lintRange": { paddingBottom: "0" },
  ".cm-lintRange-error": wavy("--stop"),
  ".cm-lintRange-warning": wavy("--muted"),
  ".cm-lintRange-active": { backgroundColor: tint("--stop", 12) },
  ".cm-lintPoint::after": { borderBottomColor: "var(--stop)" },
  ".cm-lintPoint-warning::after": { borderBottomColor: "var(--muted)" },
  ".cm-diagnostic": {
    margin: "0",
    padding: ".5rem .75rem",
    borderLeft: "3px solid var(--stop)",
    font: ".8125rem/1.25rem var(--system)",
  },
  ".cm-diagnostic-warning": { borderLeftColor: "var(--muted)" },
  ".problem b": { display: "block", fontFamily: "var(--mono)", fontWeight: "600" },
  ".cm-diagnosticAction": { ...control, display: "block", marginTop: ".5rem", color: "var(--accent)" },
};

const panel = {
  ".cm-panels": { background: "var(--raised)", color: "var(--ink)" },
  ".cm-panels-top": { borderBottom: border },
  ".cm-panel.cm-search": {
    display: "flex",
    flexWrap: "wrap",
    gap: ".5rem",
    alignItems: "center",
    padding: ".5rem 3rem .5rem .75rem",
    font: "var(--code-field)/1.25rem var(--system)",
  },
  // Replacing has a row of its own: in a flex box a line break is none, but this is.
  ".cm-panel.cm-search::before": { flexBasis: "100%", order: "1", content: "''" },
  ".cm-panel.cm-search br ~ *": { order: "2" },
  ".cm-panel.cm-search .cm-textfield": { ...control, width: "12rem", fontFamily: "var(--mono)" },
  ".cm-panel.cm-search .cm-button": { ...control, backgroundImage: "none", cursor: "pointer" },
  ".cm-panel.cm-search .cm-button:hover": { borderColor: "var(--muted)" },
  ".cm-panel.cm-search label": {
    display: "inline-flex",
    gap: ".375rem",
    alignItems: "center",
    minHeight: "var(--code-control)",
    margin: "0",
    fontSize: "inherit",
  },
  ".cm-panel.cm-search input[type=checkbox]": { width: "1rem", height: "1rem", margin: "0", accentColor: "var(--accent)" },
  ".cm-panel.cm-search [name=close]": {
    top: ".5rem",
    right: ".5rem",
    width: "var(--code-control)",
    height: "var(--code-control)",
    color: "var(--muted)",
    font: "1.25rem/1 var(--system)",
    cursor: "pointer",
  },
  "button:focus-visible, input:focus-visible": focus,
  ".cm-searchMatch": { backgroundColor: tint("--lamp", 10), outline: "1px solid var(--lamp)" },
  ".cm-searchMatch-selected": { backgroundColor: tint("--lamp", 15), outlineWidth: "2px" },
};

/** What is said by a background alone keeps it where the system chooses the colours. */
const forced = {
  ".cm-selectionBackground, .running, .breakpoint, .cm-searchMatch": { forcedColorAdjust: "none" },
};

export const theme = EditorView.theme({ ...text, ...marks, ...tips, ...faults, ...panel, ...forced });
