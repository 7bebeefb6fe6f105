// Pixel memory before an instruction.
import {button, byId, grouped, make} from './dom.js';
import {ask, lastOf, now, shownRequest} from './asking.js';
import {lineAtCursor, lineIn, showLine} from './source.js';
import {markTree} from './trees.js';
import {lookAtClocks} from './wires.js';

// Line of a primitive, or 0.
const lineOf = primitive => {
  const known = now.drawn ? now.drawn.stats.by_primitive[primitive] : null;
  return known ? lineIn(known.name) : 0;
};

const showListing = answer => {
  const listing = byId('listing');
  listing.replaceChildren(...answer.instructions.map(each => make('li', {}, button(
    ['i' + each.number + '  ' + each.text + '  ', make('span', {class: 'serves'}, each.serves)],
    () => goTo(each.number), {'aria-current': String(each.number === answer.number)}))));
  const current = listing.querySelector('[aria-current="true"]');
  if (current) listing.scrollTop = current.offsetTop - listing.offsetTop - 80;
};

const showClocks = clocks => {
  byId('clocks').hidden = !clocks;
  if (!clocks) return;
  now.issued = clocks;
  byId('clocks').textContent = 'clocks ' + grouped(clocks[0]) + ' to ' + grouped(clocks[1]) + ': show the wires';
};

const showInstant = (answer, request) => {
  byId('then').src = answer.picture;
  byId('scale').textContent = answer.scale;
  byId('instant').max = answer.count;
  // Leave the slider alone if it has been moved since the request.
  const isElsewhere = request.primitive !== undefined || request.clock !== undefined;
  if (Number(byId('instant').value) === request.number || isElsewhere) byId('instant').value = answer.number;
  if (byId('field').length === 0) byId('field').replaceChildren(make('option', {value: ''}, 'the picture'), ...answer.fields.map(name => make('option', {}, name)));
  const next = answer.instructions.find(each => each.number === answer.number);
  now.next = next;
  const clocks = answer.clocks ? ', issued in clocks ' + grouped(answer.clocks[0]) + ' to ' + grouped(answer.clocks[1]) : '';
  byId('at').textContent = next ? 'before i' + next.number + ' of ' + grouped(answer.count) + ': ' + next.text + ', for ' + next.serves + clocks : 'at the end, after ' + grouped(answer.count) + ' instructions';
  showListing(answer);
  showClocks(answer.clocks);
  markTree(next, answer.active);
  if (next && next.primitive !== undefined) showLine(lineOf(next.primitive));
  window.shownInstants = (window.shownInstants || 0) + 1;
};

export const lookAtInstant = lastOf(async () => {
  const request = {...shownRequest(), number: Number(byId('instant').value), field: byId('field').value, tinted: byId('tinted').checked, ...now.elsewhere};
  now.elsewhere = undefined;
  const {isGood, answer} = await ask('instant', request);
  if (isGood) showInstant(answer, request);
  else byId('at').textContent = answer.error;
});

export const goTo = number => {
  byId('instant').max = Math.max(Number(byId('instant').max), number);
  byId('instant').value = number;
  lookAtInstant();
};

// Goes to the first instruction that works for the primitive.
export const goToPrimitive = primitive => {
  now.elsewhere = {primitive};
  lookAtInstant();
};

export const goToClock = clock => {
  now.elsewhere = {clock};
  lookAtInstant();
};

const goToLine = () => {
  const line = lineAtCursor();
  const primitive = (now.drawn ? now.drawn.stats.by_primitive : []).findIndex((_, index) => lineOf(index) === line);
  if (primitive >= 0) goToPrimitive(primitive);
};

export const setUpTime = () => {
  byId('instant').addEventListener('input', lookAtInstant);
  byId('field').addEventListener('change', lookAtInstant);
  byId('tinted').addEventListener('change', lookAtInstant);
  byId('back').addEventListener('click', () => goTo(Math.max(0, Number(byId('instant').value) - 1)));
  byId('on').addEventListener('click', () => goTo(Number(byId('instant').value) + 1));
  byId('source').addEventListener('click', goToLine);
  byId('clocks').addEventListener('click', () => lookAtClocks(now.issued));
};
