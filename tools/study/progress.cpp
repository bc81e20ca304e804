#include "tools/study/progress.h"

#include <algorithm>
#include <cstdio>

#include "support/program/ending.h"
#include "support/program/log.h"
#include "support/program/terminal.h"

namespace telepalp::study {

std::function<void(int)> tell_progress(const Parts& parts) {
  const std::string of_all = " of " + std::to_string(parts.count) + " parts";
  if (const int kept = kept_parts(parts); kept > 0)
    program::log("telepalp-study", std::to_string(kept) + of_all + " were finished before, and are not run again");
  program::say_when_stopped("\ntelepalp-study: stopped: finished parts are kept in " + parts.folder.string() +
                            "; the same command resumes");
  return [of_all, all = parts.count, bar = program::takes_progress(stderr)](int done) {
    if (bar)
      std::fprintf(stderr, "\r\033[K%s", done == all ? "" : (std::to_string(done) + of_all).c_str());
    else if (done % std::max(1, all / 8) == 0)
      program::log("telepalp-study", std::to_string(done) + of_all);
  };
}

}  // namespace telepalp::study
