// Selects the model of the page: one that comes with it (?model=NAME), or the user's own file, which stays in the
// browser. Other parameters of the address are settings, as in ?model=carburettor.csg&machine=pixel-planes-5&z-bits=16.
import {byId, make} from './dom.js';
import {flags, showError} from './asking.js';

const ownKey = 'csgsim: a model of one\'s own';

const models = fetch(new URL('models/models.json', import.meta.url)).then(reply => reply.json());

const knobsOf = query => {
  const knobs = {};
  for (const name of new Set(query.keys())) {
    if (name === 'model' || name === 'own') continue;
    knobs[name] = name === 'set' ? query.getAll(name) : flags.includes(name) ? query.get(name) !== 'false' : query.get(name);
  }
  return knobs;
};

// Returns the selected model as {name, text, knobs}; the default is the first model that comes with the page.
export const openedModel = async () => {
  const query = new URLSearchParams(location.search);
  const own = query.has('own') ? JSON.parse(sessionStorage.getItem(ownKey)) : null;
  if (own) return {...own, knobs: knobsOf(query)};
  const name = query.get('model');
  const known = await models;
  const row = name ? known.find(each => each.name === name) : known[0];
  if (!row) throw new Error('there is no model ' + name + '; choose one of ' + known.map(each => each.name).join(', '));
  const text = await (await fetch(new URL('models/' + row.name, import.meta.url))).text();
  return {name: row.name, text, knobs: {...row.knobs, ...knobsOf(query)}};
};

const open = async file => {
  try {
    sessionStorage.setItem(ownKey, JSON.stringify({name: file.name, text: await file.text()}));
    location.search = '?own';
  } catch (error) {
    showError({error: file.name + ' cannot be stored in this browser: ' + error.message});
  }
};

export const setUpChoice = async () => {
  const query = new URLSearchParams(location.search);
  const known = await models;
  const chosen = query.has('own') ? '' : query.get('model') ?? known[0].name;
  const select = make('select', {id: 'model'}, ...known.map(({name, meaning}) => make('option', {value: name}, name + ': ' + meaning)),
    ...(query.has('own') ? [make('option', {value: ''}, 'your own file')] : []));
  select.value = chosen;
  select.addEventListener('change', () => { location.search = '?' + new URLSearchParams({model: select.value}); });
  const own = make('input', {id: 'own', type: 'file', accept: '.csg,.jan,.scad'});
  own.addEventListener('change', () => { if (own.files.length) open(own.files[0]); });
  document.head.append(make('link', {rel: 'stylesheet', href: 'choice.css'}));
  byId('told').after(make('form', {id: 'choice'}, make('label', {}, 'Model', select), make('label', {}, 'Your own .csg file, or drop it on the page', own)),
    make('p', {class: 'note'}, 'This page runs entirely in your browser; no server is involved, and your files stay here. csgsim view on your computer is faster, reads .scad, imports and text(), and shows waveforms.'));
  document.addEventListener('dragover', event => event.preventDefault());
  document.addEventListener('drop', event => {
    event.preventDefault();
    if (event.dataTransfer.files.length) open(event.dataTransfer.files[0]);
  });
};
