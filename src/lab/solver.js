'use strict';
// Runs commands of the program in workers. Each command has a worker of its own, so that it can be stopped at any moment
// and leaves no memory behind; one worker is kept ready.

class Solver {
  // `bytes`: the program as WebAssembly; `text`: the script that runs in the workers.
  constructor(bytes, text) {
    this.module = WebAssembly.compile(bytes);
    this.script = URL.createObjectURL(new Blob([text], { type: 'text/javascript' }));
    this.spare = new Worker(this.script);
  }

  // Starts a command. Returns { done, stop }: a promise of { code, message, text, files }, files a Map of bytes by name; and a
  // function that ends the command, after which the promise is never fulfilled.
  run({ words, files, wanted = [], progress = () => {} }) {
    const worker = this.spare;
    this.spare = new Worker(this.script);
    const done = this.module.then(module => new Promise((fulfil, reject) => {
      worker.onmessage = ({ data }) => {
        if ('progress' in data)
          return progress(data.progress);
        worker.terminate();
        fulfil({ ...data, files: new Map(data.files) });
      };
      worker.onerror = event => reject(new Error(event.message));
      worker.postMessage({ module, words, files: [...files], wanted });
    }));
    return { done, stop: () => worker.terminate() };
  }
}

// The bytes of a base64 text that holds a gzip file.
async function unpacked(text) {
  const stream = new Blob([bytes_of(text)]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(stream).arrayBuffer();
}
