#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::record {

/// What a session file holds. All text in it is as the file has it: escape it before it is shown.
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
  std::string program;  ///< that wrote it; empty: the file does not say
  std::string version;
  std::string commit;
  std::string source;         ///< that was recorded
  std::string depth;          ///< how exact depth is, in words; empty: the file holds none
  std::vector<Topic> topics;  ///< by name
};

/// Reads the file's index, and at most one image.
[[nodiscard]] Result<SessionFacts> inspect(const std::filesystem::path& file);

/// For people.
[[nodiscard]] std::string in_words(const SessionFacts& facts);

/// For programs.
[[nodiscard]] std::string in_json(const SessionFacts& facts);

}  // namespace telepalp::record
