#pragma once

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/support/child_process.h"
#include "where.h"

namespace telepalp::keys {

namespace fs = std::filesystem;

inline std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

struct KeysProgram : testing::Test {
  support::TemporaryFolder temporary;
  fs::path folder = temporary.path() / "keys";
  fs::path log = temporary.path() / "log";

  /// The exit code of telepalp-keys; `log` then holds what it said on stderr.
  int run(const std::vector<std::string>& words) { return run_in(folder, words); }
  /// The same with another folder than `folder`.
  int run_in(const fs::path& dir, std::vector<std::string> words) {
    words.insert(words.end(), {"--dir", dir.string()});
    support::ChildProcess process(fs::path(TELEPALP_BINARY_DIR "/bin/telepalp-keys"), words, log);
    return process.wait(std::chrono::seconds(120)).value_or(-1);
  }
  unsigned mode_of(const std::string& name) const {
    struct stat facts {};
    EXPECT_EQ(::stat((folder / name).c_str(), &facts), 0) << name;
    return facts.st_mode & 0777U;
  }
};

}  // namespace telepalp::keys
