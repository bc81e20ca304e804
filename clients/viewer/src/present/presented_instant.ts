// One instant is presented at a time: picture, hand, force and numbers belong together. The station sends its state 100
// times a second, so the state nearest to a picture's exposure is at most half a period (5 ms) away.

/** Half a period of /station/state. */
const TOGETHER_NS = 5_000_000n;
/** If the station's values are later than the pictures by more than this, the viewer does not wait for them. */
const LONGEST_WAIT_NS = 500_000_000n;
/**
 * If the newest picture is older than the station's newest values by more than this, the values are presented without a
 * new picture.
 */
const WITHOUT_PICTURE_NS = 250_000_000n;

/**
 * Pictures captured until this time can be presented: the station's values of their instant have arrived, or the viewer
 * does not wait for them.
 */
export function presentableUntil(newestStamp_ns: bigint | undefined, newestCapture_ns: bigint): bigint {
  if (newestStamp_ns === undefined || newestCapture_ns - newestStamp_ns > LONGEST_WAIT_NS) return newestCapture_ns;
  return newestStamp_ns + TOGETHER_NS;
}

/** Picture and values that are further apart than this do not belong together. */
const APART_NS = 30_000_000n;
/** A page skips pictures without values of their instant for this long. Then it presents the picture with the nearest. */
const LONGEST_SKIP_NS = 1_000_000_000n;

/**
 * True when a picture falls into a gap of the station's values, and is skipped: values before and after it have arrived,
 * and the nearest of them, of time `stamp_ns`, is too far from the picture's.
 */
export function fallsInGap(
    capture_ns: bigint, stamp_ns: bigint, newestStamp_ns: bigint, presentedCapture_ns: bigint | undefined): boolean {
  if (newestStamp_ns < capture_ns) return false;
  const off_ns = stamp_ns < capture_ns ? capture_ns - stamp_ns : stamp_ns - capture_ns;
  return off_ns > APART_NS && presentedCapture_ns !== undefined && capture_ns - presentedCapture_ns < LONGEST_SKIP_NS;
}

/** For this long after the station's first values, the viewer waits for the first picture: it takes time to draw both. */
const FIRST_PICTURE_NS = 1_000_000_000n;

/**
 * True when the station's values are presented without a new picture, because no picture comes. `first_ns`: the time of
 * the first values.
 */
export function continuesWithoutPicture(
    stamp_ns: bigint, presentedCapture_ns: bigint | undefined, first_ns: bigint): boolean {
  if (presentedCapture_ns === undefined) return stamp_ns - first_ns > FIRST_PICTURE_NS;
  return stamp_ns - presentedCapture_ns > WITHOUT_PICTURE_NS;
}

/** The item whose time is nearest to `at_ns`; undefined when there is none. */
export function nearest<Item>(items: readonly Item[], timeOf: (item: Item) => bigint, at_ns: bigint): Item | undefined {
  const distance = (item: Item) => {
    const off = timeOf(item) - at_ns;
    return off < 0n ? -off : off;
  };
  return items.reduce<Item | undefined>(
      (best, item) => (best === undefined || distance(item) <= distance(best) ? item : best), undefined);
}
