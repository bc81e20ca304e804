#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace telepalp::support {

/// A command in a pseudo-terminal of its own. What is typed reaches it as from a keyboard: Ctrl-C is a SIGINT for every
/// process of the foreground group.
class Terminal {
 public:
  explicit Terminal(const std::vector<std::string>& command);
  ~Terminal();  // ends the command
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  [[nodiscard]] pid_t pid() const noexcept { return pid_; }
  void type(std::string_view keys) const;
  /// Closes the terminal, as a user closes its window: the command gets SIGHUP from the kernel.
  void close();
  /// All that was shown so far, once it holds `text`; whether it does within `patience`.
  [[nodiscard]] bool await_text(std::string_view text, std::chrono::milliseconds patience);
  /// Whether what is typed is no longer shown, as while a passphrase is typed, within `patience`.
  [[nodiscard]] bool await_hidden_typing(std::chrono::milliseconds patience);
  /// The command's exit code, or 128 + signal; nullopt while it still runs after `patience`.
  [[nodiscard]] std::optional<int> wait(std::chrono::milliseconds patience);
  [[nodiscard]] const std::string& shown() const noexcept { return shown_; }

 private:
  void read_some();

  pid_t pid_ = -1;
  int keyboard_and_screen_ = -1;
  std::string shown_;
  std::optional<int> exit_code_;
};

inline constexpr std::string_view kCtrlC = "\x03";

}  // namespace telepalp::support
