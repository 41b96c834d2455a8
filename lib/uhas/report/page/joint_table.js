// The joints of a hand: limits, poses, and where each stands now.
'use strict';

/// Where a value stands between a joint's limits, in per cent.
function sharePercent(joint, value) {
  return joint.upper > joint.lower ? 100 * clamp((value - joint.lower) / (joint.upper - joint.lower), 0, 1) : 50;
}

function jointTable(session, hand) {
  const numbers = ['lower', 'upper', 'q_open', 'q_sphere', 'q_closed', 'current'];
  const columns = ['finger', 'joint', 'class', 'lower', 'range', 'upper', 'q_open', 'q_sphere', 'q_closed', 'current',
    'state'].map((heading) => ({heading, number: numbers.includes(heading)}));
  const cells = hand.joints.map((joint) => ({
    current: element('strong', {}), state: element('span', {}), gauge: gaugeElement(hand, joint),
  }));
  const number = (joint, value) => (value === null ? '' : jointNumber(joint.kind, value));
  const rows = hand.joints.map((joint, i) => {
    const followed = hand.joints[i - 1]?.finger === joint.finger;
    const kind = element('span', {class: 'swatch', style: `--swatch: ${kClassColours[joint.class ?? 'other']}`},
      joint.class ?? 'drives fingers');
    return [followed ? '' : joint.finger ?? 'none', joint.kind === 'prismatic' ? `${joint.name} (mm)` : joint.name, kind,
      number(joint, joint.lower), cells[i].gauge, number(joint, joint.upper),
      ...['q_open', 'q_sphere', 'q_closed'].map((pose) => number(joint, hand.poses[pose][i])),
      cells[i].current, cells[i].state];
  });
  session.onChange(() => {
    const {q, atLimit, closed} = session.states[session.hands.indexOf(hand)];
    hand.joints.forEach((joint, i) => {
      cells[i].current.textContent = jointNumber(joint.kind, q[i]);
      cells[i].state.textContent = [atLimit[i] && 'at limit', closed[i] && 'closed',
        joint.mimic !== null && `follows ${joint.mimic}`].filter(Boolean).join(', ');
      if (joint.lower !== null) cells[i].gauge.style.setProperty('--now', `${sharePercent(joint, q[i])}%`);
    });
  });
  return tableElement(`Joints of ${hand.name}, in degrees`, columns, rows);
}

/// A bar from the lower to the upper limit with a tick at q_open, q_sphere and q_closed, and a dot at the current value.
function gaugeElement(hand, joint) {
  if (joint.lower === null) return element('span', {});
  const i = hand.jointNames.indexOf(joint.name);
  return element('div', {class: 'gauge', 'aria-hidden': 'true'},
    ...['q_open', 'q_sphere', 'q_closed'].map((pose) => element('i',
      {class: pose, title: pose, style: `left: ${sharePercent(joint, hand.poses[pose][i])}%`})),
    element('b', {}));
}
