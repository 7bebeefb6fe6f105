'use strict';
(() => {
  const byId = id => document.getElementById(id);
  const grouped = number => String(number).replace(/\B(?=(\d{3})+$)/g, ',');
  const make = (name, attributes = {}, ...children) => {
    const element = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    element.append(...children);
    return element;
  };
  const tell = text => { byId('told').textContent = text; };

  // What the page shows. The camera is none until the first picture says where it is.
  const now = {about: null, camera: null, first: null, drawn: null, edited: false};
  const named = ['machine', 'strategy', 'memory-bits', 'z-bits', 'projection', 'size'];
  const flags = ['view-all', 'snap'];

  const wish = () => {
    const knobs = {};
    for (const name of now.about.names) {
      if (name === 'camera') {
        if (now.camera) knobs.camera = [...now.camera.eye, ...now.camera.centre].join(',');
      } else if (name === 'set') {
        const sets = byId('set').value.split('\n').map(line => line.trim()).filter(line => line);
        if (sets.length) knobs.set = sets;
      } else if (flags.includes(name)) {
        if (byId(name).checked) knobs[name] = true;
      } else if (byId(name).value.trim()) {
        knobs[name] = byId(name).value.trim();
      }
    }
    return now.edited ? {knobs, source: byId('source').value} : {knobs};
  };

  const ask = async (what, body) => {
    const reply = await fetch(what, {method: 'POST', headers: {'Content-Type': 'application/json'}, body: JSON.stringify(body)});
    return {isGood: reply.ok, answer: await reply.json()};
  };

  // The line of the source that an error names is selected.
  const showError = answer => {
    byId('error').textContent = answer.error;
    byId('error').hidden = false;
    byId('stage').classList.add('stale');
    if (!answer.line || !now.edited) return;
    selectLine(answer.line, answer.column);
  };

  // From a column of the source's line to its end.
  const selectLine = (line, column = 1) => {
    const lines = byId('source').value.split('\n');
    const begin = lines.slice(0, line - 1).reduce((sum, each) => sum + each.length + 1, 0);
    byId('source').setSelectionRange(begin + column - 1, begin + (lines[line - 1] || '').length);
  };

  // Of six numbers; none of others, as OpenSCAD has them.
  const cameraOf = text => {
    const numbers = text.split(',').map(Number);
    return numbers.length === 6 ? {eye: numbers.slice(0, 3), centre: numbers.slice(3)} : null;
  };

  const row = (name, ...values) => make('tr', {}, make('th', {scope: 'row'}, name), ...values.map(value => make('td', {class: 'n'}, value)));

  const countsOf = stats => {
    const rate = stats.frames_per_second;
    return [
      ['clocks until it is drawn', grouped(stats.clocks)],
      ['clocks until it is shown', grouped(stats.shown_clocks)],
      ['clocks from one frame to the next', grouped(stats.interval_clocks)],
      ['frames a second', rate === undefined || rate === null ? '' : Number(rate).toPrecision(4)],
      ['instructions', grouped(stats.instructions.total)],
      ['pixel operations', grouped(stats.pixel_operations.total)],
      ['memory bits a pixel', stats.memory.used_bits + ' of ' + stats.memory.memory_bits],
      ['primitives, half-spaces', grouped(stats.model.primitives) + ', ' + grouped(stats.model.halfspaces)],
    ];
  };

  const showCounts = stats => {
    const ofA = now.kept ? countsOf(now.kept.drawn.stats) : [];
    byId('counts').replaceChildren(...countsOf(stats).map((each, index) => row(...each, ...(now.kept ? [ofA[index][1]] : []))));
    byId('sides').hidden = !now.kept;
    byId('bound').textContent = stats.bound_by ? stats.bound_by.sentence ?? stats.bound_by : '';
    const purposes = Object.entries(stats.by_purpose).filter(([, cost]) => cost.instructions > 0);
    const whole = purposes.reduce((sum, [, cost]) => sum + cost.clocks, 0) || 1;
    byId('bill').replaceChildren(...purposes.map(([name, cost]) => make('tr', {}, make('th', {scope: 'row'}, name.replace(/_/g, ' ')),
      make('td', {class: 'n'}, grouped(cost.clocks)), make('td', {class: 'n'}, (100 * cost.clocks / whole).toFixed(1) + ' %'),
      make('td', {class: 'n'}, grouped(cost.instructions)))));
  };

  const show = answer => {
    now.drawn = answer;
    byId('picture').src = answer.picture;
    byId('error').hidden = true;
    byId('stage').classList.remove('stale');
    byId('command').textContent = answer.command;
    byId('warnings').replaceChildren(...answer.warnings.map(line => make('li', {}, line)));
    byId('warnings').hidden = answer.warnings.length === 0;
    if (!now.camera) {
      now.camera = cameraOf(answer.camera);
      now.first = now.first || structuredClone(now.camera);
    }
    showCounts(answer.stats);
  };

  // Asks one thing at a time, and of what is wished meanwhile the last.
  const lastOf = work => {
    let isBusy = false;
    let isWished = false;
    const run = async () => {
      isWished = true;
      if (isBusy) return;
      isBusy = true;
      while (isWished) {
        isWished = false;
        try {
          await work();
        } catch (error) {
          showError({error: 'csgsim view does not answer: ' + error.message});
        }
      }
      isBusy = false;
    };
    run.isBusy = () => isBusy;
    return run;
  };

  const draw = lastOf(async () => {
    const {isGood, answer} = await ask('draw', wish());
    if (isGood) show(answer);
    else showError(answer);
    window.drawnPictures = (window.drawnPictures || 0) + 1;
    // Not while the model is turned.
    clearTimeout(now.later);
    now.later = setTimeout(() => {
      now.later = 0;
      lookAtInstant();
      compareTwo();
    }, 250);
  });

  const minus = (a, b) => a.map((value, i) => value - b[i]);
  const plus = (a, b) => a.map((value, i) => value + b[i]);
  const times = (a, by) => a.map(value => value * by);
  const size = a => Math.hypot(...a);

  // About the vertical axis through the centre, and up and down, but not over the poles.
  const turn = (right, up) => {
    if (!now.camera) return;
    const from = minus(now.camera.eye, now.camera.centre);
    const distance = size(from);
    const around = Math.atan2(from[1], from[0]) + right;
    const above = Math.max(-1.55, Math.min(1.55, Math.asin(from[2] / distance) + up));
    now.camera.eye = plus(now.camera.centre, times([Math.cos(above) * Math.cos(around), Math.cos(above) * Math.sin(around), Math.sin(above)], distance));
    moved();
  };

  // By parts of the distance to the eye, in the plane of the picture.
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

  const explain = async () => {
    const answer = await ask('explain', {...wish(), pixel: byId('pixel').value.trim(), why_not: byId('why-not').value.trim()});
    const story = byId('story');
    story.hidden = false;
    if (!answer.isGood) {
      story.textContent = answer.answer.error;
      return;
    }
    story.textContent = (answer.answer.why_not ? answer.answer.why_not + '\n' : '') + answer.answer.text;
    const [x, y] = answer.answer.story.pixel;
    byId('mark').style.left = (x + 0.5) / now.drawn.width * 100 + '%';
    byId('mark').style.top = (y + 0.5) / now.drawn.height * 100 + '%';
    byId('mark').hidden = false;
    tell(story.textContent.split('\n')[0]);
    showEvents(answer.answer.story.events);
  };

  // Line of `cylinder@9:9` in the source.
  const lineOf = primitive => {
    const name = now.drawn && now.drawn.stats.by_primitive[primitive] ? now.drawn.stats.by_primitive[primitive].name : '';
    const found = /@(\d+):\d+$/.exec(name);
    return found ? Number(found[1]) : 0;
  };

  // Unless somebody writes there.
  const showLine = line => {
    const source = byId('source');
    if (!line || document.activeElement === source) return;
    selectLine(line);
    source.scrollTop = (line - 4) * parseFloat(getComputedStyle(source).lineHeight);
  };

  const showInstant = (answer, asked) => {
    byId('then').src = answer.picture;
    byId('scale').textContent = answer.scale;
    byId('instant').max = answer.count;
    // Not where the slider has been moved on meanwhile.
    if (Number(byId('instant').value) === asked.number || asked.primitive !== undefined) byId('instant').value = answer.number;
    if (byId('field').length === 0) byId('field').replaceChildren(make('option', {value: ''}, 'the picture'), ...answer.fields.map(name => make('option', {}, name)));
    const next = answer.instructions.find(each => each.number === answer.number);
    const clocks = answer.clocks ? ', issued in clocks ' + grouped(answer.clocks[0]) + ' to ' + grouped(answer.clocks[1]) : '';
    byId('at').textContent = next ? 'before i' + next.number + ' of ' + grouped(answer.count) + ': ' + next.text + ', for ' + next.serves + clocks : 'at the end, after ' + grouped(answer.count) + ' instructions';
    byId('listing').replaceChildren(...answer.instructions.map(each => {
      const button = make('button', {type: 'button', 'aria-current': String(each.number === answer.number)}, 'i' + each.number + '  ' + each.text + '  ', make('span', {class: 'serves'}, each.serves));
      button.addEventListener('click', () => goTo(each.number));
      return make('li', {}, button);
    }));
    const current = byId('listing').querySelector('[aria-current="true"]');
    if (current) byId('listing').scrollTop = current.offsetTop - byId('listing').offsetTop - 80;
    if (next && next.primitive !== undefined) showLine(lineOf(next.primitive));
    window.shownInstants = (window.shownInstants || 0) + 1;
  };

  const lookAtInstant = lastOf(async () => {
    const asked = {...wish(), number: Number(byId('instant').value), field: byId('field').value, tinted: byId('tinted').checked};
    if (now.primitive !== undefined) asked.primitive = now.primitive;
    now.primitive = undefined;
    const {isGood, answer} = await ask('instant', asked);
    if (isGood) showInstant(answer, asked);
    else byId('at').textContent = answer.error;
  });

  const goTo = number => {
    byId('instant').max = Math.max(Number(byId('instant').max), number);
    byId('instant').value = number;
    lookAtInstant();
  };

  // To the first instruction that serves the primitive of a line of the source.
  const goToLine = () => {
    const line = byId('source').value.slice(0, byId('source').selectionStart).split('\n').length;
    const primitive = (now.drawn ? now.drawn.stats.by_primitive : []).findIndex((_, index) => lineOf(index) === line);
    if (primitive < 0) return;
    now.primitive = primitive;
    lookAtInstant();
  };

  const compareTwo = lastOf(async () => {
    if (!now.kept) return;
    const {isGood, answer} = await ask('two', {a: now.kept.wish, b: wish()});
    if (!isGood) {
      byId('differs').textContent = answer.error;
      return;
    }
    byId('difference').src = answer.picture;
    const pixels = answer.pixels === 0 ? 'The pictures are equal' : grouped(answer.pixels) + (answer.pixels === 1 ? ' pixel differs' : ' pixels differ') + ', the first at ' + answer.first.join(',');
    const other = answer.instruction;
    byId('differs').replaceChildren(pixels + '. ', other ? 'The first other instruction is i' + grouped(other.number) + ': ' + other.a + ' in A, ' + other.b + ' now.' : 'All instructions are the same.');
    window.comparedTwo = (window.comparedTwo || 0) + 1;
  });

  // Whether all that was wished has been shown.
  window.isAtRest = () => now.drawn !== null && !now.changed && !now.later && ![draw, lookAtInstant, compareTwo].some(each => each.isBusy());

  const setUpTwo = () => {
    byId('keep').addEventListener('click', () => {
      if (!now.drawn) return;
      now.kept = {wish: wish(), drawn: now.drawn};
      byId('a').src = now.drawn.picture;
      byId('kept').textContent = now.drawn.command;
      byId('two').hidden = false;
      showCounts(now.drawn.stats);
      compareTwo();
    });
  };

  const setUpTime = () => {
    byId('instant').addEventListener('input', lookAtInstant);
    byId('field').addEventListener('change', lookAtInstant);
    byId('tinted').addEventListener('change', lookAtInstant);
    byId('back').addEventListener('click', () => goTo(Math.max(0, Number(byId('instant').value) - 1)));
    byId('on').addEventListener('click', () => goTo(Number(byId('instant').value) + 1));
    byId('source').addEventListener('click', goToLine);
  };

  const showEvents = events => {
    byId('events').replaceChildren(...events.map(event => {
      const whose = event.primitive ? ' p' + event.primitive.index + ' ' + event.primitive.name : '';
      const button = make('button', {type: 'button'}, 'i' + event.first + (event.last > event.first ? '–i' + event.last : '') + '  ' + event.what.replace(/_/g, ' ') + whose + (event.enabled[1] ? '' : ': disabled'));
      button.addEventListener('click', () => goTo(event.last + 1));
      return make('li', {}, button);
    }));
    byId('events').hidden = events.length === 0;
  };

  const setUpStage = () => {
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
        byId('pixel').value = pixelAt(event).join(',');
        explain();
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

  const setUpKnobs = about => {
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
    byId('why').addEventListener('submit', event => {
      event.preventDefault();
      explain();
    });
    byId('source').addEventListener('input', () => {
      now.edited = byId('source').value !== about.source;
      changed();
    });
  };

  const begin = async () => {
    const about = await (await fetch('about')).json();
    now.about = about;
    document.title = about.model + ' - csgsim view';
    byId('title').textContent = about.model;
    byId('where').textContent = 'What you change here is drawn and not written: ' + about.model + ' stays as it is.';
    byId('source').value = about.source;
    setUpKnobs(about);
    setUpStage();
    setUpTime();
    setUpTwo();
    draw();
    // Open as long as the page is: csgsim view ends with its last page.
    new EventSource('alive');
  };
  begin();
})();
