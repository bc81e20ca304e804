#pragma once

#include "proto/words/time.h"

namespace telepalp::tracking {

inline SessionTime at_s(double seconds) { return SessionTime{from_seconds(seconds)}; }

}  // namespace telepalp::tracking
