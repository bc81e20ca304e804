#pragma once

#include <string>
#include <string_view>

namespace telepalp::program {

/// Version of telepalp, for example "0.1.0".
[[nodiscard]] const char* version() noexcept;
/// Short hash of the commit that the program was built from, with "-modified" if files differed from it; empty outside
/// of a repository.
[[nodiscard]] const char* commit() noexcept;
/// `program` with version and commit, as sessions state it: "telepalp-server 0.1.0, commit 1a2b3c4d". Without a commit,
/// the text ends after the version.
[[nodiscard]] std::string software(std::string_view program);

}  // namespace telepalp::program
