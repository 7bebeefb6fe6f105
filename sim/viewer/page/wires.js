// Activities of the machine's units, clock by clock, and waveforms.
import {byId, grouped} from './dom.js';
import {ask, lastOf, now, shownRequest} from './asking.js';
import {Lanes} from './lanes.js';
import {goToClock} from './time.js';

let lanes = null;

const announceInWires = text => { byId('wires-told').textContent = text; };

const probing = () => {
  const probes = byId('probes').value.trim().split(/[\s,;]+/).filter(probe => probe);
  return {pixel: byId('wires-pixel').value.trim() || byId('pixel').value.trim() || '0,0', window: byId('window').value.trim(), probes};
};

const look = lastOf(async () => {
  const request = now.wires;
  if (!request) return;
  const {as} = now.drawn;
  const isNew = now.lanesOf !== as;
  if (isNew) announceInWires('recording, clock by clock …');
  const begun = performance.now();
  const {isGood, answer} = await ask('lanes', {...shownRequest(), ...request});
  if (request !== now.wires || as !== now.drawn.as) return;
  if (!isGood) return announceInWires(answer.error);
  if (isNew) announceInWires('recorded in ' + ((performance.now() - begun) / 1000).toFixed(1) + ' s: ' + grouped(answer.last - answer.first) + ' clocks');
  now.lanesOf = as;
  byId('timeline').hidden = false;
  lanes.show(answer);
  window.shownLanes = (window.shownLanes || 0) + 1;
});

// Clears the lanes of an earlier drawing.
export const forgetLanes = () => {
  now.wires = null;
  now.lanesOf = null;
  byId('timeline').hidden = true;
  announceInWires('');
};

// Shows these clocks with some more on either side. The whole frame is recorded once.
export const lookAtClocks = clocks => {
  const beside = Math.max(20, clocks[1] - clocks[0]);
  now.wires = {begin: Math.max(0, clocks[0] - beside), end: clocks[1] + beside};
  if (lanes) lanes.cursor = clocks[0];
  byId('wires').scrollIntoView({block: 'nearest'});
  look();
};

const saveWave = lastOf(async () => {
  const request = probing();
  announceInWires('recording …');
  const {isGood, answer} = await ask('wave', {...shownRequest(), ...request});
  if (!isGood) return announceInWires(answer.error);
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([answer.wave], {type: 'text/plain'}));
  link.download = 'wave_' + request.window.replace(/[^\w]/g, '_') + '.vcd';
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  announceInWires(link.download + ' is saved; open it with gtkwave or Surfer. This command writes the same: ' + now.drawn.command.replace(/^csgsim render/, 'csgsim wave') + ' --pixel ' + request.pixel + request.probes.map(each => ' --probe ' + each).join('') + ' --window ' + request.window + ' -o wave.vcd');
  window.savedWave = answer.wave;
  window.savedWaves = (window.savedWaves || 0) + 1;
});

export const setUpWires = () => {
  lanes = new Lanes(([begin, end]) => {
    if (now.wires.pixel) return;
    now.wires = {begin, end};
    look();
  }, goToClock);
  const show = request => {
    now.wires = request;
    look();
  };
  byId('frame').addEventListener('click', () => show({}));
  byId('nearer').addEventListener('click', () => lanes.zoom(0.5, lanes.cursor));
  byId('farther').addEventListener('click', () => lanes.zoom(2, lanes.cursor));
  byId('earlier').addEventListener('click', () => lanes.move(-0.5));
  byId('later').addEventListener('click', () => lanes.move(0.5));
  byId('all-lanes').addEventListener('change', () => lanes.paint());
  byId('probing').addEventListener('submit', event => {
    event.preventDefault();
    now.lanesOf = null;
    show(probing());
  });
  byId('save-wave').addEventListener('click', saveWave);
};
