// Runs csgsim.wasm in a worker, so that the page stays responsive. Requests {number, begin: [name, text, knobs]} or
// {number, question, request} are answered by {number, status, body}, one after another.
import {Program} from './program.js';

const compiled = async () => {
  const reply = await fetch(new URL('csgsim.wasm', import.meta.url));
  if (!reply.ok) throw new Error('csgsim.wasm: the server returned status ' + reply.status);
  // Servers without a type for .wasm files send another Content-Type.
  return reply.headers.get('Content-Type') === 'application/wasm' ? WebAssembly.compileStreaming(reply)
    : WebAssembly.compile(await reply.arrayBuffer());
};

const program = compiled().then(module => new Program(module));

self.onmessage = async ({data: {number, begin, question, request}}) => {
  try {
    const ready = await program;
    self.postMessage({number, ...(begin ? ready.begin(...begin) : ready.answer(question, request))});
  } catch (error) {
    self.postMessage({number, status: 500, body: JSON.stringify({error: error.message})});
  }
};
