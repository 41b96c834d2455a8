// The runtime of uhas in the page: hand_module.cpp, compiled to WebAssembly, gives the solutions; there is no second solver.
'use strict';

const kSolveChoices = {rule: ['correspondence', 'contact'], closing: ['fade', 'hard'], field: ['finger', 'field']};

class UhasRuntime {
  #module;

  constructor(module) {
    this.#module = module;
  }

  /// @param bytes  Uint8Array of the WebAssembly module
  static async load(bytes) {
    return new UhasRuntime(await WebAssembly.compile(bytes));
  }

  /// @param image  Uint8Array: the flat profile of a hand. Throws Error with a sentence when it is none, or damaged.
  openHand(image) {
    return new SolverHand(this.#module, image);
  }
}

/// A hand with an instance of the runtime of its own.
class SolverHand {
  #runtime;
  #options = '';  // those that the solver was made with

  constructor(module, image) {
    this.#runtime = new WebAssembly.Instance(module, {}).exports;
    this.#runtime._initialize();
    this.#write(Uint8Array, this.#call('image', image.length), image);
    this.#call('open_hand');
    this.jointCount = this.#call('joint_count');
    this.linkCount = this.#call('link_count');
  }

  /// @param action   5 + 5 V numbers in uhas' own convention, not normalised: rad, then sphere radii
  /// @param options  as those of uhas-solve: rule, closing, field, passes; and driving_vectors_phi, V or 5 V polar angles (rad)
  /// @returns q (rad; m for sliding joints), residualRms (sphere radii; NaN without points), atLimit and closed (1 or 0), one a
  ///          joint of the profile. Throws Error for an action or options that the solver refuses.
  solve(action, options = {}) {
    this.#setOptions(options);
    this.#setAction(action, options);
    this.#require(this.#call('solve'));
    return {
      q: this.#read(Float64Array, this.#call('q'), this.jointCount),
      residualRms: this.#call('residual_rms'),
      atLimit: this.#read(Uint8Array, this.#call('at_limit'), this.jointCount),
      closed: this.#read(Uint8Array, this.#call('closed'), this.jointCount),
    };
  }

  /// Where the links are at joint values `q`, one a joint of the profile, followers included.
  /// @returns Float32Array, 16 numbers a link: its frame in the palm's, column by column (m)
  pose(q) {
    if (q.length !== this.jointCount) throw new Error(`a pose of this hand has ${this.jointCount} joint values, not ${q.length}`);
    this.#write(Float64Array, this.#call('q_shown'), q);
    return this.#read(Float32Array, this.#call('pose'), 16 * this.linkCount);
  }

  /// Where the interpolated field of an action takes points of the unit sphere.
  /// @param thetaPhi  canonical azimuth and polar angle of each point, one after the other (rad)
  /// @param options   driving_vectors_phi as for `solve`
  /// @returns Float64Array: azimuth (not wrapped) and radius (sphere radii, negative beyond the centre) of each
  field(action, thetaPhi, options = {}) {
    this.#setAction(action, options);
    const count = thetaPhi.length / 2;
    const points = new Float64Array(3 * count);
    for (let i = 0; i < count; ++i) points.set([thetaPhi[2 * i], thetaPhi[2 * i + 1], 1], 3 * i);
    const address = this.#call('points', count);
    this.#write(Float64Array, address, points);
    this.#require(this.#call('deform'));
    points.set(this.#read(Float64Array, address, 3 * count));
    return Float64Array.from({length: 2 * count}, (_, i) => points[3 * (i >> 1) + 2 * (i & 1)]);
  }

  #setOptions(options) {
    const chosen = Object.entries(kSolveChoices).map(([name, words]) => {
      const word = options[name] ?? words[0];
      if (!words.includes(word)) throw new Error(`${name} is ${word}; it is one of ${words.join(', ')}`);
      return words.indexOf(word);
    });
    const passes = options.passes ?? 1;
    if (!Number.isInteger(passes) || passes < 1 || passes > 100) throw new Error(`passes is ${passes}; it is a whole number from 1 to 100`);
    chosen.push(passes);
    if (this.#options === chosen.join()) return;
    this.#call('set_options', ...chosen);
    this.#options = chosen.join();
  }

  #setAction(action, options) {
    const phi = options.driving_vectors_phi ?? [];
    this.#write(Float64Array, this.#call('action', action.length), action);
    this.#write(Float64Array, this.#call('driving_vectors_phi', phi.length), phi);
  }

  /// Throws what a status of the runtime means unless it is ok.
  #require(status) {
    if (status !== 0) throw new Error(this.#text(this.#call('status_text', status)));
  }

  /// Calls the runtime; when it stops, throws the sentence that it left.
  #call(name, ...values) {
    try {
      return this.#runtime[name](...values);
    } catch (trap) {
      const sentence = this.#text(this.#runtime.message());
      throw sentence ? new Error(sentence) : trap;
    }
  }

  #write(Numbers, address, numbers) {
    new Numbers(this.#runtime.memory.buffer, address, numbers.length).set(numbers);
  }

  #read(Numbers, address, length) {
    return new Numbers(this.#runtime.memory.buffer, address, length).slice();
  }

  /// The text at an address, up to its zero.
  #text(address) {
    const bytes = new Uint8Array(this.#runtime.memory.buffer, address);
    return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
  }
}
