// Small bodies of facets for the samples: each adds to a mesh {positions, triangles, part, material}.
export const emptyMesh = () => ({ positions: [], triangles: [], part: [], material: [] });

export function addBox(mesh, centre, size, part, material) {
  const first = mesh.positions.length / 3;
  for (let k = 0; k < 8; ++k) {
    for (let i = 0; i < 3; ++i) mesh.positions.push(centre[i] + ((k >> i) & 1 ? 0.5 : -0.5) * size[i]);
  }
  const faces = [
    [0, 2, 3, 1],
    [4, 5, 7, 6],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 4, 6, 2],
    [1, 3, 7, 5],
  ];
  for (const [a, b, c, d] of faces)
    addFacets(
      mesh,
      [
        [a, b, c],
        [a, c, d],
      ],
      first,
      part,
      material,
    );
}

// Faces +x.
export function addSheet(mesh, [x, y, z], [wide, high], part, material) {
  const first = mesh.positions.length / 3;
  for (const [right, up] of [
    [-0.5, -0.5],
    [0.5, -0.5],
    [0.5, 0.5],
    [-0.5, 0.5],
  ])
    mesh.positions.push(x, y + right * wide, z + up * high);
  addFacets(
    mesh,
    [
      [0, 1, 2],
      [0, 2, 3],
    ],
    first,
    part,
    material,
  );
}

export function addSphere(mesh, centre, radius, rings, part, material, bulge = () => 1) {
  const first = mesh.positions.length / 3;
  const around = 2 * rings;
  const place = (ring, step) => {
    if (ring === 0) return 0;
    if (ring === rings) return 1;
    return 2 + (ring - 1) * around + (step % around);
  };
  const point = (polar, azimuth) => {
    const r = radius * bulge(polar, azimuth);
    mesh.positions.push(
      centre[0] + r * Math.sin(polar) * Math.cos(azimuth),
      centre[1] + r * Math.sin(polar) * Math.sin(azimuth),
      centre[2] + r * Math.cos(polar),
    );
  };
  point(0, 0);
  point(Math.PI, 0);
  for (let ring = 1; ring < rings; ++ring) {
    for (let step = 0; step < around; ++step) point((Math.PI * ring) / rings, (2 * Math.PI * step) / around);
  }
  for (let ring = 0; ring < rings; ++ring) {
    for (let step = 0; step < around; ++step) {
      const [a, b, c, d] = [place(ring, step), place(ring + 1, step), place(ring + 1, step + 1), place(ring, step + 1)];
      if (ring + 1 < rings) addFacets(mesh, [[a, b, c]], first, part, material);
      if (ring > 0) addFacets(mesh, [[a, c, d]], first, part, material);
    }
  }
}

function addFacets(mesh, triangles, first, part, material) {
  for (const triangle of triangles) {
    mesh.triangles.push(...triangle.map((vertex) => first + vertex));
    mesh.part.push(part);
    mesh.material.push(material);
  }
}

export function facetAreas({ positions, triangles }) {
  const count = triangles.length / 3;
  const areas = new Float64Array(count);
  const normals = new Float64Array(3 * count);
  for (let f = 0; f < count; ++f) {
    const at = (k, i) => positions[3 * triangles[3 * f + k] + i];
    const u = [0, 1, 2].map((i) => at(1, i) - at(0, i));
    const v = [0, 1, 2].map((i) => at(2, i) - at(0, i));
    const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    const length = Math.hypot(...n);
    areas[f] = length / 2;
    for (let i = 0; i < 3; ++i) normals[3 * f + i] = n[i] / length;
  }
  return { areas, normals };
}
