// Reads what lrcs put into the page: the JSON, and the binary of the facets (PAYLOAD.md).
import { unzlibSync } from 'fflate';

export function readPayload() {
  const text = document.getElementById('lrcs-data')?.textContent;
  if (!text) throw new Error('This page holds no data: lrcs report fills it.');
  const data = JSON.parse(text);
  if (data.format !== 1) throw new Error(`This page reads payloads of format 1, not ${data.format}.`);
  const rows = data.rows.sigma_m2.length;
  if (data.part_sigma_m2.length !== rows) throw new Error('The parts have another number of rows than the sweep.');
  if (data.cuts.length === 0) {
    const all = Array.from({ length: rows }, (_, row) => row);
    data.cuts = [{ label: 'all rows', rows: all, angle_deg: all }];
    data.axis = 'row';
  }
  return data;
}

export function readFacets(shown) {
  const text = document.getElementById('lrcs-facets')?.textContent ?? '';
  const stored = shown.stored_rows.length;
  const bytes = 12 * shown.vertices + shown.facets * (12 + 2 + 2 + 4 + 2 * stored);
  const binary = unzlibSync(bytesOfBase64(text.trim()), { out: new Uint8Array(bytes) });
  if (binary.length !== bytes)
    throw new Error(`The facets take ${binary.length} bytes, not ${bytes}: the file is damaged.`);
  let offset = 0;
  const take = (Kind, count) => {
    const part = new Kind(binary.buffer, binary.byteOffset + offset, count);
    offset += part.byteLength;
    return part;
  };
  const facets = {
    count: shown.facets,
    positions: take(Float32Array, 3 * shown.vertices),
    triangles: take(Uint32Array, 3 * shown.facets),
    part: take(Uint16Array, shown.facets),
    material: take(Uint16Array, shown.facets),
    area: take(Float32Array, shown.facets),
  };
  const levels = take(Uint8Array, stored * shown.facets);
  const seen = take(Uint8Array, stored * shown.facets);
  return { ...facets, level: rowReader(levels, shown), seen: rowReader(seen, shown) };
}

// Decoded when first asked for.
function rowReader(bytes, shown) {
  let rows = null;
  return (k) => {
    rows ??= rowsOf(bytes, shown);
    return rows.subarray(k * shown.facets, (k + 1) * shown.facets);
  };
}

// Differences from row to row, facet by facet, take less than half the space; rows are what is painted.
function rowsOf(bytes, { coding, facets, stored_rows: { length: stored } }) {
  if (coding !== 'differences') return bytes;
  const rows = new Uint8Array(bytes.length);
  for (let k = 0; k < stored; ++k) {
    const [here, before] = [k * facets, (k - 1) * facets];
    for (let f = 0; f < facets; ++f) rows[here + f] = bytes[f * stored + k] + (k > 0 ? rows[before + f] : 0);
  }
  return rows;
}

function bytesOfBase64(text) {
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = characters.charCodeAt(i);
  return bytes;
}
