#pragma once

#include <functional>
#include <string>

#include "tools/study/run/parts.h"

namespace telepalp::study {

/// Shows on standard error how far a long run is: in one line of the terminal, which is erased at the end, or in about
/// eight log lines if there is no terminal.
class ProgressLine {
 public:
  ProgressLine();
  void show(const std::string& text, int done, int all) const;

 private:
  bool in_terminal_;
};

/// Logs how many parts were finished by an earlier run, and makes Ctrl-C print which parts are kept. Returns a function
/// that shows the number of parts that are done, as ProgressLine does.
[[nodiscard]] std::function<void(int)> tell_progress(const Parts& parts);

}  // namespace telepalp::study
