#pragma once

#include <string>
#include <vector>

#include "proto/wire/message.h"

namespace telepalp::export_tool {

/// The messages of one topic as the lines of a CSV file. The columns are `published_ns` and the topic's fields by name,
/// a field of a part as `hand.x`. A message with lists of numbers (a batch of ticks) gives one line for each of their
/// entries. Of lists of parts, and of bytes, only the number is given.
class MessageTable {
 public:
  explicit MessageTable(const wire::Topic& topic);

  [[nodiscard]] std::string header() const;
  /// The lines of one message; empty if its payload is not of the topic's type.
  [[nodiscard]] std::string lines_of(const wire::Message& message) const;

 private:
  std::vector<std::string> columns_;
};

}  // namespace telepalp::export_tool
