#include "clients/record/store/cluster_terms.h"

#include <algorithm>

#include "clients/record/retention/retention_rules.h"

namespace telepalp::record {

Result<session_store::StoreTerms> cluster_terms(const std::string& consent, std::optional<std::chrono::days> keep,
                                                std::chrono::system_clock::time_point now) {
  using std::chrono::hours;
  session_store::StoreTerms terms;
  if (consent.find_first_not_of(' ') == std::string::npos) return terms;
  const Result<std::optional<WallTime>> end = end_of_consent(consent);
  if (!end) return end.error();
  if (keep) terms.kept_for = *keep;
  if (!*end) return terms;
  const hours left = std::chrono::floor<hours>(**end - now);
  if (left < hours(1))
    return Error{.what = "the patient's consent is over: '" + consent.substr(0, 100) + "'",
                 .where = "--consent",
                 .fix = "ask the patient again, and state the new consent"};
  terms.kept_for = terms.kept_for ? std::min(*terms.kept_for, left) : left;
  return terms;
}

}  // namespace telepalp::record
