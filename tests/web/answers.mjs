// node answers.mjs SITE: answers of SITE's csgsim.wasm to lines of JSON on standard input, one a line: {begin: [name, text,
// knobs]}, or {question, request}. SITE is a folder that node takes for modules.
import fs from 'node:fs';
import path from 'node:path';
import readline from 'node:readline';
import {pathToFileURL} from 'node:url';

const site = path.resolve(process.argv[2]);
const {Program} = await import(pathToFileURL(path.join(site, 'program.js')));
const program = new Program(new WebAssembly.Module(fs.readFileSync(path.join(site, 'csgsim.wasm'))));
for await (const line of readline.createInterface({input: process.stdin})) {
  const {begin, question, request} = JSON.parse(line);
  const {status, body} = begin ? program.begin(...begin) : program.answer(question, request ? JSON.stringify(request) : '');
  process.stdout.write(JSON.stringify([status, body]) + '\n');
}
