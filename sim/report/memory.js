'use strict';

// The Program that a page holds, and pixel memory as it leaves it: what hw/isa/opcodes.h says of each instruction.
// Numbers are exact: BigInt where a double is not.
const pixelMemory = (() => {
  const safe = 2 ** 53;
  const noField = {base: 0, width: 0};

  // `12*x - 7*y + 991 (w35 >> 12)`, or `3*x*x (w40)`.
  const linearOf = text => {
    const [, sum, width, shift] = /^(.*) \(w(\d+)(?: >> (\d+))?\)$/.exec(text);
    const linear = {x: 0n, y: 0n, '': 0n, 'x*x': 0n, 'x*y': 0n, 'y*y': 0n, width: Number(width), shift: Number(shift || 0)};
    for (const [, sign, factor, star, variable] of sum.replace(/ /g, '').matchAll(/([+-]?)(?:(\d+)(\*?))?([xy](?:\*[xy])?)?/g)) {
      if (factor === undefined && variable === undefined) continue;
      linear[variable || ''] = BigInt(factor === undefined ? 1 : factor) * (sign === '-' ? -1n : 1n);
    }
    return linear;
  };

  const pieceOf = (firsts, primitive, piece) => primitive === undefined ? -1 : firsts[Number(primitive)] + Number(piece || 0);

  // `classify p0 against p1.2 for e1`.
  const originOf = (text, firsts) => {
    const [, purpose, primitive, piece, node, nodePiece, effect] =
      /^(\w+)(?: p(\d+)(?:\.(\d+))?)?(?: against p(\d+)(?:\.(\d+))?)?(?: for e(\d+))?$/.exec(text);
    return {text, purpose, primitive: pieceOf(firsts, primitive, piece), node: pieceOf(firsts, node, nodePiece), effect: effect === undefined ? -1 : Number(effect)};
  };

  const fieldOf = (text, named) => {
    const known = named.get(text);
    if (known) return known;
    const [, base, width] = /^\[(\d+)(?:\+:(\d+))?\]$/.exec(text);
    return {base: Number(base), width: Number(width || 1)};
  };

  const instructionOf = (line, program, named) => {
    const [text, origin, geometry] = line.split('\t');
    const [, opcode, rest] = /^(\w+)(?: (.*))?$/.exec(text);
    const operands = program.opcodes[opcode];
    const instruction = {text, opcode, operands, fields: [noField, noField, noField], linear: null, constant: 0, origin: originOf(origin, program.firsts), geometry: -1};
    if (geometry !== undefined) {
      instruction.geometry = program.next + Number(geometry);
      program.next = instruction.geometry + 1;
    }
    const texts = (rest || '').match(/"(?:[^"\\]|\\.)*"|[^,]+/g) || [];
    operands.forEach((kind, i) => {
      const operand = texts[i].trim();
      if (kind === 'target' || kind === 'source') instruction.fields[i] = fieldOf(operand, named);
      else if (kind === 'constant' || kind === 'count') instruction.constant = Number(operand);
      else instruction.linear = linearOf(operand);
    });
    return instruction;
  };

  // Of what program_json of sim/report/program_json.cpp writes.
  const read = json => {
    const program = {...json, firsts: [0], next: 0, skips: new Set(json.skips)};
    json.primitives.forEach((_, i) => program.firsts.push(program.firsts[i] + (json.pieces[i] || 1)));
    const named = new Map();
    for (const field of json.fields) if (!named.has(field.token)) named.set(field.token, {base: field.base, width: field.width});
    const lines = json.instructions ? json.instructions.split('\n') : [];
    let number = 0;
    program.segments = json.segments.map(([x, y, width, height, count]) => {
      const segment = {x, y, width, height, first: number, instructions: lines.slice(number, number + count).map(line => instructionOf(line, program, named))};
      number += count;
      return segment;
    });
    program.count = number;
    return program;
  };

  const isSame = (one, other) => one.base === other.base && one.width === other.width;
  const overlaps = (one, other) => one.base < other.base + other.width && other.base < one.base + one.width;

  // The sum of an instruction's linear expression and of the squares before it at a pixel, exactly.
  const sumAt = (linear, squares, x, y) => {
    const [bigX, bigY] = [BigInt(x), BigInt(y)];
    const sum = linear.x * bigX + linear.y * bigY + linear[''];
    return squares ? sum + squares['x*x'] * bigX * bigX + squares['x*y'] * bigX * bigY + squares['y*y'] * bigY * bigY : sum;
  };

  const small = number => number > -BigInt(safe) && number < BigInt(safe) ? Number(number) : number;

  // F of a sum: its low bits as a number with a sign, shifted right.
  const valueOf = (sum, linear) => small(BigInt.asIntN(linear.width, sum) >> BigInt(linear.shift));

  // A function of a pixel's place that gives F.
  const evaluator = (linear, squares, mostX, mostY) => {
    const numbers = ['x', 'y', ''].map(term => Number(linear[term]));
    const more = squares ? ['x*x', 'x*y', 'y*y'].map(term => Number(squares[term])) : [0, 0, 0];
    const [a, b, c, xx, xy, yy] = [...numbers, ...more];
    const most = Math.abs(a) * mostX + Math.abs(b) * mostY + Math.abs(c) + Math.abs(xx) * mostX * mostX + Math.abs(xy) * mostX * mostY + Math.abs(yy) * mostY * mostY;
    if (most >= safe / 2) return (x, y) => valueOf(sumAt(linear, squares, x, y), linear);
    const unit = 2 ** linear.shift;
    const whole = 2 ** linear.width;
    return (x, y) => {
      let sum = a * x + b * y + c;
      if (squares) sum += xx * x * x + xy * x * y + yy * y * y;
      if (sum < -whole / 2 || sum >= whole / 2) {
        sum -= Math.floor(sum / whole) * whole;
        if (sum >= whole / 2) sum -= whole;
      }
      return Math.floor(sum / unit);
    };
  };

  // What root makes of a field of 2w + 1 bits.
  const withRoot = (field, w) => {
    const square = BigInt.asUintN(2 * w, field);
    let root = BigInt(Math.floor(Math.sqrt(Number(square))));
    while (root * root > square) --root;
    while ((root + 1n) * (root + 1n) <= square) ++root;
    const odd = root | 1n;
    return root << BigInt(w + 1) | BigInt.asUintN(w + 1, square - odd * odd);
  };

  // Pixels of a segment: of its columns and rows every `step`, `columns` x `rows` of them from x, y of the segment on.
  class Pixels {
    constructor(memoryBits, x, y, columns, rows, step) {
      Object.assign(this, {x, y, columns, rows, step});
      this.words = Array.from({length: Math.ceil(memoryBits / 32)}, () => new Uint32Array(columns * rows));
      this.enabled = new Uint8Array(columns * rows);
      this.list = new Uint32Array(columns * rows);  // of those that are enabled
      this.listed = 0;
    }

    copy() {
      const other = Object.create(Pixels.prototype);
      return Object.assign(other, this, {words: this.words.map(word => word.slice()), enabled: this.enabled.slice(), list: this.list.slice()});
    }

    get bytes() { return this.enabled.length * (4 * this.words.length + 5); }

    // A field of any width.
    wide(field, at) {
      let value = 0n;
      for (let bit = 0; bit < field.width; bit += 32) {
        const part = {base: field.base + bit, width: Math.min(32, field.width - bit)};
        value |= BigInt(this.reader(part)(at)) << BigInt(bit);
      }
      return value;
    }

    // A function that gives the field of the pixel of that number.
    reader(field) {
      if (field.width > 32) return at => small(this.wide(field, at));
      if (field.width === 0) return () => 0;
      const [low, high] = [this.words[field.base >>> 5], this.words[(field.base >>> 5) + 1]];
      const shift = field.base & 31;
      const mask = field.width === 32 ? 0xffffffff : 2 ** field.width - 1;
      if (shift + field.width <= 32) return at => (low[at] >>> shift & mask) >>> 0;
      return at => ((low[at] >>> shift | high[at] << 32 - shift) & mask) >>> 0;
    }

    // A function that writes the low bits of a number to it.
    writer(field) {
      if (field.width > 32) {
        return (at, value) => {
          const bits = BigInt.asUintN(field.width, BigInt(value));
          for (let bit = 0; bit < field.width; bit += 32)
            this.writer({base: field.base + bit, width: Math.min(32, field.width - bit)})(at, Number(BigInt.asUintN(32, bits >> BigInt(bit))));
        };
      }
      const [low, high] = [this.words[field.base >>> 5], this.words[(field.base >>> 5) + 1]];
      const shift = field.base & 31;
      const mask = field.width === 32 ? 0xffffffff : 2 ** field.width - 1;
      const upper = shift + field.width > 32 ? mask >>> 32 - shift : 0;
      return (at, value) => {
        const bits = (typeof value === 'bigint' ? Number(BigInt.asUintN(32, value)) : value) & mask;
        low[at] = low[at] & ~(mask << shift) | bits << shift;
        if (upper) high[at] = high[at] & ~upper | bits >>> 32 - shift;
      };
    }

    // Calls visit(number, x, y) for the pixels that are enabled.
    each(visit) {
      const {list, listed, columns, step} = this;
      for (let i = 0; i < listed; ++i) {
        const column = list[i] % columns;
        visit(list[i], this.x + column * step, this.y + (list[i] - column) / columns * step);
      }
    }

    // Leaves those enabled for which that holds.
    only(holds) {
      let left = 0;
      this.each((at, x, y) => {
        if (holds(at, x, y)) this.list[left++] = at;
        else this.enabled[at] = 0;
      });
      this.listed = left;
    }

    // Enables those for which that holds, and no others.
    all(holds) {
      this.listed = 0;
      for (let at = 0; at < this.enabled.length; ++at) {
        this.enabled[at] = holds(at) ? 1 : 0;
        if (this.enabled[at]) this.list[this.listed++] = at;
      }
    }

    // E becomes a bit. Most instructions that look at every pixel are of this kind.
    loadEnabled({base}) {
      const {list, enabled} = this;
      const word = this.words[base >>> 5];
      const shift = base & 31;
      let listed = 0;
      for (let at = 0; at < word.length; ++at) {
        const bit = word[at] >>> shift & 1;
        enabled[at] = bit;
        if (bit) list[listed++] = at;
      }
      this.listed = listed;
    }

    // At every pixel a bit becomes E.
    storeEnabled({base}) {
      const word = this.words[base >>> 5];
      const bit = 1 << (base & 31);
      for (let at = 0; at < word.length; ++at) word[at] &= ~bit;
      for (let i = 0; i < this.listed; ++i) word[this.list[i]] |= bit;
    }

    execute(instruction, squares) {
      const {enabled} = this;
      const [first, second, third] = instruction.fields;
      const [s, r, q] = instruction.fields.map(field => this.reader(field));
      const f = instruction.linear ? evaluator(instruction.linear, squares, this.x + this.columns * this.step, this.y + this.rows * this.step) : null;
      const only = holds => this.only(holds);
      const store = value => {
        const write = this.writer(first);
        this.each((at, x, y) => write(at, value(at, x, y)));
      };
      const keep = where => {
        const write = this.writer(first);
        const beyond = 2 ** first.width;
        only((at, x, y) => {
          const value = f(x, y);
          if (!where(value, at)) return true;
          write(at, value);
          return value >= 0 && value < beyond;
        });
      };
      const wide = (at, sign, x, y) => BigInt(f(x, y)) + sign * this.wide(first, at);
      switch (instruction.opcode) {
        case 'enable_all': return this.all(() => true);
        case 'enable_invert': return this.all(at => !enabled[at]);
        case 'enable_load': return this.loadEnabled(first);
        case 'enable_and': return only(at => s(at) === 1);
        case 'enable_and_not': return only(at => s(at) === 0);
        case 'enable_or': return this.all(at => enabled[at] || s(at) === 1);
        case 'enable_xor': return this.all(at => (enabled[at] === 1) !== (s(at) === 1));
        case 'enable_store': return this.storeEnabled(first);
        case 'edge_not_negative': return only((at, x, y) => f(x, y) >= 0);
        case 'edge_negative':
        case 'stripe': return only((at, x, y) => f(x, y) < 0);
        case 'linear_ge': return only((at, x, y) => f(x, y) >= s(at));
        case 'linear_gt': return only((at, x, y) => f(x, y) > s(at));
        case 'linear_le': return only((at, x, y) => f(x, y) <= s(at));
        case 'linear_lt': return only((at, x, y) => f(x, y) < s(at));
        case 'linear_eq': return only((at, x, y) => {
          const value = f(x, y);
          const other = s(at);
          return value >= other && value <= other;  // one of them may be a BigInt
        });
        case 'load_linear': return keep(() => true);
        case 'keep_max': return keep((value, at) => value > s(at));
        case 'keep_min': return keep((value, at) => value < s(at));
        case 'set_constant': return store(() => instruction.constant);
        case 'copy': return store(r);
        case 'field_lt': return only(at => s(at) < r(at));
        case 'field_le': return only(at => s(at) <= r(at));
        case 'field_eq': return only(at => s(at) === r(at));
        case 'bit_and': return store(at => r(at) & q(at));
        case 'bit_or': return store(at => r(at) | q(at));
        case 'bit_xor': return store(at => r(at) ^ q(at));
        case 'bit_and_not': return store(at => r(at) & ~q(at));
        case 'bit_not': return store(at => ~r(at));
        case 'global_or':
        case 'skip_if_none':
        case 'squares': return undefined;
        case 'xor_constant': return store(at => s(at) ^ instruction.constant);
        case 'add': return store(at => s(at) + r(at));
        case 'linear_plus': return store((at, x, y) => wide(at, 1n, x, y));
        case 'linear_minus': return store((at, x, y) => wide(at, -1n, x, y));
        case 'root': return store(at => withRoot(this.wide(first, at), Math.floor(first.width / 2)));
        default: throw new Error('no such instruction: ' + instruction.opcode);
      }
    }
  }

  const squaresBefore = (segment, index) => index > 0 && segment.instructions[index - 1].opcode === 'squares' ? segment.instructions[index - 1] : null;

  // Carries out the segment's instruction of that index; returns that of the next one.
  const step = (program, segment, pixels, index) => {
    const instruction = segment.instructions[index];
    const squares = instruction.linear && squaresBefore(segment, index);
    pixels.execute(instruction, squares && squares.linear);
    return index + 1 + (program.skips.has(segment.first + index) ? instruction.constant : 0);
  };

  // The whole picture, every `step`-th pixel of it, before any instruction. What has been run through is kept now and
  // then, so that going back takes no longer than going on.
  class Frames {
    constructor(program, every) {
      Object.assign(this, {program, every, kept: new Map()});
      this.begin(0);
    }

    begin(number) {
      const segment = this.program.segments[number];
      const first = from => (this.every - from % this.every) % this.every;
      const count = (from, size) => Math.max(0, Math.ceil((size - first(from)) / this.every));
      this.segment = number;
      this.index = 0;
      this.pixels = new Pixels(this.program.memoryBits, first(segment.x), first(segment.y), count(segment.x, segment.width), count(segment.y, segment.height), this.every);
    }

    get number() { return this.program.segments[this.segment].first + this.index; }

    // The segment that is looked at there: at the end of one, that one.
    segmentAt(number) {
      const {segments} = this.program;
      return segments.findIndex(segment => segment.first + segment.instructions.length >= number);
    }

    keep() {
      const most = 96e6 / this.pixels.bytes;
      const spacing = Math.max(16, Math.ceil(this.program.segments[this.segment].instructions.length / Math.max(1, Math.min(64, most))));
      if (this.keptOf !== this.segment) this.kept.clear();
      this.keptOf = this.segment;
      const slot = Math.floor(this.index / spacing);
      if (!this.kept.has(slot)) this.kept.set(slot, {index: this.index, pixels: this.pixels.copy()});
    }

    // Towards that boundary, for so many milliseconds at most; returns whether it is there. A skip may pass it.
    goTo(number, milliseconds = Infinity) {
      const end = performance.now() + milliseconds;
      const segment = this.segmentAt(number);
      if (segment !== this.segment) this.begin(segment);
      const {first} = this.program.segments[segment];
      if (this.number > number || this.nearer(number - first)) this.restore(number - first);
      while (this.number < number) {
        this.keep();
        this.index = step(this.program, this.program.segments[segment], this.pixels, this.index);
        if (performance.now() > end) return this.number >= number;
      }
      return true;
    }

    latest(index) {
      let best = null;
      if (this.keptOf === this.segment)
        for (const one of this.kept.values()) if (one.index <= index && (!best || one.index > best.index)) best = one;
      return best;
    }

    nearer(index) {
      const best = this.latest(index);
      return best !== null && best.index > this.index;
    }

    restore(index) {
      const best = this.latest(index);
      if (!best) return this.begin(this.segment);
      this.index = best.index;
      this.pixels = best.pixels.copy();
      return undefined;
    }
  }

  return {read, isSame, overlaps, sumAt, valueOf, squaresBefore, step, Pixels, Frames, noField};
})();
