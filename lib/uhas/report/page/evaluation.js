// An evaluation document, whatever its scores: objects become tables, rows of numbers small bar plots.
'use strict';

/// @param value  any JSON value
/// @param name   its key
function evaluationElement(value, name) {
  if (Array.isArray(value)) {
    if (value.length > 1 && value.every(Number.isFinite)) return barPlot(value, name);
    if (value.length && value.every(isObject)) return recordTable(value);
    return document.createTextNode(value.map(scoreText).join(', '));
  }
  if (!isObject(value)) return document.createTextNode(scoreText(value));

  const entries = Object.entries(value).filter(([key]) => !['format', 'version', 'hand'].includes(key));
  if (entries.length > 1 && entries.every(([, entry]) => isObject(entry) && isFlat(entry))) {
    return recordTable(entries.map(([key, entry]) => ({'': words(key), ...entry})));
  }
  const flat = entries.filter(([, entry]) => !isObject(entry) && !Array.isArray(entry));
  const deep = entries.filter(([, entry]) => isObject(entry) || Array.isArray(entry));
  return element('div', {},
    flat.length ? tableElement(null, [{heading: 'item'}, {heading: 'value', number: true}],
      flat.map(([key, entry]) => [words(key), scoreText(entry)])) : null,
    ...deep.map(([key, entry]) => element('div', {class: 'score'},
      element('h3', {}, words(key)), evaluationElement(entry, key))));
}

/// A table with a row for each record; numbers of a column share a bar, so that they compare at a glance.
function recordTable(records) {
  const keys = [...new Set(records.flatMap(Object.keys))];
  const greatest = Object.fromEntries(keys.map((key) => [key,
    Math.max(0, ...records.map((record) => record[key]).filter(Number.isFinite).map(Math.abs))]));
  const isNumber = (key) => records.some((record) => Number.isFinite(record[key]));
  const cell = (key, value) => {
    if (isObject(value) || (Array.isArray(value) && value.some((entry) => typeof entry === 'object'))) {
      return element('details', {}, element('summary', {}, 'more'), evaluationElement(value, key));
    }
    if (!Number.isFinite(value)) return value === undefined ? '' : evaluationElement(value, key);
    const share = greatest[key] > 0 ? 100 * Math.abs(value) / greatest[key] : 0;
    return element('span', {class: 'bar', style: `--share: ${share.toFixed(1)}%`}, scoreText(value));
  };
  return tableElement(null, keys.map((key) => ({heading: words(key), number: isNumber(key)})),
    records.map((record) => keys.map((key) => cell(key, record[key]))));
}

/// Bars side by side, from zero.
function barPlot(values, name) {
  const least = Math.min(...values), greatest = Math.max(...values);
  const top = Math.max(0, greatest), span = top - Math.min(0, least) || 1;
  const height = 60, step = clamp(240 / values.length, 2, 14), width = step * values.length;
  return svgElement('svg', {class: 'bars', role: 'img', width, height, viewBox: `0 0 ${width} ${height}`,
    'aria-label': `${words(name)}: ${values.length} values from ${scoreText(least)} to ${scoreText(greatest)}`},
  ...values.map((value, i) => svgElement('rect', {x: i * step + 0.5, y: height * (top - Math.max(value, 0)) / span,
    width: step - 1, height: Math.max(height * Math.abs(value) / span, 0.5)}, svgElement('title', {}, scoreText(value)))));
}

function isObject(value) {
  return value !== null && typeof value === 'object' && !Array.isArray(value);
}

function isFlat(object) {
  return Object.values(object).every((value) => value === null || typeof value !== 'object');
}

function words(key) {
  return String(key).replaceAll('_', ' ');
}

function scoreText(value) {
  if (value === null || value === undefined) return 'none';
  if (typeof value === 'boolean') return value ? 'yes' : 'no';
  if (typeof value !== 'number') return String(value);
  return Number.isInteger(value) ? fixed(value, 0) : Number(value.toPrecision(4)).toString().replace('-', '\u2212');
}
