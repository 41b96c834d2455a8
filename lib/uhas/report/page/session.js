// What the page shows at this moment: the inputs, the pose, and what each hand's solver made of them. Views listen.
'use strict';

const kRadialBound = 2;  // of a displacement, sphere radii

/// Polar angles of the driving vectors, [5][V] by slot, from V that all slots share or 5 V.
function drivingVectorsOfSlots(phi) {
  const vectors = phi.length < kSlots.length ? 0 : phi.length / kSlots.length;
  return kSlots.map((_, slot) => (vectors ? phi.slice(vectors * slot, vectors * (slot + 1)) : phi));
}

class Session {
  /// @param hands  Hand[], all of which follow the same inputs
  constructor(hands) {
    this.hands = hands;
    this.phi = drivingVectorsOfSlots(hands[0].data.driving_vectors_phi);
    this.vectors = this.phi[0].length;
    this.timeline = hands.length === 1 ? hands[0].data.timeline : null;
    this.solveOptions = {rule: 'correspondence', closing: 'fade', field: 'finger', passes: 1, ...this.timeline?.options,
      driving_vectors_phi: this.phi.flat()};
    this.pose = 'solved';  // answers the inputs; or q_open, q_sphere, q_closed; or timeline, a solution of the document
    this.frame = 0;  // of the timeline
    this.inputs = new Float64Array(kSlots.length * (1 + this.vectors));
    this.states = [];  // one a hand: {action, q, residualRms, atLimit, closed}
    this.listeners = [];
    this.animation = null;  // the pending frame of the one that runs
    this.#solve();
  }

  /// Position in `inputs` of a slot's delta theta, normalised to [-1, 1]: each hand has bounds of its own.
  static lateral(slot) {
    return slot;
  }

  /// Position in `inputs` of a slot's displacement at driving vector j, in sphere radii.
  radial(slot, j) {
    return kSlots.length + this.vectors * slot + j;
  }

  /// @param listener  called without arguments after every change
  onChange(listener) {
    this.listeners.push(listener);
    listener();
  }

  setInputs(inputs) {
    this.inputs = Float64Array.from(inputs, (value, i) => {
      const bound = i < kSlots.length ? 1 : kRadialBound;
      return clamp(value, -bound, bound);
    });
    this.setPose('solved');
  }

  setInput(index, value) {
    const inputs = this.inputs.slice();
    inputs[index] = value;
    this.setInputs(inputs);
  }

  /// The action as one writes it down: delta theta in rad for a single hand, normalised for several.
  get action() {
    return this.hands.length === 1 ? this.actionOf(this.hands[0]) : Array.from(this.inputs);
  }

  set action(values) {
    this.setInputs(this.hands.length > 1 ? values : this.#inputsFrom(values));
  }

  /// The action of a hand: [5 + 5 V], rad and sphere radii.
  actionOf(hand) {
    return Array.from(this.inputs, (value, i) => (i < kSlots.length ? hand.lateralFromNormalized(i, value) : value));
  }

  setPose(pose) {
    this.pose = pose;
    this.#solve();
    this.#tell();
  }

  setSolveOption(name, value) {
    this.solveOptions[name] = value;
    this.setPose('solved');
  }

  /// Shows a solution of the timeline with the action that it answers.
  showFrame(frame) {
    this.frame = frame;
    this.inputs = Float64Array.from(this.#inputsFrom(this.timeline.actions[frame]));
    this.setPose('timeline');
  }

  /// Calls `step` with the seconds since now, once a frame of the display, until it returns false or `stop` is called.
  play(step) {
    this.stop();
    const start = performance.now();
    const next = (now) => {
      this.animation = requestAnimationFrame(next);
      if (!step(Math.max(now - start, 0) / 1000)) this.stop();
    };
    this.animation = requestAnimationFrame(next);
    this.#tell();
  }

  /// Ends the animation that runs, if one does. Whoever changes something by hand calls it first.
  stop() {
    if (this.animation === null) return;
    cancelAnimationFrame(this.animation);
    this.animation = null;
    this.#tell();
  }

  #tell() {
    this.listeners.forEach((listener) => listener());
  }

  #inputsFrom(action) {
    return action.map((value, i) => (i < kSlots.length ? this.hands[0].normalizedFromLateral(i, value) : value));
  }

  #solve() {
    this.states = this.hands.map((hand) => {
      const action = this.actionOf(hand);
      if (this.pose === 'timeline') return {action, ...this.#solutionOfFrame(hand)};
      if (this.pose === 'solved') return {action, ...hand.solver.solve(action, this.solveOptions)};
      const none = new Uint8Array(hand.jointNames.length);
      return {action, q: hand.poses[this.pose], residualRms: NaN, atLimit: none, closed: none};
    });
  }

  #solutionOfFrame(hand) {
    const {q, residual_rms, at_limit, closed} = this.timeline;
    const flags = (names) => Uint8Array.from(hand.jointNames, (name) => names.includes(name));
    return {q: Float64Array.from(q[this.frame]), residualRms: residual_rms[this.frame] ?? NaN,
      atLimit: flags(at_limit[this.frame]), closed: flags(closed[this.frame])};
  }
}
