#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::record {

/// Description of a session file. Its texts come unchecked from the file: escape them before printing.
struct SessionFacts {
  struct Topic {
    std::string name;
    std::string type;
    std::uint64_t messages = 0;
    double rate_Hz = 0.0;  ///< 0: fewer than two messages
  };

  double seconds = 0.0;
  std::uint64_t messages = 0;
  std::uint64_t chunks = 0;
  std::uint64_t bytes = 0;
  std::string program;  ///< program that wrote the file; empty: not stated
  std::string version;
  std::string commit;
  std::string source;         ///< the recorded server or file
  std::string depth;          ///< bound on the depth error, as text; empty: no depth
  std::vector<Topic> topics;  ///< sorted by name
};

/// Reads the file's index, and at most one image.
[[nodiscard]] Result<SessionFacts> inspect(const std::filesystem::path& file);

/// The description as text for a terminal.
[[nodiscard]] std::string in_words(const SessionFacts& facts);

/// The description as JSON.
[[nodiscard]] std::string in_json(const SessionFacts& facts);

}  // namespace telepalp::record
