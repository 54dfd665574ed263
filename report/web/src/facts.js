// What is known of the run and of the target, as lists; warnings first on the page.
import { el } from './dom.js';
import { countText, lengthText, plain, wavelengthText } from './sigma.js';

const list = (host, facts) =>
  host.replaceChildren(
    ...facts
      .filter(([, value]) => value !== null && value !== undefined && value !== '')
      .flatMap(([label, value]) => [
        el('dt', {}, label),
        el('dd', { class: /^[0-9a-f]{64}$/.test(value) ? 'digest' : null }, String(value)),
      ]),
  );

const seconds = (value) => (value === null || value === undefined ? null : `${plain(Number(value.toPrecision(3)))} s`);

export function drawWarnings(host, warnings) {
  host.hidden = warnings.length === 0;
  if (host.hidden) return;
  const heading = warnings.length === 1 ? 'Warning' : `${warnings.length} warnings`;
  host.replaceChildren(
    el('strong', {}, heading),
    el(
      'ul',
      {},
      warnings.map((warning) => el('li', {}, warning)),
    ),
  );
}

export function runLine({ run, target, version }) {
  const parts = [`lrcs ${version}`, timeText(run.started_utc), target.file, run.receiver];
  if (run.wavelength_m) parts.push(`wavelength ${wavelengthText(run.wavelength_m)}`);
  parts.push(run.accuracy === 'exact' ? 'exact' : `accuracy ${run.accuracy}`);
  return parts.filter(Boolean).join(' · ');
}

const timeText = (utc) => (utc ? utc.replace('T', ' ').replace(/(:\d\d)(:\d\d(\.\d+)?)?Z$/, '$1 UTC') : '');

export function drawTargetFacts(host, { target, shown }) {
  const size = target.box_m[1].map((high, k) => high - target.box_m[0][k]);
  list(host, [
    ['File', target.file],
    ['Size x, y, z', size.map(lengthText).join(' × ')],
    ['Facets', countText(target.facets)],
    ['Curved facets', target.curved_facets ? countText(target.curved_facets) : null],
    ['Shown here', shown.facets < target.facets ? `${countText(shown.facets)} facets, each for a group` : 'all facets'],
    ['Area', `${plain(Number(target.area_m2.toPrecision(6)))} m²`],
    ['Unit of the file', target.unit],
    ...(target.facts ?? []),
    ['SHA-256 of the file', target.sha256],
  ]);
}

export function drawRunFacts(host, { run, version, rows }) {
  list(host, [
    ['Command', run.command.map(quoted).join(' ')],
    ['Scene', run.scene_file],
    ['Started', timeText(run.started_utc)],
    ['Version', version],
    ['Aspects', countText(rows.sigma_m2.length)],
    ['Receiver', run.receiver],
    ['Wavelength', run.wavelength_m ? wavelengthText(run.wavelength_m) : 'none given'],
    ['Accuracy', run.accuracy],
    ['Method', run.method],
    ['Reading took', seconds(run.read_seconds)],
    ['Sweep took', seconds(run.sweep_seconds)],
    ['Threads', run.threads],
    ...(run.facts ?? []),
    ['SHA-256 of the scene', run.scene_sha256],
  ]);
}

const quoted = (word) => (/^[\w@%+=:,./-]+$/.test(word) ? word : `'${word.replace(/'/g, "'\\''")}'`);
