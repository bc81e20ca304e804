import type {HandHolder} from './generated';

/** No viewer holds the hand, and none asks for it. */
export const NOBODY: HandHolder = {stampNs: 0n, viewer: 0n, asking: []};
