// The page's current request, and how requests are sent to csgsim.
import {byId} from './dom.js';
import {forgetFault, markFault} from './source.js';

// State of the page. The camera is null until the first picture returns it.
export const now = {about: null, camera: null, first: null, drawn: null, edited: false};

export const named = ['machine', 'strategy', 'memory-bits', 'z-bits', 'projection', 'size'];
export const flags = ['view-all', 'snap'];

export const currentRequest = () => {
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

// The request of the visible picture. It is older than currentRequest() while the next picture is evaluated, or if that fails.
export const shownRequest = () => now.drawn ? now.drawn.request : currentRequest();

export {answerTo as ask} from './answers.js';

// Shows an error and marks the line of the source that it names.
export const showError = answer => {
  byId('error').textContent = answer.error;
  byId('error').hidden = false;
  byId('stage').classList.add('stale');
  if (answer.line) markFault(answer.line, answer.column, answer.error);
  else forgetFault();
};

const works = [];

// Runs the work one request at a time. Of the requests made during a run, only the last is run afterwards.
export const lastOf = work => {
  let isBusy = false;
  let isRequested = false;
  const run = async () => {
    isRequested = true;
    if (isBusy) return;
    isBusy = true;
    while (isRequested) {
      isRequested = false;
      try {
        await work();
      } catch (error) {
        showError({error: 'no answer from csgsim: ' + error.message});
      }
    }
    isBusy = false;
  };
  works.push(() => isBusy);
  return run;
};

// Whether all requests have been answered and shown.
window.isAtRest = () => now.drawn !== null && !now.changed && !now.later && !works.some(isBusy => isBusy());
