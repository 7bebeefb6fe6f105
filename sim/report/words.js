'use strict';

// A pixel's story in words, those of `csgsim explain`, and as its JSON.
const storyWords = (() => {
  const {nobody, differs, primitiveOf} = pixelStory;

  // To six digits, as C writes them with %g.
  const sixDigits = number => {
    const size = Math.abs(number);
    if (size !== 0 && (size < 1e-4 || size >= 999999.5)) {
      const [digits, exponent] = number.toExponential(5).split('e');
      return `${Number(digits)}e${exponent[0]}${exponent.slice(1).padStart(2, '0')}`;
    }
    return String(Number(number.toPrecision(6)));
  };

  const namedField = (program, field) => program.fields.find(named => pixelMemory.isSame(named, field));
  const roleOf = (program, field) => (namedField(program, field) || {role: 'scratch'}).role;
  const depthBits = program => (program.fields.find(field => field.role === 'depth') || {width: 0}).width;
  const isDepth = role => ['depth', 'candidate_depth', 'stored'].includes(role);
  const isColour = role => ['colour', 'candidate_colour', 'shown'].includes(role);

  // Model units from the eye, as hw/isa/depth_scale.h has it; null for nothing.
  const distanceOf = (program, steps) => {
    const bits = depthBits(program);
    const {perspective, near, far} = program.depth;
    if (steps === 2 ** bits - 1) return null;
    const part = (steps - 1) / (2 ** bits - 4);
    const distance = perspective ? 1 / (1 / near - part * (1 / near - 1 / far)) : near + part * (far - near);
    return Number.isFinite(distance) ? distance : null;
  };

  // Red, green and blue, 0 to 255, of a colour as a field of that many bits holds it (hw/isa/colour_format.h).
  const channelsOf = (packed, bits) => {
    const third = Math.floor(bits / 3);
    const widths = [third + (bits % 3 === 2 ? 1 : 0), third + (bits % 3 !== 0 ? 1 : 0), third];
    const channels = [0, 0, 0];
    for (let i = 2, rest = packed; i >= 0; --i) {
      const top = 2 ** widths[i] - 1;
      channels[i] = top === 0 ? 0 : Math.floor((rest % (top + 1) * 255 + Math.floor(top / 2)) / top);
      rest = Math.floor(rest / (top + 1));
    }
    return channels;
  };

  class Words {
    constructor(program) { this.program = program; }

    label(piece) {
      const primitive = primitiveOf(this.program, piece);
      const isOneOfSeveral = this.program.pieces[primitive] > 1;
      return 'p' + primitive + (isOneOfSeveral ? '.' + (piece - this.program.firsts[primitive]) : '');
    }

    primitive(piece) {
      if (piece === nobody) return 'nothing';
      const name = this.program.primitives[primitiveOf(this.program, piece)];
      return this.label(piece) + (name === undefined ? '' : ' ' + name);
    }

    depth(steps) {
      const distance = distanceOf(this.program, steps);
      return distance === null ? 'nothing' : `${steps} (${sixDigits(distance)})`;
    }

    colour(packed) {
      const bits = this.program.colour.width;
      if (bits < 3 || bits > 24) return '0x' + packed.toString(16);
      return '#' + channelsOf(packed, bits).map(channel => channel.toString(16).padStart(2, '0')).join('');
    }

    value(field, value) {
      const role = roleOf(this.program, field);
      return isDepth(role) ? this.depth(value) : isColour(role) ? this.colour(value) : String(value);
    }

    field(field) {
      const named = namedField(this.program, field);
      return named ? named.name : field.width === 1 ? `[${field.base}]` : `[${field.base}+:${field.width}]`;
    }

    decision(decision) {
      const {number, instruction, squares, value} = decision;
      const before = squares ? `, after i${number - 1} ${squares.text}` : '';
      return `i${number} ${instruction.text}${before}${instruction.linear ? ': F = ' + value : ''}`;
    }

    // How the depth of a quadric came about.
    working(depth) {
      const half = Math.floor(depth.field.width / 2);
      const root = {base: depth.field.base + half + 1, width: half};
      return `i${depth.loadNumber - 1}..i${depth.loadNumber} D = ${depth.discriminant}; i${depth.rootNumber} root ${depth.root} in ${this.field(root)}; ` +
        `i${depth.depthNumber} ${depth.isFar ? 'far' : 'near'} depth = ${depth.middle} ${depth.isFar ? '+' : '-'} ${depth.offset}`;
    }

    // Of which half-space or quadric of the model it is, if the page knows it; and how a quadric's depth came about.
    geometry({instruction, squares, quadric}) {
      const isDepth = quadric && !squares;
      const known = this.program.geometry[(isDepth ? quadric.load : instruction).geometry];
      const text = known && isDepth ? known.replace('outline', quadric.isFar ? 'far depth' : 'near depth') : known;
      return [...(text ? [text] : []), ...(quadric ? [this.working(quadric)] : [])];
    }

    changes(event) {
      return event.changes.map(change => this.field(change.field) + ' ' + (differs(change) ? this.value(change.field, change.before) + ' -> ' : '') +
        this.value(change.field, change.after)).join('; ');
    }

    decided(how, decision) { return [`${how} ${this.decision(decision)}`, ...this.geometry(decision)]; }

    // Lines, the first of which says what happened.
    event(event) {
      const {what, cut, decision, origin} = event;
      const misfit = event.misfit ? this.decided('A*x + B*y + C does not fit the width of', event.misfit) : [];
      const effect = origin.effect >= 0 && origin.effect < this.program.effects.length ? `[${this.program.effects[origin.effect]}] ` : '';
      const [first, ...more] = this.told(event, what, cut, decision);
      return [effect + first, ...more, ...misfit];
    }

    told(event, what, cut, decision) {
      const {origin} = event;
      switch (what) {
        case 'surface':
          return [`${this.primitive(origin.primitive)}: ${this.changes(event)}`, ...(decision ? this.decided('by', decision) : []),
            ...(!event.isEnabledAfter && cut ? this.decided('cut out by', cut) : [])];
        case 'stored': return [`${this.primitive(origin.primitive)}: ${this.changes(event)}`];
        case 'depth_test': {
          if (!event.isEnabledAfter && cut && (!decision || cut.number !== decision.number)) return ['not admitted', ...this.decided('by', cut)];
          if (!decision) return [this.changes(event)];
          const owner = event.ownerBefore === nobody ? '' : ' of ' + this.primitive(event.ownerBefore);
          return [`Z1 ${this.depth(decision.met)} ${event.isEnabledAfter ? 'is nearer than' : 'is not nearer than'} Z2 ${this.depth(decision.metToo)}${owner}`];
        }
        case 'comparison': return [`against ${this.primitive(origin.node)}: ${cut ? 'out' : 'in'}`, ...(cut ? this.decided('by', cut) : [])];
        case 'merge': return [`${this.changes(event)}; owner ${this.primitive(event.ownerAfter)}, was ${this.primitive(event.ownerBefore)}`];
        case 'shade': return [this.changes(event), ...(decision ? this.decided('where', decision) : [])];
        case 'skip': return [`no pixel was enabled at i${decision.number}, for ${this.primitive(origin.primitive)}`];
        default: return [this.changes(event)];
      }
    }

    withGeometry(decision) { return [this.decision(decision), this.geometry(decision).join('\n')].filter(text => text).join('; '); }

    comparison(event) {
      const other = this.primitive(event.origin.node);
      return event.cut ? `out of ${other} by ${this.withGeometry(event.cut)}` : `in ${other} (i${event.first}..i${event.last})`;
    }

    classified(story, attempt) {
      if (attempt.decidingComparison >= 0) return 'classified out: it is ' + this.comparison(story.events[attempt.decidingComparison]);
      const at = `classified out at i${story.events[attempt.decidingEvent].last}`;
      const comparisons = story.events.slice(attempt.firstEvent, attempt.decidingEvent + 1).filter(event => event.what === 'comparison');
      return comparisons.length === 0 ? at : at + ': it is ' + comparisons.map(event => this.comparison(event)).join(', ');
    }

    // How a surface ended, in a sentence.
    fate(story, attempt) {
      const event = story.events[attempt.decidingEvent];
      const cut = () => event.cut ? this.withGeometry(event.cut) : 'E';
      switch (attempt.fate) {
        case 'outside': return 'outside it by ' + cut();
        case 'no_depth': return 'nothing of it is left here, by ' + cut();
        case 'refused': return 'not admitted by ' + cut();
        case 'behind':
          return `behind ${this.primitive(event.ownerBefore)}: i${event.decision.number}, Z1 ${this.depth(event.decision.met)} is not less than Z2 ${this.depth(event.decision.metToo)}`;
        case 'classified': return this.classified(story, attempt);
        case 'covered':
          return event.what === 'setup' ? `merged, but the picture was begun anew at i${event.first}`
            : `merged, but ${this.primitive(event.origin.primitive)} was merged over it at i${event.first}`;
        case 'blended': return `merged at i${event.first}; a part of the colour, but not the nearest seen`;
        default: return `merged at i${event.first}`;
      }
    }

    // The same in a few words.
    verdict(story, attempt) {
      const deciding = story.events[attempt.decidingEvent];
      const comparison = story.events[attempt.decidingComparison];
      switch (attempt.fate) {
        case 'outside': return 'beside this pixel';
        case 'no_depth': return 'nothing of it is left here';
        case 'refused': return 'not admitted';
        case 'behind': return 'behind ' + this.primitive(deciding.ownerBefore);
        case 'classified': return comparison ? `classified out: it is ${comparison.cut ? 'outside' : 'in'} ${this.primitive(comparison.origin.node)}` : `classified out, at i${deciding.last}`;
        case 'covered': return deciding.what === 'setup' ? `the picture is begun anew at i${deciding.first}` : `merged; covered at i${deciding.first}`;
        case 'blended': return 'merged; a part of the colour';
        default: return 'merged; this is what is seen';
      }
    }

    verdictOf(story, attempt) {
      const as = attempt.shown === attempt.primitive ? '' : ', drawn with ' + this.primitive(attempt.primitive);
      return `${this.primitive(attempt.shown)}${as}: ${this.verdict(story, attempt)}`;
    }

    lineOf(piece) {
      const found = /@(\d+):/.exec(this.program.primitives[primitiveOf(this.program, piece)] || '');
      return piece !== nobody && found && this.program.file ? `, line ${found[1]} of ${this.program.file}` : '';
    }

    // What the pixel shows and since when: lines.
    head(story) {
      const distance = distanceOf(this.program, story.depth);
      const through = distanceOf(this.program, story.opaqueDepth);
      const lines = [`pixel ${story.x},${story.y} shows ${this.primitive(story.owner)}${this.lineOf(story.owner)}`];
      if (distance !== null) lines.push(`depth ${story.depth} steps, ${sixDigits(distance)} model units from the eye`);
      if (story.depth !== story.opaqueDepth)
        lines.push(`through ${this.primitive(story.opaqueOwner)}` + (through === null ? '' : `, at ${story.opaqueDepth} steps, ${sixDigits(through)} model units`));
      lines.push(`colour ${this.colour(story.colour)}`);
      const seen = story.attempts.filter(attempt => attempt.fate === 'seen').pop();
      if (story.owner === nobody || !seen) return lines;
      const {decision} = story.events[seen.firstEvent];
      if (decision) lines.push(`surface ${this.decision(decision)}`, ...this.geometry(decision));
      const merge = story.events[seen.decidingEvent];
      lines.push(`merged i${merge.first}, over ${this.primitive(merge.ownerBefore)}`);
      return lines;
    }

    // Which events are worth a line: not those of surfaces beside the pixel, nor what is skipped of others.
    worthTelling(story) {
      const told = story.events.map(event => event.what !== 'skip' && (event.what !== 'stored' || !event.isEnabledAfter));
      for (const attempt of story.attempts)
        for (let i = attempt.firstEvent; i <= attempt.lastEvent; ++i) told[i] = attempt.fate !== 'outside';
      return told;
    }

    // Surfaces that are beside the pixel.
    beside(story) {
      const pieces = [...new Set(story.attempts.filter(attempt => attempt.fate === 'outside').map(attempt => attempt.primitive))];
      const most = 6;
      if (pieces.length === 0) return '';
      return 'beside this pixel: ' + pieces.slice(0, most).map(piece => this.primitive(piece)).join(', ') + (pieces.length > most ? ` and ${pieces.length - most} more` : '');
    }

    whyNot(story, answer) {
      const primitive = primitiveOf(this.program, answer.first);
      const name = `p${primitive} ${this.program.primitives[primitive]}`;
      const isWhole = answer.count === 1;
      const lines = [`why not ${name}`];
      if (answer.isSeen) lines.push(`${name} is what the pixel shows`);
      if (isWhole && answer.drawnAs !== answer.first) lines.push(`drawn with ${this.primitive(answer.drawnAs)}, as one convex solid`);
      if (answer.attempts.length === 0) lines.push(this.nowhere(story, answer, name));
      for (const i of answer.attempts) {
        const attempt = story.attempts[i];
        const isOther = attempt.fate === 'seen' && !answer.isSeen;
        lines.push((isWhole ? '' : this.label(attempt.primitive) + ': ') + this.fate(story, attempt) + (isOther ? '; the facet seen here is of ' + this.primitive(story.owner) : ''));
      }
      return lines;
    }

    // Where it is instead, if the page knows that it is not here.
    outOfSight({x, y}, {first, count}, name) {
      const {places} = this.program;
      if (places.length === 0) return '';
      const seen = places.slice(first, first + count).map(place => place.pixels).filter(pixels => pixels);
      if (seen.length === 0) return `${name} is nowhere in the picture`;
      const [x0, y0] = [0, 1].map(i => Math.min(...seen.map(pixels => pixels[i])));
      const [x1, y1] = [2, 3].map(i => Math.max(...seen.map(pixels => pixels[i])));
      if (x >= x0 && x <= x1 && y >= y0 && y <= y1) return '';
      return `${name} is beside this pixel: it is within columns ${x0} to ${x1} and rows ${y0} to ${y1}`;
    }

    nowhere(story, answer, name) {
      if (answer.isBroadcast) return `the instructions that draw ${name} meet this pixel disabled, or are skipped`;
      const beside = this.outOfSight(story, answer, name);
      if (beside) return beside;
      const where = story.segments.length === 0 ? 'any segment' : 'segment ' + story.segments[story.segments.length - 1];
      return `no instruction of ${where} draws ${name}: it is beside the segment's pixels, or pruning found that it cannot be seen there (csgsim render --pruning none draws it)`;
    }
  }

  return {Words, channelsOf, isDepth, isColour};
})();
