'use strict';

// Evolution of the picture, step by step, and the histories of pixels.
(() => {
  const {read, grouped, announce, make, bytesOf, eachRun, showTip, hideTip} = page;
  const tintColour = [255, 150, 0];
  const tintShare = 0.55;
  const linesOf = text => text.split('\n').map(line => line.trim()).filter(line => line);

  // Histories of pixels stored in the page. For other pixels it shows the command that prints the history.
  class Why {
    constructor(drawing, {stories, explain}) {
      Object.assign(this, {drawing, stories, explain, reach: Math.max(3, Math.round(Math.max(drawing.width, drawing.height) * drawing.every / 64))});
      this.choice = make('select', {}, make('option', {value: ''}, '(choose)'), ...stories.map((story, i) => make('option', {value: i}, this.title(story))));
      this.pixel = make('input', {size: '9', placeholder: 'x,y', spellcheck: 'false', autocomplete: 'off'});
      this.form = make('form', {class: 'ask'}, make('label', {}, 'History of', this.choice), make('label', {}, 'Pixel', this.pixel), make('button', {}, 'Explain'));
      this.story = make('div', {class: 'story'}, make('p', {class: 'note'}, 'Click near a dot in the drawing, or move there with the arrow keys and press Enter, to see why the pixel shows what it shows.'));
      this.element = make('div', {class: 'why', role: 'group', 'aria-label': 'Why a pixel shows what it shows'}, this.form, this.story);
      this.choice.addEventListener('change', () => { if (this.choice.value !== '') this.tellStory(this.stories[Number(this.choice.value)]); });
      this.form.addEventListener('submit', event => {
        event.preventDefault();
        const [, x, y] = /^\s*(\d+)\s*[, ]\s*(\d+)\s*$/.exec(this.pixel.value) || [];
        if (x === undefined) this.say('enter a pixel as x,y');
        else this.ask(Number(x), Number(y), 0);
      });
      document.addEventListener('pixel', event => { event.detail.pixel = this.ask(...event.detail.pixel, this.reach); });
      document.addEventListener('primitive', event => this.tellPrimitive(event.detail));
    }

    // Title of a history, as in `310,250: p3 cylinder@9:9`.
    title({x, y, parts}) { return `${x},${y}: ${parts[0].split('\n')[0].replace(/^.* shows (.*?)(, line .*)?$/, '$1')}`; }

    // Shows the history of the nearest pixel within `reach` columns and rows, or else the command, and returns the
    // pixel.
    ask(x, y, reach) {
      const {width, height, every} = this.drawing;
      if (x >= width * every || y >= height * every) {
        this.say(`there is no pixel ${x},${y} in the picture`);
        return [x, y];
      }
      const distance = story => Math.max(Math.abs(story.x - x), Math.abs(story.y - y));
      const [nearest] = [...this.stories].sort((a, b) => distance(a) - distance(b));
      if (distance(nearest) > reach) {
        this.showCommand(x, y, nearest);
        return [x, y];
      }
      this.tellStory(nearest);
      return [nearest.x, nearest.y];
    }

    // Stores the pixel whose history is shown in `chosen`.
    tellPrimitive(chosen) {
      const story = this.stories.find(one => one.primitive === chosen.primitive);
      if (!story) return;
      this.tellStory(story);
      chosen.pixel = [story.x, story.y];
    }

    moveTo(x, y, choice) {
      this.pixel.value = `${x},${y}`;
      this.choice.value = choice;
      this.drawing.moveTo(Math.floor(x / this.drawing.every), Math.floor(y / this.drawing.every));
    }

    showCommand(x, y, nearest) {
      this.moveTo(x, y, '');
      const other = make('button', {type: 'button'}, `History of ${this.title(nearest)}`);
      other.addEventListener('click', () => this.tellStory(nearest));
      this.story.replaceChildren(
        make('p', {}, `This page does not include the history of pixel ${x},${y}. This command prints it:`),
        make('pre', {class: 'command', tabindex: '0', 'aria-label': 'The command'}, `${this.explain} --pixel ${x},${y}`),
        make('p', {class: 'note'}, 'csgsim view shows the history of every pixel, and every field at every instruction.'),
        make('p', {}, 'The nearest pixel with a history on this page: ', other));
      announce(`this page does not include the history of pixel ${x},${y}`);
    }

    tellStory(story) {
      this.moveTo(story.x, story.y, this.stories.indexOf(story));
      const [first, ...facts] = linesOf(story.parts[0]);
      const events = make('ol', {class: 'events', 'aria-label': 'Events at the pixel', tabindex: '0'});
      for (const part of story.parts.slice(1)) events.append(...(typeof part === 'string' ? this.between(part) : [this.event(...part)]));
      this.story.replaceChildren(make('p', {class: 'shows'}, make('strong', {}, first)), make('ul', {class: 'facts'}, ...facts.map(line => make('li', {}, line))), events);
      this.mark(this.drawing.now);
      announce([first, ...facts].join(', '));
    }

    say(text) {
      this.story.replaceChildren(make('p', {}, text));
      announce(text);
    }

    // Lines between events: the result of a surface, a segment, surfaces beside the pixel.
    between(text) {
      const lines = linesOf(text).filter(line => line !== 'clocks');
      const kind = line => line.startsWith('=>') ? 'verdict' : line.startsWith('segment') ? 'part' : 'note';
      return lines.map(line => make('li', {class: kind(line)}, line.replace(/^=>/, '⇒')));
    }

    // An event. Its first line has columns, with a button that moves the drawing to the end of the event.
    event(text, step) {
      const [first, ...more] = linesOf(text);
      const [, numbers, clocks, what, happened] = /^(\S+) +(\S+) +(\S+(?: \S+)?)(?: {2,}(.*))?$/.exec(first);
      const button = make('button', {type: 'button', 'data-step': step, title: `Go to step ${grouped(step)} of the drawing`}, numbers);
      button.addEventListener('click', () => {
        this.drawing.goTo(step);
        announce(`step ${step}, ${what}: ${happened}`);
      });
      return make('li', {}, make('span', {}, button, make('small', {title: 'clocks'}, clocks)), make('span', {class: 'what'}, what),
        make('div', {}, happened || '', ...more.map(line => make('small', {}, line))));
    }

    // Marks the events at this step.
    mark(step) {
      for (const button of this.story.querySelectorAll('.events button'))
        button.setAttribute('aria-current', Number(button.dataset.step) === step ? 'step' : 'false');
    }
  }

  class Drawing {
    constructor(box, data) {
      const {width, height, every, steps} = data;
      Object.assign(this, {box, width, height, every, steps, now: 0, timer: 0, cursor: [Math.floor(width / 2), Math.floor(height / 2)]});
      this.states = new Uint32Array(width * height);
      this.image = new ImageData(width, height);
      this.canvas = make('canvas', {width, height, tabindex: '0', role: 'application', class: width < 256 ? 'small' : ''});
      this.mark = make('div', {class: 'mark', hidden: ''});
      this.slider = make('input', {type: 'range', min: 0, max: steps.length - 1, value: 0, 'aria-label': 'Step of the drawing'});
      this.state = make('div', {class: 'state'});
      this.tint = make('input', {type: 'checkbox', checked: ''});
      this.controls = make('div', {class: 'controls'});
      this.why = new Why(this, data);
      if (!document.getElementById('why')) this.why.element.id = 'why';
      this.setUpControls();
      this.setUpCanvas();
      const dots = data.stories.map(({x, y}) => this.placed(make('div', {class: 'dot'}), Math.floor(x / every), Math.floor(y / every)));
      const stage = make('div', {class: 'canvas'}, this.canvas, ...dots, this.mark);
      box.replaceChildren(make('div', {class: 'left'}, stage), make('div', {}, this.controls, this.state, this.why.element));
      this.apply(0);
      this.goTo(steps.length - 1);
    }

    // Centres the element at that pixel of the canvas.
    placed(element, column, row) {
      element.style.left = (column + 0.5) / this.width * 100 + '%';
      element.style.top = (row + 0.5) / this.height * 100 + '%';
      return element;
    }

    moveTo(column, row) {
      this.cursor = [Math.max(0, Math.min(this.width - 1, column)), Math.max(0, Math.min(this.height - 1, row))];
      this.placed(this.mark, ...this.cursor).hidden = false;
    }

    apply(index) {
      let at = 0;
      eachRun(bytesOf(this.steps[index][5]), 3, (same, count, difference) => {
        at += same;
        for (const end = at + count; at < end; ++at) this.states[at] ^= difference;
      });
    }

    colourAt(at) { return [this.states[at] >> 17 & 255, this.states[at] >> 9 & 255, this.states[at] >> 1 & 255]; }

    // Tints the enabled pixels.
    paint() {
      const {data} = this.image;
      for (let at = 0; at < this.states.length; ++at) {
        const share = this.tint.checked && this.states[at] & 1 ? tintShare : 0;
        this.colourAt(at).forEach((channel, i) => { data[4 * at + i] = channel * (1 - share) + tintColour[i] * share; });
        data[4 * at + 3] = 255;
      }
      this.canvas.getContext('2d').putImageData(this.image, 0, 0);
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
      this.why.mark(this.now);
      this.paint();
    }

    stop() {
      clearInterval(this.timer);
      this.timer = 0;
      if (this.play) this.play.textContent = 'Play';
    }

    // Goes to the next step that serves another primitive.
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
      this.controls.append(make('label', {}, this.tint, 'tint the enabled pixels'));
      this.tint.addEventListener('change', () => this.paint());
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

    // Describes a pixel of the canvas.
    describe(column, row) {
      const at = row * this.width + column;
      const colour = '#' + this.colourAt(at).map(channel => channel.toString(16).padStart(2, '0')).join('');
      return `${column * this.every}, ${row * this.every}: ${colour}, ${this.states[at] & 1 ? 'enabled' : 'disabled'}`;
    }

    askAtCursor() { document.dispatchEvent(new CustomEvent('pixel', {detail: {pixel: this.cursor.map(one => one * this.every)}})); }

    setUpCanvas() {
      const {canvas} = this;
      canvas.setAttribute('aria-label', 'Pixel memory at the chosen step. Arrow keys move the cursor, with Shift by ten pixels; Enter explains what the pixel shows.');
      const at = event => {
        const frame = canvas.getBoundingClientRect();
        const of = (from, begin, size, count) => Math.max(0, Math.min(count - 1, Math.floor((from - begin) * count / size)));
        return [of(event.clientX, frame.left, frame.width, this.width), of(event.clientY, frame.top, frame.height, this.height)];
      };
      canvas.addEventListener('pointermove', event => showTip(this.describe(...at(event)), event.clientX, event.clientY));
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
          announce(this.describe(...this.cursor));
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
  // Access for tests and for the console.
  window.csgsimDrawings = drawings;
})();
