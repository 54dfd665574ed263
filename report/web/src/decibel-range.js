// One range in dBsm for every plot of a report, so that cuts compare.
import { dbsm, dbText } from './sigma.js';

const depthDb = 60;

export class DecibelRange {
  constructor(sigma, bound) {
    const largest = sigma.reduce((a, b) => Math.max(a, b), 0);
    this.allZero = !(largest > 0);
    const top = this.allZero ? 0 : dbsm(largest);
    const lowest = sigma.reduce((a, b) => Math.min(a, b), Infinity);
    const highest = sigma.reduce((a, value, row) => Math.max(a, value + bound[row]), 0);
    this.max = 5 * Math.ceil((this.allZero ? 0 : dbsm(highest)) / 5 + 1e-9);
    this.floor = 5 * Math.floor((top - depthDb) / 5);
    const bottom = Math.max(dbsm(lowest), this.floor);
    this.min = Math.min(5 * Math.floor(bottom / 5), this.max - 10);
    const span = this.max - this.min;
    this.interval = span <= 15 ? 2.5 : span <= 35 ? 5 : 10;
    this.max = this.interval * Math.ceil(this.max / this.interval - 1e-9);
    this.min = this.interval * Math.floor(this.min / this.interval + 1e-9);
    this.clipped = sigma.filter((value) => dbsm(value) < this.min).length;
  }

  height(sigma) {
    return Math.max(dbsm(sigma), this.min);
  }

  get note() {
    if (this.allZero) return 'LRCS is 0 at every aspect: \u2212\u221e dBsm.';
    if (this.clipped === 0) return '';
    const rows =
      this.clipped === 1 ? '1 row that is lower, or 0, is' : `${this.clipped} rows that are lower, or 0, are`;
    return `Floor of the plot: ${dbText(this.min, 0)} dBsm, at least ${depthDb} dB below the largest; ${rows} drawn on it.`;
  }
}
