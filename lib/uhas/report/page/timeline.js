// The solutions of the document in a row: scrub and play.
'use strict';

const kRates = [1, 2, 5, 10, 30, 60];  // solutions a second

class Timeline {
  /// @param session  one with a timeline
  constructor(session) {
    this.session = session;
    this.count = session.timeline.actions.length;
    this.playing = null;  // the pending animation frame
    this.button = element('button', {type: 'button', id: 'timeline-play', onclick: () => this.#toggle()}, 'Play');
    this.slider = element('input', {type: 'range', id: 'timeline-frame', min: 0, max: this.count - 1, step: 1, 'aria-label': 'Solution',
      oninput: () => { this.stop(); session.showFrame(this.slider.valueAsNumber); }});
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
    if (this.playing !== null) {
      this.stop();
      return;
    }
    const first = this.session.frame === this.count - 1 ? 0 : this.session.frame, start = performance.now();
    const step = (now) => {
      const frame = first + Math.floor(Math.max(now - start, 0) / 1000 * this.rate.value);
      this.playing = frame < this.count - 1 ? requestAnimationFrame(step) : null;
      if (frame !== this.session.frame || this.session.pose !== 'timeline') this.session.showFrame(Math.min(frame, this.count - 1));
      this.#label();
    };
    this.playing = requestAnimationFrame(step);
    this.#label();
  }

  stop() {
    if (this.playing !== null) cancelAnimationFrame(this.playing);
    this.playing = null;
    this.#label();
  }

  #label() {
    this.button.textContent = this.playing === null ? 'Play' : 'Pause';
  }

  #update() {
    if (this.session.pose !== 'timeline' && this.playing !== null) this.stop();
    this.slider.value = this.session.frame;
    this.output.textContent = `${this.session.frame + 1} of ${this.count}` +
      (this.session.pose === 'timeline' ? '' : ', left for the pose chosen');
    this.slider.setAttribute('aria-valuetext', this.output.textContent);
  }
}
