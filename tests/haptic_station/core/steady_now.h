#pragma once

#include <chrono>

#include "proto/words/time.h"

namespace telepalp::core {

inline SessionTime steady_now() { return SessionTime{std::chrono::steady_clock::now().time_since_epoch()}; }

}  // namespace telepalp::core
