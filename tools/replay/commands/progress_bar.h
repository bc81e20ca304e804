#pragma once

#include <algorithm>
#include <cstdio>
#include <string>

#include "support/program/terminal.h"

namespace telepalp::replay {

/// A progress bar on stderr; prints nothing if stderr is not a terminal.
class ProgressBar {
 public:
  explicit ProgressBar(double total) : total_(total), shown_(total > 0.0 && program::takes_progress(stderr)) {}
  ~ProgressBar() {
    if (shown_) std::fputs("\r\033[K", stderr);
  }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  [[nodiscard]] bool is_shown() const noexcept { return shown_; }

  /// `done`: the finished part of `total`. `unit`: the unit of both, as text.
  void show(double done, const char* unit) {
    if (!shown_) return;
    constexpr std::size_t kWidth = 40;
    const auto filled = static_cast<std::size_t>(kWidth * std::clamp(done / total_, 0.0, 1.0));
    const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
    std::fprintf(stderr, "\r[%s] %.1f of %.1f %s\033[K", bar.c_str(), done, total_, unit);
  }

 private:
  double total_;
  bool shown_;
};

}  // namespace telepalp::replay
