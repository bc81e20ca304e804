#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "proto/words/result.h"
#include "tests/bench/cluster/watching.h"
#include "tests/bench/site/two_networks.h"
#include "tests/support/child_process.h"

namespace telepalp::bench {

/// The programs of a long run, and 20 viewers at the edge. Used on a thread in the doctor's network, with which the
/// programs end.
class SoakSite {
 public:
  static constexpr std::size_t kViewers = 20;

  /// Makes the keys, starts the programs, and waits until the surface is touchable and each viewer sees. Error: a
  /// program does not start; the error names its log.
  [[nodiscard]] static Result<std::unique_ptr<SoakSite>> begin(const TwoNetworks& networks,
                                                               const std::filesystem::path& scratch);
  /// Lets the viewers receive for `seconds`, and returns the number of them that got an image meanwhile.
  std::size_t run(double seconds);
  /// What a viewer that got no image in the last run() says of its connection; empty: each got one.
  [[nodiscard]] const std::string& blind() const noexcept { return blind_; }
  /// Renews the certificate of the edge, ends the edge, and starts it again. Error: it does not start.
  [[nodiscard]] Result<void> renew_and_restart_edge();
  /// Ends all programs. Returns the file that the recorder wrote.
  std::filesystem::path end();

  struct Program {
    std::string name;
    std::unique_ptr<support::ChildProcess> process;
  };
  [[nodiscard]] const std::vector<Program>& programs() const noexcept { return programs_; }
  [[nodiscard]] double longest_gap_s() const;  ///< of all viewers, since they saw the first image

 private:
  SoakSite(const TwoNetworks& networks, std::filesystem::path scratch)
      : networks_(networks), scratch_(std::move(scratch)) {}
  [[nodiscard]] Result<void> keys(const std::vector<std::string>& command) const;
  [[nodiscard]] Result<void> make_keys() const;
  [[nodiscard]] std::string key(const char* name) const { return (scratch_ / "keys" / name).string(); }
  /// Starts a program, and waits for `ready`: words in its log.
  [[nodiscard]] Result<void> start(TwoNetworks::Side side, const std::string& name, const std::string& program,
                                   const std::vector<std::string>& options, const std::string& ready);
  [[nodiscard]] Result<void> start_links();
  [[nodiscard]] Result<void> start_site();
  [[nodiscard]] Result<void> start_edge();
  [[nodiscard]] Result<void> add_viewers();

  const TwoNetworks& networks_;
  std::filesystem::path scratch_;
  std::vector<Program> programs_;
  std::unique_ptr<Viewers> viewers_;
  std::vector<const Watched*> watched_;
  std::string blind_;
};

}  // namespace telepalp::bench
