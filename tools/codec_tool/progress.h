#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string>

#include "support/program/terminal.h"

namespace telepalp::codec_tool {

/// A progress bar on stderr; prints nothing if stderr is not a terminal.
class Progress {
 public:
  /// `total`: number of all frames; 0: unknown.
  explicit Progress(std::size_t total) : total_(total), shown_(program::takes_progress(stderr)) {}
  ~Progress() {
    if (shown_ && done_ > 0) std::fputc('\n', stderr);
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void step() {
    ++done_;
    if (!shown_) return;
    constexpr std::size_t kWidth = 40;
    const std::size_t filled = total_ == 0 ? 0 : std::min(kWidth, kWidth * done_ / total_);
    const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
    std::fprintf(stderr, "\r[%s] frames: %zu%s", bar.c_str(), done_,
                 total_ == 0 ? "" : (" of " + std::to_string(total_)).c_str());
  }

 private:
  std::size_t total_;
  std::size_t done_ = 0;
  bool shown_;
};

}  // namespace telepalp::codec_tool
