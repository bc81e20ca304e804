import {fitOffset, pairsFile, type Touch} from '../../calibration/offset_fit';
import {type Taking, TOUCHES_OF_A_PLACE} from '../../calibration/touch_taker';
import {element, setText} from '../../page/page';
import {saveFile} from '../../page/save_file';
import {RowList} from '../../page/rows';
import {fitRows, placeRows, verdict} from './calibration_rows';

const MOST_PLACES = 20;

/**
 * Walks through the calibration of paper S1, eq. (2) to (4): the hand rests on the end-effector at some places, the
 * residuals are shown, and the pairs are saved as a file for `telepalp-station calibrate`.
 */
export class CalibrationCard {
  private readonly card = element('calibration');
  private readonly places = new RowList(element('calibration-places'));
  private readonly fit = new RowList(element('calibration-fit'));
  private readonly button = element<HTMLButtonElement>('calibration-take');
  private readonly again = element<HTMLButtonElement>('calibration-again');
  private readonly save = element<HTMLButtonElement>('calibration-save');
  private touches: Touch[] = [];
  private taken = 0;  // places
  private taking = false;

  /** `take` asks for the touches of a place; undefined: of none. They come by `add`. */
  constructor(private readonly take: (place: number | undefined) => void) {
    this.button.addEventListener('click', () => this.begin());
    this.again.addEventListener('click', () => this.clear());
    this.save.addEventListener('click', () => saveFile('pairs.csv', 'text/csv', pairsFile(this.touches)));
    this.write();
  }

  /** `taking`: undefined without a live station whose tracker is calibrated. */
  show(taking: Taking | undefined): void {
    this.card.hidden = taking === undefined;
    if (taking === undefined || !this.taking) return;
    const progress = `${taking.taken} of ${TOUCHES_OF_A_PLACE} pairs. Keep the hand still.`;
    setText(element('calibration-said'), taking.problem === '' ? progress : taking.problem);
  }

  /** The touches of a place have come. */
  add(touches: readonly Touch[]): void {
    if (!this.taking) return;
    this.taking = false;
    ++this.taken;
    this.touches = [...this.touches, ...touches];
    this.write();
  }

  private begin(): void {
    this.taking = true;
    this.take(this.taken + 1);
    this.write();
  }

  private clear(): void {
    this.take(undefined);
    this.taking = false;
    this.touches = [];
    this.taken = 0;
    this.write();
  }

  private write(): void {
    const fit = fitOffset(this.touches);
    this.places.show(placeRows(fit));
    this.fit.show(fitRows(fit));
    setText(this.button, `Measure place ${this.taken + 1}`);
    this.button.disabled = this.taking || this.taken === MOST_PLACES;
    this.again.disabled = this.taken === 0 && !this.taking;
    this.save.disabled = fit === undefined;
    setText(element('calibration-verdict'), verdict(fit));
    if (!this.taking) setText(element('calibration-said'), this.taken === 0 ? '' : `Places measured: ${this.taken}.`);
  }
}
