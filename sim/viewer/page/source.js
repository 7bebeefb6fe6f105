// The text of the model.
import {byId} from './dom.js';

// From a column of the source's line to its end.
export const selectLine = (line, column = 1) => {
  const lines = byId('source').value.split('\n');
  const begin = lines.slice(0, line - 1).reduce((sum, each) => sum + each.length + 1, 0);
  byId('source').setSelectionRange(begin + column - 1, begin + (lines[line - 1] || '').length);
};

// Line of `cylinder@9:9`, or 0.
export const lineIn = name => {
  const found = /@(\d+):\d+$/.exec(name);
  return found ? Number(found[1]) : 0;
};

// Unless somebody writes there.
export const showLine = line => {
  const source = byId('source');
  if (!line || document.activeElement === source) return;
  selectLine(line);
  source.scrollTop = (line - 4) * parseFloat(getComputedStyle(source).lineHeight);
};

// Of the cursor, from 1 on.
export const lineAtCursor = () => byId('source').value.slice(0, byId('source').selectionStart).split('\n').length;
