#include "tools/study/progress.h"

#include <algorithm>
#include <cstdio>

#include "support/program/ending.h"
#include "support/program/log.h"
#include "support/program/terminal.h"

namespace telepalp::study {

ProgressLine::ProgressLine() : in_terminal_(program::takes_progress(stderr)) {}

void ProgressLine::show(const std::string& text, int done, int all) const {
  if (in_terminal_)
    std::fprintf(stderr, "\r\033[K%s", done == all ? "" : text.c_str());
  else if (done % std::max(1, all / 8) == 0 || done == all)
    program::log("telepalp-study", text);
}

std::function<void(int)> tell_progress(const Parts& parts) {
  const std::string of_all = " of " + std::to_string(parts.count) + " parts";
  if (const int kept = kept_parts(parts); kept > 0)
    program::log("telepalp-study", std::to_string(kept) + of_all + " were finished before, and are not run again");
  program::say_when_stopped("\ntelepalp-study: stopped: finished parts are kept in " + parts.folder.string() +
                            "; the same command resumes");
  return [of_all, all = parts.count, line = ProgressLine()](int done) {
    line.show(std::to_string(done) + of_all, done, all);
  };
}

}  // namespace telepalp::study
