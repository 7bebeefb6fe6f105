// Runs csgsim.wasm, which answers like csgsim view, in a worker of the page or in node.
import {systemOf} from './wasi.js';

const encoder = new TextEncoder();
const decoder = new TextDecoder();

export class Program {
  // Takes a compiled WebAssembly.Module.
  constructor(module) {
    this.module = module;
    this.begun = null;
    this.start();
  }

  // Returns the status of a question, as in HTTP, and the text of its answer.
  answer(question, request = '') {
    try {
      return this.call('answer', question, request);
    } catch (error) {
      // The memory is no longer reliable.
      this.start();
      if (this.begun) this.begin(...this.begun);
      return {status: 500, body: JSON.stringify({error: 'csgsim failed, possibly out of memory, and was restarted: ' + error.message})};
    }
  }

  // Opens a model: its name, its text, and knobs as for csgsim view.
  begin(name, text, knobs) {
    this.begun = [name, text, knobs];
    this.call('keep', name, text);
    return this.call('begin', name, JSON.stringify(knobs));
  }

  start() {
    this.exports = new WebAssembly.Instance(this.module, {wasi_snapshot_preview1: systemOf(() => this.exports.memory)}).exports;
    this.exports._initialize();
  }

  call(what, first, second) {
    const [head, tail] = [first, second].map(text => encoder.encode(text));
    const at = this.exports.csgsim_input(head.length + tail.length);
    const room = new Uint8Array(this.exports.memory.buffer, at, head.length + tail.length);
    room.set(head);
    room.set(tail, head.length);
    const status = this.exports['csgsim_' + what](head.length);
    return {status, body: decoder.decode(new Uint8Array(this.exports.memory.buffer, this.exports.csgsim_output(), this.exports.csgsim_output_size()))};
  }
}
