// Answers of a page without a server: csgsim.wasm in a worker (sim/web).
import {openedModel, setUpChoice} from './models.js';
import {byId} from './dom.js';
import {showError} from './asking.js';

const waiting = new Map();
let count = 0;
let worker = null;
let begunWith = null;

const startWorker = () => {
  worker = new Worker(new URL('worker.js', import.meta.url), {type: 'module'});
  worker.onmessage = ({data: {number, status, body}}) => {
    waiting.get(number).resolve({isGood: status === 200, body});
    waiting.delete(number);
  };
  worker.onerror = event => {
    for (const {reject} of waiting.values()) reject(new Error(event.message || 'the worker could not be loaded'));
    waiting.clear();
  };
};
startWorker();

const post = message => new Promise((resolve, reject) => {
  waiting.set(++count, {resolve, reject});
  worker.postMessage({number: count, ...message});
});

export const answerTo = async (question, request) => {
  const {isGood, body} = await post({question, request: JSON.stringify(request)});
  return {isGood, answer: JSON.parse(body)};
};

// The worker handles one request at a time and cannot report progress.
export const progressOf = async () => ({});

// Ends the worker with its pending questions, and starts another.
export const cancel = async () => {
  worker.terminate();
  const ended = [...waiting.values()];
  waiting.clear();
  startWorker();
  if (begunWith) post({begin: begunWith});
  for (const {resolve} of ended) resolve({isGood: false, body: JSON.stringify({error: 'cancelled', cancelled: true})});
};

const aboutModel = async () => {
  const {name, text, knobs} = await openedModel();
  begunWith = [name, text, knobs];
  const begun = await post({begin: begunWith});
  if (!begun.isGood) throw new Error(JSON.parse(begun.body).error);
  return JSON.parse((await post({question: 'about'})).body);
};

// The user can choose another model after an error.
export const askAbout = async () => {
  await setUpChoice();
  try {
    return await aboutModel();
  } catch (error) {
    showError({error: error.message});
    throw error;
  }
};

// Opens the report in a separate window, which has to be opened before the answer arrives.
const openReport = async event => {
  event.preventDefault();
  const page = window.open('about:blank', '_blank');
  const {isGood, body} = await post({question: 'report'});
  if (isGood) {
    page.location = URL.createObjectURL(new Blob([body], {type: 'text/html'}));
  } else {
    page.close();
    showError(JSON.parse(body));
  }
};

export const pageIsThere = () => byId('report').addEventListener('click', openReport);
