#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "messages/recording.pb.h"
#include "proto/words/result.h"
#include "server/origin/opening_pool.h"
#include "server/origin/origin.h"
#include "server/origin/reading.h"

namespace telepalp::origin {

/// The source that the server shows to all, as technicians choose it: the one of the command line, the synthetic
/// patient, the cameras that were found, and the recordings. No other one can be named. Owner: the network thread.
class SourceChoice {
 public:
  struct Source {
    std::string name;   ///< as after --source
    std::string title;  ///< for a person
  };
  struct Parts {
    Source first{};                                           ///< shown since the start
    std::function<std::vector<Source>()> recordings{};        ///< those of the folder of recordings
    std::function<std::vector<Source>()> look_for_cameras{};  ///< on a thread of the pool
    /// Opens a source. `progress` and `done` are called on the network thread, `done` once, now or later.
    std::function<void(const std::string& name, Progress progress, OpenedOrigin done)> open{};
    std::function<void(std::unique_ptr<Origin>)> show{};  ///< instead of the present one
  };
  /// This object must live until `pool` has ended, or the network thread runs no more.
  SourceChoice(OpeningPool& pool, Parts parts);

  /// msg::SourceState, msg::SourceCommand. Valid while this object lives.
  [[nodiscard]] Resource resource();

 private:
  [[nodiscard]] std::vector<Source> sources() const;
  [[nodiscard]] msg::SourceState state();
  [[nodiscard]] Result<void> apply(const std::string& json);
  [[nodiscard]] Result<void> choose(const std::string& name);
  void look_for_cameras();

  OpeningPool& pool_;
  Parts parts_;
  bool looked_ = false;          // for cameras: once somebody has asked for the state
  std::vector<Source> cameras_;  // as found last
  msg::SourceState state_;       // without `sources`, which each state() lists again
};

}  // namespace telepalp::origin
