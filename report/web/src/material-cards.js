// The materials: BRDF in the plane of incidence, one curve for each angle of incidence, and the definition.
import { baseOption, chartFontPx, lineWidth, makeChart, valueAxis } from './chart.js';
import { el } from './dom.js';
import { materialColour } from './facet-colours.js';
import { nameOf } from './part-ranking.js';
import { angleText, countText, plain } from './sigma.js';

const curveColours = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#e69f00', '#56b4e9', '#595959'];
// Wider than this, and only a logarithmic axis shows the curves.
const linearSpan = 30;

export function drawMaterials(host, data) {
  const undrawn = new Map();
  const watcher = new IntersectionObserver(
    (entries) => {
      for (const { isIntersecting, target } of entries) if (isIntersecting) draw(target);
    },
    { rootMargin: '400px' },
  );
  const draw = (plot) => {
    if (!undrawn.has(plot)) return;
    const material = undrawn.get(plot);
    undrawn.delete(plot);
    watcher.unobserve(plot);
    drawBrdf(
      makeChart(plot, (chart) => drawBrdf(chart, plot, material)),
      plot,
      material,
    );
  };
  data.materials.forEach((material, k) => {
    const plot = el('div', { class: 'chart brdf', role: 'img', 'aria-label': summary(material) });
    const swatch = el('span', { class: 'swatch', style: `background:${materialColour(k)}` });
    host.append(
      el(
        'article',
        {},
        el(
          'h3',
          {},
          swatch,
          nameOf(material),
          el('small', {}, ` ${countText(material.facets)} ${material.facets === 1 ? 'facet' : 'facets'}`),
        ),
        material.f_r_per_sr.length > 0 ? [el('div', { class: 'chart-frame' }, plot), legend(material)] : null,
        el('pre', { tabindex: 0, 'aria-label': 'definition' }, material.definition),
      ),
    );
    if (material.f_r_per_sr.length > 0) {
      undrawn.set(plot, material);
      watcher.observe(plot);
    }
  });
  window.addEventListener('beforeprint', () => [...undrawn.keys()].forEach(draw));
}

function legend(material) {
  return el(
    'ul',
    { class: 'legend' },
    material.theta_i_deg.map((theta, k) =>
      el(
        'li',
        {},
        el('span', { class: 'stroke', style: `border-color:${curveColours[k % curveColours.length]}` }),
        `θᵢ = ${angleText(theta)}`,
      ),
    ),
  );
}

function known(material) {
  return material.f_r_per_sr.flat().filter((value) => value !== null && Number.isFinite(value));
}

function summary(material) {
  const largest = known(material).reduce((a, b) => Math.max(a, b), 0);
  return (
    `BRDF of ${material.name} against angle of reflection for ${material.theta_i_deg.length} angles of incidence; ` +
    `largest ${Number(largest.toPrecision(3))} per steradian.`
  );
}

function drawBrdf(chart, plot, material) {
  const font = chartFontPx();
  const values = known(material);
  const high = values.reduce((a, b) => Math.max(a, b), 0);
  const positive = values.filter((value) => value > 0);
  const low = positive.reduce((a, b) => Math.min(a, b), Infinity);
  const logarithmic = high / low > linearSpan;
  const top = Math.ceil(Math.log10(high));
  const decades = logarithmic ? { min: 10 ** Math.max(Math.floor(Math.log10(low)), top - 6), max: 10 ** top } : null;
  const y = valueAxis({
    name: 'fᵣ [1/sr]',
    gap: 3.6 * font,
    label: logarithmic ? powerText : (value) => plain(Number(value.toPrecision(6))),
  });
  chart.setOption(
    {
      ...baseOption(),
      grid: { left: 5.2 * font, right: 1.5 * font, top: font, bottom: 3.6 * font },
      xAxis: valueAxis({
        name: 'angle of reflection θᵣ [deg], specular side below 0',
        gap: 1.9 * font,
        min: -90,
        max: 90,
        interval: plot.clientWidth < 26 * font ? 45 : 30,
      }),
      yAxis: logarithmic ? { ...y, type: 'log', ...decades } : { ...y, min: 0 },
      tooltip: { show: false },
      series: material.theta_i_deg.map((theta, k) => ({
        type: 'line',
        silent: true,
        showSymbol: false,
        connectNulls: false,
        lineStyle: { width: lineWidth(), color: curveColours[k % curveColours.length] },
        data: material.theta_r_deg.map((angle, i) => [angle, drawable(material.f_r_per_sr[k][i], decades)]),
      })),
    },
    { notMerge: true },
  );
}

function drawable(value, decades) {
  if (value === null) return null;
  return decades ? Math.max(value, decades.min) : value;
}

function powerText(value) {
  const exponent = Math.round(Math.log10(value));
  const digits = '\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079';
  if (Math.abs(exponent) <= 3) return String(Number(value.toPrecision(3)));
  return `10${exponent < 0 ? '\u207b' : ''}${[...String(Math.abs(exponent))].map((digit) => digits[digit]).join('')}`;
}
