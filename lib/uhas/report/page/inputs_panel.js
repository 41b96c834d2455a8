// The inputs: a slider for each number of the action, presets, and the action as text.
'use strict';

const kSliderSteps = 200;  // from zero to a bound, so that zero is a step of its own

/// Inputs for the presets, by slot: sideways from the middle finger outward, -1..1; displacement in radii.
const kSpread = [1, 0.5, 0, -1, -0.5];
const kClosed = -kRadialBound;
const kSecondsPerFinger = 0.9;

class InputsPanel {
  constructor(session) {
    this.session = session;
    this.sliders = [];    // {input, output, index, bound, text(value)}
    this.text = element('input', {type: 'text', id: 'action-text', spellcheck: 'false', autocomplete: 'off',
      'aria-describedby': 'action-unit', onchange: () => this.#readText()});
    this.element = element('div', {class: 'panel'},
      element('h2', {}, 'Action'),
      element('div', {class: 'buttons', role: 'group', 'aria-label': 'Presets'},
        this.#button('preset-zero', 'Zero', () => this.#set(() => 0, () => 0)),
        this.#button('preset-spread', 'Spread', () => this.#set((slot) => kSpread[slot], () => 0)),
        this.#button('preset-close', 'Close one by one', () => this.#closeOneByOne()),
        this.#button('preset-closed', 'All closed', () => this.#set(() => 0, () => kClosed))),
      ...kSlots.map((name, slot) => this.#slotPanel(name, slot)),
      element('label', {for: 'action-text'}, 'As numbers'), this.text,
      element('small', {id: 'action-unit'}, session.hands.length === 1
        ? 'Δθ in rad, then Δr in sphere radii; edit or paste'
        : 'Δθ from −1 to 1 of each hand’s own range, then Δr in sphere radii; edit or paste'));
    session.onChange(() => this.#update());
  }

  #button(id, label, action) {
    return element('button', {type: 'button', id, onclick: () => { this.session.stop(); action(); }}, label);
  }

  #slotPanel(name, slot) {
    const {hands, phi} = this.session, single = hands.length === 1;
    const still = hands.filter((hand) => !hand.turns(slot)), disabled = still.length === hands.length;
    const bounds = single ? hands[0].data.delta_theta_bounds[slot].map((bound) => `${signed(bound * kDegrees, 1)}°`)
      : ['\u22121', '+1'];
    const owners = single ? hands[0].fingersOfSlot(slot).map((finger) => finger.name).join(', ') : '';
    const lateral = (value) => (single ? `${signed(hands[0].lateralFromNormalized(slot, value) * kDegrees, 1)}°`
      : signed(value, 2));
    const remark = disabled ? 'no lateral joint: Δθ is ignored' : `Δθ ${bounds.join(' … ')}`;
    const notes = hands.map((hand) => this.#sharedNote(hand, slot)).filter(Boolean);
    if (still.length && !disabled) {
      const names = still.map((hand) => hand.name).join(', ');
      notes.push(element('small', {}, `no lateral joint, Δθ is ignored: ${names}`));
    }
    return element('fieldset', {},
      element('legend', {}, `${slot} ${name}`, owners && owners !== name ? element('span', {}, ` ${owners}`) : null,
        single || disabled ? element('small', {}, remark) : null),
      this.#slider({id: `theta-${slot}`, label: 'Δθ', name: `Δθ of slot ${slot}, ${name}`, index: Session.lateral(slot),
        bound: 1, text: lateral, bounds, disabled}),
      ...phi[slot].map((angle, j) => {
        const label = `${fixed(angle * kDegrees, 0)}°`;
        return this.#slider({id: `r-${slot}-${j}`, label: `Δr ${label}`, name: `Δr of slot ${slot}, ${name}, at ${label}`,
          index: this.session.radial(slot, j), bound: kRadialBound, text: (value) => signed(value, 2),
          bounds: ['\u22122', '+2'], disabled: false});
      }),
      ...notes);
  }

  /// @param index  of the input that it sets
  /// @param bound  of that input, on both sides
  /// @param text   value -> words; `bounds` are those of the ends
  #slider({id, label, name, index, bound, text, bounds, disabled}) {
    const input = element('input', {type: 'range', id, min: -kSliderSteps, max: kSliderSteps, step: 1, disabled,
      'aria-label': name, title: bounds.join(' … '), oninput: () => {
        this.session.stop();
        this.session.setInput(index, input.valueAsNumber / kSliderSteps * bound);
      }, ondblclick: () => this.session.setInput(index, 0)});
    const output = element('output', {for: id});
    this.sliders.push({input, output, index, bound, text});
    return element('div', {class: 'slider'}, element('label', {for: id}, label), input, output);
  }

  /// What a finger with several slots makes of their inputs; kept up to date. Null when the slot is not shared.
  #sharedNote(hand, slot) {
    const finger = hand.fingersOfSlot(slot)[0];
    if (finger.slots.length < 2 || finger.slots[0] !== slot) return null;
    const note = element('small', {class: 'shared'});
    this.session.onChange(() => {
      const action = this.session.actionOf(hand), {vectors} = this.session;
      const mean = (index) => finger.slots.reduce((sum, s) => sum + action[index(s)], 0) / finger.slots.length;
      const means = Array.from({length: vectors}, (_, j) => mean((s) => this.session.radial(s, j)));
      const radial = means.map((value) => signed(value, 2)).join(', ');
      const whose = this.session.hands.length === 1 ? '' : `${hand.name}: `;
      note.textContent = `${whose}${finger.name} follows the mean of slots ${finger.slots.join(', ')}: ` +
        `Δθ ${signed(mean((s) => s) * kDegrees, 1)}°, Δr ${radial}`;
    });
    return note;
  }

  #update() {
    for (const {input, output, index, bound, text} of this.sliders) {
      const value = this.session.inputs[index];
      input.value = input.disabled ? 0 : Math.round(value / bound * kSliderSteps);
      output.textContent = input.disabled ? 'ignored' : text(value);
      input.setAttribute('aria-valuetext', output.textContent);
    }
    this.text.value = JSON.stringify(this.session.action.map((value) => Number(value.toFixed(4))));
    this.text.setCustomValidity('');
  }

  #readText() {
    let numbers = null;
    try {
      numbers = JSON.parse(this.text.value);
    } catch { /* told below */ }
    const count = this.session.inputs.length;
    if (!Array.isArray(numbers) || numbers.length !== count || !numbers.every(Number.isFinite)) {
      this.text.setCustomValidity(`Write ${count} numbers in brackets, with commas between them.`);
      this.text.reportValidity();
      return;
    }
    this.session.stop();
    this.session.action = numbers;
  }

  /// @param lateral  slot -> -1..1
  /// @param radial   slot -> sphere radii
  #set(lateral, radial) {
    this.session.setInputs(kSlots.flatMap((_, slot) => lateral(slot)).concat(
      kSlots.flatMap((_, slot) => this.session.phi[slot].map(() => radial(slot)))));
  }

  /// From zeros, the planes of one finger after the other contract; those of slots that share a finger on some hand
  /// together.
  #closeOneByOne() {
    const groups = this.#slotGroups();
    this.session.play((seconds) => {
      const progress = seconds / kSecondsPerFinger;
      this.#set(() => 0, (slot) => kClosed * clamp(progress - groups.findIndex((group) => group.includes(slot)), 0, 1));
      return progress < groups.length;
    });
  }

  #slotGroups() {
    const groups = [];
    kSlots.forEach((_, slot) => {
      const shared = groups.find((group) => this.session.hands.some(
        (hand) => hand.fingersOfSlot(slot).some((finger) => group.some((other) => finger.slots.includes(other)))));
      if (shared) shared.push(slot);
      else groups.push([slot]);
    });
    return groups;
  }
}
