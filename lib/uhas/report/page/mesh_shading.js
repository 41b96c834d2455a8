// Normals for meshes of machined parts: smooth over curved surfaces, sharp at edges.
'use strict';

const kCreaseCosine = Math.cos(40 / kDegrees);  // faces that meet at more keep their edge

/// Geometry without index whose normal at a corner is the mean, weighted by area, of the faces about that vertex within
/// the crease angle. Vertices at one place count as one.
function creasedGeometry(vertices, triangles) {
  const at = (i) => [vertices[3 * i], vertices[3 * i + 1], vertices[3 * i + 2]];
  const places = new Map();
  const placeOf = Array.from({length: vertices.length / 3}, (_, i) => {
    const key = at(i).join();
    if (!places.has(key)) places.set(key, []);
    return places.get(key);
  });

  // area vectors of the faces, listed at each place
  const faces = [];
  for (let f = 0; f < triangles.length; f += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => at(triangles[f + k]));
    const [ux, uy, uz, vx, vy, vz] = [...b.map((x, k) => x - a[k]), ...c.map((x, k) => x - a[k])];
    const area = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    const face = {area, length: Math.hypot(...area)};
    faces.push(face);
    new Set([0, 1, 2].map((k) => placeOf[triangles[f + k]])).forEach((place) => place.push(face));
  }

  const positions = new Float32Array(3 * triangles.length), normals = new Float32Array(3 * triangles.length);
  triangles.forEach((vertex, corner) => {
    const own = faces[Math.floor(corner / 3)];
    let [x, y, z] = [0, 0, 0];
    for (const {area, length} of placeOf[vertex]) {
      const dot = area[0] * own.area[0] + area[1] * own.area[1] + area[2] * own.area[2];
      if (dot >= kCreaseCosine * length * own.length) [x, y, z] = [x + area[0], y + area[1], z + area[2]];
    }
    const size = Math.hypot(x, y, z) || 1;
    positions.set(at(vertex), 3 * corner);
    normals.set([x / size, y / size, z / size], 3 * corner);
  });

  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
  geometry.setAttribute('normal', new THREE.BufferAttribute(normals, 3));
  return geometry;
}
