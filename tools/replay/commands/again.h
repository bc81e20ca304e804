#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "support/program/options.h"
#include "tools/replay/commands/request.h"

namespace telepalp::replay {

/// What report.json says about how its run is made again.
struct Again {
  std::string source;
  std::string source_digest;  ///< empty: the source is no file
  std::string scene_text;
  RunOptions options;
};

/// Reads report.json, or the file report.json in the folder `asked`. Error: no report of telepalp-replay, or one of a
/// version that does not write how its run is made again.
[[nodiscard]] Result<Again> read_again(const std::filesystem::path& asked);

/// The command line `words` (without the program's name), completed from `again`: its source replaces again:DIR, and
/// its options are added where `words` do not give them.
[[nodiscard]] std::vector<std::string> words_again(const Again& again, const std::vector<std::string>& words);

/// The run that the arguments `given` ask for; `words` are the same command line, without the program's name. With the
/// source again:DIR, source and options of that run fill what is not given. Error: a wrong command line, or a source or
/// scene file that has changed since that run.
[[nodiscard]] Result<Request> read_command_line(const program::Arguments& given, const std::vector<std::string>& words);

}  // namespace telepalp::replay
