// The runtime that a report carries, run here as the page runs it: it solves what uhas-solve solves, poses the links and deforms
// the sphere as the second reader of profiles says, and refuses damaged profiles with a sentence.
//
//   node hand_module.js --bin BIN --folder FOLDER --hand NAME|real/NAME
'use strict';

const assert = require('node:assert');
const {execFileSync} = require('node:child_process');
const fs = require('node:fs');
const path = require('node:path');
const {ROOT, Tools, options} = require('./tools.js');

const UhasRuntime = new Function(`${fs.readFileSync(path.join(ROOT, 'lib/uhas/report/page/hand_solver.js'))}; return UhasRuntime;`)();

const ACTIONS = 200;
const SAME_CODE = 1e-9;  // rad, m, sphere radii: of one code with two libraries of elementary functions
const LEAST_GAP = 1e-7;  // rad: where a contact only comes nearest to the sphere, the root of the precision of its distance
const SINGLE = 1e-6;     // m: of positions in single precision

async function main({bin, folder, hand: name}) {
  const tools = new Tools(bin, path.join(folder, `module_${name.replace('/', '_')}`));
  const hand = tools.hand(name);
  const {module, image} = carriedBy(tools.report('report.html', hand));
  const runtime = await UhasRuntime.load(module);
  const solver = runtime.openHand(image);
  assert.strictEqual(solver.jointCount, hand.summary.joint_names.length);
  checkSolutions(solver, tools, hand);
  checkMotion(solver, hand);
  checkRefusals(solver);
  checkDamage(runtime, image);
}

/// The module and the flat profile in a report.
function carriedBy(html) {
  const document = JSON.parse(/id="uhas-report">(.*?)<\/script>/s.exec(fs.readFileSync(html, 'utf8'))[1]);
  return {module: Buffer.from(document.wasm, 'base64'), image: Buffer.from(document.hands[0].image, 'base64')};
}

/// With every choice of options, the solutions of uhas-solve.
function checkSolutions(solver, tools, hand) {
  const names = hand.summary.joint_names, actions = Array.from({length: ACTIONS}, () => randomAction(2));
  for (const chosen of solverOptions()) {
    const {solutions} = tools.solve(hand, actions, ...Object.entries(chosen).flatMap(([name, value]) => [`--${name}`, `${value}`]));
    actions.forEach((action, i) => {
      const expected = solutions[i], found = solver.solve(action, chosen), what = `action ${action} with ${JSON.stringify(chosen)}`;
      const tolerance = chosen.rule === 'contact' ? LEAST_GAP : SAME_CODE;
      assertNear(found.q, expected.q, tolerance, what);
      assertNear([found.residualRms], [expected.residual_rms ?? NaN], tolerance, what);
      assert.deepStrictEqual(names.filter((_, j) => found.atLimit[j]), expected.at_limit, what);
      assert.deepStrictEqual(names.filter((_, j) => found.closed[j]), expected.closed, what);
    });
  }
}

/// Poses and fields, with 1 to 4 driving vectors.
function checkMotion(solver, hand) {
  const actions = [1, 2, 3, 4].map(randomAction), q = actions.map((action) => Array.from(solver.solve(action).q));
  const thetaPhi = Array.from({length: 400}, (_, i) => (i % 2 ? between(0, Math.PI) : between(-4, 4)));
  const {poses, fields} = JSON.parse(execFileSync('/usr/bin/python3', [path.join(__dirname, 'expected_motion.py'), hand.profile],
    {input: JSON.stringify({q, actions, theta_phi: thetaPhi}), encoding: 'utf8', maxBuffer: 1 << 26}));
  poses.forEach((pose, i) => assertNear(solver.pose(q[i]), pose, SINGLE, `links at ${q[i]}`));
  fields.forEach((field, i) => assertNear(solver.field(actions[i], thetaPhi), field, SAME_CODE, `field of ${actions[i]}`));
}

/// What the solver refuses is an Error in words, and no reason to stop.
function checkRefusals(solver) {
  const zeros = new Array(15).fill(0), before = solver.solve(zeros);
  assert.throws(() => solver.solve([NaN, ...zeros.slice(1)]), {message: 'the input has a number that is not finite'});
  assert.throws(() => solver.field(zeros.slice(1), [0, 1]), {message: 'a span has the wrong length'});
  assert.throws(() => solver.solve(zeros, {driving_vectors_phi: [2, 1]}), /driving-vector angles must increase/);
  assert.throws(() => solver.solve(zeros, {rule: 'none'}), {message: 'rule is none; it is one of correspondence, contact'});
  assert.throws(() => solver.solve(zeros, {passes: 101}), {message: 'passes is 101; it is a whole number from 1 to 100'});
  assert.throws(() => solver.pose([0]), /a pose of this hand has \d+ joint values, not 1/);
  assert.deepStrictEqual(solver.solve(zeros), before);
}

/// A cut or damaged profile gives a sentence, or a hand that still solves; never a stop without words.
function checkDamage(runtime, image) {
  const sentence = /^(the flat hand profile |[a-z_]+\/[A-Za-z_]+(\[\d+\])? ).*; (write it again|rebuild it with uhas-build-profile)$/;
  for (let n = 0; n < 20; ++n) assert.throws(() => runtime.openHand(image.subarray(0, random() * image.length)), {message: sentence});
  for (let n = 0; n < 200; ++n) {
    const damaged = Uint8Array.from(image);
    damaged[Math.floor(random() * image.length)] ^= 1 << Math.floor(8 * random());
    let hand;
    try {
      hand = runtime.openHand(damaged);
    } catch (error) {
      assert.match(error.message, sentence);
      continue;
    }
    hand.solve(new Array(15).fill(0)).q.forEach((value) => assert(Number.isFinite(value)));
  }
}

/// Every choice of the solver's options once.
function* solverOptions() {
  for (const closing of ['fade', 'hard']) {
    for (const field of ['finger', 'field']) {
      for (const [rule, passes] of [['correspondence', 1], ['correspondence', 3], ['contact', 1]]) yield {rule, closing, field, passes};
    }
  }
}

/// Within and beyond the bounds, for V driving vectors.
function randomAction(vectors) {
  return Array.from({length: 5 + 5 * vectors}, (_, i) => (i < 5 ? between(-1, 1) : between(-2.2, 1.2)));
}

function between(low, high) {
  return low + (high - low) * random();
}

/// A number in [0, 1), the same sequence in every run (mulberry32).
let state = 5;
function random() {
  state = (state + 0x6d2b79f5) | 0;
  let t = Math.imul(state ^ (state >>> 15), 1 | state);
  t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
  return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
}

/// NaN is near NaN alone.
function assertNear(found, expected, tolerance, what) {
  assert.strictEqual(found.length, expected.length, what);
  expected.forEach((value, i) => assert(Object.is(found[i], value) || Math.abs(found[i] - value) <= tolerance,
                                        `${what}: element ${i} is ${found[i]}, not ${value}`));
}

main(options()).catch((error) => {
  console.error(error);
  process.exit(1);
});
