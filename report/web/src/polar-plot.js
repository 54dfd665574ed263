// LRCS in dBsm around the target: azimuths as seen from above with the nose up, elevations with +z up.
import { nearestIndex, placeText } from './aspect.js';
import { lineWidth, markerRadius } from './chart.js';
import { curveColour, ink } from './colour.js';
import { onResize, rootFontPx, svg } from './dom.js';
import { angleText, dbText, dbsm, plain } from './sigma.js';

export class PolarPlot {
  constructor(host, note, data, aspect, decibels) {
    Object.assign(this, { host, note, data, aspect, decibels });
    this.signed = data.axis === 'elevation' || data.cuts.some((cut) => cut.angle_deg.some((angle) => angle < 0));
    this.drawing = svg('svg', { class: 'polar', 'aria-hidden': 'true' });
    host.append(this.drawing);
    this.drawing.addEventListener('click', (event) => this.jump(event));
    this.drawing.addEventListener('pointermove', (event) => this.hover(event));
    this.drawing.addEventListener('pointerleave', () => this.readout.replaceChildren());
    onResize(host, () => this.draw());
    aspect.follow((cutChanged) => (cutChanged ? this.draw() : this.mark()));
    this.draw();
  }

  draw() {
    const size = this.host.clientWidth;
    const height = this.host.clientHeight;
    if (size === 0) return;
    this.font = 0.85 * rootFontPx();
    this.centre = [size / 2, height / 2];
    this.radius = Math.min(size / 2 - 3.4 * this.font, height / 2 - 1.9 * this.font);
    this.drawing.setAttribute('viewBox', `0 0 ${size} ${height}`);
    this.drawing.setAttribute('font-size', this.font);
    this.marker = svg('g', {});
    this.readout = svg('text', { x: 2, y: this.font, fill: ink });
    const curve = svg('path', {
      d: this.curve(),
      fill: 'none',
      stroke: curveColour,
      'stroke-width': lineWidth(),
      'stroke-linejoin': 'round',
      'stroke-linecap': 'round',
    });
    this.drawing.replaceChildren(
      this.spokes(),
      this.rings(),
      curve,
      ...this.dots(),
      this.ringLabels(),
      this.marker,
      this.readout,
    );
    this.say();
    this.mark();
  }

  // Whether 0 degrees of the present cut is where the nose points, seen from where the plot is.
  get throughNose() {
    return this.data.axis === 'azimuth' || this.data.rows.transmitter_azimuth_deg[this.aspect.cut.rows[0]] === 0;
  }

  say() {
    const side = this.throughNose
      ? 'Elevation, seen from the right side, nose to the right'
      : `Elevation, ${this.aspect.cut.label}, +z up`;
    const from = this.data.axis === 'azimuth' ? 'Azimuth, seen from above, nose up' : side;
    this.note.textContent = `${from}; rings: LRCS [dBsm], from ${plain(this.decibels.min)} in the centre to ${plain(this.decibels.max)} outside.`;
  }

  place(angleDeg, share) {
    const turn = ((this.data.axis === 'azimuth' ? angleDeg + 90 : angleDeg) * Math.PI) / 180;
    return [
      this.centre[0] + share * this.radius * Math.cos(turn),
      this.centre[1] - share * this.radius * Math.sin(turn),
    ];
  }

  share(sigma) {
    return (this.decibels.height(sigma) - this.decibels.min) / (this.decibels.max - this.decibels.min);
  }

  ringValues() {
    const { min, max, interval } = this.decibels;
    const every = Math.ceil((2.2 * this.font * (max - min)) / interval / this.radius);
    const values = [];
    for (let k = 0, value = max; value > min + 1e-9; ++k, value = max - k * every * interval) values.push(value);
    return values;
  }

  rings() {
    return svg(
      'g',
      { fill: 'none', stroke: '#d0d0d0' },
      this.ringValues().map((value, k) => {
        const share = (value - this.decibels.min) / (this.decibels.max - this.decibels.min);
        return svg('circle', {
          cx: this.centre[0],
          cy: this.centre[1],
          r: share * this.radius,
          stroke: k === 0 ? ink : null,
        });
      }),
    );
  }

  spokes() {
    const group = svg('g', {});
    for (let angle = 0; angle < 360; angle += 30) {
      const [x1, y1] = this.centre;
      const [x2, y2] = this.place(angle, 1);
      group.append(svg('line', { x1, y1, x2, y2, stroke: '#e3e3e3' }));
      const [x, y] = this.place(angle, 1 + (0.9 * this.font) / this.radius);
      const side = x - this.centre[0];
      const anchor = Math.abs(side) < 0.2 * this.radius ? 'middle' : side > 0 ? 'start' : 'end';
      const label = svg('text', { x, y: y + 0.35 * this.font, 'text-anchor': anchor, fill: ink });
      label.textContent =
        angleText(this.signed && angle > 180 ? angle - 360 : angle) + (angle === 0 && this.throughNose ? ' nose' : '');
      group.append(label);
    }
    return group;
  }

  // Between two spokes, where the least is drawn.
  ringLabels() {
    return svg(
      'g',
      { class: 'label' },
      this.ringValues()
        .slice(1)
        .map((value) => {
          const share = (value - this.decibels.min) / (this.decibels.max - this.decibels.min);
          const [x, y] = this.place(this.data.axis === 'azimuth' ? -165 : -105, share);
          const label = svg('text', { x, y: y + 0.35 * this.font, 'text-anchor': 'middle', fill: ink });
          label.textContent = plain(value);
          return label;
        }),
    );
  }

  curve() {
    const { rows, angle_deg: angles } = this.aspect.cut;
    const at = rows.map((row, i) =>
      this.place(angles[i], this.share(this.data.rows.sigma_m2[row]))
        .map((v) => v.toFixed(2))
        .join(','),
    );
    let widest = 0;
    for (let i = 1; i < angles.length; ++i) widest = Math.max(widest, angles[i] - angles[i - 1]);
    const gap = 360 - (angles[angles.length - 1] - angles[0]);
    return `M${at.join('L')}${gap > 0 && gap <= 1.5 * widest ? 'Z' : ''}`;
  }

  dots() {
    const { rows, angle_deg: angles } = this.aspect.cut;
    if (rows.length > 40) return [];
    return rows.map((row, i) => {
      const [cx, cy] = this.place(angles[i], this.share(this.data.rows.sigma_m2[row]));
      return svg('circle', { cx, cy, r: 1.4 * lineWidth(), fill: curveColour });
    });
  }

  mark() {
    if (!this.marker) return;
    const { cut, place, row } = this.aspect;
    const angle = cut.angle_deg[place];
    const sigma = this.data.rows.sigma_m2[row];
    const [cx, cy] = this.place(angle, this.share(sigma));
    const [x2, y2] = this.place(angle, 1);
    this.markerAt = [cx, cy];
    this.marker.replaceChildren(
      svg('line', { x1: this.centre[0], y1: this.centre[1], x2, y2, class: 'marker-line' }),
      svg('circle', { cx, cy, r: markerRadius(), class: 'marker-dot' }),
    );
    this.host.setAttribute(
      'aria-label',
      `Polar plot of LRCS, ${cut.label}; marked: ${placeText(this.data, angle)}, ${dbText(dbsm(sigma))} dBsm.`,
    );
  }

  nearest(event) {
    const box = this.drawing.getBoundingClientRect();
    const right = event.clientX - box.left - this.centre[0];
    const up = this.centre[1] - (event.clientY - box.top);
    if (Math.hypot(right, up) > this.radius + 4 * this.font) return -1;
    const turn = (Math.atan2(up, right) * 180) / Math.PI;
    const angle = this.data.axis === 'azimuth' ? turn - 90 : turn;
    const apart = this.aspect.cut.angle_deg.map((other) => Math.abs(((((other - angle) % 360) + 540) % 360) - 180));
    return nearestIndex(apart, 0);
  }

  hover(event) {
    const place = this.nearest(event);
    if (place < 0) return this.readout.replaceChildren();
    const { cut } = this.aspect;
    this.readout.textContent = `${angleText(cut.angle_deg[place])}: ${dbText(dbsm(this.data.rows.sigma_m2[cut.rows[place]]))} dBsm`;
  }

  jump(event) {
    const place = this.nearest(event);
    if (place >= 0) this.aspect.setPlace(place);
  }
}
