// The deformed sphere in three dimensions: always the field interpolated between the driving planes, in units of its
// radius. Colours belong to the material: they are those of the undeformed coordinates.
'use strict';

const kMeridians = 72, kParallels = 36;  // the surface's grid: 5° by 5°
const kLineEvery = 6;                    // of them drawn as a line
const kPlaneSamples = 48;                // polar angles along the rim of a driving plane
const kDiscDiameter = 0.016;
const kAxisLength = 1.3;
const kVanished = 0.05;          // a plane this small leaves its label where it was

class SphereScene {
  /// @param phi  polar angles of the driving vectors, [5][V]
  constructor(hand, phi) {
    this.hand = hand;
    this.phi = phi;
    this.layers = groups('unitSphere', 'sphere', 'spherePoints', 'planes', 'axes', 'normal');
    this.root = new THREE.Group();
    this.root.add(...Object.values(this.layers));
    this.deforming = [];  // {thetaPhi, place(positions)}: called with the deformed positions [3 n]
    this.labels = [];     // {text, position: THREE.Vector3, layer, pixels: height on the screen}
    this.#addUnitSphere();
    this.#addSurface();
    this.#addPoints();
    this.#addPlanes();
    this.#addAxes();
  }

  /// Three great circles, in the planes of the axes.
  #addUnitSphere() {
    this.unitMaterial = new THREE.LineBasicMaterial({transparent: true, opacity: 0.45});
    const circle = Array.from({length: kMeridians}, (_, i) => 2 * Math.PI * i / kMeridians);
    for (let axis = 0; axis < 3; ++axis) {
      const geometry = new THREE.BufferGeometry().setFromPoints(circle.map((angle) => new THREE.Vector3()
        .setComponent(axis, Math.cos(angle)).setComponent((axis + 1) % 3, Math.sin(angle))));
      this.#show('unitSphere', new THREE.LineLoop(geometry, this.unitMaterial), 1);
    }
  }

  #addSurface() {
    const thetaPhi = [], triangles = [], lines = [];
    for (let row = 0; row <= kParallels; ++row) {
      for (let column = 0; column <= kMeridians; ++column) {
        const i = row * (kMeridians + 1) + column, below = i + kMeridians + 1;
        thetaPhi.push(2 * Math.PI * column / kMeridians - Math.PI, Math.PI * row / kParallels);
        if (row < kParallels && column < kMeridians) triangles.push(i, below, i + 1, i + 1, below, below + 1);
        if (row < kParallels && column % kLineEvery === 0) lines.push(i, below);
        if (column < kMeridians && row % kLineEvery === 0) lines.push(i, i + 1);
      }
    }
    const surface = this.#deformingGeometry(Float64Array.from(thetaPhi));
    const grid = new THREE.BufferGeometry();
    surface.setIndex(triangles);
    grid.setIndex(lines);
    grid.setAttribute('position', surface.getAttribute('position'));
    this.gridMaterial = new THREE.LineBasicMaterial({transparent: true, opacity: 0.16});
    const skin = (side, opacity) => new THREE.Mesh(surface, new THREE.MeshBasicMaterial(
      {vertexColors: THREE.VertexColors, transparent: true, depthWrite: false, side, opacity}));
    this.#show('sphere', skin(THREE.BackSide, 0.16), 1);
    this.#show('sphere', new THREE.LineSegments(grid, this.gridMaterial), 2);
    this.#show('sphere', skin(THREE.FrontSide, 0.08), 3);
  }

  #addPoints() {
    const geometry = this.#deformingGeometry(this.hand.points.thetaPhi);
    this.#show('spherePoints', new THREE.Points(geometry, discMaterial(kDiscDiameter)), 0);
  }

  /// A half disc for each driving plane, an arrow for each driving vector. Slots of one finger share a plane.
  #addPlanes() {
    this.hand.data.planes.forEach((theta, slot, planes) => {
      if (planes.indexOf(theta) !== slot) return;
      const sharing = this.phi.filter((_, other) => planes[other] === theta);
      const phi = this.phi[slot].map((_, j) => sharing.reduce((sum, angles) => sum + angles[j], 0) / sharing.length);
      const color = new THREE.Color(...sphereColour(theta, Math.PI / 2));
      const rim = Array.from({length: kPlaneSamples + 1}, (_, i) => [theta, Math.PI * i / kPlaneSamples]);
      const disc = this.#deformingGeometry(Float64Array.from([...rim.flat(), theta, 0]), [kPlaneSamples + 1]);
      disc.setIndex(rim.slice(1).flatMap((_, i) => [kPlaneSamples + 1, i, i + 1]));
      this.#show('planes', new THREE.Mesh(disc, new THREE.MeshBasicMaterial(
        {color, transparent: true, opacity: 0.08, side: THREE.DoubleSide, depthWrite: false})), 1);
      const edge = this.#deformingGeometry(Float64Array.from(rim.flat()));
      this.#show('planes', new THREE.Line(edge, new THREE.LineBasicMaterial({color})), 2);

      const arrows = phi.map(() => new Arrow(color, 0.006));
      arrows.forEach((arrow) => this.#show('planes', arrow, 0));
      const label = {text: this.hand.fingersOfSlot(slot).map(({name}) => name).join(', '), pixels: 16,
        position: new THREE.Vector3(), layer: 'planes'};
      const distance = slot % 2 ? 0.34 : 0.2;  // so that the names of neighbours stand side by side
      this.labels.push(label);
      this.deforming.push({thetaPhi: Float64Array.from([...phi, Math.PI / 2].flatMap((angle) => [theta, angle])),
        place: (positions) => {
          const at = (i) => new THREE.Vector3().fromArray(positions, 3 * i);
          arrows.forEach((arrow, j) => arrow.point(new THREE.Vector3(), at(j)));
          const end = at(arrows.length), length = end.length();
          if (length > kVanished) label.position.copy(end).setLength(length + distance);
        }});
    });
  }

  #addAxes() {
    const axis = (layer, color, from, to, text) => {
      const arrow = new Arrow(color, 0.012);
      arrow.point(from, to);
      this.#show(layer, arrow, 0);
      this.labels.push({text, position: to.clone().multiplyScalar(1.08), layer, color, pixels: 24});
    };
    const origin = new THREE.Vector3();
    axis('axes', '#d3413c', origin, new THREE.Vector3(kAxisLength, 0, 0), 'x');
    axis('axes', '#3c9a45', origin, new THREE.Vector3(0, kAxisLength, 0), 'y');
    axis('axes', '#3c6fd3', origin, new THREE.Vector3(0, 0, kAxisLength), 'z');

    // the palm normal stands on the palm centre, the sphere's north pole
    const {palm_normal_palm: n, T_palm_sphere: T} = this.hand.data;
    const normal = new THREE.Vector3(...[0, 1, 2].map((i) => T[i] * n[0] + T[4 + i] * n[1] + T[8 + i] * n[2]));
    const foot = new THREE.Vector3(0, 0, -1);
    axis('normal', '#a64ac9', foot, foot.clone().addScaledVector(normal, 0.6), 'n');
  }

  /// A geometry over coordinates (theta, phi) whose positions follow the deformation and whose colours are theirs.
  /// @param atCentre  vertices that stay at the sphere's centre
  #deformingGeometry(thetaPhi, atCentre = []) {
    const geometry = new THREE.BufferGeometry(), count = thetaPhi.length / 2;
    const position = new THREE.BufferAttribute(new Float32Array(3 * count), 3);
    geometry.setAttribute('position', position);
    geometry.setAttribute('color', new THREE.BufferAttribute(sphereColours(thetaPhi), 3));
    this.deforming.push({thetaPhi, place: (positions) => {
      position.array.set(positions);
      atCentre.forEach((i) => position.array.fill(0, 3 * i, 3 * i + 3));
      position.needsUpdate = true;
    }});
    return geometry;
  }

  #show(layer, object, order) {
    object.renderOrder = order;
    object.frustumCulled = false;  // its vertices move
    this.layers[layer].add(object);
  }

  /// @param action  of this hand: [5 + 5 V], rad and sphere radii
  deform(action) {
    for (const {thetaPhi, place} of this.deforming) {
      const field = this.hand.solver.field(action, thetaPhi, {driving_vectors_phi: this.phi.flat()});
      const positions = new Float32Array(field.length / 2 * 3);
      for (let i = 0; i < field.length / 2; ++i) {
        // a point of negative radius has vanished
        const radius = Math.max(field[2 * i + 1], 0);
        positions.set(spherePoint(field[2 * i], thetaPhi[2 * i + 1], radius, this.hand.azimuthSign), 3 * i);
      }
      place(positions);
    }
    this.labels.forEach(({sprite, position}) => sprite?.position.copy(position));
  }

  /// Makes labels as large as they say.
  /// @param pixel  height of one on the screen, at a distance of 1 from the camera
  scaleLabels(pixel) {
    for (const {sprite, pixels} of this.labels) {
      const {width, height} = sprite.material.map.image;
      sprite.scale.set(pixels * pixel * width / height, pixels * pixel, 1);
    }
  }

  setTheme({ink, paper}) {
    this.gridMaterial.color.set(ink);
    this.unitMaterial.color.set(ink);
    for (const label of this.labels) {
      if (label.sprite) {
        this.layers[label.layer].remove(label.sprite);
        disposeDeep(label.sprite);
      }
      label.sprite = labelSprite(label.text, label.color ?? ink, paper);
      label.sprite.position.copy(label.position);
      this.layers[label.layer].add(label.sprite);
    }
  }
}
