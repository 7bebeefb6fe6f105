// What the page wishes, and how it asks csgsim for it.
import {byId} from './dom.js';
import {forgetFault, markFault} from './source.js';

// What the page shows. The camera is none until the first picture says where it is.
export const now = {about: null, camera: null, first: null, drawn: null, edited: false};

export const named = ['machine', 'strategy', 'memory-bits', 'z-bits', 'projection', 'size'];
export const flags = ['view-all', 'snap'];

export const wish = () => {
  const knobs = {};
  for (const name of now.about.names) {
    if (name === 'camera') {
      if (now.camera) knobs.camera = [...now.camera.eye, ...now.camera.centre].join(',');
    } else if (name === 'set') {
      const sets = byId('set').value.split('\n').map(line => line.trim()).filter(line => line);
      if (sets.length) knobs.set = sets;
    } else if (flags.includes(name)) {
      if (byId(name).checked) knobs[name] = true;
    } else if (byId(name).value.trim()) {
      knobs[name] = byId(name).value.trim();
    }
  }
  return now.edited ? {knobs, source: byId('source').value} : {knobs};
};

// The wish of the picture that is shown. It may be an earlier one, while the next is evaluated or cannot be drawn.
export const shownWish = () => now.drawn ? now.drawn.wish : wish();

export {answerTo as ask} from './answers.js';

// The line of the source that an error names is marked.
export const showError = answer => {
  byId('error').textContent = answer.error;
  byId('error').hidden = false;
  byId('stage').classList.add('stale');
  if (answer.line) markFault(answer.line, answer.column, answer.error);
  else forgetFault();
};

const works = [];

// Asks one thing at a time, and of what is wished meanwhile the last.
export const lastOf = work => {
  let isBusy = false;
  let isWished = false;
  const run = async () => {
    isWished = true;
    if (isBusy) return;
    isBusy = true;
    while (isWished) {
      isWished = false;
      try {
        await work();
      } catch (error) {
        showError({error: 'csgsim does not answer: ' + error.message});
      }
    }
    isBusy = false;
  };
  works.push(() => isBusy);
  return run;
};

// Whether all that was wished has been shown.
window.isAtRest = () => now.drawn !== null && !now.changed && !now.later && !works.some(isBusy => isBusy());
