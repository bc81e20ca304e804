#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "proto/words/result.h"

namespace telepalp::access {

/// Facts that must survive a restart of the server, in a file of lines "name=value": the number of the newest
/// revocation list, which browser uses which token, who holds the touch. Owner: the server's network thread.
class KeptFacts {
 public:
  /// Error: `file` exists and cannot be read, or is larger than 1 MiB.
  [[nodiscard]] static Result<KeptFacts> open(std::filesystem::path file);

  /// The value of the fact `name`; nullopt: it is not known.
  [[nodiscard]] std::optional<std::string> get(const std::string& name) const;
  /// Sets the fact `name`, or forgets it (nullopt). If it changes, the whole file is written again. False: that failed.
  bool set(const std::string& name, const std::optional<std::string>& value);

 private:
  explicit KeptFacts(std::filesystem::path file) : file_(std::move(file)) {}

  std::filesystem::path file_;
  std::map<std::string, std::string> facts_;
};

}  // namespace telepalp::access
