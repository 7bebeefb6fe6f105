// Runs csgsim.wasm beside the page, so that the page stays quick. Asked by {number, begin: [name, text, knobs]} or
// {number, question, wish}, it answers {number, status, body}, one after another.
import {Program} from './program.js';

const compiled = async () => {
  const reply = await fetch(new URL('csgsim.wasm', import.meta.url));
  if (!reply.ok) throw new Error('csgsim.wasm: the server says ' + reply.status);
  // A server that does not know what it is gives it another type.
  return reply.headers.get('Content-Type') === 'application/wasm' ? WebAssembly.compileStreaming(reply)
    : WebAssembly.compile(await reply.arrayBuffer());
};

const program = compiled().then(module => new Program(module));

self.onmessage = async ({data: {number, begin, question, wish}}) => {
  try {
    const ready = await program;
    self.postMessage({number, ...(begin ? ready.begin(...begin) : ready.answer(question, wish))});
  } catch (error) {
    self.postMessage({number, status: 500, body: JSON.stringify({error: error.message})});
  }
};
