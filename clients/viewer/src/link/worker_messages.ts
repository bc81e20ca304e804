// What page and link worker say to each other. Each message from the worker is asked for, one at a time, so that nothing
// piles up before a page that is busy.

import type {DepthTold} from '../depth/depth_told';
import type {FrameTimes} from '../present/time_account';
import type {Instant} from '../present/instant';
import type {CaptureStatus, HandHolder, LetGo, Phase, ViewerHand} from './messages';

/** How link and site are, as of now. Times on now_ms(). */
export interface News {
  connected: boolean;
  everConnected: boolean;
  retryAt_ms: number | undefined;
  offset_ms: number | undefined;  // of the session clock
  link_ms: number | undefined;    // from the server's sending to this computer, smoothed
  heard: {published_ms: number; received_ms: number} | undefined;
  waiting: FrameTimes | undefined;
  capture: CaptureStatus | undefined;
  depth: DepthTold | undefined;
  stationHeard_ms: number | undefined;
  phase: Phase;  // the newest, whatever is presented
  surfaceStale: boolean;
  lateTicks: number | undefined;
  untaken_ms: number | undefined;  // when the server last said that no station takes our hand
  holder: HandHolder;
  viewer: bigint;      // this page's number at the server; 0n before it is told
  dropped: number;     // on the way here
  overtaken: number;   // here, before they were decoded
  undecodable: number;
}

export type ToWorker = {ask: 'instant' | 'news'} | {hand: ViewerHand | LetGo};
export type FromWorker = {instant: Instant} | {news: News};
