#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "proto/words/result.h"
#include "support/nats/streams.h"

namespace telepalp::session_store {

/// A session's name in words: nats://HOST[:PORT]/SITE/SESSION.mcap.
struct SessionName {
  nats::Address cluster;
  std::string site;     ///< letters, digits, '-' and '_'
  std::string session;  ///< without ".mcap"; letters, digits, '-', '_' and '.'
};
[[nodiscard]] Result<SessionName> parse_name(const std::string& name);

/// The bytes of one session in a cluster. Each session has a stream of its own, so that the cluster removes it when its
/// time has come. The stream has a message for each block of the bytes, on a subject with the block's number, and one
/// that describes the session. A block that is stored again replaces itself, so that nothing is stored twice.
class StoredBlocks {
 public:
  static constexpr std::uint64_t kMostBlocks =
      90'000;  // 45 GB. Each block has a subject, of which NATS lists at most 100 000

  struct About {
    std::uint32_t block_B = 0;
    std::optional<std::uint64_t> size_B{};  ///< nullopt: the session is not complete
  };

  /// Connects. `patience`: how long a block may take that is stored while the cluster loses a server.
  [[nodiscard]] static Result<std::unique_ptr<StoredBlocks>> connect(const SessionName& name);

  /// Makes the session's stream. Error: it exists, or the cluster refuses.
  [[nodiscard]] Result<void> create(std::chrono::hours kept_for);
  [[nodiscard]] Result<void> remove();
  [[nodiscard]] Result<void> store(std::uint64_t number, std::string_view block);
  [[nodiscard]] Result<void> store(const About& about);
  /// Error: there is no such session.
  [[nodiscard]] Result<About> about();
  /// nullopt: the cluster has no block of this number any more.
  [[nodiscard]] Result<std::optional<std::string>> block(std::uint64_t number);
  /// Number of blocks in the cluster.
  [[nodiscard]] Result<std::uint64_t> count();
  /// Size of a new session's blocks that the cluster takes.
  [[nodiscard]] std::uint32_t most_block_B() const;

 private:
  explicit StoredBlocks(const SessionName& name);
  [[nodiscard]] std::string subject_of(std::string_view last) const { return subjects_ + std::string(last); }

  std::string stream_;
  std::string subjects_;  // beginning of all subjects
  std::unique_ptr<nats::NatsConnection> connection_;
  std::unique_ptr<nats::Streams> streams_;  // after the connection, which it uses
};

}  // namespace telepalp::session_store
