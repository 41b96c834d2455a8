// The report on one hand in a browser: its inputs move the joints to where uhas-solve puts them, and its drawing
// follows. Pictures of zeros, spread and all closed stay in FOLDER/<hand>/.
//
//   node one_hand.js --bin BIN --folder FOLDER --hand NAME|real/NAME
'use strict';

const assert = require('node:assert');
const path = require('node:path');
const {ReportPage, assertJoints, launch} = require('./browser.js');
const {Tools, options} = require('./tools.js');

async function main({bin, folder, hand: name}) {
  const tools = new Tools(bin, path.join(folder, name.replace('/', '_')));
  const hand = tools.hand(name);
  const html = tools.report('report.html', hand);
  const browser = await launch(folder);
  try {
    const report = await ReportPage.open(browser, html);
    assert.strictEqual(await report.error(), null);
    const zeros = await theZeroAction(report, tools, hand);
    const spread = await aPreset(report, tools, hand, 'spread');
    await aSlider(report, tools, hand);
    const closed = await aPreset(report, tools, hand, 'closed');
    const turns = hand.summary.fingers.some((finger) => finger.lateral_joint !== null);
    assert.strictEqual(!zeros.equals(spread), turns, 'the drawing does not follow the lateral inputs');
    assert(!zeros.equals(closed), 'the drawing does not follow the radial inputs');
    await theSidewaysInputs(report, hand);
    await thePoses(report, hand);
    await report.assertIdle();
    report.assertQuiet();
  } finally {
    await browser.close();
  }
}

/// Zeros are the hand on the undeformed sphere.
async function theZeroAction(report, tools, hand) {
  const [shown] = await report.assertSolved(tools, [hand]);
  assert(shown.action.every((value) => value === 0));
  assertJoints(shown, hand.summary.joint_names, hand.summary.joint_names.map((joint) => hand.summary.q_sphere[joint]));
  await report.picture(tools.file('zero.png'));
  return report.drawing();
}

async function aPreset(report, tools, hand, preset) {
  await report.page.click(`#preset-${preset}`);
  await report.assertSolved(tools, [hand]);
  await report.picture(tools.file(`${preset}.png`));
  return report.drawing();
}

/// A slider by mouse and by keyboard; the table says what the solver does.
async function aSlider(report, tools, hand) {
  await report.page.click('#preset-zero');
  const slider = report.page.locator('#r-3-0'), {width, height} = await slider.boundingBox();
  await slider.click({position: {x: 0.35 * width, y: height / 2}});
  await report.page.keyboard.press('ArrowLeft');
  const [{action, q, jointNames}] = await report.assertSolved(tools, [hand]);
  assert(action[11] < -0.3 && action[11] > -0.9, `the slider was set to ${action[11]}`);
  assert(action.every((value, i) => value === 0 || i === 11), 'one slider moved several inputs');

  const rows = await report.page.locator('#joints tbody tr').evaluateAll(
    (all) => all.map(({cells}) => ({joint: cells[1].textContent, current: cells[9].textContent})));
  rows.forEach(({joint, current}, i) => {
    assert(joint.startsWith(jointNames[i]));
    const unit = joint.endsWith('(mm)') ? 1000 : 180 / Math.PI;
    const read = Number(current.replace('\u2212', '-'));
    assert(Math.abs(read - q[i] * unit) <= 0.0501, `${joint} reads ${current} in the table`);
  });
}

/// A slot whose finger has no lateral joint has an input that is off and says why.
async function theSidewaysInputs(report, hand) {
  for (let slot = 0; slot < 5; ++slot) {
    const turns = hand.summary.fingers.some(({slots, lateral_joint: joint}) => slots.includes(slot) && joint !== null);
    const slider = report.page.locator(`#theta-${slot}`);
    assert.strictEqual(await slider.isEnabled(), turns, `slot ${slot}`);
    const words = await slider.locator('xpath=ancestor::fieldset').textContent();
    assert.strictEqual(words.includes('no lateral joint'), !turns, words);
  }
}

/// The stored poses, as the profile has them.
async function thePoses(report, hand) {
  for (const pose of ['q_open', 'q_sphere', 'q_closed']) {
    await report.page.check(`#pose-${pose}`);
    const [shown] = await report.hands();
    assertJoints(shown, hand.summary.joint_names, hand.summary.joint_names.map((joint) => hand.summary[pose][joint]));
  }
}

main(options()).catch((error) => {
  console.error(error);
  process.exit(1);
});
