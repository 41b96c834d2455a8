// What is shown and how: the pose, the standpoint, the layers of the drawing, the options of the solver.
'use strict';

const kLayers = {
  meshes: 'meshes', points: 'hand points', joints: 'joint axes', skeleton: 'skeleton', unitSphere: 'unit sphere',
  sphere: 'deformed sphere', spherePoints: 'sphere points', planes: 'driving planes, vectors', axes: 'sphere frame',
  normal: 'palm normal',
};

const kPoseHelp = {
  q_open: 'the open pose', q_sphere: 'wrapped on the undeformed sphere', q_closed: 'the closed ends of the ranges',
  solved: 'the solver’s answer to the action',
};

/// Radio buttons for the pose.
function posePanel(session) {
  const radios = Object.entries(kPoseHelp).map(([pose, help]) => element('input', {
    type: 'radio', name: 'pose', value: pose, id: `pose-${pose}`, title: help,
    onchange: () => { session.stop(); session.setPose(pose); },
  }));
  session.onChange(() => radios.forEach((radio) => { radio.checked = radio.value === session.pose; }));
  return element('fieldset', {class: 'panel segments'}, element('legend', {}, 'Pose'),
    ...radios.map((radio) => element('label', {title: radio.title}, radio, element('span', {}, radio.value))));
}

/// Buttons for the standpoints, check boxes for the layers.
function layersPanel(viewer, session) {
  const withoutModel = session.hands.every((hand) => hand.meshes.length === 0);
  const hidden = withoutModel ? ['meshes'] : ['skeleton'];
  hidden.forEach((layer) => viewer.setLayer(layer, false));
  return element('div', {class: 'toolbar'},
    element('div', {class: 'buttons', role: 'group', 'aria-label': 'Look from'},
      ...Object.entries(kStandpoints).map(([name, {label}]) => element('button',
        {type: 'button', id: `view-${name}`, onclick: () => viewer.lookFrom(name)}, label))),
    element('div', {class: 'checks', role: 'group', 'aria-label': 'Layers'},
      ...Object.entries(kLayers).map(([layer, label]) => element('label', {},
        element('input', {type: 'checkbox', id: `layer-${layer}`, checked: !hidden.includes(layer),
          onchange: (event) => viewer.setLayer(layer, event.target.checked)}), label))));
}

/// What colours mean.
function legend() {
  const swatch = (color, label) => element('span', {class: 'swatch', style: `--swatch: ${color}`}, label);
  return element('div', {class: 'legend'},
    colourKeyCanvas(36),
    element('span', {}, 'surface points by (θ, φ), alike on hand and sphere'),
    swatch(kClassColours.lateral, 'lateral joint'), swatch(kClassColours.encompassing, 'encompassing joint'),
    element('span', {}, 'thin: follower (mimic)'));
}

/// Menus for the solver's options.
function solverPanel(session) {
  const menu = (name, label, values) => {
    const select = element('select', {id: `solver-${name}`, onchange: () => session.setSolveOption(name,
      name === 'passes' ? Number(select.value) : select.value)},
    ...values.map((value) => element('option', {value}, String(value))));
    select.value = session.solveOptions[name];
    return element('label', {}, label, select);
  };
  const passes = [...new Set([1, 2, 3, 5, 10, session.solveOptions.passes])].sort((a, b) => a - b);
  return element('details', {class: 'panel solver'}, element('summary', {}, 'Solver options'),
    menu('rule', 'rule', ['correspondence', 'contact']), menu('closing', 'closing', ['fade', 'hard']),
    menu('field', 'field', ['finger', 'field']), menu('passes', 'passes', passes));
}
