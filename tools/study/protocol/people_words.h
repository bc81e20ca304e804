#pragma once

#include <cmath>
#include <string>

#include "proto/words/numbers/fixed_text.h"
#include "tools/study/page/words.h"
#include "tools/study/protocol/people.h"

namespace telepalp::study {

/// As in_words(); a dash where nothing was measured yet.
[[nodiscard]] inline std::string interval_or_dash(const Interval& interval) {
  return std::isfinite(interval.mean) ? in_words(interval) : "–";
}

/// What the penetrations say, and what they cannot say, sentence by sentence.
[[nodiscard]] std::vector<std::string> people_findings(const Protocol& protocol, const PeopleResult& result);

}  // namespace telepalp::study
