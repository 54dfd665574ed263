// How soon a page shows its target: node --test test/first-picture.test.mjs, with nothing else to do for the machine.
import assert from 'node:assert/strict';
import { statSync } from 'node:fs';
import { test } from 'node:test';
import { launch } from './browser.mjs';
import { placeOfPart, withReport } from './with-report.mjs';

// Keeps the pixels of the first picture as they are when the page says that it is drawn.
const keepFirstPicture = () => {
  let lrcs;
  Object.defineProperty(window, 'lrcs', {
    get: () => lrcs,
    set(value) {
      lrcs = value;
      lrcs.firstPicture.then(() => {
        const { width, height } = document.getElementById('soft');
        const { data } = document.getElementById('soft').getContext('2d').getImageData(0, 0, width, height);
        const names = [...document.querySelectorAll('#overlay .label')].map((label) => label.textContent);
        window.first = { data, names, key: document.getElementById('colour-key').innerText };
      });
    },
  });
};

// Of the pixels in the middle of 5 x 5 of one colour, not white, in both pictures: how many there are, and how many are
// another colour in the picture by WebGL. It smooths edges and draws creases.
const compareWithWebGl = () =>
  new Promise((done) =>
    requestAnimationFrame(() => {
      const view = document.getElementById('target');
      const copy = document.createElement('canvas');
      const { width, height } = view;
      Object.assign(copy, { width, height });
      copy.getContext('2d').drawImage(view, 0, 0);
      const pixelsOf = ({ data }) => new Uint32Array(data.buffer);
      const pictures = [pixelsOf(copy.getContext('2d').getImageData(0, 0, width, height)), pixelsOf(window.first)];
      const around = [-2, -1, 0, 1, 2].flatMap((y) => [-2, -1, 0, 1, 2].map((x) => y * width + x));
      const isFlat = (picture, k) => picture[k] !== 0xffffffff && around.every((d) => picture[k + d] === picture[k]);
      const result = { compared: 0, other: 0, colours: new Set(pictures[1]).size };
      for (let k = 2 * width + 2; k < width * height - 2 * width - 2; ++k) {
        if (!pictures.every((picture) => isFlat(picture, k))) continue;
        ++result.compared;
        const [a, b] = pictures.map((picture) => picture[k]);
        if ([0, 8, 16].some((shift) => Math.abs(((a >> shift) & 255) - ((b >> shift) & 255)) > 2)) ++result.other;
      }
      done(result);
    }),
  );

test('50,000 facets: size, and the first picture within 2 s in a browser just started', async () => {
  const times = [];
  // The fastest of some counts: other programs on the machine only make it slower.
  for (let k = 0; k < 6 && !times.some((time) => time < 2000); ++k) {
    const cold = await launch();
    try {
      const act = async ({ page, data, path, ready }) => {
        times.push(Math.round(ready.firstPictureMs));
        const { names, key } = await page.evaluate(() => ({ ...window.first, data: null }));
        assert.deepEqual(names.sort(), ['sensor', 'x forward', 'y', 'z']);
        assert.match(key, /40\n[^]*0\nreturn per area \[dB re/);
        const { compared, other, colours } = await page.evaluate(compareWithWebGl);
        assert.ok(compared > 5000 && colours > 50 && other === 0, `${compared} pixels, ${other} of another colour`);
        if (k > 0) return;
        const bytes = statSync(path).size;
        console.log(`${data.shown.facets} facets, ${data.shown.stored_rows.length} rows: ${bytes} bytes`);
        assert.ok(data.shown.facets >= 50000 && bytes <= 8 << 20);
        assert.match(await page.locator('#view-note').innerText(), /each for a group of the target's 1,234,567/);
        await page.evaluate(() => window.lrcs.setRow(77));
        const place = await placeOfPart(page, 14);
        const picked = await page.evaluate(([x, y]) => window.lrcs.pick(x, y), place);
        assert.equal(picked.sigma_m2, data.part_sigma_m2[77][14]);
      };
      await withReport('large', act, { from: cold, first: keepFirstPicture });
    } finally {
      await cold.close();
    }
  }
  console.log(`first picture after ${times.join(', ')} ms`);
  assert.ok(Math.min(...times) < 2000, `first picture after ${times.join(', ')} ms`);
});
