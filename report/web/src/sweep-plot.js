// LRCS along the present cut: in dBsm with the bound of its error, or in m^2 stacked by parts.
import { axisText, nearestIndex, placeText } from './aspect.js';
import {
  angleRange,
  baseOption,
  chartFontPx,
  lineWidth,
  makeChart,
  makeMarkerLayer,
  markerRadius,
  valueAxis,
} from './chart.js';
import { curveColour, ink, otherPartsColour } from './colour.js';
import { el, svg } from './dom.js';
import { nameOf } from './part-ranking.js';
import { dbText, dbsm, sigmaText } from './sigma.js';

const few = 40;

export class SweepPlot {
  constructor(host, heading, legend, note, data, aspect, ranking, decibels) {
    Object.assign(this, { host, heading, legend, note, data, aspect, ranking, decibels });
    this.stacked = false;
    this.layer = makeMarkerLayer(host);
    this.chart = makeChart(host, () => this.draw());
    this.chart.getZr().on('click', (event) => this.jump(event.offsetX, event.offsetY));
    aspect.follow((cutChanged) => (cutChanged ? this.draw() : this.mark()));
    this.draw();
  }

  setStacked(stacked) {
    this.stacked = stacked;
    this.draw();
  }

  sigma(row) {
    return this.data.rows.sigma_m2[row];
  }

  draw() {
    const { cut } = this.aspect;
    const font = chartFontPx();
    const left = (this.stacked ? 5.6 : 4.6) * font;
    const width = this.host.clientWidth - left - 1.5 * font;
    const along = angleRange(cut.angle_deg, width, this.data.axis === 'row');
    const unit = this.data.axis === 'row' ? '' : ' [deg]';
    this.chart.setOption(
      {
        ...baseOption(),
        grid: { left, right: 1.5 * font, top: font, bottom: 3.6 * font },
        xAxis: valueAxis({ name: `${axisText(this.data)}${unit}`, gap: 1.9 * font, ...along }),
        yAxis: this.stacked ? this.squareMetreAxis(font) : this.decibelAxis(font),
        tooltip: {
          trigger: 'axis',
          confine: true,
          transitionDuration: 0,
          padding: 6,
          axisPointer: { animation: false, lineStyle: { color: '#888' } },
          formatter: (hits) => this.tip(hits[0].dataIndex),
        },
        series: this.stacked ? this.partSeries() : this.decibelSeries(),
      },
      { notMerge: true },
    );
    this.heading.textContent = `LRCS against ${axisText(this.data)}, ${cut.label}`;
    this.drawLegend();
    this.mark();
  }

  decibelAxis(font) {
    const { min, max, interval } = this.decibels;
    return valueAxis({ name: 'LRCS [dBsm]', gap: 3.1 * font, min, max, interval });
  }

  squareMetreAxis(font) {
    const top = this.data.rows.sigma_m2.reduce((a, b) => Math.max(a, b), 0) || 1;
    const rough = top / 5;
    const decade = 10 ** Math.floor(Math.log10(rough));
    const interval = decade * [1, 2, 5, 10].find((step) => step * decade >= rough * (1 - 1e-9));
    const max = interval * Math.ceil(top / interval - 1e-9);
    return valueAxis({ name: 'LRCS [m²]', gap: 4.1 * font, min: 0, max, interval });
  }

  points(height) {
    const { cut } = this.aspect;
    return cut.rows.map((row, i) => [cut.angle_deg[i], height(row)]);
  }

  line(height, more) {
    const data = this.points(height);
    return {
      type: 'line',
      data,
      showSymbol: data.length <= few,
      symbol: 'circle',
      symbolSize: 2.8 * lineWidth(),
      cursor: 'pointer',
      lineStyle: { width: lineWidth(), color: curveColour },
      itemStyle: { color: curveColour },
      emphasis: { disabled: true },
      ...more,
    };
  }

  decibelSeries() {
    const curve = this.line((row) => this.decibels.height(this.sigma(row)));
    this.bandDrawn = this.bandIsVisible();
    return this.bandDrawn ? [this.band(), curve] : [curve];
  }

  bandEnds(row) {
    const bound = this.data.rows.bound_m2[row];
    return [this.decibels.height(this.sigma(row) - bound), this.decibels.height(this.sigma(row) + bound)];
  }

  bandIsVisible() {
    const perDb = this.host.clientHeight / (this.decibels.max - this.decibels.min);
    return this.aspect.cut.rows.some((row) => {
      const [low, high] = this.bandEnds(row);
      return perDb * (high - low) > 2;
    });
  }

  band() {
    const { cut } = this.aspect;
    const low = cut.rows.map((row, i) => [cut.angle_deg[i], this.bandEnds(row)[0]]);
    const high = cut.rows.map((row, i) => [cut.angle_deg[i], this.bandEnds(row)[1]]);
    return {
      type: 'custom',
      silent: true,
      clip: true,
      tooltip: { show: false },
      data: [low[0]],
      renderItem: (_, api) => ({
        type: 'polygon',
        silent: true,
        shape: { points: [...low, ...high.reverse()].map((place) => api.coord(place)) },
        style: { fill: curveColour, opacity: 0.22 },
      }),
    };
  }

  partSeries() {
    const parts = this.data.part_sigma_m2;
    const area = (name, colour, height) =>
      this.line(height, {
        name,
        stack: 'parts',
        showSymbol: false,
        lineStyle: { width: 0 },
        itemStyle: { color: colour },
        areaStyle: { color: colour, opacity: 1 },
      });
    const { strongest, others, colours } = this.ranking;
    const stack = strongest.map((part) => area('', colours[part], (row) => parts[row][part]));
    if (others.length > 0) {
      stack.push(area('', otherPartsColour, (row) => others.reduce((sum, part) => sum + parts[row][part], 0)));
    }
    return [
      this.line((row) => this.sigma(row), {
        lineStyle: { width: 0.8 * lineWidth(), color: ink },
        itemStyle: { color: ink },
      }),
      ...stack,
    ];
  }

  drawLegend() {
    const entry = (colour, name) =>
      el(
        'li',
        {},
        el('span', { class: 'swatch', style: `background:${colour}` }),
        el('span', { class: 'name', title: name }, name),
      );
    const { strongest, others, colours } = this.ranking;
    const entries = [];
    if (this.stacked) {
      entries.push(...strongest.map((part) => entry(colours[part], nameOf(this.data.parts[part]))));
      if (others.length > 0) entries.push(entry(otherPartsColour, `other parts (${others.length})`));
    } else if (this.bandDrawn) {
      entries.push(entry('#bcd0e4', 'bound of the error'));
    }
    this.legend.replaceChildren(...entries);
    this.legend.hidden = entries.length === 0;
    const thin = 'The bound of the error is narrower than the line.';
    this.note.textContent = this.stacked
      ? 'The parts that are strongest over the sweep, stacked; line: all parts together.'
      : [this.decibels.note, this.bandDrawn ? '' : thin].filter(Boolean).join(' ');
  }

  tip(place) {
    const { cut } = this.aspect;
    const row = cut.rows[place];
    if (row === undefined) return '';
    return el(
      'div',
      {},
      placeText(this.data, cut.angle_deg[place]),
      el('br'),
      `${sigmaText(this.sigma(row))} m²`,
      el('br'),
      `${dbText(dbsm(this.sigma(row)))} dBsm`,
    );
  }

  mark() {
    const { cut, place, row } = this.aspect;
    const height = this.stacked ? this.sigma(row) : this.decibels.height(this.sigma(row));
    const at = this.chart.convertToPixel({ gridIndex: 0 }, [cut.angle_deg[place], height]);
    const top = this.chart.convertToPixel({ gridIndex: 0 }, [
      cut.angle_deg[place],
      this.stacked ? 0 : this.decibels.min,
    ])[1];
    this.markerAt = at;
    const font = chartFontPx();
    this.layer.replaceChildren(
      svg('line', { x1: at[0], x2: at[0], y1: font, y2: top, class: 'marker-line' }),
      svg('circle', { cx: at[0], cy: at[1], r: markerRadius(), class: 'marker-dot' }),
    );
    this.host.setAttribute('aria-label', this.summary());
  }

  summary() {
    const { cut, row, place } = this.aspect;
    const order = cut.rows.map((_, i) => i).sort((a, b) => this.sigma(cut.rows[a]) - this.sigma(cut.rows[b]));
    const said = (i) => `${dbText(dbsm(this.sigma(cut.rows[i])))} dBsm at ${placeText(this.data, cut.angle_deg[i])}`;
    return (
      `Plot of LRCS against ${axisText(this.data)}, ${cut.label}: largest ${said(order[order.length - 1])}, ` +
      `smallest ${said(order[0])}; marked: ${placeText(this.data, cut.angle_deg[place])}, ${sigmaText(this.sigma(row))} m².`
    );
  }

  jump(x, y) {
    if (!this.chart.containPixel({ gridIndex: 0 }, [x, y])) return;
    const [angle] = this.chart.convertFromPixel({ gridIndex: 0 }, [x, y]);
    this.aspect.setPlace(nearestIndex(this.aspect.cut.angle_deg, angle));
  }
}
