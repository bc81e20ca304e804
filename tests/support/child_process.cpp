#include "tests/support/child_process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "proto/words/demand.h"

extern char** environ;

namespace telepalp::support {
namespace {

using namespace std::chrono_literals;
using SteadyClock = std::chrono::steady_clock;

constexpr auto kPoll = 10ms;

}  // namespace

ChildProcess::ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                           const std::filesystem::path& log) {
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  if (!log.empty()) {
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
  }
  // A child that inherits a socket would keep its port in use after this process has closed it.
  posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
  const int failed = posix_spawn(&pid_, program.c_str(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  demand(failed == 0, "the program under test starts");
}

ChildProcess::~ChildProcess() {
  if (exit_code_) return;
  signal(SIGTERM);
  if (wait(5s)) return;
  signal(SIGKILL);
  (void)wait(5s);
}

void ChildProcess::signal(int number) const noexcept {
  if (pid_ > 0 && !exit_code_) ::kill(pid_, number);
}

std::optional<int> ChildProcess::wait(std::chrono::milliseconds patience) {
  const auto until = SteadyClock::now() + patience;
  while (!exit_code_) {
    int status = 0;
    if (::waitpid(pid_, &status, WNOHANG) == pid_)
      exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    else if (SteadyClock::now() >= until)
      return std::nullopt;
    else
      std::this_thread::sleep_for(kPoll);
  }
  return exit_code_;
}

std::optional<std::string> await_ready(const std::filesystem::path& file, const std::string& key,
                                       std::chrono::milliseconds patience) {
  const auto until = SteadyClock::now() + patience;
  do {
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);)
      if (line.starts_with(key + "=")) return line.substr(key.size() + 1);
    std::this_thread::sleep_for(kPoll);
  } while (SteadyClock::now() < until);
  return std::nullopt;
}

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "telepalp.XXXXXX").string();
  demand(::mkdtemp(pattern.data()) != nullptr, "a temporary folder can be made");
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace telepalp::support
