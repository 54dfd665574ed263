// Drives pages made of samples in Debian's chromium: node --test test/report.test.mjs
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { launch } from './browser.mjs';
import { fill, samples } from './sample.mjs';
import { browser, desktop, folder, placeOfPart, template, withReport } from './with-report.mjs';

const stateOf = (page) => page.evaluate(() => window.lrcs.state);
const pictureOf = async (page) => {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  return (await page.locator('#view').screenshot()).toString('base64');
};
const numberIn = (text) => Number(text.replace('\u2212', '-'));
const close = (a, b, relative = 1e-12) => assert.ok(Math.abs(a - b) <= relative * Math.abs(b), `${a} is not ${b}`);

test('the template holds the marker once, the licences, and asks for nothing outside', () => {
  assert.equal(template.split('<!-- lrcs:data -->').length, 2);
  for (const words of [
    'three',
    'echarts',
    'zrender',
    'fflate',
    'Apache License',
    'MIT License',
    'Apache ECharts\nCopyright',
  ]) {
    assert.ok(template.includes(words), words);
  }
  assert.ok(template.includes("default-src 'none'"));
  assert.ok(!/(src|href)="(?!data:)/.test(template));
  assert.ok(template.length < 2e6);
  console.log(`template: ${template.length} bytes`);
});

test('the slider moves colours and markers', () =>
  withReport('satellite', async ({ page, data }) => {
    await page.waitForTimeout(300);
    const before = await stateOf(page);
    const picture = await pictureOf(page);
    await page.locator('#slider').fill('18');
    const now = await stateOf(page);
    assert.equal(now.row, 18);
    assert.equal(now.colouredRow, 18);
    assert.notDeepEqual(now.markers.sweep, before.markers.sweep);
    assert.notDeepEqual(now.markers.polar, before.markers.polar);
    assert.notEqual(await pictureOf(page), picture);
    assert.match(
      await page.locator('#result').innerText(),
      new RegExp(data.rows.sigma_m2[18].toPrecision(6).replace('.', '\\.')),
    );
    assert.match(await page.locator('#slider').getAttribute('aria-valuetext'), /^azimuth 90°: LRCS /);
  }));

test('keys move the slider, and turn the target', () =>
  withReport('satellite', async ({ page }) => {
    await page.locator('#slider').focus();
    const row = () => page.evaluate(() => window.lrcs.row());
    const after = async (key) => (await page.keyboard.press(key), row());
    assert.equal(await after('ArrowRight'), 1);
    assert.equal(await after('End'), 72);
    assert.ok((await after('PageDown')) < 72);
    assert.equal(await after('Home'), 0);
    const paged = await after('PageUp');
    assert.ok(paged > 1);
    assert.equal(await after('ArrowLeft'), paged - 1);
    await page.waitForTimeout(300);
    const picture = await pictureOf(page);
    await page.locator('#target').focus();
    for (const key of ['ArrowLeft', 'ArrowUp', '+', 'Shift+ArrowUp']) await page.keyboard.press(key);
    const turned = await pictureOf(page);
    assert.notEqual(turned, picture);
    await page.keyboard.press('0');
    assert.notEqual(await pictureOf(page), turned);
  }));

test('a click in a plot goes to that aspect', () =>
  withReport('satellite', async ({ page }) => {
    const goTo = async (row, plot, host) => {
      // Plots are drawn when there is time: on a busy machine a marker's place may be read too early.
      for (const wait of [700, 2000, 4000, 8000]) {
        await page.evaluate((k) => window.lrcs.setRow(k), row);
        await page.locator(host).scrollIntoViewIfNeeded();
        await page.waitForTimeout(wait);
        const [x, y] = (await stateOf(page)).markers[plot];
        await page.evaluate(() => window.lrcs.setRow(0));
        await page.waitForTimeout(wait);
        await page.locator(host).click({ position: { x, y } });
        const goes = page.waitForFunction((wanted) => window.lrcs.row() === wanted, row, { timeout: 2 * wait });
        if (await goes.then(() => true, () => false)) return;
      }
      assert.fail(`a click at the marker of row ${row} in ${host} does not go there`);
    };
    await goTo(30, 'sweep', '#sweep-plot');
    await goTo(50, 'polar', '#polar-plot');
    await page.locator('#stacked').check();
    await goTo(12, 'sweep', '#sweep-plot');
    assert.equal(await page.locator('#sweep-legend li').count(), 11);
  }));

test('a click on a facet marks its part and says its number', () =>
  withReport('satellite', async ({ page, data }) => {
    await page.evaluate(() => window.lrcs.setRow(7));
    const [x, y] = await placeOfPart(page, 6);
    await page.keyboard.press('Escape');
    assert.equal((await stateOf(page)).part, -1);
    const picture = await pictureOf(page);
    await page.locator('#target').click({ position: { x, y } });
    const state = await stateOf(page);
    assert.equal(state.part, 6);
    assert.ok(state.facet >= 0);
    assert.notEqual(await pictureOf(page), picture);
    assert.equal(
      Number(await page.locator('#facet-facts [data-sigma]').getAttribute('data-sigma')),
      data.part_sigma_m2[7][6],
    );
    const card = await page.locator('#facet-facts').innerText();
    for (const words of ['antenna/dish', String(data.part_sigma_m2[7][6]), 'white Lambertian', 'of the facet'])
      assert.ok(card.includes(words), words);
    assert.match(await page.locator('#parts tr.selected').innerText(), /antenna\/dish/);
    // Row 7 has no facets stored: the colours are those of row 6 or 8, and the page says so.
    assert.match(await page.locator('#view-note').innerText(), /^Facet colours: azimuth (30|40)°/);
  }));

test('a click in the table marks the part on the target', () =>
  withReport('satellite', async ({ page }) => {
    await page.waitForTimeout(300);
    const picture = await pictureOf(page);
    await page.locator('#parts tbody tr').nth(2).click();
    const { part } = await stateOf(page);
    assert.equal(String(part), await page.locator('#parts tbody tr').nth(2).getAttribute('data-part'));
    assert.notEqual(await pictureOf(page), picture);
    await page.locator('#parts tbody button').nth(2).press('Enter');
    assert.equal((await stateOf(page)).part, -1);
  }));

test('the table sums to the total, short and long', () =>
  withReport('parts', async ({ page, data }) => {
    await page.evaluate(() => window.lrcs.setRow(5));
    const sums = () =>
      page.evaluate(() =>
        [...document.querySelectorAll('#parts tbody tr td:nth-child(2)')].reduce(
          (a, cell) => a + parseFloat(cell.title),
          0,
        ),
      );
    assert.equal(await page.locator('#parts tbody tr').count(), 11);
    close(await sums(), data.rows.sigma_m2[5]);
    await page.locator('#all-parts').click();
    assert.equal(await page.locator('#parts tbody tr').count(), 1000);
    close(await sums(), data.rows.sigma_m2[5]);
    const total = page.locator('#parts tfoot td').first();
    assert.equal(parseFloat(await total.getAttribute('title')), data.rows.sigma_m2[5]);
    assert.equal(numberIn(await total.innerText()), Number(data.rows.sigma_m2[5].toPrecision(6)));
  }));

async function saved(page, button) {
  const [download] = await Promise.all([page.waitForEvent('download'), page.locator(button).click()]);
  return { name: download.suggestedFilename(), text: readFileSync(await download.path(), 'utf8') };
}

test('the files saved are the sweep and its parts', () =>
  withReport('satellite', async ({ page, data }) => {
    assert.deepEqual(await saved(page, '#save-sweep'), { name: 'sweep.csv', text: data.csv });
    const parts = await saved(page, '#save-parts');
    assert.equal(parts.name, 'parts.csv');
    const lines = parts.text.trimEnd().split('\n').slice(1);
    assert.deepEqual(
      lines.map((line) => line.split(',').slice(5).map(Number)),
      data.part_sigma_m2,
    );
  }));

test('two angles: cuts and the map', () =>
  withReport('both', async ({ page, data }) => {
    assert.equal(await page.locator('#cut option').count(), 9);
    await page.locator('#cut').selectOption('6');
    let state = await stateOf(page);
    assert.equal(data.rows.transmitter_elevation_deg[state.row], 20);
    await page.evaluate(() => window.lrcs.setRow(100));
    const [x, y] = (await stateOf(page)).markers.heat;
    await page.evaluate(() => window.lrcs.setRow(400));
    await page.locator('#heat-map').scrollIntoViewIfNeeded();
    await page.locator('#heat-map').click({ position: { x, y } });
    state = await stateOf(page);
    assert.equal(state.row, 100);
    assert.equal(state.cut, 1);
  }));

test('two sensors, a bound that is seen, a warning', () =>
  withReport('bistatic', async ({ page }) => {
    assert.match(
      await page.locator('#directions').innerText(),
      /^Transmitter at azimuth 0°, elevation 10°; receiver at azimuth 40°, elevation 0°\.$/,
    );
    assert.match(await page.locator('#sweep-legend').innerText(), /bound of the error/);
    assert.match(await page.locator('#warnings').innerText(), /10 %/);
    for (const label of ['transmitter', 'receiver'])
      await page.getByRole('button', { name: `Look from the ${label}` }).click();
  }));

test('names are text', () =>
  withReport(
    'nasty',
    async ({ page, data }) => {
      await page.locator('#all-parts').click();
      const shown = await page.locator('#parts tbody th').allInnerTexts();
      for (const { name } of data.parts) assert.ok(shown.includes(name === '' ? '(no name)' : name), name);
      assert.equal(await page.locator('h1').innerText(), data.title);
      assert.equal(await page.locator('#parts img, h1 b, #warnings script').count(), 0);
      await page.locator('#stacked').check();
      await page.evaluate(() => window.lrcs.setRow(3));
      const { text } = await saved(page, '#save-parts');
      assert.ok(text.includes('"sigma_m2 of <img src=x onerror=alert(2)> ""double"" \'single\', comma"'));
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), desktop.width);
    },
    { viewport: desktop },
  ));

test('what is not known is not claimed', () =>
  withReport('coarse', async ({ page }) => {
    assert.equal(await page.locator('#floor').inputValue(), '-20');
    assert.equal(await page.locator('#parts tfoot tr').count(), 1);
    await page.evaluate(() => window.lrcs.setRow(1));
    assert.equal(await page.locator('#parts tfoot tr').count(), 2);
  }));

test('LRCS of 0', () =>
  withReport('zero', async ({ page }) => {
    await page.evaluate(() => window.lrcs.setRow(10));
    assert.match(await page.locator('#result').innerText(), /LRCS 0 m² \(\u2212∞ dBsm\)/);
    assert.match(await page.locator('#sweep-note').innerText(), /^Floor of the plot: /);
  }));

for (const name of ['dark', 'single', 'listed', 'elevation']) {
  test(`opens: ${name}`, () =>
    withReport(name, async ({ page, data }) => {
      const last = data.rows.sigma_m2.length - 1;
      await page.evaluate((row) => window.lrcs.setRow(row), last);
      assert.equal((await stateOf(page)).row, last);
      await page.locator('#stacked').check();
      for (const choice of ['seen', 'part', 'material']) await page.locator('#colouring').selectOption(choice);
      for (const plot of await page.locator('.brdf').all()) await plot.scrollIntoViewIfNeeded();
    }));
}

for (const width of [360, 768, 1440, 3840]) {
  test(`fits a width of ${width}`, async () => {
    for (const name of ['satellite', 'nasty']) {
      await withReport(
        name,
        async ({ page }) => {
          const needed = await page.evaluate(() => document.documentElement.scrollWidth);
          assert.ok(needed <= width, `${name} needs ${needed}`);
        },
        { viewport: { width, height: 900 } },
      );
    }
  });
}

test('colours are those of the colour bar', () =>
  withReport('satellite', async ({ page }) => {
    await page.evaluate(() => window.lrcs.setRow(0));
    const yellow = await page.evaluate(
      () =>
        new Promise((done) =>
          requestAnimationFrame(() => {
            const view = document.getElementById('target');
            const copy = document.createElement('canvas');
            [copy.width, copy.height] = [view.width, view.height];
            copy.getContext('2d').drawImage(view, 0, 0);
            const { data } = copy.getContext('2d').getImageData(0, 0, copy.width, copy.height);
            let count = 0;
            for (let k = 0; k < data.length; k += 4)
              if (data[k] === 0xfd && data[k + 1] === 0xe7 && data[k + 2] === 0x25) ++count;
            done(count);
          }),
        ),
    );
    assert.ok(yellow > 20, `${yellow} pixels of the brightest colour`);
  }));

test('names of arrows that are close lie apart, and in the frame', () =>
  withReport(
    'near',
    async ({ page }) => {
      for (const key of ['0', ...Array(12).fill('ArrowLeft')]) {
        await page.locator('#target').press(key);
        const [frame, ...names] = await page.evaluate(() => {
          const labels = [...document.querySelectorAll('#overlay .label')];
          const named = labels.filter((label) => /transmitter|receiver/.test(label.textContent));
          return [document.getElementById('view'), ...named].map((node) => {
            const { left, right, top, bottom } = node.getBoundingClientRect();
            return { left, right, top, bottom };
          });
        });
        assert.equal(names.length, 2);
        const [a, b] = names;
        assert.ok(a.right <= b.left || b.right <= a.left || a.bottom <= b.top + 2 || b.bottom <= a.top + 2, key);
        for (const { left, right, top, bottom } of names)
          assert.ok(left >= frame.left && right <= frame.right && top >= frame.top - 1 && bottom <= frame.bottom + 1, key);
      }
    },
    { viewport: { width: 360, height: 740 } },
  ));

for (const webGl of [true, false]) {
  test(`a sheet is coloured by the material of the side that is seen, ${webGl ? 'with' : 'without'} WebGL`, async () => {
    const from = webGl ? browser : await launch({ webGl });
    try {
      await withReport(
        'sheet',
        async ({ page }) => {
          await page.locator('#colouring').selectOption('material');
          const blueShare = () =>
            page.evaluate(
              (id) =>
                new Promise((done) =>
                  requestAnimationFrame(() =>
                    requestAnimationFrame(() => {
                      const view = document.getElementById(id);
                      const copy = document.createElement('canvas');
                      [copy.width, copy.height] = [view.width, view.height];
                      copy.getContext('2d').drawImage(view, 0, 0);
                      const { data } = copy.getContext('2d').getImageData(0, 0, copy.width / 2, copy.height);
                      let [blue, orange] = [0, 0];
                      for (let k = 0; k < data.length; k += 4) {
                        if (data[k + 2] - data[k] > 80) ++blue;
                        if (data[k] - data[k + 2] > 80) ++orange;
                      }
                      done(blue / (blue + orange));
                    }),
                  ),
                ),
              webGl ? 'target' : 'soft',
            );
          // From the front the sheet of y < 0, blue, is on the left; from behind the other is, whose back is blue.
          await page.getByRole('button', { name: 'Look from the sensor' }).click();
          assert.ok((await blueShare()) > 0.9);
          await page.locator('#target').focus();
          for (let k = 0; k < 36; ++k) await page.keyboard.press('ArrowLeft');
          assert.ok((await blueShare()) > 0.9);
          for (let k = 0; k < 36; ++k) await page.keyboard.press('ArrowLeft');
          assert.ok((await blueShare()) > 0.9);
        },
        { from },
      );
    } finally {
      if (!webGl) await from.close();
    }
  });
}

test('without WebGL the target is drawn all the same, and turns', async () => {
  const from = await launch({ webGl: false });
  try {
    await withReport(
      'satellite',
      async ({ page }) => {
        assert.equal((await stateOf(page)).webgl, false);
        assert.match(await page.locator('#view-note').innerText(), /without WebGL 2/);
        await page.locator('#slider').fill('9');
        assert.equal((await stateOf(page)).row, 9);
        const picture = await pictureOf(page);
        await page.locator('#target').press('ArrowLeft');
        assert.notEqual(await pictureOf(page), picture);
        const [x, y] = await placeOfPart(page, 6);
        await page.locator('#target').click({ position: { x, y } });
        assert.equal((await stateOf(page)).part, 6);
        assert.match(await page.locator('#facet-facts').innerText(), /LRCS of the part/);
      },
      { from },
    );
  } finally {
    await from.close();
  }
});

test('a page in a frame that is hidden at first shows its target when it is seen', async () => {
  await withReport('satellite', async ({ path }) => {
    const outer = join(folder, 'frame.html');
    const frame = `<iframe src="${pathToFileURL(path).href}" width="1000" height="800"></iframe>`;
    writeFileSync(outer, `<div id="tab" style="display: none">${frame}</div>`);
    const page = await browser.newPage({ viewport: desktop });
    await page.goto(pathToFileURL(outer).href);
    const [, inner] = page.frames();
    await inner.evaluate(() => window.lrcs.ready);
    await page.evaluate(() => (document.getElementById('tab').style.display = ''));
    await inner.waitForFunction(() => document.querySelectorAll('#overlay .label').length === 4);
    // Large enough that the middle part is where it is picked.
    assert.ok(await placeOfPart(inner, 6));
    const box = await inner.evaluate(() => {
      const { clientWidth: width, clientHeight: height } = document.getElementById('target');
      const xs = Array.from({ length: 50 }, (_, k) => 0.02 * k).filter((x) =>
        [0.3, 0.4, 0.5, 0.6, 0.7].some((y) => window.lrcs.pick(x * width, y * height)),
      );
      return xs[xs.length - 1] - xs[0];
    });
    assert.ok(box > 0.3, `the target is ${box} of the view wide`);
    await page.close();
  });
});

test('a page that gets no frames is filled all the same', () =>
  withReport(
    'satellite',
    async ({ page, data }) => {
      assert.ok((await page.locator('#parts tbody tr').count()) >= Math.min(10, data.parts.length));
      assert.ok((await page.locator('#sweep-plot path').count()) > 3);
      assert.ok((await page.locator('#run-facts dt').count()) > 3);
    },
    { first: () => (window.requestAnimationFrame = () => 0) },
  ));

test('where WebGL is lost the target is drawn without it', async () => {
  await withReport('satellite', async ({ path }) => {
    const page = await browser.newPage({ viewport: desktop });
    await page.goto(pathToFileURL(path).href);
    await page.evaluate(() => window.lrcs.ready);
    await page.evaluate(() =>
      document.getElementById('target').getContext('webgl2').getExtension('WEBGL_lose_context').loseContext(),
    );
    await page.waitForFunction(() => window.lrcs.state.webgl === false);
    assert.match(await page.locator('#view-note').innerText(), /without WebGL 2/);
    const colours = await page.evaluate(() => {
      const soft = document.getElementById('soft');
      const { data } = soft.getContext('2d').getImageData(0, 0, soft.width, soft.height);
      return new Set(new Uint32Array(data.buffer)).size;
    });
    assert.ok(colours > 5, `${colours} colours`);
    await page.close();
  });
});

test('a damaged or empty page says so', async () => {
  const page = await browser.newPage();
  const path = join(folder, 'empty.html');
  const cases = [template, fill(template, { data: { format: 3 }, binary: Buffer.alloc(0) })];
  for (const html of cases) {
    writeFileSync(path, html);
    await page.goto(pathToFileURL(path).href);
    assert.match(await page.locator('#warnings').innerText(), /^The report cannot be shown: /);
  }
  const { data } = samples.single();
  writeFileSync(path, fill(template, { data, binary: Buffer.alloc(10) }));
  await page.goto(pathToFileURL(path).href);
  await page.evaluate(() => window.lrcs.ready);
  assert.match(await page.locator('#no-view').innerText(), /^The facets cannot be read: /);
  // What the first picture needs is whole, the rest is not: numbers and plots are there, and follow the slider.
  const { data: many, binary } = samples.satellite();
  const complaints = [];
  page.on('pageerror', (error) => complaints.push(error.message));
  for (const damaged of [binary.subarray(0, binary.length - 100), Buffer.concat([binary, Buffer.alloc(1000, 7)])]) {
    writeFileSync(path, fill(template, { data: many, binary: damaged }));
    await page.goto(pathToFileURL(path).href);
    await page.evaluate(() => window.lrcs.ready);
    assert.match(await page.locator('#no-view').innerText(), /^The facets cannot be read: /);
    await page.locator('#slider').fill('5');
    assert.equal((await stateOf(page)).row, 5);
    assert.equal(await page.evaluate(() => window.lrcs.pick(300, 300)), null);
  }
  assert.deepEqual(complaints, []);
  await page.close();
});
