#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::recording {

/// A child process that ends with the server: the kernel sends the child SIGTERM when the thread that called start()
/// ends.
class RecorderProcess {
 public:
  /// Starts `program`; its stderr goes to the file `log`. Error: `program` is not executable, `log`
  /// cannot be written, or the system cannot start another process.
  [[nodiscard]] static Result<RecorderProcess> start(const std::filesystem::path& program,
                                                     const std::vector<std::string>& arguments,
                                                     const std::filesystem::path& log);
  /// Sends SIGTERM: telepalp-record then completes its file and exits.
  void ask_to_end() const noexcept;
  /// The exit code, 128 + N after signal N; nullopt while the process runs. Never blocks.
  [[nodiscard]] std::optional<int> exit_code() noexcept;

 private:
  explicit RecorderProcess(pid_t pid) noexcept : pid_(pid) {}
  pid_t pid_;
  std::optional<int> exit_code_;
};

}  // namespace telepalp::recording
