// Images that arrive over an impaired network, and the page's watch over them, both in virtual time.
import {execFileSync} from 'node:child_process';

/** Times of arrival [ms] of images over a profile of proto/impaired. `program`: telepalp-image-arrivals. */
export const imageArrivals = (program, profile, kilobytes, seconds) =>
    execFileSync(program, [profile, String(seconds), String(kilobytes)], {encoding: 'utf8', maxBuffer: 1 << 26})
        .trim().split('\n').map(Number);

/** The viewer's SilenceWatch on a clock that is moved by hand; `marks`: times at which a silence was noticed. */
export function watchWith(SilenceWatch) {
  const seen = {now_ms: 0, due_ms: Infinity, call: undefined, marks: [], changes: 0};
  const watch = new SilenceWatch({
    now_ms: () => seen.now_ms,
    setTimer: (call, after_ms) => {
      seen.due_ms = seen.now_ms + after_ms;
      seen.call = call;
    },
    changed: () => {
      ++seen.changes;
      if (watch.since_ms !== undefined) seen.marks.push(seen.now_ms);
    },
  });
  watch.restart();
  const passTo = (at_ms) => {
    while (seen.due_ms <= at_ms) {
      seen.now_ms = seen.due_ms;
      seen.due_ms = Infinity;
      seen.call();
    }
    seen.now_ms = at_ms;
  };
  return {seen, watch, passTo, image: (at_ms) => {
    passTo(at_ms);
    watch.imageCame();
  }};
}
