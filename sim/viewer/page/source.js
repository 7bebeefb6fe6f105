// The source text of the model, and marks in it. Marks move neither the caret nor the selection, except after a click.
import {byId} from './dom.js';

const lines = () => byId('source').value.split('\n');

const px = text => parseFloat(text) || 0;

// Columns before a column; a tab advances to the next multiple of its size.
const columnsBefore = (text, column, tabSize) => [...text.slice(0, column - 1)].reduce((at, each) => each === '\t' ? at + tabSize - at % tabSize : at + 1, 0);

let columnWidth = 0;

// Width of a character; the source has a monospaced font.
const widthOfColumn = style => {
  if (columnWidth) return columnWidth;
  const context = document.createElement('canvas').getContext('2d');
  context.font = style.fontSize + ' ' + style.fontFamily;
  columnWidth = context.measureText('m'.repeat(100)).width / 100;
  return columnWidth;
};

// Places a mark under a line of the source, from a column to the end of the line.
const place = (mark, {line, column}) => {
  const source = byId('source');
  const style = getComputedStyle(source);
  const height = px(style.lineHeight);
  const text = lines()[line - 1] ?? '';
  const tabSize = px(style.tabSize);
  const before = columnsBefore(text, column, tabSize);
  const width = Math.max(1, columnsBefore(text, text.length + 1, tabSize) - before) * widthOfColumn(style);
  const top = source.clientTop + px(style.paddingTop) + (line - 1) * height - source.scrollTop;
  const left = source.clientLeft + px(style.paddingLeft) + before * widthOfColumn(style) - source.scrollLeft;
  const right = Math.min(left + width, source.clientLeft + source.clientWidth);
  const begin = Math.max(left, source.clientLeft);
  mark.hidden = top < 0 || top + height > source.clientTop + source.clientHeight + height / 2 || right <= begin;
  mark.style.setProperty('top', top + 'px');
  mark.style.setProperty('left', begin + 'px');
  mark.style.setProperty('width', right - begin + 'px');
  mark.style.setProperty('height', height + 'px');
};

// Marked positions: `fault`, where an error is, and `current`, the line of the selected instruction.
const marked = {fault: null, current: null};

const placeMarks = () => {
  for (const [name, at] of Object.entries(marked)) {
    byId(name).hidden = !at;
    if (at) place(byId(name), at);
  }
  const gutter = byId('fault-line');
  gutter.hidden = !marked.fault || byId('fault').hidden;
  if (marked.fault) gutter.style.setProperty('top', byId('fault').style.top);
};

// Marks the error of a line until the next text is drawn or has another error.
export const markFault = (line, column, message) => {
  marked.fault = {line, column: column || 1, message};
  byId('fault-line').textContent = line;
  byId('fault-line').title = message;
  byId('fault-told').textContent = 'line ' + line + ': ' + message;
  byId('fault-told').hidden = false;
  byId('source').setAttribute('aria-invalid', 'true');
  placeMarks();
};

export const forgetFault = () => {
  marked.fault = null;
  byId('fault-told').hidden = true;
  byId('source').removeAttribute('aria-invalid');
  placeMarks();
};

// Called on a click.
const goToFault = () => {
  if (!marked.fault) return;
  const {line, column} = marked.fault;
  const begin = lines().slice(0, line - 1).reduce((sum, each) => sum + each.length + 1, 0) + column - 1;
  const source = byId('source');
  source.focus();
  source.setSelectionRange(begin, begin);
  source.scrollTop = (line - 4) * px(getComputedStyle(source).lineHeight);
};

// Line in a name such as `cylinder@9:9`, or 0.
export const lineIn = name => {
  const found = /@(\d+):\d+$/.exec(name);
  return found ? Number(found[1]) : 0;
};

// Marks the line of the selected instruction. Scrolls there, unless the user is editing the source.
export const showLine = line => {
  const source = byId('source');
  marked.current = line ? {line, column: 1} : null;
  if (line && document.activeElement !== source) source.scrollTop = (line - 4) * px(getComputedStyle(source).lineHeight);
  placeMarks();
};

// Line of the cursor, from 1.
export const lineAtCursor = () => byId('source').value.slice(0, byId('source').selectionStart).split('\n').length;

export const setUpSource = () => {
  byId('source').addEventListener('scroll', placeMarks);
  byId('source').addEventListener('input', placeMarks);
  addEventListener('resize', placeMarks);
  byId('fault-told').addEventListener('click', goToFault);
  byId('fault-line').addEventListener('click', goToFault);
};
