#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace telepalp::record {

/// Chooses topics by patterns with the wildcards of a shell: * ? [abc]. A pattern that begins with '!' excludes topics.
/// Without a pattern that includes, all topics but the excluded ones are chosen.
class TopicFilter {
 public:
  explicit TopicFilter(const std::string& comma_separated);

  [[nodiscard]] bool matches(std::string_view topic) const;
  /// The names and prefixes ("/station/*") to subscribe to at a server. They may cover topics that do not match.
  [[nodiscard]] std::vector<std::string> subscription() const;

 private:
  std::vector<std::string> included_;
  std::vector<std::string> excluded_;
};

}  // namespace telepalp::record
