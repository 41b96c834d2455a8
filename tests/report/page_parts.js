// The parts of the page that do not depend on the hand: layers, standpoints, the animation, numbers as text, options of
// the solver; the page in the dark, in a narrow window, without WebGL, without a model, and around a document that it
// cannot show.
//
//   node page_parts.js --bin BIN --folder FOLDER
'use strict';

const assert = require('node:assert');
const fs = require('node:fs');
const path = require('node:path');
const {ReportPage, launch} = require('./browser.js');
const {Tools, options} = require('./tools.js');

const MOST_PICTURE_BYTES = 400e3;  // of the picture for the README
const SMALL = {width: 900, height: 600};  // the drawing is compared often and rendered in software
const GENTLE = [0.25, 0.1, 0, -0.15, 0, -0.1, -0.35, 0, -0.1, 0, 0, -0.15, -0.45, -0.2, -0.3];

async function main({bin, folder}) {
  const tools = new Tools(bin, path.join(folder, 'page_parts'));
  const hand = tools.hand('shadow_right');
  const html = tools.report('report.html', hand);
  let browser = await launch(folder);
  try {
    const report = await ReportPage.open(browser, html);
    await thePicture(report, tools);
    await report.page.setViewportSize(SMALL);
    await theLayers(report);
    await theStandpoints(report);
    await theAnimation(report, tools, hand);
    await theNumbers(report);
    await theSolverOptions(report, tools, hand);
    await theColours(report, tools, hand);
    report.assertQuiet();
    await report.page.close();
    await theDark(browser, html, tools);
    await aNarrowWindow(browser, html, tools);
    await noModel(browser, hand, tools);
    await anEvaluation(browser, html, tools);
    await aForeignDocument(browser, html, tools);
    await browser.close();
    browser = await launch(folder, {webgl: false});
    await noWebgl(browser, html, tools, hand);
  } finally {
    await browser.close();
  }
}

/// docs/report.png is this picture.
async function thePicture(report, tools) {
  await report.setAction(GENTLE);
  const picture = await report.picture(tools.file('report.png'));
  assert(picture.length < MOST_PICTURE_BYTES, `report.png has ${picture.length} bytes`);
}

/// Each layer draws something, which its box hides and brings back.
async function theLayers(report) {
  const boxes = await report.page.locator('.checks input').evaluateAll((inputs) => inputs.map(({id}) => id));
  assert(boxes.length >= 9);
  const before = await report.drawing();
  for (const id of boxes) {
    await report.page.click(`#${id}`);
    assert(!(await report.drawing()).equals(before), `${id} changes nothing`);
    await report.page.click(`#${id}`);
  }
  assert((await report.drawing()).equals(before), 'the boxes do not bring back what they hid');
}

async function theStandpoints(report) {
  const pictures = [];
  for (const name of ['palm', 'back', 'side', 'tips', 'oblique']) {
    await report.page.click(`#view-${name}`);
    const picture = await report.drawing();
    assert(pictures.every((other) => !other.equals(picture)), `${name} is no other view`);
    pictures.push(picture);
  }
}

/// One finger after the other closes, until all are closed; a click elsewhere ends it.
async function theAnimation(report, tools, hand) {
  await report.page.click('#preset-close');
  await report.page.waitForFunction(() => window.uhasReport.action()[5] === -2 && window.uhasReport.action()[14] === 0);
  await report.assertSolved(tools, [hand]);
  await report.page.waitForFunction(() => window.uhasReport.action().slice(5).every((value) => value === -2));
  await report.page.click('#preset-close');
  await report.page.click('#preset-zero');
  assert((await report.hands())[0].action.every((value) => value === 0));
  await report.assertIdle();
}

/// An action is read as it is written, and a wrong one refused.
async function theNumbers(report) {
  const text = report.page.locator('#action-text');
  await text.fill(JSON.stringify(GENTLE));
  await text.press('Enter');
  const [{action}] = await report.hands();
  GENTLE.forEach((value, i) => assert(Math.abs(action[i] - value) < 1e-12, `number ${i} became ${action[i]}`));
  assert.deepStrictEqual(JSON.parse(await text.inputValue()), GENTLE);
  for (const wrong of ['[1, 2]', 'zero', '[0,0,0,0,0,0,0,0,0,0,0,0,0,0,null]']) {
    await text.fill(wrong);
    await text.press('Enter');
    assert.match(await text.evaluate((input) => input.validationMessage), /15 numbers/);
    assert.deepStrictEqual((await report.hands())[0].action, action);
  }
}

async function theSolverOptions(report, tools, hand) {
  await report.page.click('.solver summary');
  await report.page.selectOption('#solver-passes', '3');
  await report.assertSolved(tools, [hand], '--passes', '3');
  await report.page.selectOption('#solver-field', 'field');
  await report.assertSolved(tools, [hand], '--passes', '3', '--field', 'field');
  await report.page.selectOption('#solver-rule', 'contact');
  await report.page.selectOption('#solver-closing', 'hard');
  await report.assertSolved(tools, [hand], '--rule', 'contact', '--closing', 'hard', '--field', 'field');
}

/// A place on the sphere has one colour in the page and in the files for other programs.
async function theColours(report, tools, hand) {
  const file = tools.file('points.ply');
  tools.run('uhas-inspect', hand.profile, '--ply', file);
  const [header, body] = fs.readFileSync(file, 'latin1').split('end_header\n');
  assert.match(header, /format ascii/);
  const names = [...header.matchAll(/^property \S+ (\S+)$/gm)].map(([, name]) => name);
  const points = body.trim().split('\n').filter((_, i) => i % 97 === 0)
    .map((line) => Object.fromEntries(line.split(' ').map((word, i) => [names[i], Number(word)])));
  assert(points.length > 20);
  const colours = await report.page.evaluate(
    (places) => places.map(({theta, phi}) => sphereColour(theta, phi).map((value) => 255 * value)), points);
  points.forEach(({red, green, blue}, i) => [red, green, blue].forEach((value, channel) =>
    assert(Math.abs(value - colours[i][channel]) <= 0.51, `${[red, green, blue]} in the file, ${colours[i]} in the page`)));
}

async function theDark(browser, html, tools) {
  const report = await ReportPage.open(browser, html, {colorScheme: 'dark'});
  await report.page.click('#preset-spread');
  await report.picture(tools.file('dark.png'));
  const dark = await report.drawing();
  await report.page.emulateMedia({colorScheme: 'light'});
  assert(!(await report.drawing()).equals(dark), 'the drawing does not follow the colour scheme');
  report.assertQuiet();
  await report.page.close();
}

async function aNarrowWindow(browser, html, tools) {
  const report = await ReportPage.open(browser, html, {viewport: {width: 400, height: 800}});
  await report.picture(tools.file('narrow.png'), {fullPage: true});
  const width = await report.page.evaluate(() => document.documentElement.scrollWidth);
  assert(width <= 400, `the page is ${width} pixels wide in a window of 400`);
  report.assertQuiet();
  await report.page.close();
}

/// Without a model, points and skeleton stand for the hand. No URDF lies beside the profile.
async function noModel(browser, hand, tools) {
  const html = tools.file('no_model.html');
  tools.run('uhas-inspect', hand.profile, '--html', html);
  const report = await ReportPage.open(browser, html);
  assert.strictEqual(await report.error(), null);
  assert(await report.page.isChecked('#layer-skeleton'));
  await report.page.click('#preset-spread');
  await report.assertSolved(tools, [hand]);
  await report.picture(tools.file('no_model.png'));
  report.assertQuiet();
  await report.page.close();
}

/// Scores of any shape are shown: records as rows, numbers in a row as bars, what is nested under its own heading.
async function anEvaluation(browser, html, tools) {
  const evaluated = tools.file('evaluated.html');
  const scores = {
    format: 'some-scores', version: 1, actions: 1000,
    fit: [{finger: 'index', median: 0.012, p95: 0.13}, {finger: 'thumb', median: 0.024, p95: null}],
    reach: {index: {share: 0.9, dead: false}, thumb: {share: 0.45, dead: true}},
    time: {median_ns: 2300, histogram: [1, 4, 9, 3]},
  };
  const text = fs.readFileSync(html, 'utf8');
  assert(text.includes('"evaluation":null'));
  fs.writeFileSync(evaluated, text.replace('"evaluation":null', `"evaluation":${JSON.stringify(scores)}`));
  const report = await ReportPage.open(browser, evaluated);
  const section = report.page.locator('#evaluation');
  assert.deepStrictEqual(await section.locator('h3').allTextContents(), ['fit', 'reach', 'time', 'histogram']);
  const rows = await section.locator('tbody tr').evaluateAll(
    (all) => all.map(({cells}) => Array.from(cells, (cell) => cell.textContent).join(' ')));
  assert.deepStrictEqual(rows, ['actions 1000', 'index 0.012 0.13', 'thumb 0.024 none', 'index 0.9 no', 'thumb 0.45 yes',
    'median ns 2300']);
  const shares = await section.locator('.bar').evaluateAll((bars) => bars.map((bar) => bar.style.getPropertyValue('--share')));
  assert.deepStrictEqual(shares, ['50.0%', '100.0%', '100.0%', '100.0%', '50.0%']);
  const heights = await section.locator('svg rect').evaluateAll((bars) => bars.map((bar) => Number(bar.getAttribute('height'))));
  assert.deepStrictEqual(heights.map((height) => Math.round(9 * height / heights[2])), [1, 4, 9, 3]);
  await section.scrollIntoViewIfNeeded();
  await report.picture(tools.file('evaluation.png'));
  report.assertQuiet();
  await report.page.close();
}

/// A document of another version, or a damaged hand, is refused in words.
async function aForeignDocument(browser, html, tools) {
  const text = fs.readFileSync(html, 'utf8'), foreign = tools.file('foreign.html');
  const version = [/"format":"uhas-report","version":1/, '"format":"uhas-report","version":2', /uhas-report 2/];
  const image = [/"image":"[^"]{400}/, '"image":"', /hand|profile/];
  for (const [from, to, words] of [version, image]) {
    assert.match(text, from);
    fs.writeFileSync(foreign, text.replace(from, to));
    const report = await ReportPage.open(browser, foreign);
    assert.match(await report.error(), words);
    assert.match(await report.page.textContent('#failure'), /cannot be shown/);
    assert(await report.page.isVisible('#failure'));
    report.assertQuiet();
    await report.page.close();
  }
}

/// The rest of the page works where nothing can be drawn.
async function noWebgl(browser, html, tools, hand) {
  const report = await ReportPage.open(browser, html);
  assert.strictEqual(await report.error(), null);
  assert.match(await report.page.textContent('.stage'), /no WebGL/);
  await report.page.click('#preset-closed');
  await report.assertSolved(tools, [hand]);
  await report.picture(tools.file('no_webgl.png'));
  report.assertQuiet();
}

main(options()).catch((error) => {
  console.error(error);
  process.exit(1);
});
