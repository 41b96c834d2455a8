// What the build warned of, and what it inferred, how surely and why.
'use strict';

function findingsOf(hand) {
  const {warnings} = hand.summary;
  const rows = hand.data.findings.map(({item, value, reason, confidence}) => [item, value,
    element('meter', {min: 0, max: 1, low: 0.5, optimum: 1, value: confidence, 'aria-label': 'confidence'}),
    fixed(confidence, 2), reason]);
  return element('div', {},
    warnings.length === 0 ? element('p', {}, `No warnings for ${hand.name}.`)
      : element('ul', {class: 'warnings'}, ...warnings.map((warning) => element('li', {}, warning))),
    tableElement(`What was inferred of ${hand.name}`, [{heading: 'item'}, {heading: 'value'}, {heading: 'confidence'},
      {heading: '', number: true}, {heading: 'reason'}], rows));
}
