// Lines that make the shape readable: edges of sheets, creases, and where parts meet.
const creaseCosine = Math.cos((30 * Math.PI) / 180);

// Two ends (xyz) a line.
export function creaseLines(facets) {
  const corner = weldedCorners(facets.positions, facets.triangles);
  const normal = normals(facets);
  const vertices = facets.positions.length / 3;
  const first = new Map();
  const lines = [];
  const draw = (a, b) => {
    for (const vertex of [a, b]) lines.push(...facets.positions.subarray(3 * vertex, 3 * vertex + 3));
  };
  for (let f = 0; f < facets.count; ++f) {
    for (let k = 0; k < 3; ++k) {
      const a = corner[3 * f + k];
      const b = corner[3 * f + ((k + 1) % 3)];
      if (a === b) continue;
      const edge = a < b ? a * vertices + b : b * vertices + a;
      const other = first.get(edge);
      if (other === undefined) {
        first.set(edge, f);
        continue;
      }
      first.set(edge, -1);
      if (other >= 0 && (facets.part[f] !== facets.part[other] || cosine(normal, f, other) < creaseCosine)) draw(a, b);
    }
  }
  for (const [edge, f] of first) {
    if (f >= 0) draw(Math.floor(edge / vertices), edge % vertices);
  }
  return new Float32Array(lines);
}

function cosine(normal, f, g) {
  return normal[3 * f] * normal[3 * g] + normal[3 * f + 1] * normal[3 * g + 1] + normal[3 * f + 2] * normal[3 * g + 2];
}

function normals({ positions, triangles, count }) {
  const normal = new Float32Array(3 * count);
  for (let f = 0; f < count; ++f) {
    const [a, b, c] = [3 * triangles[3 * f], 3 * triangles[3 * f + 1], 3 * triangles[3 * f + 2]];
    const u = [0, 1, 2].map((i) => positions[b + i] - positions[a + i]);
    const v = [0, 1, 2].map((i) => positions[c + i] - positions[a + i]);
    const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    const length = Math.hypot(...n) || 1;
    for (let i = 0; i < 3; ++i) normal[3 * f + i] = n[i] / length;
  }
  return normal;
}

// Vertices at one place count as one: faces of CAD bodies need not share theirs.
function weldedCorners(positions, triangles) {
  const bits = new Uint32Array(positions.buffer, positions.byteOffset, positions.length);
  const vertices = positions.length / 3;
  let size = 1;
  while (size < 2 * vertices) size *= 2;
  const table = new Int32Array(size).fill(-1);
  const same = (a, b) =>
    positions[3 * a] === positions[3 * b] &&
    positions[3 * a + 1] === positions[3 * b + 1] &&
    positions[3 * a + 2] === positions[3 * b + 2];
  const welded = new Uint32Array(vertices);
  for (let v = 0; v < vertices; ++v) {
    // -0 and 0 are one place but two bit patterns.
    const word = (i) => (positions[3 * v + i] === 0 ? 0 : bits[3 * v + i]);
    let hash = Math.imul(word(0), 0x9e3779b1) ^ Math.imul(word(1), 0x85ebca6b) ^ Math.imul(word(2), 0xc2b2ae35);
    hash ^= hash >>> 15;
    let place = hash & (size - 1);
    while (table[place] >= 0 && !same(table[place], v)) place = (place + 1) & (size - 1);
    if (table[place] < 0) table[place] = v;
    welded[v] = table[place];
  }
  return triangles.map((vertex) => welded[vertex]);
}
