// The scale of every drawing of a touch, as in proto/words/drawn_sizes.h.
export const ARROW_M_PER_N = 0.02;
export const BALL_RADIUS_M = 0.03;
