// What the charts have in common: only the pieces of ECharts that are used, fonts, axes in field units, the marker.
import { CustomChart, LineChart } from 'echarts/charts';
import { GridComponent, TooltipComponent } from 'echarts/components';
import * as echarts from 'echarts/core';
import { SVGRenderer } from 'echarts/renderers';
import { ink } from './colour.js';
import { onResize, rootFontPx, svg } from './dom.js';
import { plain } from './sigma.js';

echarts.use([CustomChart, GridComponent, LineChart, SVGRenderer, TooltipComponent]);

export const fontFamily = 'system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif';

// draw(chart) sets all options; it is called when the host changes its size.
export function makeChart(host, draw) {
  const chart = echarts.init(host, null, { renderer: 'svg' });
  onResize(host, () => {
    chart.resize();
    draw(chart);
  });
  return chart;
}

export const lineWidth = () => 0.12 * rootFontPx();

export const chartFontPx = () => 0.85 * rootFontPx();

export function baseOption() {
  return { animation: false, textStyle: { fontFamily, fontSize: chartFontPx(), color: ink } };
}

export function valueAxis({ name, min, max, interval, gap, ticks, grid = true, label = plain }) {
  const fontSize = chartFontPx();
  return {
    type: 'value',
    min,
    max,
    interval,
    name,
    nameGap: gap,
    nameLocation: 'middle',
    nameTextStyle: { fontSize, color: ink, fontFamily },
    axisLine: { show: true, onZero: false, lineStyle: { color: ink } },
    axisTick: { show: true, lineStyle: { color: ink }, customValues: ticks },
    axisLabel: { fontSize, color: ink, fontFamily, formatter: label, hideOverlap: true, customValues: ticks },
    splitLine: { show: grid, lineStyle: { color: '#e3e3e3' } },
  };
}

const angleSteps = [0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 45, 60, 90];
const countSteps = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000];

// Limits at multiples of a step that leaves room for the labels.
export function angleRange(angles, widthPx, counted) {
  const low = angles.reduce((a, b) => Math.min(a, b), Infinity);
  const high = angles.reduce((a, b) => Math.max(a, b), -Infinity);
  const room = Math.max(widthPx / (3.6 * chartFontPx()), 2);
  const steps = counted ? countSteps : angleSteps;
  const interval = steps.find((step) => (high - low) / step <= room) ?? steps[steps.length - 1];
  const range = {
    min: interval * Math.floor(low / interval + 1e-9),
    max: interval * Math.ceil(high / interval - 1e-9),
    interval,
  };
  if (range.max > range.min) return range;
  return { min: range.min - 2 * interval, max: range.max + 2 * interval, interval };
}

export function multiples(min, max, interval) {
  const values = [];
  for (let k = Math.ceil(min / interval - 1e-9); k * interval <= max + 1e-9; ++k) values.push(k * interval);
  return values;
}

export const markerRadius = () => 0.32 * rootFontPx();

// An SVG over a chart, for the marker at the present aspect: moving it redraws no curve.
export function makeMarkerLayer(host) {
  const layer = svg('svg', { class: 'marker', 'aria-hidden': 'true' });
  host.parentElement.append(layer);
  return layer;
}
