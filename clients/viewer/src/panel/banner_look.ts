/** A text above the picture. */
export interface Banner {
  level: 'wait' | 'warn' | 'alarm';
  title: string;
  text: string;
  rearms?: boolean;  // with a button that re-arms the station
  acceptsObject?: boolean;  // with a button by which the doctor accepts the object over the place as skin
}
