#include "proto/wire/mcap/format/byte_source.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace telepalp::wire::mcap {
namespace {

class File : public ByteSource {
 public:
  File(int descriptor, std::uint64_t size, std::string name)
      : descriptor_(descriptor), size_(size), name_(std::move(name)) {}
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() override { ::close(descriptor_); }

  [[nodiscard]] const std::string& name() const noexcept override { return name_; }
  [[nodiscard]] std::uint64_t size() const noexcept override { return size_; }
  [[nodiscard]] std::uint64_t next_data(std::uint64_t offset) const noexcept override {
    const off_t found = ::lseek(descriptor_, static_cast<off_t>(offset), SEEK_DATA);
    if (found >= 0) return static_cast<std::uint64_t>(found);
    return errno == ENXIO ? size_ : offset;  // other errors: the file system does not tell holes from data
  }
  [[nodiscard]] bool read(std::uint64_t offset, std::size_t length, std::string& into) override {
    into.resize(length);
    std::size_t have = 0;
    while (have < length) {
      const ssize_t got = ::pread(descriptor_, into.data() + have, length - have, static_cast<off_t>(offset + have));
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) return false;
      have += static_cast<std::size_t>(got);
    }
    return true;
  }

 private:
  int descriptor_;
  std::uint64_t size_;
  std::string name_;
};

class Memory : public ByteSource {
 public:
  Memory(std::string bytes, std::string name) : bytes_(std::move(bytes)), name_(std::move(name)) {}
  [[nodiscard]] const std::string& name() const noexcept override { return name_; }
  [[nodiscard]] std::uint64_t size() const noexcept override { return bytes_.size(); }
  [[nodiscard]] bool read(std::uint64_t offset, std::size_t length, std::string& into) override {
    into.assign(bytes_, offset, length);
    return into.size() == length;
  }

 private:
  std::string bytes_;
  std::string name_;
};

}  // namespace

Result<std::unique_ptr<ByteSource>> open_file(const std::filesystem::path& file) {
  std::error_code unknown;
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0 && errno == ENOENT && std::filesystem::exists(file.string() + ".partial", unknown))
    return Error{.what = "is not completed: " + file.string() + ".partial holds what was recorded so far",
                 .where = file.string(),
                 .fix = "telepalp-record repair " + file.string() + ", once no recorder writes it any more"};
  if (descriptor < 0)
    return Error{.what = std::string("cannot be opened: ") + std::strerror(errno),
                 .where = file.string(),
                 .fix = "check the path and its permissions"};
  struct stat status {};
  if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
    ::close(descriptor);
    return Error{.what = "is not a file", .where = file.string(), .fix = "give a session file (.mcap)"};
  }
  return std::unique_ptr<ByteSource>(
      std::make_unique<File>(descriptor, static_cast<std::uint64_t>(status.st_size), file.string()));
}

std::unique_ptr<ByteSource> in_memory(std::string bytes, std::string name) {
  return std::make_unique<Memory>(std::move(bytes), std::move(name));
}

}  // namespace telepalp::wire::mcap
