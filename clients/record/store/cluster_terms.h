#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "proto/words/result.h"
#include "support/session_store/session_place.h"

namespace telepalp::record {

/// How long a cluster keeps a session: `keep`, but no longer than the date in the consent allows ("form 4711, until
/// 2027-03-01"). No time at all without a consent, or if neither states one. Error: the consent is over, or its date
/// does not exist.
[[nodiscard]] Result<session_store::StoreTerms> cluster_terms(const std::string& consent,
                                                              std::optional<std::chrono::days> keep,
                                                              std::chrono::system_clock::time_point now);

}  // namespace telepalp::record
