#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "proto/impaired/impairment.h"
#include "proto/words/result.h"

namespace telepalp::impaired {

/// The impairments of a kind of network path, in both directions.
struct Profile {
  std::string_view name;
  Impairment down;  ///< from the server to the client
  Impairment up;    ///< from the client to the server
};

/// The profiles `lan`, `lte`, `satellite` and `hostile`.
[[nodiscard]] const std::vector<Profile>& profiles();
/// Error: no profile has this name; the error lists the names.
[[nodiscard]] Result<Profile> profile_named(std::string_view name);

/// Reads a trace: CSV with the header `t_s,delay_ms,jitter_ms,loss_percent,rate_kbit_per_s` and at least two rows; t_s
/// is 0 in the first row and increases. At most 1 MiB. Error: the text is no such trace; the error states `where`, the
/// name of the text's source, and the number of the first wrong line.
[[nodiscard]] Result<Trace> parse_trace(std::string_view text, std::string_view where);
[[nodiscard]] Result<Trace> read_trace(const std::filesystem::path& file);

}  // namespace telepalp::impaired
