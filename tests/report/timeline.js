// The report on a file of actions: the timeline shows the solutions of uhas-solve, by scrubbing and by playing, and the
// page solves with the options that made them.
//
//   node timeline.js --bin BIN --folder FOLDER
'use strict';

const assert = require('node:assert');
const path = require('node:path');
const {ReportPage, assertJoints, launch} = require('./browser.js');
const {ROOT, Tools, options} = require('./tools.js');

const SOLVER = ['--rule', 'contact', '--closing', 'hard'];  // not the defaults

async function main({bin, folder}) {
  const tools = new Tools(bin, path.join(folder, 'timeline'));
  const hand = tools.hand('allegro_right'), html = tools.file('report.html');
  const actions = path.join(ROOT, 'examples/first_actions.json');
  const solve = ['uhas-solve', actions, '--profile', hand.profile, ...SOLVER];
  const {joint_names: names, solutions} = JSON.parse(tools.run(...solve));
  tools.run(...solve, '--html', html, '--urdf', hand.urdf, '-o', tools.file('q.json'));
  const browser = await launch(folder);
  try {
    const report = await ReportPage.open(browser, html);
    assert.strictEqual(await report.error(), null);
    const shows = async (frame) => assertJoints((await report.hands())[0], names, solutions[frame].q);
    await shows(0);
    await report.page.focus('#timeline-frame');
    for (let frame = 1; frame < solutions.length; ++frame) {
      await report.page.keyboard.press('ArrowRight');
      await shows(frame);
    }

    // plays from the beginning to the end, and stops there
    await report.page.selectOption('#timeline-rate', '30');
    await report.page.click('#timeline-play');
    await report.page.waitForFunction(() => document.getElementById('timeline-play').textContent === 'Play' &&
      document.getElementById('timeline-frame').value === document.getElementById('timeline-frame').max);
    await shows(solutions.length - 1);
    await report.picture(tools.file('last.png'));

    // an input moved by hand is solved as the solutions were
    await report.page.focus('#r-2-1');
    await report.page.keyboard.press('PageUp');
    await report.assertSolved(tools, [hand], ...SOLVER);
    await report.assertIdle();
    report.assertQuiet();
  } finally {
    await browser.close();
  }
}

main(options()).catch((error) => {
  console.error(error);
  process.exit(1);
});
