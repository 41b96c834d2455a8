// The built tools and the hands: profiles, reports and solutions for the tests of the page.
'use strict';

const assert = require('node:assert');
const {execFileSync} = require('node:child_process');
const fs = require('node:fs');
const path = require('node:path');

const ROOT = path.resolve(__dirname, '../..');
const SKIPPED = 77;  // ctest's SKIP_RETURN_CODE of these tests
const MOST_BYTES = 5e6;  // of a report on one hand

/// The options --name value of the command line.
function options() {
  const words = process.argv.slice(2), found = {};
  for (let i = 0; i < words.length; i += 2) found[words[i].replace(/^--/, '')] = words[i + 1];
  return found;
}

function skip(reason) {
  console.log(`SKIPPED: ${reason}`);
  process.exit(SKIPPED);
}

/// The URDF of a hand in hands/, or of a real one (`real/<name>`) in UHAS_HANDS_DIR; skips when that is not set.
function urdfOf(hand) {
  if (!hand.startsWith('real/')) return path.join(ROOT, 'hands', hand, `${hand}.urdf`);
  if (process.env.UHAS_HANDS_DIR === undefined) skip('UHAS_HANDS_DIR is not set');
  const folder = path.join(process.env.UHAS_HANDS_DIR, path.basename(hand));
  return path.join(folder, JSON.parse(fs.readFileSync(path.join(folder, 'truth.json'))).urdf);
}

/// Runs the tools of a folder and keeps what they write in another.
class Tools {
  constructor(bin, folder) {
    this.bin = bin;
    this.folder = folder;
    fs.mkdirSync(folder, {recursive: true});
  }

  run(tool, ...words) {
    return execFileSync(path.join(this.bin, tool), words, {encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe']});
  }

  file(name) {
    return path.join(this.folder, name);
  }

  /// {name, urdf, profile, summary} of a hand as in urdfOf.
  hand(name) {
    const urdf = urdfOf(name), profile = this.file(`${path.basename(name)}.h5`);
    this.run('uhas-build-profile', '--quiet', urdf, '-o', profile);
    return {name, urdf, profile, summary: JSON.parse(this.run('uhas-inspect', profile, '--json'))};
  }

  /// The report on hands, as a file.
  report(name, ...hands) {
    const html = this.file(name);
    this.run('uhas-inspect', ...hands.map((hand) => hand.profile), '--html', html,
      ...hands.flatMap((hand) => ['--urdf', hand.urdf]));
    if (hands.length === 1) assert(fs.statSync(html).size < MOST_BYTES, `${html} is larger than ${MOST_BYTES} bytes`);
    return html;
  }

  /// What uhas-solve answers to actions of a hand: {joint_names, solutions}.
  solve(hand, actions, ...words) {
    const file = this.file('actions.json');
    fs.writeFileSync(file, JSON.stringify({format: 'uhas-actions', version: 1, actions}));
    return JSON.parse(this.run('uhas-solve', file, '--profile', hand.profile, ...words));
  }
}

module.exports = {ROOT, Tools, options, skip};
