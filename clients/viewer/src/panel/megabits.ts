const MEGABIT = 1e6 / 8;

/** A rate in bytes per second, in the words of a network: "9.6 Mbit/s". */
export const megabits = (bytes_per_s: number, digits = 1) => `${(bytes_per_s / MEGABIT).toFixed(digits)} Mbit/s`;
