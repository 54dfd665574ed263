// The ten parts that are strongest over the whole sweep: one order and one colour a part in every picture.
import { otherPartsColour, partPalette } from './colour.js';

export class PartRanking {
  constructor(data) {
    const sums = new Float64Array(data.parts.length);
    for (const row of data.part_sigma_m2) row.forEach((sigma, part) => (sums[part] += sigma));
    const order = data.parts.map((_, part) => part).sort((a, b) => sums[b] - sums[a] || a - b);
    this.strongest = order.slice(0, partPalette.length);
    this.others = order.slice(partPalette.length);
    this.colours = data.parts.map(() => otherPartsColour);
    this.strongest.forEach((part, place) => (this.colours[part] = partPalette[place]));
  }
}

export const nameOf = ({ name }) => (name.trim() === '' ? '(no name)' : name);

// Parts by their sigma at one row, strongest first.
export function partsAt(data, row) {
  const sigma = data.part_sigma_m2[row];
  return sigma.map((_, part) => part).sort((a, b) => sigma[b] - sigma[a] || a - b);
}
