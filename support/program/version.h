#pragma once

namespace telepalp::program {

/// Version of telepalp, for example "0.1.0".
[[nodiscard]] const char* version() noexcept;
/// Short hash of the commit that the program was built from, with "-modified" if files differed from it; empty outside
/// of a repository.
[[nodiscard]] const char* commit() noexcept;

}  // namespace telepalp::program
