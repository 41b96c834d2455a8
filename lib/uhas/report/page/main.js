// Puts the page together.
'use strict';

/// For tests: what the page computes. `ready` once the page stands; `error` says why it does not.
window.uhasReport = {ready: false, error: null, hands: []};

async function start() {
  const report = JSON.parse(document.getElementById('uhas-report').textContent);
  if (report.format !== 'uhas-report' || report.version !== 1) {
    throw new Error(`the document in this file is ${report.format} ${report.version}, not uhas-report 1`);
  }
  document.getElementById('title').textContent = report.title;
  const runtime = await UhasRuntime.load(bytesOf(report.wasm));
  const hands = report.hands.map((data) => new Hand(data, runtime));
  const session = new Session(hands);
  document.querySelector('main').hidden = false;
  layOut(session);
  Object.assign(window.uhasReport, {
    ready: true,
    hands: hands.map((hand, i) => ({
      name: hand.name, jointNames: hand.jointNames, q: () => Array.from(session.states[i].q),
      action: () => session.states[i].action,
    })),
    action: () => session.action,
    setAction: (values) => { session.action = values; },
  });
}

function layOut(session) {
  const [controls, views, details] = ['controls', 'views', 'details'].map((id) => document.getElementById(id));
  const stage = element('div', {class: 'stage'});
  const inputs = new InputsPanel(session);
  views.append(stage, legend());
  controls.append(posePanel(session), inputs.element);
  try {
    const viewer = new Viewer(stage, session);
    views.prepend(layersPanel(viewer, session));
    followTheme(viewer);
    viewer.lookFrom('oblique');
  } catch (error) {
    stage.classList.add('undrawn');
    stage.replaceChildren(element('p', {role: 'alert', class: 'failure'},
      `${sentence(error)} Inputs, tables and plots still work.`));
  }
  controls.append(solverPanel(session));
  if (session.timeline) {
    stage.after(new Timeline(session).element);
  }
  details.append(
    sectionElement('joints', 'Joints', ...session.hands.map((hand) => jointTable(session, hand))),
    sectionElement('lateral', 'Lateral tables', ...session.hands.map((hand) => lateralPlots(session, hand))),
    sectionElement('findings', 'Warnings and findings', ...session.hands.map(findingsOf)));
  const evaluated = session.hands.filter((hand) => hand.data.evaluation);
  if (evaluated.length) {
    details.append(sectionElement('evaluation', 'Evaluation',
      ...evaluated.map((hand) => evaluationElement(hand.data.evaluation, hand.name))));
  }
}

/// The drawing takes its colours from the style sheet, now and when the system turns dark or light.
function followTheme(viewer) {
  const take = () => {
    const style = getComputedStyle(document.documentElement);
    const colour = (name) => style.getPropertyValue(`--${name}`).trim();
    viewer.setTheme({mesh: colour('mesh'), ink: colour('ink'), paper: colour('paper')});
  };
  take();
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', take);
}

function sentence(error) {
  const text = error.message.charAt(0).toUpperCase() + error.message.slice(1);
  return /[.!?]$/.test(text) ? text : `${text}.`;
}

start().catch((error) => {
  window.uhasReport.error = error.message;
  const failure = document.getElementById('failure');
  failure.textContent = `This report cannot be shown. ${sentence(error)}`;
  failure.hidden = false;
});
