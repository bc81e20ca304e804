#pragma once

namespace telepalp::program {

/// "0.1.0"
[[nodiscard]] const char* version() noexcept;
/// Short hash of the commit that this was configured from; empty outside of a repository.
[[nodiscard]] const char* commit() noexcept;

}  // namespace telepalp::program
