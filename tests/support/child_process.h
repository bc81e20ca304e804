#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace telepalp::support {

/// A telepalp program that a test or benchmark starts; it ends with this object.
class ChildProcess {
 public:
  /// Starts `program` (a path) with `arguments`; what it prints goes to `log` if given, else where this process prints.
  ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
               const std::filesystem::path& log = {});
  ~ChildProcess();  // asks it to end, and kills it after 5 s
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  [[nodiscard]] pid_t pid() const noexcept { return pid_; }
  void signal(int number) const noexcept;
  /// Its exit code, or 128 + signal; nullopt while it still runs after `patience`.
  std::optional<int> wait(std::chrono::milliseconds patience);

 private:
  pid_t pid_ = -1;
  std::optional<int> exit_code_;
};

/// Waits until the ready file `file` has a line `key=value`, and returns the value.
[[nodiscard]] std::optional<std::string> await_ready(const std::filesystem::path& file, const std::string& key,
                                                     std::chrono::milliseconds patience = std::chrono::seconds(20));

/// A new empty folder, removed with this object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace telepalp::support
