// Two hands side by side, a left one with four fingers and a right one with five, move together from one slider, each
// within its own bounds.
//
//   node two_hands.js --bin BIN --folder FOLDER
'use strict';

const assert = require('node:assert');
const path = require('node:path');
const {ReportPage, launch} = require('./browser.js');
const {Tools, options} = require('./tools.js');

const INDEX = 3;  // slot

async function main({bin, folder}) {
  const tools = new Tools(bin, path.join(folder, 'two_hands'));
  const hands = ['allegro_left', 'shadow_right'].map((name) => tools.hand(name));
  const html = tools.report('report.html', ...hands);
  const browser = await launch(folder);
  try {
    const report = await ReportPage.open(browser, html);
    assert.strictEqual(await report.error(), null);
    const zeros = await report.assertSolved(tools, hands);

    // to the upper bound of the index fingers, whatever that is on each hand
    await report.page.focus(`#theta-${INDEX}`);
    await report.page.keyboard.press('End');
    const turned = await report.assertSolved(tools, hands);
    const fingers = hands.map(({summary}) => summary.fingers.find(({slots}) => slots.includes(INDEX)));
    fingers.forEach((finger, i) => {
      assert.strictEqual(turned[i].action[INDEX], finger.delta_theta_range[1]);
      assertMoved(zeros[i], turned[i], finger);
    });

    // a quarter of the radial range, in radii on both
    await report.page.click('#preset-zero');
    await report.page.focus(`#r-${INDEX}-1`);
    for (let step = 0; step < 50; ++step) await report.page.keyboard.press('ArrowLeft');
    const bent = await report.assertSolved(tools, hands);
    bent.forEach(({action}) => assert.strictEqual(action[5 + 2 * INDEX + 1], -0.5));
    fingers.forEach((finger, i) => assertMoved(zeros[i], bent[i], finger));

    await oneCamera(report);
    await report.page.click('#view-oblique');
    await report.page.click('#preset-spread');
    await report.assertSolved(tools, hands);
    await report.picture(tools.file('spread.png'));
    await report.assertIdle();
    report.assertQuiet();
  } finally {
    await browser.close();
  }
}

/// Joints of the finger have moved, those of other fingers have not.
function assertMoved(before, after, finger) {
  const own = finger.joints.map(({name}) => name);
  const moved = after.jointNames.filter((_, i) => after.q[i] !== before.q[i]);
  assert(moved.length > 0 && moved.every((name) => own.includes(name)), `${after.name}: ${moved} moved`);
}

/// A drag in one view turns both.
async function oneCamera(report) {
  const cells = report.page.locator('.cell');
  const pictures = () => Promise.all([0, 1].map((i) => cells.nth(i).screenshot()));
  await report.settle();
  const before = await pictures(), {x, y, width, height} = await cells.nth(0).boundingBox();
  await report.page.mouse.move(x + width / 2, y + height / 2);
  await report.page.mouse.down();
  await report.page.mouse.move(x + width / 2 + 60, y + height / 2 + 20, {steps: 3});
  await report.page.mouse.up();
  await report.settle();
  (await pictures()).forEach((picture, i) => assert(!picture.equals(before[i]), `view ${i} did not turn`));
}

main(options()).catch((error) => {
  console.error(error);
  process.exit(1);
});
