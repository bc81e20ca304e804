#pragma once

#include <stdint.h>

#include "codec/entropy/range_coder.h"

// Internal linkage for the same reason as in range_coder.h.

namespace telepalp::codec {

/// The trained part of the codec: contexts that behave alike share a model, and each model starts where frames like
/// those it was trained on left it. Generated; see codec/training/.
struct ContextTables {
  const uint8_t* group_of;  ///< of each of kContexts, for each of kBeyondClasses
  const Model*
      models;  ///< as they are at the start of a slice; one a group, kBeforeClasses a group in dependent frames
  int count;   ///< of models
};

namespace {

/// What a pixel can be, as seen from its prediction.
enum Symbol : int {
  kAsPredicted = 0,
  kNotMeasured = 1,
  kFirstStep = 2,  // +1, −1, +2, −2 … +6, −6
  kFarther = 14,   // a number and a sign follow
};
constexpr int kLargestStep = 6;

/// A model moves 1/64 of the way to what it sees; where a frame stands alone half as far once a slice is some way down,
/// as what it has learnt by then is worth more.
constexpr int kLearningRate = 6;
constexpr int kSettledRate = 7;
constexpr int kFirstSettledRow = 30;

constexpr int learning_rate(bool is_dependent, int row) {
  return !is_dependent && row >= kFirstSettledRow ? kSettledRate : kLearningRate;
}

/// Step of each symbol from the prediction. A pixel that was not measured is filled with its prediction.
constexpr int8_t kStepOf[16] = {0, 0, 1, -1, 2, -2, 3, -3, 4, -4, 5, -5, 6, -6, 0, 0};

/// Symbol of each step from −7 to 7.
constexpr uint8_t kSymbolOf[15] = {14, 13, 11, 9, 7, 5, 3, 0, 2, 4, 6, 8, 10, 12, 14};

/// A context is made of which of the pixels west, north, north-west and north-east were measured (16), and of four
/// differences between neighbours, each in five classes: beyond −1, −1, 0, 1, beyond 1. Neighbours that were not
/// measured count as filled.
constexpr int kWestClass = 5;
constexpr int kNorthClass = 125;
constexpr int kWestMeasured = 625;
constexpr int kNorthMeasured = 1250;
constexpr int kContexts = 10000;

inline int bounded(int value, int most) { return value < -most ? -most : value > most ? most : value; }

/// The median edge detector of LOCO-I (Weinberger, Seroussi, Sapiro 2000).
inline int predict(int west, int north, int north_west) {
  const int low = west < north ? west : north;
  const int high = west < north ? north : west;
  const int slope = west + north - north_west;
  const int bounded_slope = slope < high ? slope : high;
  return bounded_slope > low ? bounded_slope : low;
}

/// The share of a context that the row above decides. Pointers to the pixel above; `filled` has no gaps, `measured`
/// is 0 where there was one.
inline int context_from_above(const uint16_t* filled, const uint16_t* measured) {
  const int classes =
      25 * (bounded(filled[1] - filled[0], 2) + 2) + kNorthClass * (bounded(filled[0] - filled[-1], 2) + 2);
  const int flags = (measured[0] != 0 ? 1 : 0) + (measured[-1] != 0 ? 2 : 0) + (measured[1] != 0 ? 4 : 0);
  return classes + kNorthMeasured * flags;
}

/// The share that the pixels before it on its own row decide.
inline int context_from_row(int west, int west_west, int north_west, bool west_measured) {
  return (bounded(west_west - west, 2) + 2) + kWestClass * (bounded(west - north_west, 2) + 2) +
         (west_measured ? kWestMeasured : 0);
}

/// What lies a pixel further away than a context looks: whether three more neighbours differ, and which way. Of the
/// rows above alone, so that it is known for a whole row at once. Clusters that behave alike under it share a group of
/// models.
constexpr int kBeyondClasses = 27;

/// Pointers to the filled pixel one row above, and two.
inline int beyond_class(const uint16_t* above, const uint16_t* two_above) {
  return (bounded(two_above[0] - above[0], 1) + 1) + 3 * (bounded(above[2] - above[1], 1) + 1) +
         9 * (bounded(above[-2] - above[-1], 1) + 1);
}

/// What the frame before says of a pixel in a dependent frame: nothing, or that it lies this far from the prediction
/// (five classes), each with whether the pixel to the west stayed what it was.
constexpr int kBeforeClasses = 11;

inline int before_class(int before, int predicted, bool west_stayed) {
  if (before == 0) return 0;
  return 1 + 2 * (bounded(before - predicted, 2) + 2) + (west_stayed ? 1 : 0);
}

}  // namespace
}  // namespace telepalp::codec
