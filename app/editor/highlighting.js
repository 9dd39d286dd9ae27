// The colours of what is in sight, by the page's own lexer.

import { RangeSetBuilder } from "@codemirror/state";
import { Decoration, ViewPlugin } from "@codemirror/view";

/** Characters of a line that are coloured: more than any device's line has, and a bound for a pasted monster. */
const MOST_COLOURED = 2000;

export function highlighting(editor) {
  const classes = editor.classes.map((name) => Decoration.mark({ class: name }));

  function coloured(view) {
    const builder = new RangeSetBuilder();
    let done = -1;
    for (const range of view.visibleRanges) {
      for (let at = range.from; at <= range.to; ) {
        const line = view.state.doc.lineAt(at);
        // Parts of one long line may come as several ranges.
        if (line.from > done) {
          const parts = editor.highlight(line.text.slice(0, MOST_COLOURED));
          for (let part = 0; part < parts.length; part += 3) {
            builder.add(line.from + parts[part], line.from + parts[part + 1], classes[parts[part + 2]]);
          }
          done = line.to;
        }
        at = line.to + 1;
      }
    }
    return builder.finish();
  }

  class Colours {
    constructor(view) {
      this.decorations = coloured(view);
    }

    update(update) {
      if (update.docChanged || update.viewportChanged) {
        this.decorations = coloured(update.view);
      }
    }
  }

  return ViewPlugin.fromClass(Colours, { decorations: (plugin) => plugin.decorations });
}
