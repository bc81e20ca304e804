#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "proto/words/result.h"
#include "support/nats/nats_connection.h"

namespace telepalp::nats {

/// A stream that a cluster keeps in files (JetStream).
struct StreamSettings {
  std::string name;                   ///< letters, digits and '_'
  std::vector<std::string> subjects;  ///< messages of these subjects are kept: "telepalp-sweep.cell.>"
  bool is_work_queue;  ///< a message is removed once it is acknowledged; else the newest of each subject is kept
  std::chrono::hours longest_kept;
};

/// The streams of the cluster to which a connection leads. A message that does not fit is refused; no older message
/// makes room for it. Any thread.
class Streams {
 public:
  /// Error: the cluster has no JetStream.
  [[nodiscard]] static Result<std::unique_ptr<Streams>> open(const NatsConnection& connection);
  ~Streams();
  Streams(const Streams&) = delete;
  Streams& operator=(const Streams&) = delete;

  /// Makes the stream if there is none of its name. Error: JetStream is not enabled or full, or the account may not.
  [[nodiscard]] Result<void> keep(const StreamSettings& settings);
  /// Publishes, and waits until the message is stored. Error: no connection, or no room.
  [[nodiscard]] Result<void> store(const std::string& subject, std::string_view payload);
  /// The subjects of the messages in `stream` that match `filter`, which may end with '*' or '>'.
  [[nodiscard]] Result<std::vector<std::string>> subjects(const std::string& stream, const std::string& filter);
  /// The newest message of `subject`; nullopt: none is stored.
  [[nodiscard]] Result<std::optional<std::string>> newest(const std::string& stream, const std::string& subject);
  /// Removes the messages that match `filter`.
  [[nodiscard]] Result<void> erase(const std::string& stream, const std::string& filter);

 private:
  friend class WorkQueue;
  struct Parts;
  explicit Streams(std::unique_ptr<Parts> parts);
  [[nodiscard]] void* library_context() const noexcept;  ///< a jsCtx
  std::unique_ptr<Parts> parts_;
};

}  // namespace telepalp::nats
