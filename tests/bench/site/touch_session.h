#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "proto/words/result.h"
#include "proto/words/time.h"
#include "tests/bench/site/two_networks.h"

namespace telepalp::bench {

/// What a recorder at the patient's site wrote down of one session. All times are session times.
struct TouchRecord {
  struct Image {
    Nanoseconds captured{0}, touchable{0};
  };
  struct State {
    Nanoseconds at{0};
    bool released = false;  ///< the station gives no force, because its inputs are too old
  };
  struct Sent {
    Nanoseconds at{0};
    double bytes = 0.0;  ///< to the station since the server's start
    bool told = false;   ///< the server says that something else uses the station's line
  };
  std::vector<Image> images;
  std::vector<State> states;
  std::vector<Sent> sent;
  std::vector<Nanoseconds> full_again;  ///< when the server's log says that images are as large as before
};

/// A real server and recorder at the patient's site, and a real station at the doctor's.
class TouchSession {
 public:
  /// Starts the programs and waits until the surface is touchable. `number`: differs for each session of one run.
  /// Error: a program did not start; the error names its log.
  [[nodiscard]] static Result<std::unique_ptr<TouchSession>> begin(const TwoNetworks& networks,
                                                                   const std::filesystem::path& programs,
                                                                   const std::filesystem::path& folder, int number);
  /// Ends the programs and reads the recording.
  [[nodiscard]] Result<TouchRecord> end();

 private:
  TouchSession() = default;
  [[nodiscard]] Result<void> start(const TwoNetworks& networks, const std::filesystem::path& programs, int number);

  std::filesystem::path folder_;
  std::unique_ptr<support::ChildProcess> server_, recorder_, station_;  ///< the last one ends first
};

}  // namespace telepalp::bench
