// One hand of the report: what the document says of it, and its solver.
'use strict';

const kSlots = ['pinky', 'ring', 'middle', 'index', 'thumb'];

function bytesOf(base64) {
  const text = atob(base64), bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

function floatsOf(base64) {
  return new Float32Array(bytesOf(base64).buffer);
}

class Hand {
  /// @param data     an element of the document's `hands`
  /// @param runtime  a loaded UhasRuntime
  constructor(data, runtime) {
    this.data = data;
    this.summary = data.summary;
    this.name = data.summary.hand;
    this.solver = runtime.openHand(bytesOf(data.image));
    this.azimuthSign = data.mirrored ? -1 : 1;
    this.jointNames = data.summary.joint_names;
    this.joints = this.jointNames.map((name, i) => ({...data.joints[i], ...this.#jointOfFinger(name), name}));
    this.poses = Object.fromEntries(['q_open', 'q_sphere', 'q_closed'].map(
      (pose) => [pose, Float64Array.from(this.jointNames, (name) => data.summary[pose][name])]));
    this.meshes = data.meshes.map((mesh) => ({link: mesh.link, vertices: floatsOf(mesh.vertices),
      triangles: new Uint32Array(bytesOf(mesh.triangles).buffer)}));
    this.points = this.#readPoints(data.points);
  }

  /// The finger, class, limits and master of a joint. A master that drives fingers from outside of them has no finger.
  #jointOfFinger(name) {
    for (const finger of this.summary.fingers) {
      const joint = finger.joints.find((candidate) => candidate.name === name);
      if (joint) return {...joint, finger: finger.name};
    }
    return {finger: null, class: null, lower: null, upper: null, mimic: null};
  }

  /// {link: Int32Array[n], position: Float32Array[3 n] (m, link frame), thetaPhi: Float64Array[2 n]}
  #readPoints(points) {
    const theta = floatsOf(points.theta), phi = floatsOf(points.phi);
    const thetaPhi = new Float64Array(2 * theta.length);
    theta.forEach((value, i) => thetaPhi.set([value, phi[i]], 2 * i));
    return {link: new Int32Array(bytesOf(points.link).buffer), position: floatsOf(points.position), thetaPhi};
  }

  /// The fingers that own a slot.
  fingersOfSlot(slot) {
    return this.summary.fingers.filter((finger) => finger.slots.includes(slot));
  }

  /// Whether delta theta of a slot turns a finger: one without a lateral joint ignores it.
  turns(slot) {
    return this.fingersOfSlot(slot).some((finger) => finger.lateral_joint !== null);
  }

  /// Delta theta (rad) of normalised values in [-1, 1]: 0 maps to 0, the ends to the slot's bounds.
  lateralFromNormalized(slot, value) {
    const [lower, upper] = this.data.delta_theta_bounds[slot];
    return value < 0 ? -value * lower : value * upper;
  }

  /// The inverse of lateralFromNormalized; values beyond the bounds come out at the ends.
  normalizedFromLateral(slot, value) {
    const [lower, upper] = this.data.delta_theta_bounds[slot];
    if (value === 0 || (value < 0 ? lower : upper) === 0) return 0;
    return clamp(value < 0 ? -value / lower : value / upper, -1, 1);
  }
}
