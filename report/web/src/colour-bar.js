// Colour bars and colour keys: what the colours of the target and of the map stand for, with units and limits.
import { otherPartsColour, unseenColour, viridisGradient } from './colour.js';
import { el } from './dom.js';
import { materialColour } from './facet-colours.js';
import { nameOf } from './part-ranking.js';
import { plain } from './sigma.js';

// atMost: colours at the low end stand for all that is lower, too.
export function horizontalBar(host, { gradient, min, max, interval, label, atMost, text = plain }, ...more) {
  const ticks = [];
  for (let k = 0; min + k * interval <= max + 1e-9; ++k) {
    const value = min + k * interval;
    const tick = el('span', { class: 'tick', style: `left:${(100 * (value - min)) / (max - min)}%` });
    tick.textContent = (k === 0 && atMost ? '\u2264 ' : '') + text(value);
    ticks.push(tick);
  }
  host.replaceChildren(
    el(
      'div',
      { class: 'bar' },
      el('div', { class: 'gradient', style: `background:${gradient}` }),
      el('div', { class: 'ticks' }, ticks),
    ),
    el('div', { class: 'bar-label' }, label, ...more),
  );
}

const swatch = (colour, name) =>
  el(
    'li',
    {},
    el('span', { class: 'swatch', style: `background:${colour}` }),
    el('span', { class: 'name', title: name }, name),
  );

const unseen = () =>
  el(
    'span',
    { class: 'key' },
    el('span', { class: 'swatch', style: `background:${unseenColour}` }),
    'not lit and seen',
  );

export function drawColourKey(host, data, ranking, { colouring, floorDb }) {
  const gradient = viridisGradient('right');
  if (colouring === 'contribution') {
    const label = `return per area [dB re ${plain(Number(data.shown.brightest_per_m2.toPrecision(4)))} m²/m², brightest of all aspects]`;
    horizontalBar(
      host,
      { gradient, min: floorDb, max: 0, interval: floorDb < -40 ? 20 : 10, label, atMost: true },
      unseen(),
    );
  } else if (colouring === 'seen') {
    horizontalBar(
      host,
      { gradient, min: 0, max: 100, interval: 20, label: 'lit and seen share of the facet [%]' },
      unseen(),
    );
  } else if (colouring === 'part') {
    const entries = ranking.strongest.map((part) => swatch(ranking.colours[part], nameOf(data.parts[part])));
    if (ranking.others.length > 0) entries.push(swatch(otherPartsColour, `other parts (${ranking.others.length})`));
    host.replaceChildren(el('ul', { class: 'legend' }, entries));
  } else {
    host.replaceChildren(
      el(
        'ul',
        { class: 'legend' },
        data.materials.map((material, k) => swatch(materialColour(k), nameOf(material))),
      ),
    );
  }
}
