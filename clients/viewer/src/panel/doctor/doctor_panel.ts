import {element} from '../../page/page';
import type {Reading} from '../../state/viewer_state';
import {presenceRows} from '../presence_rows';
import {RowList} from '../../page/rows';
import {compensationRows} from './compensation_rows';
import {delayRows} from './delay_rows';

/** The doctor's cards: who is here, the way of a frame to the hand, and what is compensated. */
export class DoctorPanel {
  private readonly presence = new RowList(element('presence'));
  private readonly delay = new RowList(element('delay'));
  private readonly compensated = new RowList(element('compensated'));

  show({presence, surfaceReport, compensation, station}: Reading): void {
    this.presence.show(presenceRows(presence));
    this.delay.show(delayRows(surfaceReport));
    this.compensated.show(compensationRows(compensation, station));
  }
}
