// The report. For tests and scripts, window.lrcs has:
//   firstPicture   promise, kept when the target's first picture is drawn: milliseconds since navigation began
//   ready          promise, kept when all is drawn: {firstPictureMs}
//   row(), setRow(k)   the present row of the sweep
//   pick(x, y)     marks the facet at a place of the target's view (CSS pixels from its top left); returns
//                  {facet, part, name, sigma_m2} or null
//   state          {row, cut, colouredRow, colouring, floorDb, part, facet, webgl, markers}, as shown now; markers: places
//                  [x, y] of the markers in their plots
import { Aspect } from './aspect.js';
import { AspectBar } from './aspect-bar.js';
import { DecibelRange } from './decibel-range.js';
import { byId } from './dom.js';
import { partsCsv, saveText } from './download.js';
import { FacetCard } from './facet-card.js';
import { drawRunFacts, drawTargetFacts, drawWarnings, runLine } from './facts.js';
import { HeatMap, rowTable } from './heat-map.js';
import { drawMaterials } from './material-cards.js';
import { PartRanking } from './part-ranking.js';
import { PartTable } from './part-table.js';
import { readFacets, readPayload } from './payload.js';
import { PolarPlot } from './polar-plot.js';
import { Selection } from './selection.js';
import { SweepPlot } from './sweep-plot.js';
import { TargetPanel } from './target-panel.js';

async function main() {
  const data = readPayload();
  document.title = data.title;
  byId('title').textContent = data.title;
  byId('run-line').textContent = runLine(data);
  drawWarnings(byId('warnings'), data.run.warnings);

  const aspect = new Aspect(data);
  const ranking = new PartRanking(data);
  const decibels = new DecibelRange(data.rows.sigma_m2, data.rows.bound_m2);
  const selection = new Selection([]);
  const bar = {
    slider: byId('slider'),
    cutSelect: byId('cut'),
    cutLabel: byId('cut-label'),
    play: byId('play'),
    result: byId('result'),
    directions: byId('directions'),
    ends: [byId('first-angle'), byId('last-angle')],
  };
  new AspectBar(bar, data, aspect);
  const panel = drawTarget(data, aspect, ranking, selection);
  const plots = {};
  const firstPicture = shownWithin(1000).then(() => performance.now());
  // In between, the browser shows what is there and takes what the reader does.
  const ready = firstPicture.then(async (firstPictureMs) => {
    drawRest(data, aspect, ranking, selection, panel);
    await shownWithin(100);
    drawPlots(plots, data, aspect, ranking, decibels);
    await shownWithin(100);
    await panel.finish();
    return { firstPictureMs };
  });
  window.lrcs = {
    firstPicture,
    ready,
    row: () => aspect.row,
    setRow: (row) => aspect.setRow(row),
    pick: (x, y) => panel.pick(x, y),
    get state() {
      return {
        row: aspect.row,
        cut: aspect.cutIndex,
        part: selection.part,
        facet: selection.facet,
        ...panel.state,
        markers: Object.fromEntries(Object.entries(plots).map(([name, plot]) => [name, plot.markerAt])),
      };
    },
  };
  await ready;
}

// Kept when the browser has taken over all that was drawn until now; at the latest after so many milliseconds: a page
// that is not seen gets no frames, and where frames take long, what is left to do need not wait for them.
const shownWithin = (most) =>
  Promise.race([
    new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve))),
    new Promise((resolve) => setTimeout(resolve, most)),
  ]);

function drawRest(data, aspect, ranking, selection, panel) {
  new FacetCard(byId('facet-facts'), byId('clear'), data, panel.view ? panel.facets : null, aspect, selection);
  new PartTable(byId('parts'), byId('all-parts'), data, aspect, selection, ranking);
  drawMaterials(byId('materials'), data);
  drawTargetFacts(byId('target-facts'), data);
  drawRunFacts(byId('run-facts'), data);
  byId('save-sweep').addEventListener('click', () => saveText('sweep.csv', data.csv));
  byId('save-parts').addEventListener('click', () => saveText('parts.csv', partsCsv(data)));
  window.addEventListener('keydown', (event) => event.key === 'Escape' && selection.clear());
}

function drawPlots(plots, data, aspect, ranking, decibels) {
  plots.sweep = new SweepPlot(
    byId('sweep-plot'),
    byId('sweep-heading'),
    byId('sweep-legend'),
    byId('sweep-note'),
    data,
    aspect,
    ranking,
    decibels,
  );
  byId('stacked').addEventListener('change', (event) => plots.sweep.setStacked(event.target.checked));
  byId('polar-panel').hidden = data.axis === 'row';
  if (data.axis !== 'row') plots.polar = new PolarPlot(byId('polar-plot'), byId('polar-note'), data, aspect, decibels);
  const table = rowTable(data);
  byId('heat-panel').hidden = table === null;
  if (table)
    plots.heat = new HeatMap(byId('heat-map'), byId('heat-bar'), byId('heat-note'), data, table, aspect, decibels);
}

function drawTarget(data, aspect, ranking, selection) {
  const panel = new TargetPanel(data, aspect, ranking, selection, {
    frame: byId('view'),
    canvas: byId('target'),
    soft: byId('soft'),
    overlay: byId('overlay'),
    message: byId('no-view'),
    colouring: byId('colouring'),
    floor: byId('floor'),
    floorLabel: byId('floor-label'),
    key: byId('colour-key'),
    note: byId('view-note'),
    buttons: byId('view-buttons'),
    controls: byId('view-controls'),
  });
  panel.start(() => readFacets(data.shown));
  return panel;
}

main().catch((error) => {
  const message = byId('warnings');
  message.hidden = false;
  message.textContent = `The report cannot be shown: ${error.message}`;
});
