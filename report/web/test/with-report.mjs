// Pages made of samples, and a browser to open them in, for the tests of a file.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { launch } from './browser.mjs';
import { fill, samples } from './sample.mjs';

const project = fileURLToPath(new URL('..', import.meta.url));
export const desktop = { width: 1440, height: 900 };

export let folder;
export let template;
export let browser;
const made = new Map();

before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'lrcs-report-'));
  execFileSync(process.execPath, [join(project, 'build.mjs'), join(folder, 'template.html')]);
  template = readFileSync(join(folder, 'template.html'), 'utf8');
  browser = await launch();
});

after(async () => {
  await browser?.close();
  if (folder) rmSync(folder, { recursive: true });
});

function report(name) {
  if (!made.has(name)) {
    const sample = samples[name]();
    const path = join(folder, `${name}.html`);
    writeFileSync(path, fill(template, sample));
    made.set(name, { data: sample.data, path, url: pathToFileURL(path).href });
  }
  return made.get(name);
}

// Opens a report, lets act use it, and sees to it that the page said nothing and asked for nothing.
export async function withReport(name, act, { viewport = desktop, from = browser, first, ...more } = {}) {
  const { data, url, path } = report(name);
  const context = await from.newContext({ viewport, ...more });
  const page = await context.newPage();
  if (first) await page.addInitScript(first);
  const said = [];
  page.on('console', (message) => said.push(`${message.type()}: ${message.text()}`));
  page.on('pageerror', (error) => said.push(error.stack));
  page.on('dialog', (dialog) => said.push(`dialog ${dialog.message()}`) && dialog.dismiss());
  page.on('request', (request) => {
    if (request.url() !== url && !/^(data|blob):/.test(request.url())) said.push(`request ${request.url()}`);
  });
  try {
    await page.goto(url);
    const ready = await page.evaluate(() => window.lrcs.ready);
    await act({ page, data, path, ready });
    assert.deepEqual(said, []);
  } finally {
    await context.close();
  }
}

// A place of the view where a facet of the part is, by looking for it.
export async function placeOfPart(page, part) {
  return page.evaluate((wanted) => {
    const { clientWidth: width, clientHeight: height } = document.getElementById('target');
    for (let y = 0.1; y < 0.95; y += 0.02) {
      for (let x = 0.05; x < 0.98; x += 0.02) {
        if (window.lrcs.pick(x * width, y * height)?.part === wanted) return [x * width, y * height];
      }
    }
    return null;
  }, part);
}
