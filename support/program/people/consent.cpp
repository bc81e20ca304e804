#include "support/program/people/consent.h"

namespace telepalp::program {

Option consent_option() { return {"consent", "TEXT", "note on the patient's consent; needed with --key"}; }

Result<void> check_consent(const Arguments& arguments, const std::string& what) {
  if (!arguments.has("key") || arguments.text("consent").find_first_not_of(' ') != std::string::npos) return {};
  return Error{.what = "the patient's consent to " + what + " is not stated",
               .where = "--consent",
               .fix = "ask the patient, then give --consent \"signed form, study 17\", or who heard the consent"};
}

}  // namespace telepalp::program
