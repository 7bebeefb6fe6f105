// Results that need more time than a picture, computed on request.
import {byId, make} from './dom.js';
import {ask, lastOf, now, shownRequest} from './asking.js';

const advise = lastOf(async () => {
  byId('advice').replaceChildren(make('li', {}, 'trying changes …'));
  const {as} = now.drawn;
  const {isGood, answer} = await ask('advice', shownRequest());
  if (as !== now.drawn.as) return;
  const rows = isGood ? answer.knobs.map(knob => make('li', {}, make('strong', {}, knob.option), ': ' + knob.worth)) : [make('li', {}, answer.error)];
  byId('advice').replaceChildren(...(rows.length ? rows : [make('li', {}, 'none of the tried changes helps')]));
});

const judge = lastOf(async () => {
  byId('verdict').textContent = 'computing the exact picture …';
  const {as} = now.drawn;
  const {isGood, answer} = await ask('verdict', shownRequest());
  if (as !== now.drawn.as) return;
  byId('verdict').textContent = isGood ? answer.text.replace(/^accuracy +/, '') : answer.error;
  byId('verdict').dataset.wrong = isGood ? answer.accuracy.wrong : '';
});

// Clears the answers about an earlier picture.
export const forgetAnswers = () => {
  byId('advice').replaceChildren();
  byId('verdict').textContent = '';
};

export const setUpJudged = () => {
  byId('advise').addEventListener('click', advise);
  byId('judge').addEventListener('click', judge);
};
