// The frame that the whole page looks at, and playing through the frames by their timestamps.

export function createPlayhead(frames) {
  const listeners = new Set();
  const state = { frame: Math.max(0, frames.count - 1), playing: false, speed: 1 };
  let seconds = 0, before = 0; // the clock of playing, and when it was read last

  const tell = () => listeners.forEach((listener) => listener(state));

  function show(frame) {
    state.frame = Math.min(Math.max(0, frames.count - 1), Math.max(0, Math.round(frame)));
    tell();
  }

  function seek(frame) {
    show(frame);
    seconds = frames.time_s[state.frame];
  }

  function pause() {
    state.playing = false;
    tell();
  }

  function tick(now) {
    if (!state.playing) return;
    seconds += (state.speed * (now - before)) / 1000;
    before = now;
    let frame = state.frame;
    while (frame + 1 < frames.count && frames.time_s[frame + 1] <= seconds) ++frame;
    if (frame !== state.frame) show(frame);
    if (state.frame >= frames.count - 1) pause();
    else requestAnimationFrame(tick);
  }

  function play() {
    if (state.playing || frames.count < 2) return;
    state.playing = true;
    seek(state.frame >= frames.count - 1 ? 0 : state.frame);
    before = performance.now();
    requestAnimationFrame(tick);
  }

  return {
    state,
    seek,
    play,
    pause,
    toggle: () => (state.playing ? pause() : play()),
    setSpeed(speed) { state.speed = speed; },
    /// Called now and on every change.
    watch(listener) {
      listeners.add(listener);
      listener(state);
    },
  };
}
