// Khronos' validator must find nothing wrong and nothing doubtful.
// usage: node validate.cjs FILE.glb...
const validator = require('gltf-validator');
const fs = require('fs');
let bad = 0;
const check = async file => {
  const { issues } = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)));
  const { numErrors, numWarnings, numInfos, numHints, messages } = issues;
  console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos, ${numHints} hints`);
  messages.slice(0, 5).forEach(message => console.log(' ', message.code, message.pointer, message.message));
  bad += numErrors + numWarnings;
};
Promise.all(process.argv.slice(2).map(check)).then(() => process.exit(bad ? 1 : 0));
