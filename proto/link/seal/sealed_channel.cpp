#include "proto/link/seal/sealed_channel.h"

#include <limits>
#include <utility>

#include "proto/words/demand.h"

namespace telepalp::link {
namespace {

constexpr std::uint16_t kLastEpoch = std::numeric_limits<std::uint16_t>::max();
/// RFC 9001 §6.6 allows ChaCha20-Poly1305 2^36 forgeries a key, and AES-GCM more.
constexpr std::uint64_t kMostForged = std::uint64_t{1} << 36U;

}  // namespace

Sealer::Sealer(const SealSettings& settings, Direction direction)
    : settings_(settings),
      epoch_secret_(first_epoch(settings.session, direction, settings.cipher)),
      aead_(settings.cipher, packet_key(epoch_secret_), Aead::Use::Seal) {
  settings_.session = Secret();
}

bool Sealer::change_key() {
  if (epoch_ == kLastEpoch) return false;
  ++epoch_;
  sealed_in_epoch_ = 0;
  epoch_secret_ = next_epoch(epoch_secret_);
  aead_ = Aead(settings_.cipher, packet_key(epoch_secret_), Aead::Use::Seal);
  return true;
}

std::optional<std::uint64_t> Sealer::seal(std::span<const std::byte> head, std::span<const std::byte> tail,
                                          Datagram& out) {
  const std::size_t payload_bytes = head.size() + tail.size();
  demand(payload_bytes <= kPayloadBytes, "the payload of a sealed datagram is not larger than its limit");
  if (sealed_in_epoch_ >= settings_.packets_per_epoch && !change_key()) return std::nullopt;
  ++sealed_in_epoch_;
  const HeaderBytes header(out.storage.data(), kHeaderBytes);
  write_header({.epoch = epoch_, .session = settings_.number, .sequence = sequence_}, header);
  aead_.seal(sequence_, header, {head, tail}, out.storage.data() + kHeaderBytes);
  out.size = kHeaderBytes + payload_bytes + kTagBytes;
  return sequence_++;
}

Opener::Opener(const SealSettings& settings, Direction direction)
    : settings_(settings),
      current_([&] {
        const Secret secret = first_epoch(settings.session, direction, settings.cipher);
        return Epoch{0, secret, Aead(settings.cipher, packet_key(secret), Aead::Use::Open)};
      }()),
      next_(epoch_after(current_)) {
  settings_.session = Secret();
}

Opener::Epoch Opener::epoch_after(const Epoch& epoch) const {
  const Secret secret = next_epoch(epoch.secret);
  return {static_cast<std::uint16_t>(epoch.number + 1), secret,
          Aead(settings_.cipher, packet_key(secret), Aead::Use::Open)};
}

Opener::Epoch* Opener::epoch_of(std::uint16_t number) noexcept {
  if (number == current_.number) return &current_;
  if (previous_ && number == previous_->number) return &*previous_;
  return number == next_.number && current_.number != kLastEpoch ? &next_ : nullptr;
}

/// Moves on when an authenticated packet has used the next epoch's key.
void Opener::adopt(const Epoch& used) {
  if (&used != &next_) return;
  previous_ = std::move(current_);
  current_ = std::move(next_);
  next_ = epoch_after(current_);
}

std::optional<Opened> Opener::open(std::span<const std::byte> datagram) {
  const std::optional<SealHeader> header = read_header(datagram);
  Epoch* const epoch = header && header->session == settings_.number ? epoch_of(header->epoch) : nullptr;
  if (epoch == nullptr || statistics_.forged >= kMostForged) {
    ++statistics_.malformed;
    return std::nullopt;
  }
  if (!window_.would_accept(header->sequence)) {
    ++statistics_.replayed;
    return std::nullopt;
  }
  const std::span<const std::byte> sealed = datagram.subspan(kHeaderBytes);
  if (!epoch->aead.open(header->sequence, datagram.first(kHeaderBytes), sealed, payload_.data())) {
    ++statistics_.forged;
    return std::nullopt;
  }
  const bool newest = header->sequence >= window_.next();
  window_.accept(header->sequence);
  adopt(*epoch);
  return Opened{header->sequence, newest, {payload_.data(), sealed.size() - kTagBytes}};
}

}  // namespace telepalp::link
