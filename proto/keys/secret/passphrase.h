#pragma once

#include <functional>
#include <string>

#include "proto/words/result.h"

namespace telepalp::keys {

/// Returns the passphrase of `what`, such as "keys/anna.key". `attempt`: 0 at first, then 1, 2, … after a wrong
/// passphrase. Error: there is none, or no further attempt is wanted.
using AskPassphrase = std::function<Result<std::string>(const std::string& what, int attempt)>;

/// The passphrase of TELEPALP_PASSPHRASE, or the first line of the file that TELEPALP_PASSPHRASE_FILE names; else the
/// one that is typed in the terminal, without echo, in at most three attempts. At most 256 bytes.
[[nodiscard]] Result<std::string> ask_passphrase(const std::string& what, int attempt);

/// As ask_passphrase(), but nobody is asked in the terminal.
[[nodiscard]] Result<std::string> passphrase_of_environment(const std::string& what, int attempt);

/// True if passphrase_of_environment() has a passphrase to give, right or wrong: one of the two variables is set.
[[nodiscard]] bool environment_has_passphrase();

/// A new passphrase for `what`, of 12 to 256 bytes: of TELEPALP_NEW_PASSPHRASE, or the first line of the file that
/// TELEPALP_NEW_PASSPHRASE_FILE names; else typed twice in the terminal.
[[nodiscard]] Result<std::string> new_passphrase(const std::string& what);

}  // namespace telepalp::keys
