// The chosen row of the sweep, the cut it is looked at in, and how aspects are named.
import { angleText } from './sigma.js';

export class Aspect {
  constructor(data) {
    this.data = data;
    this.cutIndex = 0;
    this.row = data.cuts[0].rows[0];
    this.followers = [];
    this.monostatic = data.run.receiver === 'monostatic';
  }

  get cut() {
    return this.data.cuts[this.cutIndex];
  }

  get place() {
    return this.cut.rows.indexOf(this.row);
  }

  // act(cutChanged) is called after every change.
  follow(act) {
    this.followers.push(act);
  }

  setRow(row) {
    if (!(row >= 0 && row < this.data.rows.sigma_m2.length)) return;
    let cutIndex = this.cutIndex;
    if (!this.cut.rows.includes(row)) cutIndex = this.data.cuts.findIndex((cut) => cut.rows.includes(row));
    if (cutIndex >= 0) this.set(row, cutIndex);
  }

  // Stays at the angle nearest to the present one.
  setCut(cutIndex) {
    const angle = this.cut.angle_deg[this.place];
    const cut = this.data.cuts[cutIndex];
    this.set(cut.rows[nearestIndex(cut.angle_deg, angle)], cutIndex);
  }

  setPlace(place) {
    const last = this.cut.rows.length - 1;
    this.set(this.cut.rows[Math.min(Math.max(place, 0), last)], this.cutIndex);
  }

  set(row, cutIndex) {
    if (row === this.row && cutIndex === this.cutIndex) return;
    const cutChanged = cutIndex !== this.cutIndex;
    this.row = row;
    this.cutIndex = cutIndex;
    for (const act of this.followers) act(cutChanged);
  }
}

export function nearestIndex(values, wanted) {
  let best = 0;
  for (let i = 1; i < values.length; ++i) {
    if (Math.abs(values[i] - wanted) < Math.abs(values[best] - wanted)) best = i;
  }
  return best;
}

// Body frame: x forward, y left, z up; azimuth from +x toward +y, elevation toward +z.
export function direction(azimuthDeg, elevationDeg) {
  const azimuth = (azimuthDeg * Math.PI) / 180;
  const elevation = (elevationDeg * Math.PI) / 180;
  return [Math.cos(elevation) * Math.cos(azimuth), Math.cos(elevation) * Math.sin(azimuth), Math.sin(elevation)];
}

export function directionsOf(rows, row) {
  return {
    transmitter: direction(rows.transmitter_azimuth_deg[row], rows.transmitter_elevation_deg[row]),
    receiver: direction(rows.receiver_azimuth_deg[row], rows.receiver_elevation_deg[row]),
  };
}

const anglesText = (azimuth, elevation) => `azimuth ${angleText(azimuth)}, elevation ${angleText(elevation)}`;

export const transmitterText = (rows, row) =>
  anglesText(rows.transmitter_azimuth_deg[row], rows.transmitter_elevation_deg[row]);

export const receiverText = (rows, row) => anglesText(rows.receiver_azimuth_deg[row], rows.receiver_elevation_deg[row]);

export function axisText(data) {
  return data.axis === 'row' ? 'row of sweep.csv' : data.axis;
}

export function placeText(data, angle) {
  return data.axis === 'row' ? `row ${angle}` : `${data.axis} ${angleText(angle)}`;
}

// Index into stored_rows of the stored row whose directions are nearest; -1 if none is stored.
export function nearestStored(data, row) {
  const exact = data.shown.stored_rows.indexOf(row);
  if (exact >= 0) return exact;
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const here = directionsOf(data.rows, row);
  let best = -1;
  let bestLikeness = -Infinity;
  data.shown.stored_rows.forEach((stored, k) => {
    const there = directionsOf(data.rows, stored);
    const likeness = dot(here.transmitter, there.transmitter) + dot(here.receiver, there.receiver);
    if (likeness > bestLikeness + 1e-12) {
      best = k;
      bestLikeness = likeness;
    }
  });
  return best;
}
