'use strict';
// The worker of the laboratory: runs one command of the program, which the page sends as words, with files in a folder of
// its own. See docs/lab.md.
//
// Gets  { module, words, files, wanted }   module: the compiled program; files: [name, bytes] to be written first;
//                                          wanted: names of files to be sent back
// Sends { progress }                       0 to 1, at most twenty times a second
//       { code, message, text, files }     exit code; standard error and output; the wanted files that exist: [name, bytes]

onmessage = async ({ data: { module, words, files, wanted } }) => {
  let message = '', text = '', line = '', told = 0;
  const read_progress = () => {
    const share = /(\d+) %/.exec(line), now = performance.now();
    if (line.includes('solving') && share && now - told > 50) {
      told = now;
      postMessage({ progress: Number(share[1]) / 100 });
    }
    if (!share)
      message += line.replaceAll('\x1b[K', ''); // which clears the rest of a terminal's line
    line = '';
  };
  const program = await Multipath({
    instantiateWasm: (imports, use) => {
      WebAssembly.instantiate(module, imports).then(instance => use(instance, module));
      return {};
    },
    noInitialRun: true,
    stdin: () => null,
    stdout: code => { text += String.fromCharCode(code); },
    stderr: code => {
      line += String.fromCharCode(code);
      if (code === 10 || code === 13)
        read_progress();
    },
    quit: (status, exit) => { throw exit; },
  });
  const { FS } = program;
  FS.mkdir('/room');
  FS.chdir('/room');
  for (const [name, bytes] of files)
    FS.writeFile(name, bytes);
  let code = 0;
  try {
    code = program.callMain(words);
  } catch (exit) {
    code = 'status' in exit ? exit.status : 1;
    message += 'status' in exit ? '' : String(exit);
  }
  const found = wanted.filter(name => FS.analyzePath(name).exists).map(name => [name, FS.readFile(name)]);
  postMessage({ code, message: message + line, text, files: found }, found.map(([, bytes]) => bytes.buffer));
};
