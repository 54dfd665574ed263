// What is known of the marked part and of the facet that was pointed at.
import { nearestStored, transmitterText } from './aspect.js';
import { el } from './dom.js';
import { levelDb } from './facet-colours.js';
import { nameOf } from './part-ranking.js';
import { countText, dbText, dbsm, plain, shareText } from './sigma.js';

const entry = (label, ...value) => [el('dt', {}, label), el('dd', {}, ...value)];

export class FacetCard {
  constructor(host, clear, data, facets, aspect, selection) {
    Object.assign(this, { host, clear, data, facets, aspect, selection });
    clear.addEventListener('click', () => selection.clear());
    aspect.follow(() => this.draw());
    selection.follow(() => this.draw());
    this.draw();
  }

  draw() {
    const { part, facet } = this.selection;
    this.clear.hidden = part < 0;
    if (part < 0) {
      const how = this.facets ? 'Click a facet of the target, or a part in the table.' : 'Click a part in the table.';
      this.host.replaceChildren(el('p', { class: 'hint' }, how));
      return;
    }
    this.host.replaceChildren(el('dl', {}, ...this.partEntries(part), ...(facet >= 0 ? this.facetEntries(facet) : [])));
  }

  partEntries(part) {
    const { row } = this.aspect;
    const sigma = this.data.part_sigma_m2[row][part];
    const { facets, area_m2: area } = this.data.parts[part];
    return [
      ...entry('Part', nameOf(this.data.parts[part])),
      ...entry(
        'LRCS of the part',
        el('span', { 'data-sigma': sigma, title: `${sigma} m²` }, `${sigma} m²`),
        ` (${dbText(dbsm(sigma))} dBsm)`,
      ),
      ...entry('Share of the total', shareText(sigma, this.data.rows.sigma_m2[row])),
      ...entry('Facets, area', `${countText(facets)}, ${plain(Number(area.toPrecision(4)))} m²`),
    ];
  }

  facetEntries(facet) {
    const material = this.data.materials[this.facets.material[facet]];
    const back = this.data.materials[this.facets.back[facet]];
    const stored = nearestStored(this.data, this.aspect.row);
    return [
      ...entry('Material', material ? nameOf(material) : 'none'),
      ...(back === material ? [] : entry('Material behind', nameOf(back))),
      ...(stored < 0 ? [] : this.returnEntries(facet, stored)),
      ...entry('Area of the facet', `${plain(Number(this.facets.area[facet].toPrecision(4)))} m²`),
    ];
  }

  returnEntries(facet, stored) {
    const { shown, rows } = this.data;
    const row = shown.stored_rows[stored];
    const level = this.facets.level(stored)[facet];
    const where = row === this.aspect.row ? '' : ` (${transmitterText(rows, row)})`;
    return [
      ...entry(`Return per area${where}`, this.perArea(level)),
      ...entry(`Lit and seen${where}`, `${Math.round((100 * this.facets.seen(stored)[facet]) / 255)} % of the facet`),
    ];
  }

  perArea(level) {
    const { shown } = this.data;
    if (level === 0) return 'not lit and seen';
    const decibels = levelDb(shown, level);
    const perArea = shown.brightest_per_m2 * 10 ** (decibels / 10);
    const value = `${Number(perArea.toPrecision(3))} m²/m²`;
    if (level === 1) return `at most ${value} (${dbText(decibels, 1)} dB re brightest)`;
    return `about ${value} (${dbText(decibels)} ± ${plain(shown.step_db / 2)} dB re brightest)`;
  }
}
