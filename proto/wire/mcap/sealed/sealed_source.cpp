#include "proto/wire/mcap/sealed/sealed_source.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "proto/wire/mcap/sealed/sealed_header.h"

namespace telepalp::wire::mcap {
namespace {

constexpr std::uint64_t kStride = kSealedBlockBytes + keys::kSealBytes;

class SealedSource final : public ByteSource {
 public:
  SealedSource(std::unique_ptr<ByteSource> source, SealedHeader header, const keys::FileKey& key)
      : source_(std::move(source)), header_(std::move(header)), key_(key) {
    const std::uint64_t body = source_->size() - kSealedHeaderBytes;
    const std::uint64_t full = body / kStride;
    size_ = full * kSealedBlockBytes;
    const std::uint64_t rest = body % kStride;
    if (rest <= keys::kSealBytes) return;
    size_ += rest - keys::kSealBytes;
    if (!open(full)) size_ = full * kSealedBlockBytes;  // it was cut off while it was written
  }

  [[nodiscard]] const std::string& name() const noexcept override { return source_->name(); }
  [[nodiscard]] std::uint64_t size() const noexcept override { return size_; }
  [[nodiscard]] bool read(std::uint64_t offset, std::size_t length, std::string& into) override {
    into.clear();
    into.reserve(length);
    while (into.size() < length) {
      const std::uint64_t at = offset + into.size();
      if (!open(at / kSealedBlockBytes)) return false;
      into += std::string_view(block_).substr(at % kSealedBlockBytes, length - into.size());
    }
    return true;
  }

 private:
  /// Decrypts the block of this number into block_; false: it was altered, or cannot be read.
  bool open(std::uint64_t number) {
    if (number == number_) return true;
    const std::uint64_t from = number * kSealedBlockBytes;
    if (from >= size_) return false;
    const std::size_t content = static_cast<std::size_t>(std::min<std::uint64_t>(kSealedBlockBytes, size_ - from));
    number_.reset();
    block_.clear();
    if (!source_->read(kSealedHeaderBytes + number * kStride, content + keys::kSealBytes, sealed_) ||
        !keys::open_block(key_, header_.about_block(number), sealed_, block_))
      return false;
    number_ = number;
    return true;
  }

  std::unique_ptr<ByteSource> source_;
  SealedHeader header_;
  keys::FileKey key_;
  std::uint64_t size_ = 0;
  std::optional<std::uint64_t> number_;  // of the block in block_
  std::string block_;
  std::string sealed_;  // used again
};

}  // namespace

Result<std::unique_ptr<ByteSource>> decrypted(std::unique_ptr<ByteSource> source) {
  std::string begin;
  const std::size_t size = static_cast<std::size_t>(std::min<std::uint64_t>(kSealedHeaderBytes, source->size()));
  if (!source->read(0, size, begin)) return source;  // its reader says so
  Result<std::optional<SealedHeader>> header = header_in(begin, source->name());
  if (!header) return header.error();
  if (!*header) return source;
  const Result<keys::FileKey> key = file_key_of(**header, source->name());
  if (!key) return key.error();
  return std::unique_ptr<ByteSource>(std::make_unique<SealedSource>(std::move(source), **std::move(header), *key));
}

}  // namespace telepalp::wire::mcap
