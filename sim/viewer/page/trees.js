// The model's tree, and the active tree that a surface is compared with.
import {button, byId, make} from './dom.js';
import {ask, lastOf, now, shownRequest} from './asking.js';
import {goToPrimitive} from './time.js';

const rowOf = row => {
  const text = (row.complemented ? 'not ' : '') + row.text + (row.others ? ' and ' + row.others.map(each => 'p' + each).join(', ') : '');
  const item = make('li', {class: row.complemented ? 'out' : ''}, row.primitive === undefined ? text : button(text, () => goToPrimitive(row.primitive)));
  if (row.primitive !== undefined) item.dataset.primitive = row.primitive;
  // A style attribute would violate the page's content security policy.
  item.style.setProperty('--depth', Math.min(row.depth, 24));
  return item;
};

export const showTree = lastOf(async () => {
  // The tree does not depend on the camera.
  const {knobs, source} = shownRequest();
  const key = JSON.stringify([source, knobs.set, knobs.snap]);
  if (key === now.treeOf) return;
  const {isGood, answer} = await ask('tree', shownRequest());
  if (!isGood) return;
  now.treeOf = key;
  byId('tree').replaceChildren(...answer.tree.map(rowOf));
  markTree(now.next, now.active);
});

// Marks the primitive whose surface the instruction draws, and the nodes that it is compared with.
export const markTree = (next, active) => {
  now.active = active;
  for (const row of document.querySelectorAll('#tree [data-primitive], #active [data-primitive]')) row.removeAttribute('aria-current');
  byId('active-of').textContent = next && active ? 'Active tree of ' + next.serves.replace(/^[a-z ]+ /, '') + (active.length ? '' : ': empty, so no other primitive removes any of this surface') : '';
  byId('active').replaceChildren(...(active || []).map(rowOf));
  if (!next) return;
  const mark = (list, primitive, what) => {
    const row = primitive === undefined ? null : byId(list).querySelector('[data-primitive="' + primitive + '"]');
    if (!row) return;
    row.setAttribute('aria-current', what);
    const box = byId(list);
    if (row.offsetTop < box.scrollTop || row.offsetTop > box.scrollTop + box.clientHeight - 30) box.scrollTop = row.offsetTop - 60;
  };
  mark('tree', next.against, 'location');
  mark('tree', next.primitive, 'true');
  mark('active', next.against, 'location');
};
