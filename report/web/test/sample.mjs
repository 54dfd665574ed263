// Payloads for tests and for looking at, and pages made of them: node test/sample.mjs TEMPLATE OUTDIR [NAME...]
// Their returns are a plain model without shadows; only their form is that of a report.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { deflateSync } from 'node:zlib';
import { addBox, addSheet, addSphere, emptyMesh, facetAreas } from './sample-mesh.mjs';

const rad = Math.PI / 180;
const direction = (azimuth, elevation) => [
  Math.cos(elevation * rad) * Math.cos(azimuth * rad),
  Math.cos(elevation * rad) * Math.sin(azimuth * rad),
  Math.sin(elevation * rad),
];

const looks = [
  {
    name: 'painted steel',
    diffuse: 0.3,
    lobe: 0.4,
    width: 0.2,
    definition: 'model: five_parameter\nkb: 0.153\nkr: 0.4\nb: -20.5\na: 0.9\nkd: 0.3\n',
  },
  {
    name: 'solar cell',
    diffuse: 0.02,
    lobe: 30,
    width: 0.04,
    definition: 'model: five_parameter\nkb: 1.2\nkr: 0.9\nb: -310\na: 0.7\nkd: 0.02\n',
  },
  { name: 'white Lambertian', diffuse: 0.9, lobe: 0, width: 1, definition: 'model: lambert\nalbedo: 0.9\n' },
];

function reflectance({ diffuse, lobe, width }, halfTilt) {
  return diffuse / Math.PI + lobe * Math.exp(-((halfTilt / width) ** 2));
}

function brdfOf(look, facets) {
  const theta_i_deg = [0, 30, 60];
  const theta_r_deg = Array.from({ length: 61 }, (_, k) => -90 + 3 * k);
  const f_r_per_sr = theta_i_deg.map((i) =>
    theta_r_deg.map((r) => (Math.abs(r) > 87 ? null : reflectance(look, Math.abs(r - i) * 0.5 * rad))),
  );
  return { name: look.name, definition: look.definition, facets, theta_i_deg, theta_r_deg, f_r_per_sr };
}

export function satellite(rings = 16) {
  const mesh = emptyMesh();
  const parts = [
    'bus/body',
    'bus/nose plate',
    'panel/left',
    'panel/right',
    'boom/left',
    'boom/right',
    'antenna/dish',
    'antenna/mast',
    'sensor/head',
    'sensor/hood',
    'thruster:1',
    'thruster:2',
    'thruster:3',
    'thruster:4',
  ];
  addBox(mesh, [0, 0, 0], [1.6, 1, 1], 0, 0);
  addBox(mesh, [0.85, 0, 0], [0.1, 0.8, 0.8], 1, 2);
  addBox(mesh, [0, 2, 0], [1, 2.2, 0.04], 2, 1);
  addBox(mesh, [0, -2, 0], [1, 2.2, 0.04], 3, 1);
  addBox(mesh, [0, 0.7, 0], [0.1, 0.4, 0.1], 4, 0);
  addBox(mesh, [0, -0.7, 0], [0.1, 0.4, 0.1], 5, 0);
  addSphere(mesh, [-0.3, 0, 1], 0.45, rings, 6, 2);
  addBox(mesh, [-0.3, 0, 0.55], [0.08, 0.08, 0.2], 7, 0);
  addSphere(mesh, [0.5, 0.3, 0.62], 0.16, Math.max(6, rings >> 1), 8, 0);
  addBox(mesh, [0.5, 0.3, 0.5], [0.2, 0.2, 0.1], 9, 0);
  [
    [1, 1],
    [1, -1],
    [-1, 1],
    [-1, -1],
  ].forEach(([y, z], k) => addBox(mesh, [-0.85, 0.35 * y, 0.35 * z], [0.1, 0.12, 0.12], 10 + k, 0));
  return { mesh, parts };
}

// rows: [[transmitter azimuth, elevation, receiver azimuth, elevation], ...]
export function payload({ mesh, parts }, rows, cuts, more = {}) {
  const { areas, normals } = facetAreas(mesh);
  const facets = areas.length;
  const stored = more.stored ?? rows.map((_, k) => k).filter((k) => k % 2 === 0);
  const perArea = stored.map(() => new Float64Array(facets));
  const part_sigma_m2 = rows.map((row, k) => {
    const sums = new Array(parts.length).fill(0);
    const [t, r] = [direction(row[0], row[1]), direction(row[2], row[3])];
    const half = t.map((v, i) => v + r[i]);
    const length = Math.hypot(...half) || 1;
    const keep = stored.indexOf(k);
    for (let f = 0; f < facets; ++f) {
      const dot = (v) => v[0] * normals[3 * f] + v[1] * normals[3 * f + 1] + v[2] * normals[3 * f + 2];
      const [ci, cr] = [dot(t), dot(r)];
      if (ci <= 0 || cr <= 0 || more.dark) continue;
      const tilt = Math.acos(Math.min(1, dot(half) / length));
      const value = 4 * Math.PI * ci * cr * reflectance(looks[mesh.material[f]], tilt);
      sums[mesh.part[f]] += value * areas[f];
      if (keep >= 0) perArea[keep][f] = value;
    }
    return sums;
  });
  const brightest = perArea.reduce((a, row) => row.reduce((b, v) => Math.max(b, v), a), 0) || 1;
  const [floor, step] = [-63.5, 0.25];
  const level = (value) =>
    value > 0 ? Math.min(255, Math.max(1, Math.round((10 * Math.log10(value / brightest) - floor) / step) + 1)) : 0;
  const sigma_m2 = part_sigma_m2.map((sums) => sums.reduce((a, b) => a + b, 0));
  const column = (i) => rows.map((row) => row[i]);
  const data = {
    format: 2,
    title: more.title ?? 'Monostatic LRCS of satellite.step',
    version: '0.9.0',
    run: {
      command: ['sweep', 'satellite.yaml', '-o', 'out dir'],
      started_utc: '2026-11-30T17:00:00Z',
      scene_file: 'satellite.yaml',
      scene_sha256: '0f'.repeat(32),
      wavelength_m: 1.06e-6,
      accuracy: more.accuracy ?? 'exact',
      method: 'exact seen area of every facet',
      receiver: more.receiver ?? 'monostatic',
      threads: 2,
      read_seconds: 0.41,
      sweep_seconds: 1.234,
      warnings: more.warnings ?? [],
      facts: [['Skipped: convex facets', '12']],
    },
    target: {
      file: 'satellite.step',
      sha256: 'a1'.repeat(32),
      unit: 'mm',
      facets: more.targetFacets ?? facets,
      shown_facets: facets,
      curved_facets: 0,
      box_m: boxOf(mesh.positions),
      area_m2: areas.reduce((a, b) => a + b, 0),
      facts: [
        ['Closed', 'yes'],
        ['Repaired', '3 degenerate facets dropped'],
      ],
    },
    parts: parts.map((name, k) => ({
      name,
      facets: mesh.part.filter((part) => part === k).length,
      area_m2: areas.reduce((a, b, f) => (mesh.part[f] === k ? a + b : a), 0),
    })),
    materials: (more.materialNames ?? looks.map((look) => look.name)).map((name, k) => ({
      ...brdfOf(looks[k], mesh.material.filter((m) => m === k).length),
      name,
    })),
    rows: {
      transmitter_azimuth_deg: column(0),
      transmitter_elevation_deg: column(1),
      receiver_azimuth_deg: column(2),
      receiver_elevation_deg: column(3),
      sigma_m2,
      bound_m2: sigma_m2.map((sigma) => (more.relativeBound ?? 1e-12) * sigma),
      seen_area_m2: sigma_m2.map(() => 1.5),
    },
    axis: more.axis ?? 'azimuth',
    cuts,
    part_sigma_m2,
    csv: 'azimuth_deg,elevation_deg,sigma_m2\n' + rows.map((row, k) => `${row[0]},${row[1]},${sigma_m2[k]}\n`).join(''),
    shown: {
      vertices: mesh.positions.length / 3,
      facets,
      stored_rows: stored,
      coding: more.coding,
      floor_db: floor,
      step_db: step,
      brightest_per_m2: brightest,
    },
  };
  const binary = Buffer.concat(
    [
      new Float32Array(mesh.positions),
      new Uint32Array(mesh.triangles),
      new Float32Array(areas),
      new Uint16Array(mesh.part),
      new Uint16Array(mesh.material),
      new Uint16Array(more.back ?? mesh.material),
      ...coded(
        perArea.map((row) => Uint8Array.from(row, level)),
        more.coding,
      ),
      ...coded(
        perArea.map((row) => Uint8Array.from(row, (value) => (value > 0 ? 255 : 0))),
        more.coding,
      ),
    ].map((array) => Buffer.from(array.buffer, array.byteOffset, array.byteLength)),
  );
  return { data, binary };
}

function coded(rows, coding) {
  if (coding !== 'differences') return rows;
  const bytes = new Uint8Array(rows.length * rows[0].length);
  bytes.set(rows[0]);
  for (let f = 0, k = rows[0].length; f < rows[0].length; ++f)
    rows.slice(1).forEach((row, i) => (bytes[k++] = row[f] - rows[i][f]));
  return [bytes];
}

function boxOf(positions) {
  const box = [
    [Infinity, Infinity, Infinity],
    [-Infinity, -Infinity, -Infinity],
  ];
  positions.forEach((v, k) => {
    box[0][k % 3] = Math.min(box[0][k % 3], v);
    box[1][k % 3] = Math.max(box[1][k % 3], v);
  });
  return box;
}

export function fill(template, { data, binary }) {
  const json = JSON.stringify(data).replace(/</g, '\\u003c');
  const scripts =
    `<script type="application/json" id="lrcs-data">${json}</script>\n` +
    `<script type="text/plain" id="lrcs-facets">${deflateSync(binary).toString('base64')}</script>`;
  return template.replace('<!-- lrcs:data -->', () => scripts);
}

const range = (from, to, step) => Array.from({ length: Math.round((to - from) / step) + 1 }, (_, k) => from + k * step);
const around = (azimuths, elevation = 0) => azimuths.map((azimuth) => [azimuth, elevation, azimuth, elevation]);
const oneCut = (angles, label = 'elevation 0°') => [{ label, rows: angles.map((_, k) => k), angle_deg: angles }];

function sweptBoth() {
  const azimuths = range(-180, 175, 5);
  // Levels that reach down less far, and parts that miss some of the total.
  function coarse() {
    const made = payload(satellite(6), around([0, 10]), oneCut([0, 10]));
    Object.assign(made.data.shown, { floor_db: -25.4, step_db: 0.1 });
    made.data.part_sigma_m2[1][0] = 0;
    return made;
  }

  const elevations = range(-40, 40, 10);
  const rows = elevations.flatMap((elevation) => around(azimuths, elevation));
  const cuts = elevations.map((elevation, j) => ({
    label: `elevation ${elevation}°`,
    rows: azimuths.map((_, i) => j * azimuths.length + i),
    angle_deg: azimuths,
  }));
  return payload(satellite(8), rows, cuts, {
    title: 'Monostatic LRCS of satellite.step, both angles',
    stored: rows.map((_, k) => k).filter((k) => k % 36 === 0),
  });
}

function large() {
  const body = satellite(24);
  addSphere(
    body.mesh,
    [0, 0, -1.4],
    0.8,
    110,
    14,
    2,
    (polar, azimuth) => 1 + 0.06 * Math.sin(7 * azimuth) * Math.sin(5 * polar),
  );
  body.parts.push('tank/shell');
  const azimuths = range(0, 358, 2);
  return payload(body, around(azimuths), oneCut(azimuths), {
    stored: azimuths.map((_, k) => k),
    targetFacets: 1234567,
    coding: 'differences',
  });
}

function nasty() {
  const body = satellite(6);
  body.parts[0] = '</script><script>alert(1)</script>';
  body.parts[1] = '<img src=x onerror=alert(2)> "double" \'single\', comma';
  body.parts[2] = '🛰️ panneau à gauche, Größe 太陽電池';
  body.parts[3] = 'a/very/long/path/' + 'assembly_without_any_blank_'.repeat(8) + '/part:1';
  body.parts[4] = '';
  const azimuths = range(0, 90, 10);
  const more = {
    title: 'LRCS of <b>"nasty" & </title></script> $& names',
    warnings: ['<script>alert(3)</script> was read', 'facet 3 & 4 touch'],
    materialNames: ['<i>paint</i>', '$`cell$&', '"white"'],
  };
  return payload(body, around(azimuths), oneCut(azimuths, '<u>cut</u>'), more);
}

function thousandParts() {
  const mesh = emptyMesh();
  for (let k = 0; k < 1000; ++k)
    addBox(
      mesh,
      [(k % 10) * 0.3, (Math.floor(k / 10) % 10) * 0.3, Math.floor(k / 100) * 0.3],
      [0.1, 0.1 + 0.0001 * k, 0.1],
      k,
      k % 3,
    );
  const azimuths = range(0, 350, 10);
  return payload(
    { mesh, parts: Array.from({ length: 1000 }, (_, k) => `rack:${1 + Math.floor(k / 100)}/shelf/box:${k}`) },
    around(azimuths),
    oneCut(azimuths),
  );
}

function withZero() {
  const azimuths = range(0, 180, 5);
  const body = emptyMesh();
  addBox(body, [0, 0, 0], [0.02, 1, 1], 0, 1);
  const made = payload({ mesh: body, parts: ['plate'] }, around(azimuths), oneCut(azimuths));
  const k = 10;
  made.data.rows.sigma_m2[k] = 0;
  made.data.rows.bound_m2[k] = 0;
  made.data.part_sigma_m2[k] = [0];
  return made;
}

// Levels that reach down less far, and parts that miss some of the total.
function coarse() {
  const made = payload(satellite(6), around([0, 10]), oneCut([0, 10]));
  Object.assign(made.data.shown, { floor_db: -25.4, step_db: 0.1 });
  made.data.part_sigma_m2[1][0] = 0;
  return made;
}

const elevations = range(-90, 90, 5);
const azimuths73 = range(0, 360, 5);

export const samples = {
  satellite: () => payload(satellite(), around(azimuths73), oneCut(azimuths73)),
  both: sweptBoth,
  large,
  bistatic: () =>
    payload(
      satellite(),
      azimuths73.map((a) => [a, 10, a + 40, 0]),
      oneCut(azimuths73, 'elevation 10°'),
      {
        title: 'Bistatic LRCS of satellite.step',
        receiver: 'bistatic angle 40° in azimuth',
        accuracy: 'relative 0.1',
        relativeBound: 0.1,
        warnings: ['The accuracy asked for is coarse: sigma may be off by 10 %.'],
      },
    ),
  near: () => payload(satellite(8), [[-30, 10, -22, 12]], oneCut([-30]), { receiver: 'bistatic angle 8\u00b0 in azimuth' }),
  sheet: () => {
    const body = emptyMesh();
    for (const y of [-0.6, 0.6]) addSheet(body, [0, y, 0], [1, 1], 0, y < 0 ? 0 : 1);
    for (const list of [body.part, body.material]) list.pop();
    body.triangles.length -= 3; // an odd number of facets
    const back = body.material.map((material) => 1 - material);
    return payload({ mesh: body, parts: ['sheet'] }, around([0, 90]), oneCut([0, 90]), { back });
  },
  elevation: () =>
    payload(
      satellite(10),
      elevations.map((e) => [30, e, 30, e]),
      oneCut(elevations, 'azimuth 30°'),
      { axis: 'elevation' },
    ),
  nasty,
  zero: withZero,
  coarse,
  dark: () => payload(satellite(6), around(range(0, 90, 10)), oneCut(range(0, 90, 10)), { dark: true }),
  single: () => payload(satellite(8), around([40], 20), oneCut([40], 'elevation 20°')),
  parts: thousandParts,
  listed: () =>
    payload(
      satellite(8),
      [
        [0, 0, 0, 0],
        [40, 20, 40, 20],
        [10, -80, 10, -80],
      ],
      oneCut([0, 1, 2], 'rows'),
      { axis: 'row', stored: [] },
    ),
};

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [template, folder, ...names] = process.argv.slice(2);
  mkdirSync(folder, { recursive: true });
  for (const name of names.length > 0 ? names : Object.keys(samples)) {
    const html = fill(readFileSync(template, 'utf8'), samples[name]());
    writeFileSync(join(folder, `${name}.html`), html);
    console.log(`${name}.html ${html.length}`);
  }
}
