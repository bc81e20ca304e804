#pragma once

#include <string>

#include "proto/words/result.h"
#include "support/program/options.h"

namespace telepalp::program {

/// The option --consent, by which whoever sees the patient through a server with keys states the patient's consent.
[[nodiscard]] Option consent_option();

/// Error: --key is given and --consent states nothing. `what`: that to which the patient consents, such as "this
/// recording".
[[nodiscard]] Result<void> check_consent(const Arguments& arguments, const std::string& what);

}  // namespace telepalp::program
