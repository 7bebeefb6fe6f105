// Draws the picture and shows its counts.
import {byId, grouped, make} from './dom.js';
import {ask, currentRequest, lastOf, now, showError} from './asking.js';
import {cameraOf} from './camera.js';
import {lookAtInstant} from './time.js';
import {compareTwo} from './two.js';
import {forgetAnswers} from './judged.js';
import {watched} from './progress.js';
import {forgetFault} from './source.js';
import {showTree} from './trees.js';
import {forgetLanes} from './wires.js';

const row = (name, ...values) => make('tr', {}, make('th', {scope: 'row'}, name), ...values.map(value => make('td', {class: 'n'}, value)));

const rounded = rate => Number(rate).toPrecision(4);

const countsOf = stats => {
  return [
    ['clocks until drawn', grouped(stats.clocks)],
    ['clocks until shown', grouped(stats.shown_clocks)],
    ['clocks from one frame to the next', grouped(stats.interval_clocks)],
    ['frames per second', rounded(stats.frames_per_second)],
    ['frames per second with the host', rounded(stats.hosted_frames_per_second)],
    ['instructions', grouped(stats.instructions.total)],
    ['pixel operations', grouped(stats.pixel_operations.total)],
    ['memory bits per pixel', stats.memory.used_bits + ' of ' + stats.memory.memory_bits],
    ['primitives, half-spaces', grouped(stats.model.primitives) + ', ' + grouped(stats.model.halfspaces)],
  ];
};

export const showCounts = stats => {
  const ofA = now.kept ? countsOf(now.kept.drawn.stats) : [];
  byId('counts').replaceChildren(...countsOf(stats).map((each, index) => row(...each, ...(now.kept ? [ofA[index][1]] : []))));
  byId('sides').hidden = !now.kept;
  byId('bound').textContent = stats.bound_by ? stats.bound_by.sentence ?? stats.bound_by : '';
  const purposes = Object.entries(stats.by_purpose).filter(([, cost]) => cost.instructions > 0);
  const whole = purposes.reduce((sum, [, cost]) => sum + cost.clocks, 0) || 1;
  byId('bill').replaceChildren(...purposes.map(([name, cost]) => make('tr', {}, make('th', {scope: 'row'}, name.replace(/_/g, ' ')),
    make('td', {class: 'n'}, grouped(cost.clocks)), make('td', {class: 'n'}, (100 * cost.clocks / whole).toFixed(1) + ' %'),
    make('td', {class: 'n'}, grouped(cost.instructions)))));
};

const show = (answer, request) => {
  const as = answer.command + (request.source ?? '');
  if (!now.drawn || now.drawn.as !== as) {
    forgetAnswers();
    forgetLanes();
  }
  now.drawn = {...answer, as, request};
  byId('picture').src = answer.picture;
  byId('error').hidden = true;
  forgetFault();
  byId('stage').classList.remove('stale');
  byId('command').textContent = answer.command;
  byId('warnings').replaceChildren(...answer.warnings.map(line => make('li', {}, line)));
  byId('warnings').hidden = answer.warnings.length === 0;
  if (!now.camera) {
    now.camera = cameraOf(answer.camera);
    now.first = now.first || structuredClone(now.camera);
  }
  showCounts(answer.stats);
};

export const draw = lastOf(async () => {
  const request = currentRequest();
  const {isGood, answer} = await watched(request.source, evaluation => ask('draw', {...request, evaluation}));
  // Cancelled because the text has changed: the new text is drawn next.
  const isOld = answer.cancelled && request.source !== currentRequest().source;
  if (isGood) show(answer, request);
  else if (!isOld) showError(answer);
  window.drawnPictures = (window.drawnPictures || 0) + 1;
  // Wait until the model is no longer being turned.
  clearTimeout(now.later);
  now.later = setTimeout(() => {
    now.later = 0;
    lookAtInstant();
    compareTwo();
    showTree();
  }, 250);
});
