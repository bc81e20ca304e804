// One instant is presented at a time: picture, hand, force and numbers belong together. The station tells of itself 100
// times a second, so that the word nearest to a picture's exposure lies within half a period of it.

/** Half a period of /station/state. */
const TOGETHER_NS = 5_000_000n;
/** A station whose word is further behind the pictures is not waited for. */
const LONGEST_WAIT_NS = 500_000_000n;
/** Numbers go on alone when the newest picture is older than the station's newest word by this. */
const ALONE_NS = 250_000_000n;

/** Pictures captured until then can be presented: the station's word of their instant has come, or is not waited for. */
export function presentableUntil(newestStamp_ns: bigint | undefined, newestCapture_ns: bigint): bigint {
  if (newestStamp_ns === undefined || newestCapture_ns - newestStamp_ns > LONGEST_WAIT_NS) return newestCapture_ns;
  return newestStamp_ns + TOGETHER_NS;
}

/** Whether the station's word is presented without a new picture, because none comes. */
export function goesAlone(stamp_ns: bigint, presentedCapture_ns: bigint | undefined): boolean {
  return presentedCapture_ns === undefined || stamp_ns - presentedCapture_ns > ALONE_NS;
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
