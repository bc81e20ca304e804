#include "server/recording/recorder_process.h"

#include <fcntl.h>
#include <linux/close_range.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace telepalp::recording {
namespace {

constexpr int kNotStarted = 127;  // exit code of a shell whose command cannot be started

Error cannot_start(const std::filesystem::path& program, int code) {
  return {.what = "the recorder cannot be started: " + std::string(std::strerror(code)),
          .where = program.string(),
          .fix = "install telepalp-record beside telepalp-server"};
}

Error cannot_write(const std::filesystem::path& log, int code) {
  return {.what = "the recorder's log cannot be written: " + std::string(std::strerror(code)),
          .where = log.string(),
          .fix = "free space on the disk, or name another folder by --record-dir"};
}

/// Runs in the child between fork() and execv(). The parent has threads, so only async-signal-safe calls are allowed.
[[noreturn]] void become(const char* program, char* const* arguments, int log) noexcept {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  const int nothing = ::open("/dev/null", O_RDWR);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(nothing, STDOUT_FILENO);
  ::dup2(log, STDERR_FILENO);
  // A child that inherits a socket would keep the server's port in use.
  ::close_range(STDERR_FILENO + 1, ~0U, 0);
  ::execv(program, arguments);
  ::_exit(kNotStarted);
}

}  // namespace

Result<RecorderProcess> RecorderProcess::start(const std::filesystem::path& program,
                                               const std::vector<std::string>& arguments,
                                               const std::filesystem::path& log) {
  if (::access(program.c_str(), X_OK) != 0) return cannot_start(program, errno);
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const int written = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (written < 0) return cannot_write(log, errno);
  const pid_t child = ::fork();
  if (child == 0) become(program.c_str(), argv.data(), written);
  const int code = errno;
  ::close(written);
  if (child < 0) return cannot_start(program, code);
  return RecorderProcess(child);
}

void RecorderProcess::ask_to_end() const noexcept {
  if (!exit_code_) ::kill(pid_, SIGTERM);
}

std::optional<int> RecorderProcess::exit_code() noexcept {
  int status = 0;
  if (!exit_code_ && ::waitpid(pid_, &status, WNOHANG) == pid_)
    exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return exit_code_;
}

}  // namespace telepalp::recording
