#pragma once

#include <optional>
#include <string>
#include <vector>

#include "proto/wire/message.h"

namespace telepalp::export_tool {

/// The messages of one topic as the lines of a CSV file. The columns are `published_ns`, `row` and the fields of the
/// topic's type; a field of a nested message is named `hand.x`. A message with lists of numbers (a batch of ticks)
/// gives one line for each entry, with its index in `row`. Of a list of messages and of a field of bytes, only the
/// length is written, in a column such as `data.size`.
class MessageTable {
 public:
  explicit MessageTable(const wire::Topic& topic);

  [[nodiscard]] std::string header() const;
  /// The lines of one message; nullopt if its payload is not of the topic's type.
  [[nodiscard]] std::optional<std::string> lines_of(const wire::Message& message) const;

 private:
  std::vector<std::string> columns_;
};

}  // namespace telepalp::export_tool
