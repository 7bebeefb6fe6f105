'use strict';

// How the picture comes to be, step by step: colours, fields of pixel memory, and the story of a pixel.
(() => {
  const {read, grouped, tell, make, bytesOf, eachRun, showTip, hideTip} = page;
  const tintColour = [255, 150, 0];
  const tintShare = 0.55;
  const titles = {surface: 'surface', depth_test: 'depth test', comparison: 'classify', bits: 'bits', merge: 'merge', shade: 'shade', effect: 'effect', setup: 'setup', skip: 'skipped', stored: 'store'};

  const unpacked = async bytes => {
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
    return pixelMemory.read(JSON.parse(await new Response(stream).text()));
  };

  // A field of the pixels of a segment as a picture: colours in colour, other numbers in grey from the least to the
  // greatest; of depths, all ones, which is nothing, is white and does not count (sim/debug/field_picture.h). What is
  // beside the segment is black.
  const fieldPicture = (program, frames, field, width, image) => {
    const {pixels} = frames;
    const value = field.width > 0 ? pixels.reader(field) : at => pixels.enabled[at];
    const count = pixels.enabled.length;
    const nothing = storyWords.isDepth(field.role) ? 2 ** field.width - 1 : -1;
    const isColour = storyWords.isColour(field.role) && field.width >= 3 && field.width <= 24;
    let [low, high] = [2 ** 32, 0];
    for (let at = 0; at < count; ++at) {
      const one = value(at);
      if (one === nothing) continue;
      low = Math.min(low, one);
      high = Math.max(high, one);
    }
    if (field.width <= 1) [low, high] = [0, 1];
    low = Math.min(low, high);
    const grey = one => one === nothing || one >= high ? 255 : Math.floor((one - low) * 255 / (high - low));
    image.data.fill(0);
    const segment = program.segments[frames.segment];
    const [left, top] = [segment.x + pixels.x, segment.y + pixels.y].map(from => from / frames.every);
    for (let at = 0; at < count; ++at) {
      const to = 4 * ((top + Math.floor(at / pixels.columns)) * width + left + at % pixels.columns);
      const channels = isColour ? storyWords.channelsOf(value(at), field.width) : Array(3).fill(grey(value(at)));
      image.data.set(channels, to);
    }
    for (let i = 3; i < image.data.length; i += 4) image.data[i] = 255;
    return isColour ? 'in its colours' : `black is ${grouped(low)}, white ${grouped(high)}${nothing < 0 ? '' : ' or nothing'}`;
  };

  // The story of a pixel, and its form.
  class Why {
    constructor(program, stepAfter, goTo) {
      Object.assign(this, {program, stepAfter, goTo, words: new storyWords.Words(program)});
      this.pixel = make('input', {size: '9', placeholder: 'x,y', spellcheck: 'false', autocomplete: 'off'});
      this.whyNot = make('select', {}, make('option', {value: ''}, '(nothing)'),
        ...program.primitives.map((name, i) => make('option', {value: i}, `p${i} ${name}`)));
      this.form = make('form', {class: 'ask'}, make('label', {}, 'Pixel', this.pixel), make('label', {}, 'Why not', this.whyNot), make('button', {}, 'Tell why'));
      this.story = make('div', {class: 'story'}, make('p', {class: 'note'}, 'Click a pixel, or move to it with the arrow keys and press Enter, to be told why it shows what it shows.'));
      this.element = make('div', {class: 'why', role: 'group', 'aria-label': 'Why a pixel shows what it shows'}, this.form, this.story);
    }

    ask(x, y) {
      const {program, words} = this;
      if (!(x < program.width && y < program.height)) {
        this.say(`there is no pixel ${this.pixel.value} in a picture of ${program.width} x ${program.height}`);
        return false;
      }
      this.pixel.value = `${x},${y}`;
      const story = pixelStory.of(program, x, y);
      const [first, ...head] = words.head(story);
      const answer = this.whyNot.value === '' ? [] : words.whyNot(story, pixelStory.whyNot(program, story, Number(this.whyNot.value)));
      const parts = [make('p', {class: 'shows'}, make('strong', {}, first)), this.lines('facts', head), this.events(story)];
      if (answer.length > 0) parts.unshift(make('div', {class: 'answer'}, make('strong', {}, answer[0]), this.lines('facts', answer.slice(1))));
      if (words.beside(story)) parts.push(make('p', {class: 'note'}, words.beside(story)));
      if (story.segments.length === 0) parts.push(make('p', {}, 'no segment holds this pixel: it shows the background'));
      this.story.replaceChildren(...parts);
      tell(answer.length > 0 ? answer.join('. ') : [first, ...head].join(', '));
      return true;
    }

    say(text) {
      this.story.replaceChildren(make('p', {}, text));
      tell(text);
    }

    lines(name, lines) { return make('ul', {class: name}, ...lines.map(line => make('li', {}, line))); }

    // A line each, with a button that sets the time to its end; and after each surface how it ended.
    events(story) {
      const {words} = this;
      const isTold = words.worthTelling(story);
      const list = make('ol', {class: 'events', 'aria-label': 'What happened at the pixel', tabindex: '0'});
      let segment = -1;
      story.events.forEach((event, i) => {
        if (!isTold[i]) return;
        if (story.segments.length > 1 && event.segment !== segment) list.append(make('li', {class: 'part'}, `segment ${event.segment}`));
        segment = event.segment;
        list.append(this.item(event));
        for (const attempt of story.attempts)
          if (attempt.lastEvent === i) list.append(make('li', {class: 'verdict'}, '⇒ ' + words.verdictOf(story, attempt)));
      });
      return list;
    }

    item(event) {
      const [first, ...more] = this.words.event(event);
      const numbers = event.first === event.last ? `i${event.first}` : `i${event.first}..i${event.last}`;
      const step = this.stepAfter(event.last + 1);
      const button = make('button', {type: 'button', 'data-step': step, title: `To step ${grouped(step)} of the drawing`}, numbers);
      button.addEventListener('click', () => {
        this.goTo(step);
        tell(`step ${step}, ${titles[event.what]}: ${first}`);
      });
      return make('li', {}, button, make('span', {class: 'what'}, titles[event.what]), make('div', {}, first, ...more.map(line => make('small', {}, line))));
    }

    // The time is at that step.
    mark(step) {
      for (const button of this.story.querySelectorAll('.events button'))
        button.setAttribute('aria-current', Number(button.dataset.step) === step ? 'step' : 'false');
    }
  }

  class Drawing {
    constructor(box, data) {
      const {width, height, every, steps} = data;
      Object.assign(this, {box, width, height, every, steps, packed: data.program, now: 0, timer: 0, cursor: [Math.floor(width / 2), Math.floor(height / 2)]});
      this.states = new Uint32Array(width * height);
      this.image = new ImageData(width, height);
      this.canvas = make('canvas', {width, height, tabindex: '0', role: 'application', class: width < 256 ? 'small' : ''});
      this.mark = make('div', {class: 'mark', hidden: ''});
      this.scale = make('p', {class: 'note scale'});
      this.slider = make('input', {type: 'range', min: 0, max: steps.length - 1, value: 0, 'aria-label': 'Step of the drawing'});
      this.state = make('div', {class: 'state'});
      this.tint = make('input', {type: 'checkbox', checked: ''});
      this.field = make('select', {}, make('option', {value: ''}, 'the picture'));
      this.controls = make('div', {class: 'controls'});
      this.right = make('div', {}, this.controls, this.state);
      this.setUpControls();
      this.setUpCanvas();
      const stage = make('div', {class: 'canvas'}, this.canvas, this.mark);
      box.replaceChildren(make('div', {class: 'left'}, stage, this.scale), this.right);
      this.apply(0);
      this.goTo(steps.length - 1);
      if (this.packed) this.load();
      else this.name();
    }

    name() {
      this.canvas.setAttribute('aria-label', 'Pixel memory at the chosen step.' + (this.why ? ' Arrow keys move the cursor, with Shift by ten pixels; Enter tells why the pixel shows what it shows.' : ''));
    }

    // Unpacks the Program; stories and fields come with it.
    async load() {
      this.box.setAttribute('aria-busy', 'true');
      try {
        this.program = await unpacked(bytesOf(this.packed));
      } catch (error) {
        this.right.append(make('p', {class: 'note'}, 'This browser cannot unpack the Program, from which fields and stories are worked out: ' + error.message));
        this.name();
        return;
      } finally {
        this.box.removeAttribute('aria-busy');
      }
      this.frames = new pixelMemory.Frames(this.program, this.every);
      this.fields = [{name: 'E', base: 0, width: 0, role: 'enable'}, ...this.program.fields.filter(field => field.width <= 32 && !pixelMemory.isSame(field, this.program.colour))];
      this.field.append(...this.fields.map((field, i) => make('option', {value: i}, field.name)));
      this.why = new Why(this.program, number => this.stepAfter(number), step => this.goTo(step));
      this.why.form.addEventListener('submit', event => {
        event.preventDefault();
        const [, x, y] = /^\s*(\d+)\s*[, ]\s*(\d+)\s*$/.exec(this.why.pixel.value) || [];
        if (x === undefined) this.why.say('say which pixel, as x,y');
        else this.ask(Number(x), Number(y));
      });
      document.addEventListener('pixel', event => this.ask(...event.detail));
      if (!document.getElementById('why')) this.why.element.id = 'why';
      this.right.append(this.why.element);
      this.name();
    }

    // The first step that has carried out so many instructions.
    stepAfter(number) {
      const step = this.steps.findIndex(each => each[0] >= number);
      return step < 0 ? this.steps.length - 1 : step;
    }

    ask(x, y) {
      if (!this.why || !this.why.ask(x, y)) return;
      this.moveTo(Math.floor(x / this.every), Math.floor(y / this.every));
      this.why.mark(this.now);
    }

    moveTo(column, row) {
      this.cursor = [Math.max(0, Math.min(this.width - 1, column)), Math.max(0, Math.min(this.height - 1, row))];
      this.mark.style.left = (this.cursor[0] + 0.5) / this.width * 100 + '%';
      this.mark.style.top = (this.cursor[1] + 0.5) / this.height * 100 + '%';
      this.mark.hidden = false;
    }

    apply(index) {
      let at = 0;
      eachRun(bytesOf(this.steps[index][5]), 3, (same, count, difference) => {
        at += same;
        for (const end = at + count; at < end; ++at) this.states[at] ^= difference;
      });
    }

    colourAt(at) { return [this.states[at] >> 17 & 255, this.states[at] >> 9 & 255, this.states[at] >> 1 & 255]; }

    paintColours() {
      for (let at = 0; at < this.states.length; ++at) {
        const value = this.states[at];
        this.image.data.set([value >> 17 & 255, value >> 9 & 255, value >> 1 & 255, 255], 4 * at);
      }
      this.finish('');
    }

    // What is enabled is tinted, and the picture shown.
    finish(scale) {
      const {data} = this.image;
      for (let at = 0; this.tint.checked && at < this.states.length; ++at) {
        if (!(this.states[at] & 1)) continue;
        for (let i = 0; i < 3; ++i) data[4 * at + i] = data[4 * at + i] * (1 - tintShare) + tintColour[i] * tintShare;
      }
      this.canvas.getContext('2d').putImageData(this.image, 0, 0);
      this.scale.textContent = scale;
      this.box.removeAttribute('aria-busy');
    }

    // Runs the Program up to the step, and lets the page breathe meanwhile.
    paintField() {
      clearTimeout(this.working);
      this.box.setAttribute('aria-busy', 'true');
      const number = this.steps[this.now][0];
      if (!this.frames.goTo(number, 40)) {
        this.scale.textContent = `worked out up to i${grouped(this.frames.number)} of ${grouped(number)}`;
        this.working = setTimeout(() => this.paintField());
        return;
      }
      const field = this.fields[Number(this.field.value)];
      this.finish(`${field.name}: ${fieldPicture(this.program, this.frames, field, this.width, this.image)}`);
    }

    paint() {
      clearTimeout(this.working);
      if (this.field.value === '') this.paintColours();
      else this.paintField();
    }

    goTo(index) {
      const to = Math.max(0, Math.min(this.steps.length - 1, index));
      while (this.now < to) this.apply(++this.now);
      while (this.now > to) this.apply(this.now--);
      this.slider.value = this.now;
      const [number, text, serves, clocks, pixels] = this.steps[this.now];
      const line = `Step ${grouped(this.now)} of ${grouped(this.steps.length - 1)}: ${grouped(number)} instructions, ${grouped(clocks)} clocks; ${grouped(pixels)} pixels enabled`;
      this.state.replaceChildren(make('p', {}, line), make('p', {}, serves));
      if (text) this.state.append(make('p', {}, 'last: ', make('code', {}, text)));
      this.slider.setAttribute('aria-valuetext', line + ', ' + serves);
      if (this.why) this.why.mark(this.now);
      this.paint();
    }

    stop() {
      clearInterval(this.timer);
      this.timer = 0;
      if (this.play) this.play.textContent = 'Play';
    }

    // To the next step that serves another primitive.
    nextPart(by) {
      const part = step => this.steps[step][2].split(' against ')[0];
      let to = this.now;
      while (to + by >= 0 && to + by < this.steps.length && part(to + by) === part(this.now)) to += by;
      this.goTo(to + by);
    }

    setUpControls() {
      const button = (text, action) => {
        const one = make('button', {type: 'button'}, text);
        one.addEventListener('click', action);
        this.controls.append(one);
        return one;
      };
      const move = (text, action) => button(text, () => { this.stop(); action(); });
      this.controls.append(this.slider);
      move('Start', () => this.goTo(0));
      move('Part back', () => this.nextPart(-1));
      move('Step back', () => this.goTo(this.now - 1));
      if (!matchMedia('(prefers-reduced-motion: reduce)').matches) this.play = button('Play', () => this.playOrPause());
      move('Step', () => this.goTo(this.now + 1));
      move('Next part', () => this.nextPart(1));
      move('End', () => this.goTo(this.steps.length - 1));
      if (this.packed) this.controls.append(make('label', {}, 'show', this.field));
      this.controls.append(make('label', {}, this.tint, 'tint the enabled pixels'));
      this.tint.addEventListener('change', () => this.paint());
      this.field.addEventListener('change', () => this.paint());
      this.slider.addEventListener('input', () => { this.stop(); this.goTo(Number(this.slider.value)); });
    }

    playOrPause() {
      if (this.timer) {
        this.stop();
        return;
      }
      if (this.now === this.steps.length - 1) this.goTo(0);
      this.play.textContent = 'Pause';
      this.timer = setInterval(() => this.now < this.steps.length - 1 ? this.goTo(this.now + 1) : this.stop(), 60);
    }

    // What the field that is shown holds there; nothing beside the segment.
    valueAt(column, row) {
      const {pixels, segment} = this.frames;
      const {x, y} = this.program.segments[segment];
      const [left, top] = [column - (x + pixels.x) / this.every, row - (y + pixels.y) / this.every];
      if (left < 0 || top < 0 || left >= pixels.columns || top >= pixels.rows) return '';
      const field = this.fields[Number(this.field.value)];
      const at = top * pixels.columns + left;
      return field.width === 0 ? '' : `, ${field.name} ${this.why.words.value(field, pixels.reader(field)(at))}`;
    }

    // What a pixel of the canvas holds, in words.
    toldAt(column, row) {
      const at = row * this.width + column;
      const colour = '#' + this.colourAt(at).map(channel => channel.toString(16).padStart(2, '0')).join('');
      const isWorkedOut = this.field.value !== '' && !this.box.hasAttribute('aria-busy');
      return `${column * this.every}, ${row * this.every}: ${colour}${isWorkedOut ? this.valueAt(column, row) : ''}, ${this.states[at] & 1 ? 'enabled' : 'disabled'}`;
    }

    askAtCursor() { document.dispatchEvent(new CustomEvent('pixel', {detail: this.cursor.map(one => one * this.every)})); }

    setUpCanvas() {
      const {canvas} = this;
      const at = event => {
        const frame = canvas.getBoundingClientRect();
        const of = (from, begin, size, count) => Math.max(0, Math.min(count - 1, Math.floor((from - begin) * count / size)));
        return [of(event.clientX, frame.left, frame.width, this.width), of(event.clientY, frame.top, frame.height, this.height)];
      };
      canvas.addEventListener('pointermove', event => showTip(this.toldAt(...at(event)), event.clientX, event.clientY));
      canvas.addEventListener('pointerleave', hideTip);
      canvas.addEventListener('click', event => {
        this.moveTo(...at(event));
        this.askAtCursor();
      });
      canvas.addEventListener('keydown', event => {
        const by = event.shiftKey ? 10 : 1;
        const arrow = {ArrowLeft: [-by, 0], ArrowRight: [by, 0], ArrowUp: [0, -by], ArrowDown: [0, by]}[event.key];
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        if (arrow) {
          this.moveTo(this.cursor[0] + arrow[0], this.cursor[1] + arrow[1]);
          tell(this.toldAt(...this.cursor));
        } else if (event.key === 'Enter') {
          this.askAtCursor();
        } else {
          return;
        }
        event.preventDefault();
      });
    }
  }

  const drawings = [...document.querySelectorAll('.drawing')].map(box => new Drawing(box, read(box.dataset.of)));
  // For who looks into the page: a program, or somebody at the console.
  window.csgsimDrawings = drawings;
})();
