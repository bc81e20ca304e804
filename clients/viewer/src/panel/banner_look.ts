/** A text above the picture. */
export interface Banner {
  level: 'wait' | 'warn' | 'alarm';
  title: string;
  text: string;
  rearms?: boolean;  // with a button that re-arms the station
}
