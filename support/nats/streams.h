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

/// A stream: messages that a cluster stores in files (JetStream).
struct StreamSettings {
  std::string name;                   ///< letters, digits and '_'
  std::vector<std::string> subjects;  ///< of the messages that are stored, such as "telepalp-sweep.cell.>"
  bool is_work_queue;  ///< a message is removed when a consumer acknowledges it; otherwise it stays until a newer one
                       ///< of its subject replaces it
  std::chrono::hours longest_kept;  ///< then a message is removed in any case
  int copies = 1;  ///< on different servers; on a cluster that has not as many, one. 3 survive the loss of a server
};

/// The streams of a cluster. A full stream refuses new messages; it does not remove old ones to make room. The
/// connection must outlive this object. Any thread.
class Streams {
 public:
  /// Error: the cluster has no JetStream.
  [[nodiscard]] static Result<std::unique_ptr<Streams>> open(const NatsConnection& connection);
  ~Streams();
  Streams(const Streams&) = delete;
  Streams& operator=(const Streams&) = delete;

  /// Makes the stream unless there is one of this name; waits up to 20 s for a cluster that has no leader. Error:
  /// JetStream is not enabled, it is full, the account lacks the permission, or the cluster does not answer.
  [[nodiscard]] Result<void> keep(const StreamSettings& settings);
  /// Publishes, and waits until the cluster has stored the message. Error: no connection, or no room.
  [[nodiscard]] Result<void> store(const std::string& subject, std::string_view payload);
  /// As store(), but tries again for at most `patience` while the connection is lost or the cluster elects a new
  /// leader. A payload may be stored twice, so it must be one that replaces itself (StreamSettings::is_work_queue
  /// false).
  [[nodiscard]] Result<void> store_patiently(const std::string& subject, std::string_view payload,
                                             std::chrono::milliseconds patience);
  /// The subjects of the messages in `stream` that match `filter`, which may end with '*' or '>'.
  [[nodiscard]] Result<std::vector<std::string>> subjects(const std::string& stream, const std::string& filter);
  /// The payload of the newest message of `subject`; nullopt: none is stored.
  [[nodiscard]] Result<std::optional<std::string>> newest(const std::string& stream, const std::string& subject);
  /// Removes the messages that match `filter`.
  [[nodiscard]] Result<void> erase(const std::string& stream, const std::string& filter);
  /// Removes the stream and its messages.
  [[nodiscard]] Result<void> remove(const std::string& stream);
  /// True if the cluster has a stream of this name.
  [[nodiscard]] Result<bool> has(const std::string& stream);

 private:
  friend class WorkQueue;
  struct Parts;
  explicit Streams(std::unique_ptr<Parts> parts);
  [[nodiscard]] void* library_context() const noexcept;  ///< a jsCtx*; void keeps libnats out of this header
  std::unique_ptr<Parts> parts_;
};

}  // namespace telepalp::nats
