#pragma once

#include <deque>
#include <functional>

#include "proto/words/time.h"

namespace telepalp::link {

/// The least or greatest of the values that were added within a span of time. `Better{}(a, b)`: a is better than b.
/// Only values that may still become the best are kept, so that add() takes constant time on average.
template <class Value, class Better>
class WindowedExtreme {
 public:
  /// Adds a value, and forgets those older than `span`. `now` never runs backwards. Returns the best.
  const Value& add(const Value& value, SessionTime now, Nanoseconds span) {
    while (!kept_.empty() && !Better{}(kept_.back().value, value)) kept_.pop_back();
    kept_.push_back({now, value});
    while (kept_.front().at < now - span) kept_.pop_front();
    return kept_.front().value;
  }

 private:
  struct Kept {
    SessionTime at;
    Value value;
  };
  std::deque<Kept> kept_;  ///< oldest first; each is better than all that follow
};

template <class Value>
using WindowedMinimum = WindowedExtreme<Value, std::less<Value>>;
template <class Value>
using WindowedMaximum = WindowedExtreme<Value, std::greater<Value>>;

}  // namespace telepalp::link
