// Progress of a long request, and its cancel button.
import {byId} from './dom.js';
import {cancel, progressOf} from './answers.js';

const shownAfter = 400; // milliseconds
const askedEvery = 500;

// Unique to this page.
const own = Math.random().toString(36).slice(2);
let count = 0;
let current = null;

const textOf = ({doing, seconds, most}) => (doing || 'working') + ', ' + seconds.toFixed(0) + ' s' + (most ? ' of at most ' + most.toFixed(0) + ' s' : '');

const show = ({name, begun, progress}) => {
  const known = progress.doing ? progress : {seconds: (performance.now() - begun) / 1000};
  byId('working').hidden = false;
  byId('doing').textContent = textOf(known);
  const bar = byId('share');
  if (known.most) bar.value = Math.min(1, known.seconds / known.most);
  else bar.removeAttribute('value');
};

const follow = async watched => {
  while (current === watched) {
    watched.progress = await progressOf(watched.name).catch(() => ({}));
    if (current === watched) show(watched);
    await new Promise(resolve => setTimeout(resolve, askedEvery));
  }
};

// Calls `work` with the name of a new evaluation and returns its answer; `source` is the text that is evaluated.
export const watched = async (source, work) => {
  const one = {name: own + '-' + ++count, source, begun: performance.now(), progress: {}};
  current = one;
  const later = setTimeout(() => follow(one), shownAfter);
  try {
    return await work(one.name);
  } finally {
    clearTimeout(later);
    if (current === one) {
      current = null;
      byId('working').hidden = true;
    }
  }
};

// Cancels the request if its source has been changed since.
export const cancelUnless = source => {
  if (current && current.source !== source) cancel(current.name);
};

export const setUpProgress = () => byId('cancel').addEventListener('click', () => {
  if (current) cancel(current.name);
});
