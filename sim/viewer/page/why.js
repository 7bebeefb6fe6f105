// Explains what a pixel shows.
import {button, byId, make, announce} from './dom.js';
import {ask, now, shownRequest} from './asking.js';
import {goTo} from './time.js';

const showEvents = events => {
  byId('events').replaceChildren(...events.map(event => {
    const whose = event.primitive ? ' p' + event.primitive.index + ' ' + event.primitive.name : '';
    const label = 'i' + event.first + (event.last > event.first ? '–i' + event.last : '') + '  ' + event.what.replace(/_/g, ' ') + whose + (event.enabled[1] ? '' : ': the pixel is then disabled');
    return make('li', {}, button(label, () => goTo(event.last + 1)));
  }));
  byId('events').hidden = events.length === 0;
};

const explain = async () => {
  const answer = await ask('explain', {...shownRequest(), pixel: byId('pixel').value.trim(), why_not: byId('why-not').value.trim()});
  const story = byId('story');
  story.hidden = false;
  if (!answer.isGood) {
    story.textContent = answer.answer.error;
    return;
  }
  story.textContent = answer.answer.text;
  const [x, y] = answer.answer.story.pixel;
  byId('mark').style.left = (x + 0.5) / now.drawn.width * 100 + '%';
  byId('mark').style.top = (y + 0.5) / now.drawn.height * 100 + '%';
  byId('mark').hidden = false;
  announce(story.textContent.split('\n')[0]);
  showEvents(answer.answer.story.events);
};

export const explainPixel = ([x, y]) => {
  byId('pixel').value = x + ',' + y;
  explain();
};

export const setUpWhy = () => byId('why').addEventListener('submit', event => {
  event.preventDefault();
  explain();
});
