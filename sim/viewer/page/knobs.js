// Settings of the page.
import {byId, make} from './dom.js';
import {flags, named, now} from './asking.js';
import {cameraOf} from './camera.js';
import {draw} from './draw.js';
import {setUpEffects} from './effects.js';
import {cancelUnless} from './progress.js';

export const setUpKnobs = about => {
  byId('machines').replaceChildren(...about.machines.map(name => make('option', {value: name})));
  byId('strategy').replaceChildren(...about.strategies.map(name => make('option', {value: name === about.usual.strategy ? '' : name}, name)));
  for (const name of about.names) {
    if (named.includes(name) || name === 'set' || name === 'camera') continue;
    const input = flags.includes(name) ? make('input', {type: 'checkbox', id: name}) : make('input', {id: name, spellcheck: 'false'});
    byId('more').append(make('label', {}, name, input));
  }
  for (const [name, value] of Object.entries(about.knobs)) {
    if (name === 'set') byId('set').value = value.join('\n');
    else if (name === 'camera') now.camera = cameraOf(value);
    else if (flags.includes(name)) byId(name).checked = value === true;
    else if (name !== 'strategy' || value !== about.usual.strategy) byId(name).value = value;
  }
  now.first = now.camera && structuredClone(now.camera);
  byId('machine').placeholder = about.usual.machine;
  byId('z-bits').placeholder = about.usual['z-bits'];
  setUpEffects(about.effects);
  const changed = () => {
    clearTimeout(now.changed);
    now.changed = setTimeout(() => {
      now.changed = 0;
      if (byId('view-all').checked) now.camera = null;
      draw();
    }, 150);
  };
  byId('knobs').addEventListener('input', changed);
  byId('knobs').addEventListener('submit', event => event.preventDefault());
  byId('source').addEventListener('input', () => {
    now.edited = byId('source').value !== about.source;
    changed();
    cancelUnless(now.edited ? byId('source').value : undefined);
  });
};
