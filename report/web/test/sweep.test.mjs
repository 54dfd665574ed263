// Drives the report of a real sweep in Debian's chromium: LRCS=/path/to/lrcs SCENE=scene.yaml node --test
// test/sweep.test.mjs
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { launch } from './browser.mjs';

const { LRCS: lrcs, SCENE: scene } = process.env;
const skip = lrcs && scene ? false : 'needs LRCS and SCENE';
let folder;
let browser;

before(async () => {
  if (skip) return;
  folder = mkdtempSync(join(tmpdir(), 'lrcs-sweep-'));
  execFileSync(lrcs, ['sweep', scene, '-o', join(folder, 'out'), '-q']);
  execFileSync(lrcs, ['report', join(folder, 'out'), '-o', join(folder, 'report.html'), '-q']);
  browser = await launch();
});

after(async () => {
  await browser?.close();
  if (folder) rmSync(folder, { recursive: true });
});

// Rows of sweep.csv as numbers.
function rowsOf(csv) {
  const [, ...lines] = csv.split('\n').filter((line) => line && !line.startsWith('#'));
  return lines.map((line) => line.split(',').map(Number));
}

test('the report of a sweep says what its CSV says, asks for nothing and has no complaint', { skip }, async () => {
  const file = join(folder, 'report.html');
  const csv = readFileSync(join(folder, 'out', 'sweep.csv'), 'utf8');
  const rows = rowsOf(csv);
  assert.ok(statSync(file).size < 8e6);
  const page = await browser.newPage({ viewport: { width: 1440, height: 900 } });
  const said = [];
  page.on('console', (message) => said.push(message.text()));
  page.on('pageerror', (error) => said.push(error.stack));
  page.on('request', (request) => {
    if (!/^(file|data|blob):/.test(request.url())) said.push(request.url());
  });
  await page.goto(pathToFileURL(file).href);
  await page.evaluate(() => window.lrcs.ready);
  const data = JSON.parse(await page.locator('#lrcs-data').textContent());

  assert.equal(data.csv, csv);
  assert.equal(data.rows.sigma_m2.length, rows.length);
  rows.forEach(([azimuth, elevation, , , sigma, , bound], row) => {
    assert.equal(data.rows.transmitter_azimuth_deg[row], azimuth);
    assert.equal(data.rows.transmitter_elevation_deg[row], elevation);
    assert.equal(data.rows.sigma_m2[row], sigma);
    assert.equal(data.rows.bound_m2[row], bound);
    const sum = data.part_sigma_m2[row].reduce((a, b) => a + b, 0);
    assert.ok(Math.abs(sum - sigma) <= 1e-12 * sigma, `row ${row}: parts sum to ${sum}, not ${sigma}`);
  });

  // Every row is coloured by its own facets, and what the slider says is the row's.
  for (const row of [0, Math.floor(rows.length / 2), rows.length - 1]) {
    await page.locator('#slider').fill(String(row));
    const state = await page.evaluate(() => window.lrcs.state);
    assert.equal(state.row, row);
    assert.equal(state.colouredRow, row);
    assert.ok((await page.locator('#result').innerText()).includes(rows[row][4].toPrecision(6)));
    // Facets picked here and there: a part's number is its sum.
    const picked = await page.evaluate(() => {
      const { clientWidth: width, clientHeight: height } = document.getElementById('target');
      const places = [0.3, 0.4, 0.5, 0.6, 0.7];
      return places.flatMap((x) => places.map((y) => window.lrcs.pick(x * width, y * height))).filter(Boolean);
    });
    assert.ok(picked.length > 3);
    for (const { part, sigma_m2: sigma } of picked) assert.equal(sigma, data.part_sigma_m2[row][part]);
  }
  assert.deepEqual(said, []);
});
