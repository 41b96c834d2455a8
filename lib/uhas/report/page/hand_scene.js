// A hand in three dimensions: links with meshes and surface points, joint markers, skeleton. It stands in the sphere
// frame, in units of its radius.
'use strict';

const kClassColours = {lateral: '#e07b1f', encompassing: '#2f76d2', other: '#7a7f87'};

class HandScene {
  constructor(hand) {
    this.hand = hand;
    this.layers = groups('meshes', 'points', 'joints', 'skeleton');
    this.meshMaterial = new THREE.MeshStandardMaterial({roughness: 0.75, metalness: 0.05, side: THREE.DoubleSide,
      polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1});
    this.root = new THREE.Group();
    this.root.matrixAutoUpdate = false;
    this.root.matrix.set(...hand.data.T_palm_sphere);
    this.root.matrix.getInverse(this.root.matrix).premultiply(
      new THREE.Matrix4().makeScale(1 / hand.data.radius, 1 / hand.data.radius, 1 / hand.data.radius));
    this.root.add(...Object.values(this.layers));
    this.moving = [];  // objects to be placed where a link is: {object, link}
    for (const mesh of hand.meshes) {
      const geometry = creasedGeometry(mesh.vertices, mesh.triangles);
      this.#attach('meshes', mesh.link, new THREE.Mesh(geometry, this.meshMaterial));
    }
    this.#addPoints();
    hand.joints.forEach((joint) => this.#addMarker(joint));
    this.#addSkeleton();
  }

  #attach(layer, link, object) {
    object.matrixAutoUpdate = false;
    this.layers[layer].add(object);
    this.moving.push({object, link});
  }

  #addPoints() {
    const {link, position, thetaPhi} = this.hand.points;
    const colors = sphereColours(thetaPhi), material = discMaterial(0.022);
    for (let first = 0, end; first < link.length; first = end) {
      for (end = first + 1; end < link.length && link[end] === link[first];) ++end;
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute('position', new THREE.BufferAttribute(position.slice(3 * first, 3 * end), 3));
      geometry.setAttribute('color', new THREE.BufferAttribute(colors.slice(3 * first, 3 * end), 3));
      this.#attach('points', link[first], new THREE.Points(geometry, material));
    }
  }

  /// A pin along the joint's axis, thinner for a joint that follows another one; where the hand hides it, it shines
  /// through.
  #addMarker(joint) {
    const r = this.hand.data.radius, thickness = (joint.mimic === null ? 0.026 : 0.015) * r;
    const color = kClassColours[joint.class ?? 'other'];
    const geometry = new THREE.CylinderBufferGeometry(thickness, thickness, 0.4 * r, 12);
    const pin = new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({color}));
    const within = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial(
      {color, transparent: true, opacity: 0.25, depthTest: false}));
    within.renderOrder = 5;
    for (const mesh of [pin, within]) {
      mesh.position.fromArray(joint.origin);
      mesh.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), new THREE.Vector3(...joint.axis));
    }
    this.#attach('joints', joint.link, new THREE.Group().add(pin, within));
  }

  /// Lines from the palm's frame over the joints' origins to the fingertips.
  #addSkeleton() {
    const {summary, joints, jointNames, data} = this.hand;
    this.bones = [];  // ends of lines: {link, position: THREE.Vector3}, in pairs
    summary.fingers.forEach((finger, f) => {
      const nodes = finger.joints.map(({name}) => joints[jointNames.indexOf(name)])
        .map((joint) => ({link: joint.link, position: new THREE.Vector3(...joint.origin)}));
      const tip = data.tips[f];
      nodes.push({link: tip.link, position: new THREE.Vector3(...tip.position)});
      nodes.slice(1).forEach((node, i) => this.bones.push(nodes[i], node));
    });
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(3 * this.bones.length), 3));
    this.boneMaterial = new THREE.LineBasicMaterial({depthTest: false});  // it lies within the hand
    this.layers.skeleton.add(new THREE.LineSegments(geometry, this.boneMaterial));
    this.layers.skeleton.children[0].frustumCulled = false;  // its vertices move
    this.layers.skeleton.children[0].renderOrder = 6;
  }

  /// @param q  joint values, the order of the profile
  pose(q) {
    const links = this.hand.solver.pose(q);
    const place = (link, matrix) => matrix.fromArray(links, 16 * link);
    for (const {object, link} of this.moving) place(link, object.matrix);
    const positions = this.layers.skeleton.children[0].geometry.getAttribute('position'), matrix = new THREE.Matrix4();
    this.bones.forEach(({link, position}, i) => {
      position.clone().applyMatrix4(place(link, matrix)).toArray(positions.array, 3 * i);
    });
    positions.needsUpdate = true;
    this.root.updateMatrixWorld(true);
  }

  /// Corners of the boxes about the links' meshes (about their points where there are none) as posed now, in the sphere
  /// frame.
  corners() {
    const source = this.hand.meshes.length ? this.layers.meshes : this.layers.points;
    return source.children.flatMap(({geometry, matrixWorld}) => {
      if (!geometry.boundingBox) geometry.computeBoundingBox();
      const ends = [geometry.boundingBox.min, geometry.boundingBox.max];
      return Array.from({length: 8}, (_, bits) =>
        new THREE.Vector3(ends[bits & 1].x, ends[bits >> 1 & 1].y, ends[bits >> 2].z).applyMatrix4(matrixWorld));
    });
  }

  setTheme({mesh, ink}) {
    this.meshMaterial.color.set(mesh);
    this.boneMaterial.color.set(ink);
  }
}
