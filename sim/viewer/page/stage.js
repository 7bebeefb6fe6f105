// The picture, and the camera, which pointer and keys move.
import {byId} from './dom.js';
import {now} from './asking.js';
import {draw} from './draw.js';
import {explainPixel} from './why.js';

const minus = (a, b) => a.map((value, i) => value - b[i]);
const plus = (a, b) => a.map((value, i) => value + b[i]);
const times = (a, by) => a.map(value => value * by);
const size = a => Math.hypot(...a);

// Turns the camera about the vertical axis through the centre, and up and down, but not over the poles.
const turn = (right, up) => {
  if (!now.camera) return;
  const from = minus(now.camera.eye, now.camera.centre);
  const distance = size(from);
  const around = Math.atan2(from[1], from[0]) + right;
  const above = Math.max(-1.55, Math.min(1.55, Math.asin(from[2] / distance) + up));
  now.camera.eye = plus(now.camera.centre, times([Math.cos(above) * Math.cos(around), Math.cos(above) * Math.sin(around), Math.sin(above)], distance));
  moved();
};

// Moves the camera in the plane of the picture, in fractions of the distance to the eye.
const move = (right, up) => {
  if (!now.camera) return;
  const from = minus(now.camera.eye, now.camera.centre);
  const flat = Math.hypot(from[0], from[1]) || 1e-9;
  const side = [-from[1] / flat, from[0] / flat, 0];
  const distance = size(from);
  const ahead = times(from, 1 / distance);
  const upwards = [ahead[1] * side[2] - ahead[2] * side[1], ahead[2] * side[0] - ahead[0] * side[2], ahead[0] * side[1] - ahead[1] * side[0]];
  const by = plus(times(side, right * distance), times(upwards, up * distance));
  now.camera = {eye: plus(now.camera.eye, by), centre: plus(now.camera.centre, by)};
  moved();
};

const comeNearer = by => {
  if (!now.camera) return;
  now.camera.eye = plus(now.camera.centre, times(minus(now.camera.eye, now.camera.centre), by));
  moved();
};

const moved = () => {
  byId('view-all').checked = false;
  byId('mark').hidden = true;
  draw();
};

const pixelAt = event => {
  const box = byId('picture').getBoundingClientRect();
  const at = (value, begin, length, count) => Math.max(0, Math.min(count - 1, Math.floor((value - begin) / length * count)));
  return [at(event.clientX, box.left, box.width, now.drawn.width), at(event.clientY, box.top, box.height, now.drawn.height)];
};

export const setUpStage = () => {
  const stage = byId('stage');
  let held = null;
  stage.addEventListener('pointerdown', event => {
    held = {x: event.clientX, y: event.clientY, hasMoved: false};
    stage.setPointerCapture(event.pointerId);
  });
  stage.addEventListener('pointermove', event => {
    if (!held) return;
    const x = event.clientX - held.x;
    const y = event.clientY - held.y;
    if (!held.hasMoved && Math.hypot(x, y) < 4) return;
    stage.classList.add('turning');
    const width = stage.clientWidth;
    if (event.shiftKey) move(-x / width, y / width);
    else turn(-x / width * 3, y / width * 3);
    held = {x: event.clientX, y: event.clientY, hasMoved: true};
  });
  stage.addEventListener('pointerup', event => {
    stage.classList.remove('turning');
    if (held && !held.hasMoved && now.drawn) {
      explainPixel(pixelAt(event));
    }
    held = null;
  });
  stage.addEventListener('pointercancel', () => { held = null; });
  stage.addEventListener('wheel', event => {
    event.preventDefault();
    comeNearer(Math.exp(Math.max(-100, Math.min(100, event.deltaY)) / 500));
  }, {passive: false});
  stage.addEventListener('keydown', event => {
    const step = 5 * Math.PI / 180;
    const arrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key];
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (arrows && event.shiftKey) move(arrows[0] * 0.05, arrows[1] * 0.05);
    else if (arrows) turn(arrows[0] * step, arrows[1] * step);
    else if (event.key === '+' || event.key === '=') comeNearer(0.9);
    else if (event.key === '-') comeNearer(1 / 0.9);
    else if (event.key === '0' && now.first) {
      now.camera = structuredClone(now.first);
      moved();
    } else return;
    event.preventDefault();
  });
};
