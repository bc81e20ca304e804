#include "support/session_store/stored_session.h"

#include <algorithm>
#include <chrono>
#include <list>
#include <optional>
#include <thread>
#include <utility>

#include "support/session_store/stored_blocks.h"

namespace telepalp::session_store {
namespace {

constexpr std::uint64_t kWrittenAgain_B = 128 << 10;  // an encrypted file's last block, which changes, is smaller
constexpr int kAttempts = 3;  // a server of the cluster answers that may be a little behind, or has just been lost
constexpr auto kTriesAgainAfter = std::chrono::milliseconds(100);
constexpr std::size_t kMostHeldBlocks = 16;  // 8 MiB: a chunk of a session, and the indexes between which a seek looks

class StoredSource final : public wire::mcap::ByteSource {
 public:
  StoredSource(std::string name, std::unique_ptr<StoredBlocks> blocks, std::uint32_t block_B, std::uint64_t size_B)
      : name_(std::move(name)), blocks_(std::move(blocks)), block_B_(block_B), size_(size_B) {}

  [[nodiscard]] const std::string& name() const noexcept override { return name_; }
  [[nodiscard]] std::uint64_t size() const noexcept override { return size_; }
  [[nodiscard]] bool read(std::uint64_t offset, std::size_t length, std::string& into) override {
    into.clear();
    into.reserve(length);
    while (into.size() < length) {
      const std::uint64_t at = offset + into.size();
      const std::string* const block = fetch(at / block_B_);
      if (block == nullptr || block->size() <= at % block_B_) return false;
      into += std::string_view(*block).substr(at % block_B_, length - into.size());
    }
    return true;
  }

 private:
  struct Held {
    std::uint64_t number;
    std::string bytes;
  };

  /// The block of this number; null: it has another size than it must have, or the cluster does not have it.
  const std::string* fetch(std::uint64_t number) {
    const auto held = std::ranges::find(held_, number, &Held::number);
    if (held != held_.end()) {
      held_.splice(held_.begin(), held_, held);
      return &held_.front().bytes;
    }
    const std::uint64_t must_have_B = std::min<std::uint64_t>(block_B_, size_ - number * block_B_);
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      if (attempt > 0) std::this_thread::sleep_for(kTriesAgainAfter);
      Result<std::optional<std::string>> block = blocks_->block(number);
      if (!block || !*block || (*block)->size() != must_have_B) continue;
      held_.push_front({number, **std::move(block)});
      if (held_.size() > kMostHeldBlocks) held_.pop_back();
      return &held_.front().bytes;
    }
    return nullptr;
  }

  std::string name_;
  std::unique_ptr<StoredBlocks> blocks_;
  std::uint64_t block_B_;
  std::uint64_t size_;
  std::list<Held> held_;  // used last: first
};

class StoredSink final : public wire::mcap::ByteSink {
 public:
  StoredSink(std::unique_ptr<StoredBlocks> blocks, std::uint32_t block_B)
      : blocks_(std::move(blocks)), block_B_(block_B) {}

  [[nodiscard]] Result<void> write(std::uint64_t offset, std::string_view bytes) override;
  /// The blocks from `size` on stay in the cluster until they are written again; publish() states the size.
  void cut(std::uint64_t size) noexcept override {
    const std::uint64_t kept = std::min<std::uint64_t>(size > last_from_ ? size - last_from_ : 0, last_.size());
    last_.resize(kept);
    size_ = std::min(size_, size);
  }
  [[nodiscard]] Result<void> publish() override {
    return blocks_->store(StoredBlocks::About{.block_B = block_B_, .size_B = size_});
  }
  void discard() noexcept override { (void)blocks_->remove(); }

 private:
  std::unique_ptr<StoredBlocks> blocks_;
  std::uint32_t block_B_;
  std::uint64_t size_ = 0;
  std::uint64_t last_from_ = 0;  // begin of a block; from there on bytes may be written again
  std::string last_;             // bytes from last_from_ to size_
};

/// Keeps the bytes of the newest blocks, because their end is written again: an encrypted file's last block changes.
Result<void> StoredSink::write(std::uint64_t offset, std::string_view bytes) {
  if (offset < last_from_ || offset > size_)
    return Error{.what = "a part of the session is written again that is in the cluster already",
                 .where = "session in a cluster",
                 .fix = "report this with the program's log"};
  std::string next = last_.substr(0, offset - last_from_);
  next += bytes;
  const std::uint64_t first = last_from_ / block_B_;
  const std::uint64_t end = last_from_ + next.size();
  const std::uint64_t changed = offset / block_B_;
  for (std::uint64_t number = changed; number * block_B_ < end; ++number) {
    if (number >= StoredBlocks::kMostBlocks)
      return Error{.what = "the session is larger than a cluster may keep",
                   .where = "session in a cluster",
                   .fix = "record in parts: --split 1GB"};
    const std::string_view block = std::string_view(next).substr((number - first) * block_B_, block_B_);
    if (Result<void> stored = blocks_->store(number, block); !stored) return stored;
  }
  size_ = end;
  const std::uint64_t kept_from = (end > kWrittenAgain_B ? end - kWrittenAgain_B : 0) / block_B_ * block_B_;
  last_ = next.substr(std::max(kept_from, last_from_) - last_from_);
  last_from_ = std::max(kept_from, last_from_);
  return {};
}

}  // namespace

Result<std::unique_ptr<wire::mcap::ByteSource>> open_stored(const std::string& name) {
  const Result<SessionName> read = parse_name(name);
  if (!read) return read.error();
  Result<std::unique_ptr<StoredBlocks>> blocks = StoredBlocks::connect(*read);
  if (!blocks) return blocks.error();
  Result<StoredBlocks::About> about = (*blocks)->about();
  for (int attempt = 1; attempt < kAttempts && about && !about->size_B; ++attempt) {
    std::this_thread::sleep_for(kTriesAgainAfter);
    about = (*blocks)->about();
  }
  if (!about) return about.error();
  std::uint64_t size_B = about->size_B.value_or(0);
  if (!about->size_B) {
    const Result<std::uint64_t> count = (*blocks)->count();
    if (!count) return count.error();
    const auto last = *count == 0 ? Result<std::optional<std::string>>(std::nullopt) : (*blocks)->block(*count - 1);
    if (!last) return last.error();
    if (*last && (*last)->size() <= about->block_B) size_B = (*count - 1) * about->block_B + (*last)->size();
  }
  return std::unique_ptr<wire::mcap::ByteSource>(
      std::make_unique<StoredSource>(name, *std::move(blocks), about->block_B, size_B));
}

Result<std::unique_ptr<wire::mcap::ByteSink>> create_stored(const std::string& name, const StoreTerms& terms) {
  const Result<SessionName> read = parse_name(name);
  if (!read) return read.error();
  if (!terms.kept_for)
    return Error{.what = "no session is stored in a cluster without the patient's consent, and the time that it allows",
                 .where = name,
                 .fix = "ask the patient, then give --consent \"signed form 4711, until 2027-03-01\", or --keep-days"};
  Result<std::unique_ptr<StoredBlocks>> blocks = StoredBlocks::connect(*read);
  if (!blocks) return blocks.error();
  if (const Result<void> created = (*blocks)->create(*terms.kept_for); !created) return created.error();
  const std::uint32_t block_B = (*blocks)->most_block_B();
  if (const Result<void> described = (*blocks)->store(StoredBlocks::About{.block_B = block_B}); !described)
    return described.error();
  return std::unique_ptr<wire::mcap::ByteSink>(std::make_unique<StoredSink>(*std::move(blocks), block_B));
}

}  // namespace telepalp::session_store
