// A report in a headless browser that notes whatever the page asks for or complains of.
'use strict';

const assert = require('node:assert');
const fs = require('node:fs');
const path = require('node:path');
const {pathToFileURL} = require('node:url');
const {skip} = require('./tools.js');

const CHROMIUM = '/usr/bin/chromium';
const SOFTWARE_WEBGL = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
const NO_WEBGL = ['--disable-gpu', '--disable-3d-apis'];
const TOLERANCE = 1e-4;  // of joint values, rad or m

/// @param modules  the folder that set_up.py filled
async function launch(modules, {webgl = true} = {}) {
  const playwright = path.join(path.resolve(modules), 'node_modules/playwright-core');
  if (!fs.existsSync(playwright) || !fs.existsSync(CHROMIUM)) skip('playwright-core or chromium is not installed');
  return require(playwright).chromium.launch({executablePath: CHROMIUM, args: webgl ? SOFTWARE_WEBGL : NO_WEBGL});
}

class ReportPage {
  /// Opens a report from its file and waits until it stands.
  static async open(browser, html, context = {}) {
    const report = new ReportPage();
    report.url = pathToFileURL(html).href;
    report.requests = [];
    report.complaints = [];
    report.page = await browser.newPage({viewport: {width: 1280, height: 800}, colorScheme: 'light', ...context});
    report.page.on('request', (request) => report.requests.push(request.url()));
    report.page.on('console', (message) => report.complaints.push(`${message.type()}: ${message.text()}`));
    report.page.on('pageerror', (error) => report.complaints.push(`uncaught: ${error.message}`));
    await report.page.addInitScript(() => {
      const request = window.requestAnimationFrame.bind(window);
      window.framesAsked = 0;
      window.requestAnimationFrame = (draw) => { ++window.framesAsked; return request(draw); };
    });
    await report.page.goto(report.url);
    await report.page.waitForFunction(() => window.uhasReport.ready || window.uhasReport.error !== null);
    return report;
  }

  /// What the page computes of each hand now: {name, jointNames, q, action}.
  hands() {
    return this.page.evaluate(() => window.uhasReport.hands.map(
      ({name, jointNames, q, action}) => ({name, jointNames, q: q(), action: action()})));
  }

  error() {
    return this.page.evaluate(() => window.uhasReport.error);
  }

  setAction(values) {
    return this.page.evaluate((action) => window.uhasReport.setAction(action), values);
  }

  /// Waits until nothing is left to be drawn.
  async settle() {
    await this.page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  }

  /// A picture of the drawing alone, as bytes.
  async drawing() {
    await this.settle();
    return this.page.locator('.stage').screenshot();
  }

  async picture(file, settings = {}) {
    await this.settle();
    return this.page.screenshot({path: file, ...settings});
  }

  /// The page's joint values are those of `uhas-solve` for the action that the page says it solved.
  async assertSolved(tools, hands, ...words) {
    const shown = await this.hands();
    shown.forEach((state, i) => {
      const {joint_names: names, solutions} = tools.solve(hands[i], [state.action], ...words);
      assertJoints(state, names, solutions[0].q);
    });
    return shown;
  }

  /// The file asked for nothing but itself, and complained of nothing.
  assertQuiet() {
    assert.deepStrictEqual(this.requests, [this.url]);
    assert.deepStrictEqual(this.complaints, []);
  }

  /// Nothing is drawn while nothing changes.
  async assertIdle() {
    await this.settle();
    const before = await this.page.evaluate(() => window.framesAsked);
    await this.page.waitForTimeout(300);
    const after = await this.page.evaluate(() => window.framesAsked);
    assert.strictEqual(after, before, 'frames were asked for while nothing changed');
  }
}

function assertJoints({name, jointNames, q}, expectedNames, expected) {
  assert.deepStrictEqual(jointNames, expectedNames);
  jointNames.forEach((joint, i) => assert(Math.abs(q[i] - expected[i]) <= TOLERANCE,
    `${name}: ${joint} is ${q[i]} in the page and ${expected[i]} by uhas-solve`));
}

module.exports = {ReportPage, assertJoints, launch};
