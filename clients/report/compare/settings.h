#pragma once

#include <string>
#include <vector>

#include "clients/report/compare/run.h"

namespace telepalp::report {

/// A condition under which the two runs took place. A text is empty where a session does not state it.
struct Setting {
  std::string name;
  std::string a;
  std::string b;
  [[nodiscard]] bool differs() const { return a != b; }
};

/// Network, software, source, scene, surface, camera, computer and other settings of both runs, the differing ones
/// first. Settings that neither session states are left out.
[[nodiscard]] std::vector<Setting> settings_of(const Run& a, const Run& b);

}  // namespace telepalp::report
