// Form of the effects. It edits lines of the KEY=VALUE field; csgsim receives only that field.
import {byId, make} from './dom.js';

const lines = () => byId('set').value.split('\n').map(line => line.trim()).filter(line => line);

const valueOf = key => {
  const line = lines().find(each => each.startsWith(key + '='));
  return line ? line.slice(key.length + 1) : '';
};

// Removes the key if the value is empty.
const put = (key, value) => {
  const others = lines().filter(line => !line.startsWith(key + '='));
  byId('set').value = [...others, ...(value ? [key + '=' + value] : [])].join('\n');
  byId('set').dispatchEvent(new Event('input', {bubbles: true}));
};

const inputOf = (effect, key) => {
  const name = effect.key + '.' + key.name;
  const attributes = {'data-key': name, title: key.meaning, spellcheck: 'false'};
  const input = key.choices
    ? make('select', attributes, ...['', ...key.choices].map(choice => make('option', {value: choice}, choice || (key.usual ? key.usual + ' (default)' : 'not set'))))
    : make('input', {...attributes, placeholder: (key.usual || key.allowed).replace(/[`[\]]/g, '')});
  input.addEventListener('change', () => put(name, input.value.trim()));
  return make('label', {}, key.name.replace(/_/g, ' ') + (key.unit ? ', ' + key.unit : ''), input);
};

const fieldsOf = effect => {
  const fields = make('fieldset', {}, make('legend', {}, effect.name.replace(/_/g, ' ')), make('p', {class: 'note'}, effect.meaning));
  if (!effect.is_list) {
    const isOn = make('select', {'data-key': effect.key + '.on'}, ...[['', 'if a key is set or the model requests it'], ['true', 'on'], ['false', 'off']].map(([value, text]) => make('option', {value}, text)));
    isOn.addEventListener('change', () => put(effect.key + '.on', isOn.value));
    fields.append(make('label', {}, 'drawn', isOn));
  }
  fields.append(...effect.keys.map(key => inputOf(effect, key)));
  return fields;
};

// Updates the form from the lines.
const read = () => {
  for (const input of byId('effects').querySelectorAll('[data-key]')) {
    if (document.activeElement !== input) input.value = valueOf(input.dataset.key);
  }
};

export const setUpEffects = effects => {
  byId('effects').replaceChildren(...effects.map(fieldsOf));
  byId('effects').addEventListener('input', event => event.stopPropagation());
  byId('set').addEventListener('input', read);
  read();
};
