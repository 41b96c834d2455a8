// The solutions of the document in a row: scrub and play.
'use strict';

const kRates = [1, 2, 5, 10, 30, 60];  // solutions a second

class Timeline {
  /// @param session  one with a timeline
  constructor(session) {
    this.session = session;
    this.count = session.timeline.actions.length;
    this.button = element('button', {type: 'button', id: 'timeline-play', onclick: () => this.#toggle()}, 'Play');
    this.slider = element('input', {type: 'range', id: 'timeline-frame', min: 0, max: this.count - 1, step: 1,
      'aria-label': 'Solution', oninput: () => { session.stop(); session.showFrame(this.slider.valueAsNumber); }});
    this.rate = element('select', {id: 'timeline-rate', 'aria-label': 'Solutions a second'},
      ...kRates.map((rate) => element('option', {value: rate}, `${rate}/s`)));
    this.rate.value = 10;
    this.output = element('output', {for: 'timeline-frame'});
    this.element = element('div', {class: 'timeline', role: 'group', 'aria-label': 'Timeline'},
      this.button, this.slider, this.output, this.rate);
    session.onChange(() => this.#update());
    session.showFrame(0);
  }

  #toggle() {
    const {session} = this;
    if (session.animation !== null) {
      session.stop();
      return;
    }
    const first = session.frame === this.count - 1 ? 0 : session.frame;
    session.play((seconds) => {
      const frame = Math.min(first + Math.floor(seconds * this.rate.value), this.count - 1);
      if (frame !== session.frame || session.pose !== 'timeline') session.showFrame(frame);
      return frame < this.count - 1;
    });
  }

  #update() {
    const {session} = this, shown = session.pose === 'timeline';
    this.button.textContent = session.animation === null ? 'Play' : 'Pause';
    this.slider.value = session.frame;
    this.output.textContent = `${session.frame + 1} of ${this.count}${shown ? '' : ', not shown'}`;
    this.slider.setAttribute('aria-valuetext', this.output.textContent);
  }
}
