#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "proto/keys/seal/site_key.h"
#include "proto/wire/mcap/sealed/sealed_header.h"
#include "proto/wire/mcap/format/byte_sink.h"
#include "proto/words/result.h"

namespace telepalp::wire::mcap {

/// Encrypts a session while it is written. The last block grows: it is encrypted again, with a new nonce, each time
/// that something is appended, so that all that was appended survives a crash. Owner: one thread.
class Sealer {
 public:
  Sealer(SealedHeader header, const keys::FileKey& key) : header_(std::move(header)), key_(key) {}

  /// Writes the header.
  [[nodiscard]] Result<void> begin(ByteSink& sink);
  /// Appends all of `bytes`. Error: nothing is appended.
  [[nodiscard]] Result<void> append(ByteSink& sink, std::string_view bytes);

 private:
  [[nodiscard]] std::optional<std::string> sealed(std::uint64_t number, std::string_view blocks) const;

  SealedHeader header_;
  keys::FileKey key_;
  std::uint64_t full_ = 0;  // blocks that do not change any more
  std::string last_;        // content of the block that grows
};

/// Encrypts with the first key of TELEPALP_SITE_KEYS. nullopt: the variable is not set. Error: the key cannot be read.
[[nodiscard]] Result<std::optional<Sealer>> sealer_of_site();

}  // namespace telepalp::wire::mcap
