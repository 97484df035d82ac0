'use strict';
// Drives a real browser without any package: chromium over its debugging pipe, Firefox over its Marionette port. Both load
// nothing from a network.
//
//   const page = await open_page('chromium', url, width, height);
//   await page.run(code)              the value of an expression in the page, awaited
//   await page.until(code, seconds)   true as soon as the expression is true
//   await page.picture(file)          a screenshot as PNG
//   page.said                         what the page said on its console, and its uncaught errors (chromium)

const { spawn } = require('child_process');
const fs = require('fs'), net = require('net'), os = require('os'), path = require('path');

const sleep = ms => new Promise(fulfil => setTimeout(fulfil, ms));

class Page {
  async until(code, seconds = 120) {
    for (const end = Date.now() + 1000 * seconds; Date.now() < end; await sleep(50))
      if (await this.run(`Boolean(${code})`).catch(() => false))
        return true;
    return false;
  }
}

class Chromium extends Page {
  async open(url, width, height) {
    this.said = [];
    this.waiting = new Map();
    this.browser = spawn(process.env.CHROMIUM || 'chromium', ['--headless', '--no-sandbox', '--use-gl=angle',
      '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--hide-scrollbars', '--allow-file-access-from-files',
      '--host-resolver-rules=MAP * ~NOTFOUND', '--remote-debugging-pipe'],
      { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
    let text = '';
    this.browser.stdio[4].on('data', chunk => {
      const messages = (text + chunk).split('\0');
      text = messages.pop();
      messages.forEach(message => this.take(JSON.parse(message)));
    });
    const { targetId } = await this.send('Target.createTarget', { url: 'about:blank' });
    this.session = (await this.send('Target.attachToTarget', { targetId, flatten: true })).sessionId;
    await this.send('Runtime.enable');
    await this.send('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: 1, mobile: width < 500 });
    await this.send('Page.navigate', { url });
    return this;
  }
  take({ id, result, error, method, params }) {
    if (id) {
      const { fulfil, reject } = this.waiting.get(id);
      error ? reject(new Error(error.message)) : fulfil(result);
    } else if (method === 'Runtime.exceptionThrown') {
      this.said.push(params.exceptionDetails.exception?.description || params.exceptionDetails.text);
    } else if (method === 'Runtime.consoleAPICalled') {
      this.said.push(params.args.map(({ value }) => value).join(' '));
    }
  }
  send(method, params = {}) {
    const id = this.number = (this.number || 0) + 1;
    this.browser.stdio[3].write(JSON.stringify({ id, method, params, sessionId: this.session }) + '\0');
    return new Promise((fulfil, reject) => this.waiting.set(id, { fulfil, reject }));
  }
  async run(code) {
    const { result, exceptionDetails } =
      await this.send('Runtime.evaluate', { expression: code, awaitPromise: true, returnByValue: true });
    if (exceptionDetails)
      throw new Error(exceptionDetails.exception?.description || exceptionDetails.text);
    return result.value;
  }
  async picture(file) {
    fs.writeFileSync(file, Buffer.from((await this.send('Page.captureScreenshot')).data, 'base64'));
  }
  close() { this.browser.kill(); }
}

class Firefox extends Page {
  async open(url, width, height) {
    this.said = [];
    this.waiting = new Map();
    this.folder = fs.mkdtempSync(path.join(os.tmpdir(), 'firefox-'));
    const port = 20000 + process.pid % 20000;
    fs.writeFileSync(path.join(this.folder, 'user.js'), `user_pref("marionette.port", ${port});\n`);
    // Without a display Firefox has no WebGL. Xvfb is one in memory.
    this.display = spawn('Xvfb', ['-displayfd', '3', '-screen', '0', '1920x1200x24'], { stdio: ['ignore', 'ignore', 'ignore', 'pipe'] });
    const number = await new Promise((fulfil, reject) => {
      this.display.on('error', () => reject(new Error('Firefox needs Xvfb')));
      this.display.stdio[3].on('data', text => fulfil(String(text).trim()));
    });
    this.browser = spawn(process.env.FIREFOX || 'firefox-esr', ['--marionette', '--profile', this.folder,
      '--width', String(width), '--height', String(height)],
      { stdio: 'ignore', env: { ...process.env, HOME: this.folder, DISPLAY: ':' + number } });
    for (let tries = 0; !this.socket && tries < 300; ++tries) {
      await sleep(100);
      this.socket = await new Promise(fulfil => {
        const socket = net.connect(port, '127.0.0.1', () => fulfil(socket));
        socket.on('error', () => fulfil(null));
      });
    }
    let bytes = Buffer.alloc(0);
    this.socket.on('data', chunk => {
      bytes = Buffer.concat([bytes, chunk]);
      for (let colon; (colon = bytes.indexOf(':')) > 0;) {
        const end = colon + 1 + Number(bytes.subarray(0, colon));
        if (bytes.length < end)
          break;
        this.take(JSON.parse(bytes.subarray(colon + 1, end)));
        bytes = bytes.subarray(end);
      }
    });
    await this.send('WebDriver:NewSession', {});
    await this.send('WebDriver:SetTimeouts', { script: 600000 });
    await this.send('WebDriver:Navigate', { url });
    return this;
  }
  take(message) {
    if (!Array.isArray(message))
      return; // the greeting
    const [, id, error, result] = message, { fulfil, reject } = this.waiting.get(id);
    error ? reject(new Error(error.message)) : fulfil(result);
  }
  send(command, parameters) {
    const id = this.number = (this.number || 0) + 1, text = JSON.stringify([0, id, command, parameters]);
    this.socket.write(`${Buffer.byteLength(text)}:${text}`);
    return new Promise((fulfil, reject) => this.waiting.set(id, { fulfil, reject }));
  }
  async run(code) {
    const script = `const done = arguments[0]; (async () => ${code})().then(value => done({ value }), error => done({ error: String(error) }))`;
    const { value: { value, error } } = await this.send('WebDriver:ExecuteAsyncScript', { script, args: [], newSandbox: false, sandbox: null });
    if (error)
      throw new Error(error);
    return value;
  }
  async picture(file) {
    const { value } = await this.send('WebDriver:TakeScreenshot', { full: false });
    fs.writeFileSync(file, Buffer.from(value, 'base64'));
  }
  close() {
    this.browser.kill();
    this.display.kill();
    fs.rmSync(this.folder, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
  }
}

const open_page = (browser, ...rest) => (browser === 'firefox' ? new Firefox() : new Chromium()).open(...rest);

module.exports = { open_page };
