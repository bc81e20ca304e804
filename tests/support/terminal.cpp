#include "tests/support/terminal.h"

#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <array>

#include "proto/words/demand.h"

namespace telepalp::support {
namespace {

using Clock = std::chrono::steady_clock;

}  // namespace

Terminal::Terminal(const std::vector<std::string>& command) {
  std::vector<char*> argv;
  for (const std::string& word : command) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  pid_ = ::forkpty(&keyboard_and_screen_, nullptr, nullptr, nullptr);
  demand(pid_ >= 0, "there is a pseudo-terminal");
  if (pid_ > 0) return;
  ::execvp(argv.front(), argv.data());
  ::_exit(127);
}

Terminal::~Terminal() {
  if (!exit_code_) ::kill(pid_, SIGTERM);
  if (!wait(std::chrono::seconds(10))) {
    ::kill(pid_, SIGKILL);
    (void)wait(std::chrono::seconds(5));
  }
  close();
}

void Terminal::close() {
  if (keyboard_and_screen_ >= 0) ::close(keyboard_and_screen_);
  keyboard_and_screen_ = -1;  // poll() skips it
}

void Terminal::type(std::string_view keys) const {
  demand(::write(keyboard_and_screen_, keys.data(), keys.size()) == static_cast<ssize_t>(keys.size()),
         "a terminal takes what is typed");
}

bool Terminal::await_hidden_typing(std::chrono::milliseconds patience) {
  for (const auto end = Clock::now() + patience; Clock::now() < end; read_some()) {
    termios settings{};
    if (::tcgetattr(keyboard_and_screen_, &settings) == 0 && (settings.c_lflag & ECHO) == 0) return true;
  }
  return false;
}

void Terminal::read_some() {
  pollfd screen{keyboard_and_screen_, POLLIN, 0};
  if (::poll(&screen, 1, 10) <= 0) return;
  std::array<char, 4096> block{};
  const ssize_t got = ::read(keyboard_and_screen_, block.data(), block.size());
  if (got > 0)
    shown_.append(block.data(), static_cast<std::size_t>(got));
  else
    ::usleep(10'000);  // nobody has the terminal open
}

bool Terminal::await_text(std::string_view text, std::chrono::milliseconds patience) {
  for (const auto until = Clock::now() + patience; Clock::now() < until; read_some())
    if (shown_.find(text) != std::string::npos) return true;
  return false;
}

std::optional<int> Terminal::wait(std::chrono::milliseconds patience) {
  for (const auto until = Clock::now() + patience; !exit_code_ && Clock::now() < until; read_some()) {
    int status = 0;
    if (::waitpid(pid_, &status, WNOHANG) == pid_)
      exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  return exit_code_;
}

}  // namespace telepalp::support
