// Numbers for people: degrees and millimetres, as in the tools' printed tables; the document has radians and metres.
'use strict';

const kDegrees = 180 / Math.PI;

/// Fixed digits with a real minus sign; never "-0".
function fixed(value, digits) {
  const text = value.toFixed(digits);
  return /^-0\.?0*$/.test(text) ? text.slice(1) : text.replace('-', '\u2212');
}

/// The same with a plus sign for positive values.
function signed(value, digits) {
  const text = fixed(value, digits);
  return /[1-9]/.test(text) && !text.startsWith('\u2212') ? `+${text}` : text;
}

/// A joint's value in degrees, or in millimetres for a prismatic joint, with one digit.
function jointNumber(kind, value) {
  return fixed(value * (kind === 'prismatic' ? 1000 : kDegrees), 1);
}

function jointUnit(kind) {
  return kind === 'prismatic' ? 'mm' : '°';
}

function clamp(value, lowest, greatest) {
  return Math.min(Math.max(value, lowest), greatest);
}

/// y at x of the polyline (xs, ys), xs increasing; the ends are held.
function interpolate(xs, ys, x) {
  if (x <= xs[0]) return ys[0];
  for (let i = 1; i < xs.length; ++i) {
    if (x <= xs[i]) return ys[i - 1] + (ys[i] - ys[i - 1]) * (x - xs[i - 1]) / (xs[i] - xs[i - 1]);
  }
  return ys[ys.length - 1];
}
