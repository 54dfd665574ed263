// The parts at the present aspect, strongest first, and their sum, which is the total.
import { el } from './dom.js';
import { nameOf, partsAt } from './part-ranking.js';
import { dbText, dbsm, shareText, sigmaText } from './sigma.js';

const shortest = 10;
// Sums in another order differ by this at most.
const roundOff = 1e-9;

export class PartTable {
  constructor(table, toggle, data, aspect, selection, ranking) {
    Object.assign(this, { table, toggle, data, aspect, selection, ranking });
    this.all = false;
    toggle.hidden = data.parts.length <= shortest;
    toggle.addEventListener('click', () => {
      this.all = !this.all;
      this.draw();
    });
    table.tBodies[0].addEventListener('click', (event) => {
      const row = event.target.closest('tr[data-part]');
      if (row) selection.togglePart(Number(row.dataset.part));
    });
    aspect.follow(() => this.draw());
    selection.follow(() => this.markSelected());
    this.draw();
  }

  draw() {
    const { row } = this.aspect;
    const sigma = this.data.part_sigma_m2[row];
    const total = this.data.rows.sigma_m2[row];
    const order = partsAt(this.data, row);
    const listed = this.all ? order : order.slice(0, shortest);
    const focused = this.table.contains(document.activeElement)
      ? document.activeElement.closest('tr')?.dataset.part
      : null;
    const rows = listed.map((part) => this.line(part, sigma[part], total));
    const rest = order.slice(listed.length);
    if (rest.length > 0) {
      const sum = rest.reduce((a, part) => a + sigma[part], 0);
      rows.push(
        el(
          'tr',
          { class: 'rest' },
          el('th', { scope: 'row' }, `other parts (${rest.length})`),
          ...this.numbers(sum, total),
        ),
      );
    }
    this.table.tBodies[0].replaceChildren(...rows);
    const closing = (label, value) => el('tr', {}, el('th', { scope: 'row' }, label), ...this.numbers(value, total));
    const summed = sigma.reduce((a, b) => a + b, 0);
    const agree = Math.abs(summed - total) <= roundOff * total;
    this.table.tFoot.replaceChildren(
      ...(agree
        ? [closing('sum of all parts = total', total)]
        : [closing('sum of all parts', summed), closing('total of the sweep', total)]),
    );
    this.toggle.textContent = this.all ? `Show the ${shortest} strongest` : `Show all ${this.data.parts.length} parts`;
    this.toggle.setAttribute('aria-expanded', String(this.all));
    this.markSelected();
    if (focused) this.table.querySelector(`tr[data-part="${focused}"] button`)?.focus({ preventScroll: true });
  }

  line(part, sigma, total) {
    const swatch = el('span', { class: 'swatch', style: `background:${this.ranking.colours[part]}` });
    const button = el(
      'button',
      { type: 'button', class: 'part-name', title: 'Mark this part on the target' },
      nameOf(this.data.parts[part]),
    );
    return el(
      'tr',
      { 'data-part': part },
      el('th', { scope: 'row' }, el('span', { class: 'part-cell' }, swatch, button)),
      ...this.numbers(sigma, total),
    );
  }

  numbers(sigma, total) {
    return [
      el('td', { title: `${sigma} m²` }, sigmaText(sigma)),
      el('td', {}, dbText(dbsm(sigma))),
      el('td', {}, shareText(sigma, total)),
    ];
  }

  markSelected() {
    for (const row of this.table.tBodies[0].rows) {
      const selected = Number(row.dataset.part) === this.selection.part;
      row.classList.toggle('selected', selected);
      row.querySelector('button')?.setAttribute('aria-pressed', String(selected));
    }
  }
}
