// Lanes of stretches of clocks, drawn on a canvas that can be zoomed and moved by pointer and keys.
import {byId, grouped, make} from './dom.js';

const height = 22;
const waits = /^(wait|block|latent|hold|asking|drain|idle|asleep|done|full|empty|ready)/;

const colourOf = (text, isDark) => {
  if (waits.test(text)) return isDark ? '#474747' : '#d9d9d9';
  let hash = 7;
  for (const letter of text.split(' ')[0]) hash = (hash * 31 + letter.charCodeAt(0)) % 3600;
  return 'hsl(' + hash / 10 + ' 55% ' + (isDark ? '38%' : '76%') + ')';
};

// Shows an answer of csgsim: {begin, end, lanes}. Calls `changed` with a range of clocks to load and `chosen` with a
// clock.
export class Lanes {
  constructor(changed, chosen) {
    Object.assign(this, {changed, chosen, canvas: byId('lanes'), view: null, data: null, limits: [0, 1], cursor: 0, held: null});
    this.canvas.addEventListener('wheel', event => this.onWheel(event), {passive: false});
    this.canvas.addEventListener('pointerdown', event => {
      this.held = {x: event.clientX, hasMoved: false};
      this.canvas.setPointerCapture(event.pointerId);
    });
    this.canvas.addEventListener('pointermove', event => this.onMove(event));
    this.canvas.addEventListener('pointerup', event => {
      if (this.held && !this.held.hasMoved) this.chosen(this.clockAt(event));
      this.held = null;
    });
    this.canvas.addEventListener('keydown', event => this.onKey(event));
    new ResizeObserver(() => this.paint()).observe(this.canvas);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.paint());
  }

  show(answer) {
    this.data = answer;
    this.limits = [answer.first, answer.last];
    this.view = [answer.begin, answer.end];
    if (this.cursor < answer.begin || this.cursor >= answer.end) this.cursor = answer.begin;
    this.paint();
  }

  shownLanes() {
    const isMain = lane => byId('all-lanes').checked || /^(state|activity|text|square|segment|subsegment|packet|function)$/.test(lane.name) || lane.part.startsWith('pixel_');
    return this.data ? this.data.lanes.filter(lane => isMain(lane) && lane.stretches.length) : [];
  }

  clockAt(event) {
    const box = this.canvas.getBoundingClientRect();
    const [begin, end] = this.view;
    return Math.max(begin, Math.min(end - 1, Math.floor(begin + (event.clientX - box.left) / box.width * (end - begin))));
  }

  // Shows other clocks, within the limits of the recording.
  go(begin, end) {
    if (!this.view) return;
    const [first, last] = this.limits;
    const length = Math.max(1, Math.min(last - first, Math.round(end - begin)));
    const from = Math.max(first, Math.min(last - length, Math.round(begin)));
    this.view = [from, from + length];
    this.paint();
    this.changed(this.view);
  }

  zoom(by, about) {
    if (!this.view) return;
    const [begin, end] = this.view;
    const length = Math.max(8, (end - begin) * by);
    this.go(about - (about - begin) / (end - begin) * length, about - (about - begin) / (end - begin) * length + length);
  }

  move(by) {
    if (!this.view) return;
    const length = this.view[1] - this.view[0];
    this.go(this.view[0] + by * length, this.view[1] + by * length);
  }

  onWheel(event) {
    if (!this.view) return;
    event.preventDefault();
    this.zoom(Math.exp(Math.max(-100, Math.min(100, event.deltaY)) / 300), this.clockAt(event));
  }

  onMove(event) {
    if (!this.view) return;
    if (!this.held) {
      this.cursor = this.clockAt(event);
      this.paint();
      return;
    }
    const by = event.clientX - this.held.x;
    if (!this.held.hasMoved && Math.abs(by) < 4) return;
    this.move(-by / this.canvas.clientWidth);
    this.held = {x: event.clientX, hasMoved: true};
  }

  onKey(event) {
    if (!this.view || event.ctrlKey || event.metaKey || event.altKey) return;
    const grain = Math.max(1, Math.round((this.view[1] - this.view[0]) / 100));
    const steps = {ArrowLeft: -1, ArrowRight: 1}[event.key];
    if (steps && event.shiftKey) this.move(steps / 4);
    else if (steps) this.point(this.cursor + steps * grain);
    else if (event.key === '+' || event.key === '=') this.zoom(0.5, this.cursor);
    else if (event.key === '-') this.zoom(2, this.cursor);
    else if (event.key === 'Home') this.go(...this.limits);
    else if (event.key === 'Enter') this.chosen(this.cursor);
    else return;
    event.preventDefault();
  }

  point(clock) {
    this.cursor = Math.max(this.limits[0], Math.min(this.limits[1] - 1, clock));
    if (this.cursor < this.view[0] || this.cursor >= this.view[1]) this.move(this.cursor < this.view[0] ? -0.5 : 0.5);
    this.paint();
  }

  paint() {
    const lanes = this.shownLanes();
    byId('lane-names').replaceChildren(...lanes.map(lane => make('li', {}, lane.part.replace(/_/g, ' ') + ' ' + lane.name.replace(/_/g, ' '))));
    this.canvas.style.height = Math.max(1, lanes.length) * height + 'px';
    const scale = devicePixelRatio;
    const width = this.canvas.clientWidth;
    this.canvas.width = Math.max(1, Math.round(width * scale));
    this.canvas.height = Math.round(Math.max(1, lanes.length) * height * scale);
    const pen = this.canvas.getContext('2d');
    pen.scale(scale, scale);
    pen.font = '12px ui-monospace, "DejaVu Sans Mono", monospace';
    pen.textBaseline = 'middle';
    lanes.forEach((lane, row) => this.paintLane(pen, lane, row * height, width));
    if (lanes.length) this.paintCursor(pen, width, lanes.length * height);
    this.tellCursor(lanes);
  }

  paintLane(pen, lane, top, width) {
    const [begin, end] = this.view;
    const isDark = matchMedia('(prefers-color-scheme: dark)').matches;
    const placeOf = clock => (clock - begin) / (end - begin) * width;
    for (const [first, clocks, text, count, busy] of lane.stretches) {
      const left = Math.max(0, placeOf(first));
      const right = Math.min(width, placeOf(first + clocks));
      if (right <= 0 || left >= width) continue;
      pen.globalAlpha = count ? 0.35 + 0.65 * busy / clocks : 1;
      pen.fillStyle = colourOf(text, isDark);
      pen.fillRect(left, top + 2, Math.max(1, right - left - (right - left > 3 ? 1 : 0)), height - 4);
      pen.globalAlpha = 1;
      if (right - left < 14) continue;
      pen.fillStyle = isDark ? '#eee' : '#111';
      const letters = Math.floor((right - left - 4) / 7.3);
      const label = count ? text + ' …×' + count : text;
      pen.fillText(label.length > letters ? label.slice(0, Math.max(0, letters - 1)) + '…' : label, left + 3, top + height / 2);
    }
  }

  paintCursor(pen, width, bottom) {
    const [begin, end] = this.view;
    pen.fillStyle = getComputedStyle(document.body).getPropertyValue('--mark') || 'red';
    pen.fillRect((this.cursor - begin + 0.5) / (end - begin) * width - 0.5, 0, 1.5, bottom);
  }

  // Describes the cursor position for screen readers, and texts too narrow to read.
  tellCursor(lanes) {
    const at = lane => lane.stretches.find(([first, clocks]) => first <= this.cursor && this.cursor < first + clocks);
    const active = lanes.map(lane => [lane, at(lane)]).filter(([, stretch]) => stretch);
    byId('lanes-told').textContent = this.view ? 'Clock ' + grouped(this.cursor) + ' of ' + grouped(this.view[0]) + ' to ' + grouped(this.view[1]) + ': '
      + active.map(([lane, [, , text, count]]) => lane.part + ' ' + (lane.name === 'state' || lane.name === 'activity' ? '' : lane.name + ' ') + text + (count ? ' (of ' + count + ')' : '')).join('; ') : '';
  }
}
