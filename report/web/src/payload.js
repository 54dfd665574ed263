// Reads what lrcs put into the page: the JSON, and the binary of the facets (PAYLOAD.md).
import { Unzlib } from 'fflate';

export function readPayload() {
  const text = document.getElementById('lrcs-data')?.textContent;
  if (!text) throw new Error('This page holds no data: lrcs report fills it.');
  const data = JSON.parse(text);
  if (data.format !== 2) throw new Error(`This page reads payloads of format 2, not ${data.format}.`);
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
  const stored = shown.stored_rows.length;
  const stream = new Inflated(
    document.getElementById('lrcs-facets')?.textContent.trim() ?? '',
    12 * shown.vertices + shown.facets * (12 + 2 + 2 + 2 + 4 + 2 * stored),
  );
  const facets = {
    count: shown.facets,
    positions: stream.take(Float32Array, 3 * shown.vertices),
    triangles: stream.take(Uint32Array, 3 * shown.facets),
    area: stream.take(Float32Array, shown.facets),
    part: stream.take(Uint16Array, shown.facets),
    material: stream.take(Uint16Array, shown.facets),
    back: stream.take(Uint16Array, shown.facets),
  };
  stream.inflate(stream.taken);
  facets.level = rowReader(stream, shown);
  facets.seen = rowReader(stream, shown);
  facets.readAll = () => stream.inflate(stream.bytes.length);
  return facets;
}

// A base64 text of a zlib stream, inflated as far as is asked for.
class Inflated {
  constructor(text, length) {
    this.text = text;
    this.bytes = new Uint8Array(length);
    this.read = 0;
    this.filled = 0;
    this.taken = 0;
    this.stream = new Unzlib((chunk) => {
      if (this.filled + chunk.length > length) throw new Error(`They take more than ${length} bytes: the file is damaged.`);
      this.bytes.set(chunk, this.filled);
      this.filled += chunk.length;
    });
  }

  // The next so many values: what is inflated later fills them later.
  take(Kind, count) {
    const part = new Kind(this.bytes.buffer, this.taken, count);
    this.taken += part.byteLength;
    return part;
  }

  inflate(upTo) {
    const piece = 1 << 16; // a multiple of 4 characters
    while (this.filled < upTo && this.read < this.text.length) {
      const packed = bytesOfBase64(this.text.slice(this.read, this.read + piece));
      this.read += piece;
      this.stream.push(packed, this.read >= this.text.length);
    }
    if (this.filled < upTo) throw new Error(`They take ${this.filled} bytes, not ${upTo}: the file is damaged.`);
  }
}

// Rows are what is painted. Differences from row to row, facet by facet, take less than half the space in the file.
function rowReader(stream, { coding, facets, stored_rows: { length: stored } }) {
  const begin = stream.taken;
  const values = stream.take(Uint8Array, stored * facets);
  const differences = values.subarray(facets);
  return (k) => {
    stream.inflate(begin + (k === 0 ? facets : values.length));
    if (k === 0 || coding !== 'differences') return values.subarray(k * facets, (k + 1) * facets);
    const row = values.slice(0, facets);
    for (let f = 0; f < facets; ++f) {
      const first = f * (stored - 1);
      for (let at = first; at < first + k; ++at) row[f] += differences[at];
    }
    return row;
  };
}

function bytesOfBase64(text) {
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = characters.charCodeAt(i);
  return bytes;
}
