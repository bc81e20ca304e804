#include "support/program/patience.h"

namespace telepalp::program {

Option patience_option(std::string_view help, std::string_view initial_s) { return {"patience", "S", help, initial_s}; }

Result<Patience> patience_of(const Arguments& arguments) {
  const Result<double> seconds = arguments.number("patience", 0.0, kForEver.count());
  if (!seconds) return seconds.error();
  if (*seconds == 0.0) return Patience{};
  return Patience{std::chrono::duration<double>(*seconds)};
}

}  // namespace telepalp::program
