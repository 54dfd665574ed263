// LRCS over azimuth and elevation of the transmitter, for sweeps over both.
import { angleRange, baseOption, chartFontPx, makeChart, makeMarkerLayer, multiples, valueAxis } from './chart.js';
import { viridis, viridisGradient } from './colour.js';
import { nearestIndex, transmitterText } from './aspect.js';
import { horizontalBar } from './colour-bar.js';
import { el, svg } from './dom.js';
import { dbText, dbsm, sigmaText } from './sigma.js';

// The rows as a table [elevation][azimuth], or null where they make none.
export function rowTable(data) {
  if (data.axis === 'row') return null;
  const { transmitter_elevation_deg: elevation } = data.rows;
  // As the cuts have them: from 340 to 20 deg they are -20 to 20.
  const azimuth = [...data.rows.transmitter_azimuth_deg];
  if (data.axis === 'azimuth')
    for (const cut of data.cuts) cut.rows.forEach((row, i) => (azimuth[row] = cut.angle_deg[i]));
  const sorted = (values) => [...new Set(values)].sort((a, b) => a - b);
  const table = { azimuths: sorted(azimuth), elevations: sorted(elevation), azimuthOf: azimuth };
  const cells = table.azimuths.length * table.elevations.length;
  if (table.azimuths.length < 2 || table.elevations.length < 2 || azimuth.length < 0.5 * cells) return null;
  const column = new Map(table.azimuths.map((value, i) => [value, i]));
  const line = new Map(table.elevations.map((value, i) => [value, i]));
  table.rows = table.elevations.map(() => new Int32Array(table.azimuths.length).fill(-1));
  azimuth.forEach((value, row) => (table.rows[line.get(elevation[row])][column.get(value)] = row));
  return table;
}

// Cells meet halfway between their angles.
function edges(angles) {
  const between = angles.slice(1).map((angle, i) => 0.5 * (angle + angles[i]));
  const last = angles.length - 1;
  return [1.5 * angles[0] - 0.5 * angles[1], ...between, 1.5 * angles[last] - 0.5 * angles[last - 1]];
}

export class HeatMap {
  constructor(host, bar, note, data, table, aspect, decibels) {
    Object.assign(this, { host, data, table, aspect, decibels });
    this.across = edges(table.azimuths);
    this.up = edges(table.elevations);
    this.layer = makeMarkerLayer(host);
    this.chart = makeChart(host, () => this.draw());
    this.readout = svg('text', { x: 4.4 * chartFontPx(), y: 1.1 * chartFontPx(), 'font-size': chartFontPx() });
    this.chart.getZr().on('mousemove', (event) => this.hover(event.offsetX, event.offsetY));
    this.chart.getZr().on('globalout', () => this.readout.replaceChildren());
    this.chart.getZr().on('click', (event) => this.jump(event.offsetX, event.offsetY));
    const { min, max, interval } = decibels;
    horizontalBar(bar, {
      gradient: viridisGradient('right'),
      min,
      max,
      interval,
      label: 'LRCS [dBsm]',
      atMost: decibels.clipped > 0,
    });
    note.textContent = decibels.note;
    note.hidden = decibels.note === '';
    aspect.follow(() => this.mark());
    this.draw();
  }

  draw() {
    const font = chartFontPx();
    const [left, right, top, bottom] = [4.4 * font, 1.5 * font, 1.6 * font, 3.6 * font];
    const width = this.host.clientWidth - left - right;
    const height = this.host.clientHeight - top - bottom;
    const axis = (name, gap, angles, ends, room) => {
      const [min, max] = [ends[0], ends[ends.length - 1]];
      const { interval } = angleRange(angles, room);
      return valueAxis({ name, gap, grid: false, min, max, interval, ticks: multiples(min, max, interval) });
    };
    const x = axis('azimuth [deg]', 1.9 * font, this.table.azimuths, this.across, width);
    const y = axis('elevation [deg]', 2.9 * font, this.table.elevations, this.up, 1.6 * height);
    this.chart.setOption(
      {
        ...baseOption(),
        grid: { left, right, top, bottom },
        xAxis: x,
        yAxis: y,
        series: [
          {
            type: 'custom',
            data: [[x.min, y.min]],
            clip: true,
            cursor: 'pointer',
            renderItem: (_, api) => {
              const [px, py] = api.coord([x.min, y.max]);
              const [qx, qy] = api.coord([x.max, y.min]);
              return {
                type: 'image',
                style: { image: this.picture(qx - px, qy - py), x: px, y: py, width: qx - px, height: qy - py },
              };
            },
          },
        ],
      },
      { notMerge: true },
    );
    this.mark();
  }

  // Cells as a picture of its own: tens of thousands of them are no elements of the page.
  picture(width, height) {
    const ratio = window.devicePixelRatio;
    const canvas = el('canvas', {
      width: Math.max(1, Math.round(width * ratio)),
      height: Math.max(1, Math.round(height * ratio)),
    });
    const pen = canvas.getContext('2d', { willReadFrequently: true });
    const { min, max } = this.decibels;
    const at = (values, size) =>
      values.map((v) => Math.round(((v - values[0]) / (values[values.length - 1] - values[0])) * size));
    const x = at(this.across, canvas.width);
    const y = at(this.up, canvas.height).map((v) => canvas.height - v);
    this.table.rows.forEach((line, j) =>
      line.forEach((row, i) => {
        if (row < 0) return;
        pen.fillStyle = `rgb(${viridis((this.decibels.height(this.data.rows.sigma_m2[row]) - min) / (max - min)).join()})`;
        pen.fillRect(x[i], y[j + 1], x[i + 1] - x[i], y[j] - y[j + 1]);
      }),
    );
    return canvas.toDataURL();
  }

  rowAt(x, y) {
    if (!this.chart.containPixel({ gridIndex: 0 }, [x, y])) return -1;
    const [azimuth, elevation] = this.chart.convertFromPixel({ gridIndex: 0 }, [x, y]);
    return this.table.rows[nearestIndex(this.table.elevations, elevation)][nearestIndex(this.table.azimuths, azimuth)];
  }

  hover(x, y) {
    const row = this.rowAt(x, y);
    this.readout.textContent =
      row < 0 ? '' : `${transmitterText(this.data.rows, row)}: ${dbText(dbsm(this.data.rows.sigma_m2[row]))} dBsm`;
  }

  jump(x, y) {
    const row = this.rowAt(x, y);
    if (row >= 0) this.aspect.setRow(row);
  }

  mark() {
    const { rows } = this.data;
    const { row } = this.aspect;
    const i = this.table.azimuths.indexOf(this.table.azimuthOf[row]);
    const j = this.table.elevations.indexOf(rows.transmitter_elevation_deg[row]);
    const [x0, y0] = this.chart.convertToPixel({ gridIndex: 0 }, [this.across[i], this.up[j + 1]]);
    const [x1, y1] = this.chart.convertToPixel({ gridIndex: 0 }, [this.across[i + 1], this.up[j]]);
    const [x, y] = [0.5 * (x0 + x1), 0.5 * (y0 + y1)];
    this.markerAt = [x, y];
    const wide = Math.max(x1 - x0, 9);
    const high = Math.max(y1 - y0, 9);
    const frame = { x: x - wide / 2, y: y - high / 2, width: wide, height: high, fill: 'none' };
    this.layer.replaceChildren(
      svg('rect', { ...frame, stroke: '#fff', 'stroke-width': 4.5 }),
      svg('rect', { ...frame, class: 'marker-frame' }),
      this.readout,
    );
    const sigma = rows.sigma_m2[row];
    this.host.setAttribute(
      'aria-label',
      `Map of LRCS over azimuth and elevation; marked: ${transmitterText(rows, row)}, ` +
        `${sigmaText(sigma)} m², ${dbText(dbsm(sigma))} dBsm.`,
    );
  }
}
