'use strict';

// What happened at a pixel and why, as sim/story tells it; a test holds it against `csgsim explain`. Pieces and
// primitives are numbers, -1 where there is none.
const pixelStory = (() => {
  const {isSame, overlaps, sumAt, valueOf, squaresBefore, noField} = pixelMemory;
  const nobody = -1;
  const isOneOf = (value, ...values) => values.includes(value);
  const comparesFields = opcode => isOneOf(opcode, 'field_lt', 'field_le');
  const addsToExpression = opcode => isOneOf(opcode, 'linear_plus', 'linear_minus');
  const maySetDepth = opcode => addsToExpression(opcode) || isOneOf(opcode, 'copy', 'load_linear', 'set_constant', 'keep_max', 'keep_min');
  // Whether what is classified is compared with nothing yet: its depths are stored.
  const stores = origin => origin.purpose === 'classify' && origin.node === nobody;
  const fieldOf = (program, role) => program.fields.find(field => field.role === role) || noField;
  const allOnes = field => 2 ** field.width - 1;

  // The smallest field with a name that holds this one, of several the first. Of a depth a part is none.
  const namedAround = (program, field) => {
    let smallest = null;
    for (const named of program.fields) {
      const isDepth = isOneOf(named.role, 'depth', 'candidate_depth');
      const holds = isDepth ? isSame(named, field) : named.base <= field.base && named.base + named.width >= field.base + field.width;
      if (holds && (!smallest || named.width < smallest.width)) smallest = named;
    }
    return smallest ? {base: smallest.base, width: smallest.width} : field;
  };

  // Who owns the pixel, as sim/observe/frame.h takes it down from outside.
  class Owner {
    constructor(program) {
      const effect = program.effects.findIndex(name => program.fields.some(field => field.name === name + '.nearest_depth'));
      const named = name => effect < 0 ? noField : program.fields.find(field => field.role === 'effect' && field.name === program.effects[effect] + '.' + name) || noField;
      Object.assign(this, {program, effect, depthField: fieldOf(program, 'depth'), colourField: program.colour, candidate: fieldOf(program, 'candidate_colour')});
      this.nearest = this.depthField.width > 0 ? named('nearest_depth') : noField;
      this.nearestColour = named('nearest_colour');
      Object.assign(this, {owner: nobody, candidateOwner: nobody, paneOwner: nobody, paneDepth: null, depth: allOnes(this.depthField), colour: program.background});
      Object.assign(this, {opaqueOwner: nobody, opaqueDepth: this.depth});
    }

    writesPanes({origin, fields}) { return this.nearest.width > 0 && origin.effect === this.effect && isSame(fields[0], this.nearest); }
    isMerge({opcode, fields}) { return opcode === 'copy' && this.depthField.width > 0 && isSame(fields[0], this.depthField); }
    isPaneMerge(one) { return one.opcode === 'copy' && one.origin.purpose === 'merge' && this.writesPanes(one); }
    beginsPanes(one) { return one.opcode === 'copy' && isSame(one.fields[1], this.depthField) && this.writesPanes(one); }
    colours({opcode, origin, fields}, colour) {
      if (origin.node === nobody || colour.width === 0) return false;
      if (opcode === 'set_constant' && isSame(fields[0], colour)) return true;
      return opcode === 'copy' && origin.purpose === 'shade' && fields[0].base >= colour.base && fields[0].base + fields[0].width <= colour.base + colour.width;
    }
    merges(one) { return this.isMerge(one) || this.isPaneMerge(one); }

    after(one, isEnabled, read) {
      const {origin} = one;
      if (one.opcode === 'field_lt' && isSame(one.fields[1], this.depthField) && this.writesPanes(one)) {
        if (this.paneOwner !== nobody && this.paneDepth === null) this.paneDepth = read(this.nearest);
        return;
      }
      if (!isEnabled) return;
      const merged = () => this.merges(one) && origin.node !== nobody && this.candidate.width > 0 ? this.candidateOwner : origin.primitive;
      const isPane = this.isPaneMerge(one);
      if (this.colours(one, this.candidate)) {
        this.candidateOwner = origin.primitive;
      } else if (isPane || this.beginsPanes(one)) {
        this.paneOwner = isPane ? merged() : nobody;
        this.paneDepth = null;
      } else if (origin.effect === this.effect && this.colours(one, this.nearestColour)) {
        if (this.paneDepth === null) this.paneOwner = origin.primitive;
      } else if (this.isMerge(one) || this.colours(one, this.colourField)) {
        this.owner = merged();
      }
    }

    soFar(read) {
      if (this.nearest.width > 0 && this.paneOwner !== nobody) return this.paneOwner;
      return this.depthField.width > 0 && read(this.depthField) === allOnes(this.depthField) ? nobody : this.owner;
    }

    afterSegment(read) {
      if (this.depthField.width > 0) {
        this.depth = read(this.depthField);
        if (this.depth === allOnes(this.depthField)) this.owner = nobody;
        this.opaqueDepth = this.depth;
        this.opaqueOwner = this.owner;
        if (this.nearest.width > 0 && this.paneDepth !== null) {
          Object.assign(this, {depth: this.paneDepth, owner: this.paneOwner, paneDepth: null, paneOwner: nobody});
        }
      }
      if (this.colourField.width > 0) this.colour = read(this.colourField);
    }
  }

  const holds = (segment, x, y) => x >= segment.x && x < segment.x + segment.width && y >= segment.y && y < segment.y + segment.height;

  // What each instruction did at the pixel.
  const runPixel = (program, x, y) => {
    const run = {segments: [], steps: []};
    const frame = new Owner(program);
    program.segments.forEach((segment, number) => {
      if (!holds(segment, x, y)) return;
      run.segments.push(number);
      const [column, row] = [x - segment.x, y - segment.y];
      const pixel = new pixelMemory.Pixels(program.memoryBits, column, row, 1, 1, 1);
      const read = field => pixel.reader(field)(0);
      for (let index = 0; index < segment.instructions.length;) {
        const instruction = segment.instructions[index];
        const {linear, fields} = instruction;
        const done = {segment: number, index, number: segment.first + index, instruction, fits: true, value: 0, isEnabledBefore: pixel.enabled[0] === 1, skipped: 0};
        if (linear && instruction.opcode !== 'squares') {
          const before = squaresBefore(segment, index);
          const sum = sumAt(linear, before && before.linear, column, row);
          done.fits = instruction.opcode === 'stripe' || BigInt.asIntN(linear.width, sum) === sum;
          done.value = valueOf(sum, linear);
        }
        done.met = read(fields[0]);
        done.metToo = read(fields[1]);
        done.target = instruction.operands[0] === 'target' ? namedAround(program, fields[0]) : noField;
        done.before = read(done.target);
        const next = pixelMemory.step(program, segment, pixel, index);
        done.isEnabledAfter = pixel.enabled[0] === 1;
        frame.after(instruction, done.isEnabledAfter, read);
        done.after = read(done.target);
        done.takesPixel = done.isEnabledAfter && frame.merges(instruction);
        done.owner = frame.soFar(read);
        done.skipped = next - index - 1;
        run.steps.push(done);
        index = next;
      }
      if (segment.instructions.length > 0) frame.afterSegment(read);
    });
    return Object.assign(run, {owner: frame.owner, depth: frame.depth, opaqueOwner: frame.nearest.width > 0 ? frame.opaqueOwner : frame.owner,
      opaqueDepth: frame.nearest.width > 0 ? frame.opaqueDepth : frame.depth, colour: frame.colour});
  };

  const setsDepth = (opcode, step) => {
    if (!step.isEnabledBefore) return false;
    if (opcode === 'keep_max') return step.value > step.met;
    if (opcode === 'keep_min') return step.value < step.met;
    return true;
  };

  const differs = change => change.before !== change.after;

  // Goes through the steps of a run and closes an event where the origin changes.
  class Narrator {
    constructor(program) { Object.assign(this, {program, events: [], open: null, owner: nobody, z1: noField, quadric: null, withResults: false}); }

    tell(run) {
      for (const step of run.steps) {
        if (this.open && this.open.event.segment !== step.segment) this.close();
        this.take(step);
        this.owner = step.owner;
      }
      this.close();
      return this.events;
    }

    hasRole(field, ...roles) { return this.program.fields.some(named => roles.includes(named.role) && field.width > 0 && overlaps(named, field)); }

    usesQuadric({opcode, origin, fields}) {
      if (!isOneOf(origin.purpose, 'render', 'classify')) return false;
      if (!stores(origin) && fields.some(field => this.hasRole(field, 'stored'))) return false;
      return comparesFields(opcode) || opcode === 'copy' || addsToExpression(opcode);
    }

    decisionOf(step) {
      const {segment, number, instruction, value, met, metToo} = step;
      const squares = instruction.linear && squaresBefore(this.program.segments[segment], step.index);
      return {segment, number, instruction, value, met, metToo, squares, quadric: this.usesQuadric(instruction) ? this.quadric && {...this.quadric} : null};
    }

    copiesDepth({opcode, fields}) { return opcode === 'copy' && this.z1.width > 0 && isSame(fields[1], this.z1); }

    whatOf(instruction) {
      const {origin} = instruction;
      const open = this.open && this.open.event;
      if (open && open.what === 'surface' && (origin.purpose === 'shade' || (origin.purpose === 'render' && origin.primitive === open.origin.primitive))) return 'surface';
      if (origin.purpose === 'merge') {
        const goesOn = open && open.what === 'merge' && open.origin.primitive === origin.primitive && !comparesFields(instruction.opcode);
        return goesOn || this.copiesDepth(instruction) ? 'merge' : 'depth_test';
      }
      if (origin.purpose === 'classify') return stores(origin) ? 'stored' : 'comparison';
      return {setup: 'setup', render: 'surface', stack: 'bits', shade: 'shade', effect: 'effect'}[origin.purpose];
    }

    take(step) {
      const {instruction} = step;
      if (instruction.opcode === 'skip_if_none') return this.takeQuestion(step);
      const what = this.whatOf(instruction);
      const goesOn = this.open && this.open.event.what === what &&
        (isOneOf(what, 'surface', 'merge') || this.open.event.origin.text === instruction.origin.text);
      if (!goesOn) this.begin(what, instruction.origin, step);
      const {open} = this;
      const {event} = open;
      this.noteQuadric(instruction, step);
      if (what === 'surface' && instruction.origin.purpose === 'render') this.noteDepth(instruction, step);
      this.noteBits(instruction, step);
      this.noteChange(step);
      this.noteCut(instruction, step);
      if (!step.fits && step.isEnabledBefore && !event.misfit) event.misfit = this.decisionOf(step);
      if (comparesFields(instruction.opcode)) {
        open.testsDepth = true;
        if (step.isEnabledBefore && what !== 'surface') event.decision = this.decisionOf(step);
      }
      if (what === 'shade' && instruction.opcode === 'linear_eq' && step.isEnabledAfter) event.decision = this.decisionOf(step);
      open.isMet = open.isMet || step.isEnabledBefore || step.isEnabledAfter;
      Object.assign(event, {last: step.number, isEnabledAfter: step.isEnabledAfter, ownerAfter: step.owner});
      if (what === 'merge' && this.copiesDepth(instruction)) Object.assign(event, {mergedInto: step.target, takesPixel: step.takesPixel});
      return undefined;
    }

    eventAt(what, step, first, origin) {
      return {what, segment: step.segment, first, last: first, origin, isEnabledBefore: false, isEnabledAfter: false, cut: null, decision: null, misfit: null,
        changes: [], mergedInto: noField, takesPixel: false, byResults: false, ownerBefore: this.owner, ownerAfter: this.owner};
    }

    takeQuestion(step) {
      if (step.skipped === 0) return;
      this.close();
      const event = this.eventAt('skip', step, step.number + 1, step.instruction.origin);
      this.events.push(Object.assign(event, {last: step.number + step.skipped, decision: this.decisionOf(step)}));
    }

    begin(what, origin, step) {
      this.close();
      this.open = {isMet: false, testsDepth: false, event: Object.assign(this.eventAt(what, step, step.number, origin), {isEnabledBefore: step.isEnabledBefore})};
      if (what === 'surface') Object.assign(this, {z1: noField, withResults: false});
    }

    // What quadrics are worked out in, or a part of a depth, is no surface's depth.
    isScratch(field) {
      return this.program.fields.some(named => overlaps(named, field) && (named.role === 'scratch' || (named.role === 'candidate_depth' && !isSame(named, field))));
    }

    // Follows how the depth of a quadric comes about.
    noteQuadric(instruction, step) {
      if (instruction.opcode === 'load_linear') {
        const squares = squaresBefore(this.program.segments[step.segment], step.index);
        this.quadric = squares && {squares, load: instruction, loadNumber: step.number, discriminant: step.value, field: noField, rootNumber: 0, root: 0, depthNumber: 0, middle: 0, offset: 0, isFar: false};
      }
      if (!this.quadric || !step.isEnabledBefore) return;
      if (instruction.opcode === 'root') {
        const [field] = instruction.fields;
        Object.assign(this.quadric, {field, rootNumber: step.number});
        if (isSame(step.target, field)) this.quadric.root = Number(BigInt(step.after) >> BigInt(Math.floor(field.width / 2) + 1));
      } else if (addsToExpression(instruction.opcode)) {
        Object.assign(this.quadric, {depthNumber: step.number, middle: step.value, offset: step.met, isFar: instruction.opcode === 'linear_plus'});
      }
    }

    noteDepth(instruction, step) {
      if (!maySetDepth(instruction.opcode) || this.isScratch(instruction.fields[0])) return;
      [this.z1] = instruction.fields;
      if (setsDepth(instruction.opcode, step)) this.open.event.decision = this.decisionOf(step);
    }

    // Whether what the mask is narrowed by next is the last comparison alone.
    noteBits(instruction, step) {
      if (instruction.origin.purpose !== 'stack') return;
      instruction.operands.forEach((kind, i) => {
        if (kind === 'source' && this.hasRole(instruction.fields[i], 'stack', 'product')) this.withResults = true;
      });
      if (!this.hasRole(instruction.fields[0], 'mask')) return;
      if (step.before === 1 && step.after === 0 && step.target.width > 0) this.open.event.byResults = this.withResults;
      if (instruction.opcode === 'enable_load' || step.target.width > 0) this.withResults = false;
    }

    noteChange(step) {
      if (step.target.width === 0 || !(step.isEnabledBefore || step.before !== step.after)) return;
      const {changes} = this.open.event;
      const known = changes.find(change => isSame(change.field, step.target));
      if (known) Object.assign(known, {after: step.after, number: step.number});
      else changes.push({field: step.target, before: step.before, after: step.after, number: step.number});
      this.open.isMet = true;
    }

    noteCut(instruction, step) {
      if (step.isEnabledAfter) this.open.event.cut = null;
      else if (step.isEnabledBefore && instruction.opcode !== 'enable_load') this.open.event.cut = this.decisionOf(step);
    }

    close() {
      if (this.open && this.isTold(this.open)) this.events.push(this.open.event);
      this.open = null;
    }

    isTold({event, isMet, testsDepth}) {
      const hasChanged = event.changes.some(differs);
      switch (event.what) {
        case 'surface': return isMet;
        case 'depth_test': return (testsDepth || event.cut !== null) && (event.isEnabledBefore || hasChanged);
        case 'comparison': return event.isEnabledBefore;
        case 'bits':
        case 'effect': return hasChanged;
        default: return event.changes.length > 0;
      }
    }
  }

  // The first change of a field of that role.
  const changeOf = (program, event, role) =>
    event.changes.find(change => program.fields.some(named => named.role === role && isSame(named, change.field)));

  // The surfaces among the events, and how each ended.
  class Attempts {
    constructor(program, events) { Object.assign(this, {program, events}); }

    goesOn(event, primitive, segment) {
      if (event.segment !== segment) return false;
      if (isOneOf(event.what, 'depth_test', 'comparison', 'bits', 'merge', 'skip')) return event.origin.primitive === primitive && event.origin.purpose !== 'render';
      return event.what === 'shade' && (event.origin.primitive === primitive || event.origin.node === primitive);
    }

    // The last event for which that holds; -1 if there is none.
    lastThat({firstEvent, lastEvent}, holds) {
      for (let i = lastEvent; i > firstEvent; --i) if (holds(this.events[i])) return i;
      return -1;
    }
    lastOf(attempt, what) { return this.lastThat(attempt, event => event.what === what); }
    own({firstEvent, lastEvent}) { return this.events.slice(firstEvent, lastEvent + 1); }

    untilWithdrawn(attempt) {
      const withdrawn = this.lastThat(attempt, event => event.what === 'bits' && changeOf(this.program, event, 'candidate_depth'));
      return {...attempt, lastEvent: withdrawn < 0 ? attempt.lastEvent : withdrawn};
    }

    tellClassified(attempt) {
      attempt.fate = 'classified';
      const emptied = this.lastThat(attempt, event => {
        const mask = event.what === 'bits' && changeOf(this.program, event, 'mask');
        return mask && mask.before === 1 && mask.after === 0;
      });
      attempt.decidingEvent = emptied < 0 ? attempt.lastEvent : emptied;
      const until = {...attempt, lastEvent: attempt.decidingEvent};
      const comparison = this.lastOf(until, 'comparison');
      const count = this.own(until).filter(event => event.what === 'comparison').length;
      const passed = this.own(attempt).filter(event => event.what === 'depth_test' && event.decision && event.isEnabledAfter).length;
      const hasLabels = fieldOf(this.program, 'label').width > 0;
      const isAlone = count === 1 || (emptied >= 0 && !this.events[emptied].byResults && !hasLabels && passed <= 1);
      if (comparison >= 0 && isAlone) attempt.decidingComparison = comparison;
    }

    tellUnmerged(attempt) {
      const tested = this.untilWithdrawn(attempt);
      const test = this.lastOf(tested, 'depth_test');
      if (test < 0 || !this.events[test].isEnabledBefore) {
        const joint = this.lastThat(tested, event => event.what === 'comparison' && !event.cut);
        if (joint >= 0) {
          Object.assign(attempt, {fate: 'classified', decidingEvent: joint, decidingComparison: joint});
          return;
        }
      }
      if (test >= 0 && !this.events[test].isEnabledAfter) {
        const [surface, {cut, decision}] = [this.events[attempt.firstEvent], this.events[test]];
        const isBehind = cut && decision && surface.decision && isSame(cut.instruction.fields[0], surface.decision.instruction.fields[0]);
        Object.assign(attempt, {fate: isBehind ? 'behind' : 'refused', decidingEvent: test});
        return;
      }
      this.tellClassified(attempt);
    }

    covers(event, merge) {
      if (event.what === 'setup')
        return event.changes.some(change => isSame(change.field, merge.mergedInto)) || changeOf(this.program, event, 'depth') !== undefined;
      return event.what === 'merge' && isSame(event.mergedInto, merge.mergedInto) && event.origin.effect === merge.origin.effect;
    }

    tellFate(attempt) {
      const surface = this.events[attempt.firstEvent];
      attempt.decidingEvent = attempt.firstEvent;
      if (!surface.isEnabledAfter) {
        attempt.fate = surface.decision ? 'no_depth' : 'outside';
        return;
      }
      const merge = this.lastOf(attempt, 'merge');
      if (merge < 0) {
        this.tellUnmerged(attempt);
        return;
      }
      if (this.events[merge].takesPixel) attempt.shown = this.events[attempt.lastEvent].ownerAfter;
      const covering = this.events.findIndex((event, i) => i > merge && this.covers(event, this.events[merge]));
      attempt.fate = covering < 0 ? 'seen' : 'covered';
      attempt.decidingEvent = covering < 0 ? merge : covering;
    }

    tell(owner) {
      const attempts = [];
      this.events.forEach((event, i) => {
        if (event.what !== 'surface') return;
        const {primitive} = event.origin;
        const attempt = {primitive, shown: primitive, firstEvent: i, lastEvent: i, fate: '', decidingEvent: i, decidingComparison: -1};
        while (attempt.lastEvent + 1 < this.events.length && this.goesOn(this.events[attempt.lastEvent + 1], primitive, event.segment)) ++attempt.lastEvent;
        this.tellFate(attempt);
        attempts.push(attempt);
      });
      // Several may end uncovered: the last that took the pixel is seen, and the others have a part in the colour.
      const seen = attempts.filter(one => one.fate === 'seen');
      const nearest = seen.filter(one => this.events[one.decidingEvent].takesPixel).pop();
      if (nearest) {
        seen.forEach(one => { if (one !== nearest) one.fate = 'blended'; });
        nearest.shown = owner;
      }
      return attempts;
    }
  }

  // All that happened at a pixel in a frame.
  const of = (program, x, y) => {
    const {segments, owner, depth, opaqueOwner, opaqueDepth, colour, ...run} = runPixel(program, x, y);
    const events = new Narrator(program).tell(run);
    return {x, y, segments, owner, depth, opaqueOwner, opaqueDepth, colour, events, attempts: new Attempts(program, events).tell(owner)};
  };

  const primitiveOf = (program, piece) => {
    let low = 0;
    for (let high = program.primitives.length; high - low > 1;) {
      const middle = low + high >> 1;
      if (program.firsts[middle] <= piece) low = middle;
      else high = middle;
    }
    return piece < program.firsts[program.primitives.length] ? low : piece;
  };

  // Why a primitive is not what a pixel shows.
  const whyNot = (program, story, primitive) => {
    const first = program.firsts[primitive];
    const count = program.firsts[primitive + 1] - first;
    const find = holds => story.segments.map(number => program.segments[number].instructions.find(holds)).find(one => one);
    const isDrawn = piece => find(({origin}) => origin.purpose === 'render' && origin.primitive === piece) !== undefined;
    const drawnAs = piece => {
      if (isDrawn(piece)) return piece;
      const place = program.places[piece];
      if (place && isDrawn(place.front)) return place.front;
      const shading = find(({origin}) => origin.purpose === 'shade' && origin.primitive === piece && origin.node !== nobody);
      return shading ? shading.origin.node : piece;
    };
    const drawn = Array.from({length: count}, (_, i) => drawnAs(first + i));
    return {first, count, drawnAs: drawn[0], isSeen: story.owner !== nobody && primitiveOf(program, story.owner) === primitive, isBroadcast: drawn.some(isDrawn),
      attempts: story.attempts.map((_, i) => i).filter(i => drawn.includes(story.attempts[i].primitive))};
  };

  return {of, whyNot, primitiveOf, nobody, differs};
})();
