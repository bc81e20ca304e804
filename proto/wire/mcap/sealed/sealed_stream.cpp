#include "proto/wire/mcap/sealed/sealed_stream.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <optional>
#include <streambuf>
#include <string>
#include <utility>

#include "proto/wire/mcap/format/byte_sink.h"
#include "proto/wire/mcap/format/byte_source.h"
#include "proto/wire/mcap/sealed/sealer.h"

namespace telepalp::wire::mcap {
namespace {

constexpr std::size_t kMostWaiting_B = std::size_t{1} << 20;
constexpr std::size_t kRead_B = std::size_t{64} << 10;
constexpr mode_t kOwnerAndGroup = 0640;

/// A file that has its final name from the beginning; a session's gets it in the end.
class OpenFile final : public ByteSink {
 public:
  OpenFile(int descriptor, std::string name) : descriptor_(descriptor), name_(std::move(name)) {}
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() override { ::close(descriptor_); }

  [[nodiscard]] Result<void> write(std::uint64_t offset, std::string_view bytes) override {
    while (!bytes.empty()) {
      const ssize_t written = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
      if (written < 0 && errno == EINTR) continue;
      if (written < 0)
        return Error{.what = std::string("cannot be written: ") + std::strerror(errno),
                     .where = name_,
                     .fix = "check the disk of this file"};
      bytes.remove_prefix(static_cast<std::size_t>(written));
      offset += static_cast<std::uint64_t>(written);
    }
    return {};
  }
  void cut(std::uint64_t size) noexcept override { (void)!::ftruncate(descriptor_, static_cast<off_t>(size)); }
  [[nodiscard]] Result<void> publish() override { return {}; }
  void discard() noexcept override {}

 private:
  int descriptor_;
  std::string name_;
};

class WritingBuffer final : public std::streambuf {
 public:
  WritingBuffer(std::unique_ptr<ByteSink> sink, std::optional<Sealer> sealer)
      : sink_(std::move(sink)), sealer_(std::move(sealer)) {}

 protected:
  std::streamsize xsputn(const char* bytes, std::streamsize count) override {
    waiting_.append(bytes, static_cast<std::size_t>(count));
    return waiting_.size() < kMostWaiting_B || write() ? count : 0;
  }
  int_type overflow(int_type letter) override {
    if (traits_type::eq_int_type(letter, traits_type::eof())) return traits_type::not_eof(letter);
    const char byte = traits_type::to_char_type(letter);
    return xsputn(&byte, 1) == 1 ? letter : traits_type::eof();
  }
  int sync() override { return write() ? 0 : -1; }

 private:
  bool write() {
    if (waiting_.empty()) return true;
    const Result<void> done = sealer_ ? sealer_->append(*sink_, waiting_) : sink_->write(size_, waiting_);
    if (!done) return false;
    size_ += waiting_.size();
    waiting_.clear();
    return true;
  }

  std::unique_ptr<ByteSink> sink_;
  std::optional<Sealer> sealer_;  // nullopt: the file is not encrypted
  std::uint64_t size_ = 0;        // written, of an unencrypted file
  std::string waiting_;
};

class ReadingBuffer final : public std::streambuf {
 public:
  explicit ReadingBuffer(std::unique_ptr<ByteSource> source) : source_(std::move(source)) {}

 protected:
  int_type underflow() override {
    const std::uint64_t left = source_->size() - at_;
    if (left == 0 || !source_->read(at_, static_cast<std::size_t>(std::min<std::uint64_t>(kRead_B, left)), piece_))
      return traits_type::eof();
    at_ += piece_.size();
    setg(piece_.data(), piece_.data(), piece_.data() + piece_.size());
    return traits_type::to_int_type(piece_.front());
  }

 private:
  std::unique_ptr<ByteSource> source_;
  std::uint64_t at_ = 0;
  std::string piece_;
};

/// A stream with a buffer of its own.
template <class Stream, class Buffer>
class Owning final : public Stream {
 public:
  template <class... Parts>
  explicit Owning(Parts&&... parts) : Stream(nullptr), buffer_(std::forward<Parts>(parts)...) {
    this->rdbuf(&buffer_);
  }
  Owning(const Owning&) = delete;
  Owning& operator=(const Owning&) = delete;
  ~Owning() override { this->rdbuf(nullptr); }

 private:
  Buffer buffer_;
};

}  // namespace

Result<std::unique_ptr<std::ostream>> create_stream(const std::filesystem::path& file) {
  Result<std::optional<Sealer>> sealer = sealer_of_site();
  if (!sealer) return sealer.error();
  const int descriptor = ::open(file.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, kOwnerAndGroup);
  if (descriptor < 0)
    return Error{.what = std::string("cannot be created: ") + std::strerror(errno),
                 .where = file.string(),
                 .fix = "check that the folder exists and may be written"};
  auto sink = std::make_unique<OpenFile>(descriptor, file.string());
  if (*sealer)
    if (const Result<void> begun = (**sealer).begin(*sink); !begun) return begun.error();
  return std::unique_ptr<std::ostream>(
      std::make_unique<Owning<std::ostream, WritingBuffer>>(std::move(sink), *std::move(sealer)));
}

Result<std::unique_ptr<std::istream>> open_stream(const std::filesystem::path& file) {
  Result<std::unique_ptr<ByteSource>> source = open_session(file);
  if (!source) return source.error();
  return std::unique_ptr<std::istream>(std::make_unique<Owning<std::istream, ReadingBuffer>>(*std::move(source)));
}

}  // namespace telepalp::wire::mcap
