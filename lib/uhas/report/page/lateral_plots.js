// The lateral tables: azimuth of the fingertip against the value of its lateral joint, and the point where it stands.
'use strict';

const kPlot = {width: 230, height: 150, left: 40, right: 10, top: 10, bottom: 30};

/// Plots of all tables of a hand; a sentence when it has none.
function lateralPlots(session, hand) {
  if (hand.data.tables.length === 0) {
    return element('p', {}, `${hand.name} has no lateral joint: Δθ is ignored.`);
  }
  return element('div', {class: 'plots'}, ...hand.data.tables.map((table) => lateralPlot(session, hand, table)));
}

function lateralPlot(session, hand, table) {
  const i = hand.jointNames.indexOf(table.joint), kind = hand.joints[i].kind;
  const unit = jointUnit(kind), shown = (q) => q * (kind === 'prismatic' ? 1000 : kDegrees);
  const values = table.q.map(shown), angles = table.theta.map((theta) => theta * kDegrees);
  const [low, high] = [Math.min(...angles), Math.max(...angles)];
  const first = values[0], last = values[values.length - 1];
  const {left, top} = kPlot, bottom = kPlot.height - kPlot.bottom, right = kPlot.width - kPlot.right;
  const x = (value) => left + (right - left) * (value - first) / (last - first);
  const y = (angle) => bottom - (bottom - top) * (angle - low) / (high - low);
  const neutral = x(shown(table.neutral)), initial = y(table.theta_initial * kDegrees);
  const points = values.map((value, k) => `${x(value).toFixed(1)},${y(angles[k]).toFixed(1)}`).join(' ');
  const text = (at, up, anchor, words) => svgElement('text', {x: at, y: up, 'text-anchor': anchor}, words);
  const dot = svgElement('circle', {r: 4.5, class: 'now'});
  const finger = table.finger ?? 'several fingers', name = `${finger}: θ of the fingertip over ${table.joint}`;

  session.onChange(() => {
    const q = session.states[session.hands.indexOf(hand)].q[i];
    const value = clamp(shown(q), first, last);
    dot.setAttribute('cx', x(value));
    dot.setAttribute('cy', y(interpolate(values, angles, value)));
  });
  return element('figure', {},
    svgElement('svg', {viewBox: `0 0 ${kPlot.width} ${kPlot.height}`, role: 'img', 'aria-label': name},
      svgElement('path', {class: 'axis', d: `M${left} ${top}V${bottom}H${right}`}),
      svgElement('path', {class: 'guide', d: `M${neutral} ${top}V${bottom}M${left} ${initial}H${right}`}),
      svgElement('polyline', {class: 'curve', points}),
      dot,
      text(left - 4, top + 8, 'end', `${fixed(high, 0)}°`),
      text(left - 4, (top + bottom) / 2, 'end', 'θ'),
      text(left - 4, bottom, 'end', `${fixed(low, 0)}°`),
      text(left, bottom + 13, 'start', `${fixed(first, 0)}${unit}`),
      text(right, bottom + 13, 'end', `${fixed(last, 0)}${unit}`),
      text((left + right) / 2, bottom + 24, 'middle', table.joint)),
    element('figcaption', {}, element('strong', {}, finger), table.driving
      ? ` Δθ ${table.delta_theta_range.map((bound) => `${signed(bound * kDegrees, 1)}°`).join(' … ')}`
      : ' stays at neutral: another joint follows Δθ'));
}
