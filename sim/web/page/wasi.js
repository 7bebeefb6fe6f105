// System interface (WASI) of csgsim.wasm in a page: a clock, and a console for printed text. There are no environment
// variables and no files.

const success = 0;
const badDescriptor = 8;
const noEntry = 44;
const characterDevice = 2;

// `memory` returns the memory of the module.
export const systemOf = memory => {
  const view = () => new DataView(memory().buffer);
  const lines = {1: '', 2: ''};
  const decoder = new TextDecoder();

  const print = (descriptor, text) => {
    const parts = (lines[descriptor] + text).split('\n');
    lines[descriptor] = parts.pop();
    for (const line of parts) console.log(line);
  };

  return {
    environ_sizes_get: (countAt, bytesAt) => {
      view().setUint32(countAt, 0, true);
      view().setUint32(bytesAt, 0, true);
      return success;
    },
    environ_get: () => success,
    clock_time_get: (clock, precision, at) => {
      const milliseconds = clock === 0 ? Date.now() : performance.now();
      view().setBigUint64(at, BigInt(Math.round(milliseconds * 1e6)), true);
      return success;
    },
    fd_write: (descriptor, vectors, count, writtenAt) => {
      let written = 0;
      for (let i = 0; i < count; ++i) {
        const at = view().getUint32(vectors + 8 * i, true);
        const length = view().getUint32(vectors + 8 * i + 4, true);
        print(descriptor, decoder.decode(new Uint8Array(memory().buffer, at, length)));
        written += length;
      }
      view().setUint32(writtenAt, written, true);
      return success;
    },
    fd_fdstat_get: (descriptor, at) => {
      if (descriptor > 2) return badDescriptor;
      new Uint8Array(memory().buffer, at, 24).fill(0);
      view().setUint8(at, characterDevice);
      return success;
    },
    fd_fdstat_set_flags: () => success,
    fd_close: () => success,
    fd_seek: () => badDescriptor,
    fd_read: () => badDescriptor,
    fd_prestat_get: () => badDescriptor,
    fd_prestat_dir_name: () => badDescriptor,
    path_open: () => noEntry,
    path_filestat_get: () => noEntry,
    proc_exit: status => { throw new Error('csgsim ended with status ' + status); },
  };
};
