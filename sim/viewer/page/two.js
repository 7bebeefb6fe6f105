// Comparison of two drawings.
import {byId, grouped} from './dom.js';
import {ask, lastOf, now, shownRequest} from './asking.js';
import {showCounts} from './draw.js';

export const compareTwo = lastOf(async () => {
  if (!now.kept) return;
  const {isGood, answer} = await ask('two', {a: now.kept.request, b: shownRequest()});
  if (!isGood) {
    byId('differs').textContent = answer.error;
    return;
  }
  byId('difference').src = answer.picture;
  const pixels = answer.pixels === 0 ? 'The pictures are equal' : grouped(answer.pixels) + (answer.pixels === 1 ? ' pixel differs' : ' pixels differ') + ', the first at ' + answer.first.join(',');
  const other = answer.instruction;
  byId('differs').replaceChildren(pixels + '. ', other ? 'The first instruction that differs is i' + grouped(other.number) + ': ' + other.a + ' in A, ' + other.b + ' now.' : 'All instructions are the same.');
  window.comparedTwo = (window.comparedTwo || 0) + 1;
});

export const setUpTwo = () => {
  byId('keep').addEventListener('click', () => {
    if (!now.drawn) return;
    now.kept = {request: shownRequest(), drawn: now.drawn};
    byId('a').src = now.drawn.picture;
    byId('kept').textContent = now.drawn.command;
    byId('two').hidden = false;
    showCounts(now.drawn.stats);
    compareTwo();
  });
};
