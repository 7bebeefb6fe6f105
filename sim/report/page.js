'use strict';

// Common functions of a page, its plots, and the picture of its owners.
const page = (() => {
  const byId = id => document.getElementById(id);
  const read = id => byId(id) && JSON.parse(byId(id).textContent);
  const grouped = number => String(number).replace(/\B(?=(\d{3})+$)/g, ',');
  const announce = text => { byId('told').textContent = text; };

  const make = (name, attributes = {}, ...children) => {
    const element = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    element.append(...children);
    return element;
  };

  const bytesOf = text => Uint8Array.from(atob(text), c => c.charCodeAt(0));

  // Calls visit(...numbers) for each group of `count` varints.
  const eachRun = (bytes, count, visit) => {
    let at = 0;
    const take = () => {
      let number = 0;
      for (let scale = 1; ; scale *= 128) {
        const byte = bytes[at++];
        number += (byte & 127) * scale;
        if (byte < 128) return number;
      }
    };
    while (at < bytes.length) visit(...Array.from({length: count}, take));
  };

  const tip = make('div', {class: 'tip', hidden: ''});
  document.body.append(tip);
  const showTip = (text, x, y) => {
    tip.textContent = text;
    tip.hidden = false;
    const left = Math.min(x + 14, document.documentElement.clientWidth - tip.offsetWidth - 8);
    const below = y + 16 + tip.offsetHeight < document.documentElement.clientHeight;
    tip.style.left = Math.max(4, left) + window.scrollX + 'px';
    tip.style.top = (below ? y + 16 : y - tip.offsetHeight - 12) + window.scrollY + 'px';
  };
  const hideTip = () => { tip.hidden = true; };
  window.addEventListener('resize', hideTip);

  const setUpPlot = svg => {
    const points = [...svg.querySelectorAll('.pt')];
    if (points.length === 0) return;
    const texts = points.map(point => {
      const title = point.querySelector('title');
      const text = title.textContent;
      title.remove();
      return text;
    });
    let now = -1;
    // Points at the same place share one tooltip.
    const near = (point, box) => {
      const other = point.getBoundingClientRect();
      return Math.abs(other.left + other.width / 2 - box.left - box.width / 2) < 2 &&
        Math.abs(other.top + other.height / 2 - box.top - box.height / 2) < 2;
    };
    const choose = (index, spoken) => {
      if (now >= 0) points[now].classList.remove('at');
      now = index;
      if (now < 0) return hideTip();
      points[now].classList.add('at');
      if (spoken) points[now].scrollIntoView({block: 'nearest', inline: 'nearest', behavior: 'instant'});
      const box = points[now].getBoundingClientRect();
      const text = texts.filter((_, index) => near(points[index], box)).join('\n');
      showTip(text, box.left + box.width / 2, box.top + box.height / 2);
      if (spoken) announce(text);
    };
    svg.setAttribute('tabindex', '0');
    svg.setAttribute('role', 'application');
    svg.setAttribute('aria-label', svg.getAttribute('aria-label') + '. Arrow keys go from point to point.');
    svg.addEventListener('pointermove', event => {
      let best = -1;
      let least = 40 * 40;
      points.forEach((point, index) => {
        const box = point.getBoundingClientRect();
        const dx = box.left + box.width / 2 - event.clientX;
        const dy = box.top + box.height / 2 - event.clientY;
        if (dx * dx + dy * dy < least) {
          least = dx * dx + dy * dy;
          best = index;
        }
      });
      choose(best, false);
    });
    svg.addEventListener('pointerleave', () => choose(-1));
    svg.addEventListener('blur', () => choose(-1));
    svg.addEventListener('keydown', event => {
      const last = points.length - 1;
      const to = {ArrowRight: Math.min(now + 1, last), ArrowLeft: Math.max(now - 1, 0), Home: 0, End: last, Escape: -1}[event.key];
      if (to === undefined) return;
      event.preventDefault();
      choose(to, true);
    });
  };

  const setUpOwners = (box, data, stats) => {
    const {width, height} = data;
    const owner = new Int32Array(width * height);
    let filled = 0;
    eachRun(bytesOf(data.runs), 2, (count, value) => {
      owner.fill(value - 1, filled, filled + count);
      filled += count;
    });
    const rows = new Map([...box.querySelectorAll('tr[data-p]')].map(row => [Number(row.dataset.p), row]));
    const titles = [...box.querySelectorAll('thead th')].map(cell => cell.textContent);
    const nameOf = primitive => rows.has(primitive) ? rows.get(primitive).cells[0].textContent + ' ' + rows.get(primitive).cells[1].textContent
      : 'p' + primitive + ' ' + stats.by_primitive[primitive].name;
    const price = make('div', {class: 'price'});
    const choice = make('div', {class: 'choice', role: 'group', 'aria-label': 'View'});
    box.querySelector('.stage').prepend(choice);
    box.querySelector('.prices').prepend(price);
    box.classList.add('ready');

    const views = [['Picture', false], ['Owners', true]].map(([text, byOwner]) => {
      const button = make('button', {type: 'button', 'aria-pressed': String(!byOwner)}, text);
      button.addEventListener('click', () => {
        box.classList.toggle('by-owner', byOwner);
        views.forEach(one => one.setAttribute('aria-pressed', String(one === button)));
      });
      choice.append(button);
      return button;
    });

    const canvases = [...box.querySelectorAll('.stage figure')].map(figure => {
      const canvas = make('canvas', {width, height, 'aria-hidden': 'true'});
      figure.append(canvas);
      return canvas;
    });

    // Dims all but the primitive, and draws its outline.
    const light = primitive => {
      const image = new ImageData(width, height);
      const pixels = new Uint32Array(image.data.buffer);
      const opaque = new Uint8Array(new Uint32Array([1]).buffer)[0] === 1;
      const colour = (r, g, b, a) => opaque ? (a << 24 | b << 16 | g << 8 | r) >>> 0 : (r << 24 | g << 16 | b << 8 | a) >>> 0;
      const dim = colour(0, 0, 0, 150);
      const edge = colour(255, 200, 0, 255);
      const isSeen = primitive >= 0 && owner.includes(primitive);
      for (let y = 0, at = 0; isSeen && y < height; ++y) {
        for (let x = 0; x < width; ++x, ++at) {
          if (owner[at] !== primitive) {
            pixels[at] = dim;
          } else if (x === 0 || y === 0 || x === width - 1 || y === height - 1 || owner[at - 1] !== primitive ||
                     owner[at + 1] !== primitive || owner[at - width] !== primitive || owner[at + width] !== primitive) {
            pixels[at] = edge;
          }
        }
      }
      canvases.forEach(canvas => canvas.getContext('2d').putImageData(image, 0, 0));
    };

    // drawing.js stores the pixel whose history it shows in the detail.
    const link = make('p');
    const linkToStory = (event, detail) => {
      document.dispatchEvent(new CustomEvent(event, {detail}));
      link.remove();
      if (!detail.pixel) return;
      link.replaceChildren(make('a', {href: '#why'}, `Why pixel ${detail.pixel.join()} shows it`));
      price.append(link);
    };

    const buttons = new Map();
    let chosen = -1;
    const choose = (primitive, spoken) => {
      if (rows.has(chosen)) rows.get(chosen).classList.remove('chosen');
      chosen = primitive;
      light(primitive);
      price.replaceChildren();
      if (primitive < 0) {
        price.append(make('p', {class: 'note'}, 'Click on the picture, or choose a primitive in the table, to see its cost here.'));
        return;
      }
      const row = rows.get(primitive);
      const facts = row ? [...row.cells].slice(1).map((cell, i) => titles[i + 1] + ' ' + cell.textContent)
        : ['clocks ' + grouped(stats.by_primitive[primitive].clocks)];
      const name = row ? row.cells[0].textContent : nameOf(primitive);
      price.append(make('p', {}, make('strong', {}, name)), make('p', {}, facts.join(', ')));
      if (row) {
        row.classList.add('chosen');
        const frame = row.closest('.scroll');
        const head = row.closest('table').tHead.offsetHeight;
        if (row.offsetTop - head < frame.scrollTop || row.offsetTop + row.offsetHeight > frame.scrollTop + frame.clientHeight)
          frame.scrollTop = row.offsetTop - head - 8;
        buttons.forEach(button => button.setAttribute('tabindex', '-1'));
        buttons.get(primitive).setAttribute('tabindex', '0');
      }
      linkToStory('primitive', {primitive});
      if (spoken) announce(name + ': ' + facts.join(', '));
    };

    // The table is one tab stop; arrow keys move between its rows.
    const order = [...rows.keys()];
    order.forEach((primitive, index) => {
      const cell = rows.get(primitive).cells[0];
      const button = make('button', {type: 'button', tabindex: index === 0 ? '0' : '-1'}, cell.textContent);
      cell.replaceChildren(button);
      buttons.set(primitive, button);
      button.addEventListener('click', () => choose(primitive, true));
      button.addEventListener('keydown', event => {
        const last = order.length - 1;
        const to = {ArrowDown: Math.min(index + 1, last), ArrowUp: Math.max(index - 1, 0), Home: 0, End: last}[event.key];
        if (event.key === 'Escape') choose(-1);
        if (to === undefined) return;
        event.preventDefault();
        choose(order[to], true);
        buttons.get(order[to]).focus({preventScroll: true});
      });
      rows.get(primitive).addEventListener('click', () => choose(primitive, false));
    });

    canvases.forEach(canvas => {
      const at = event => {
        const frame = canvas.getBoundingClientRect();
        const x = Math.floor((event.clientX - frame.left) * width / frame.width);
        const y = Math.floor((event.clientY - frame.top) * height / frame.height);
        return x >= 0 && y >= 0 && x < width && y < height ? [x, y, owner[y * width + x]] : null;
      };
      canvas.addEventListener('pointermove', event => {
        const found = at(event);
        if (!found) return hideTip();
        const [x, y, primitive] = found;
        showTip(`${x}, ${y}: ${primitive < 0 ? 'nothing' : nameOf(primitive)}`, event.clientX, event.clientY);
      });
      canvas.addEventListener('pointerleave', hideTip);
      canvas.addEventListener('click', event => {
        const found = at(event);
        if (!found) return;
        choose(found[2], true);
        linkToStory('pixel', {pixel: found.slice(0, 2)});
      });
    });
    choose(-1);
  };

  document.querySelectorAll('svg.plot').forEach(setUpPlot);
  const owners = read('owners-data');
  if (owners) setUpOwners(byId('owners-box'), owners, read('data'));
  return {read, grouped, announce, make, bytesOf, eachRun, showTip, hideTip};
})();
