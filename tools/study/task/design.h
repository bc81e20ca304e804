#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "haptic_station/mechanism/four_bar.h"
#include "proto/words/result.h"
#include "tools/study/task/other_mechanism.h"

namespace telepalp::study {

/// One mechanism of a study.
struct Configuration {
  std::string name;
  std::optional<OtherMechanism> other{};  ///< in the place of `bar`
  mechanism::FourBar bar{};  ///< the plant gives l4_m unless `l4_given`, and needle_m unless `needle_given`
  bool l4_given = false;
  bool needle_given = false;
};

struct Design {
  std::string name;
  std::vector<Configuration> configurations;
  bool of_the_paper = false;  ///< its configurations have the order of S4's Table 2
};

/// A parameter of a mechanism as lists name it: l1, l2, l3, l4, theta, phi, h, l_h, needle.
struct MechanismParameter {
  std::string_view name;
  double mechanism::FourBar::*value;
  double unit;  ///< what one unit of text is in SI: 1e-3 for mm, 1 for rad
};
[[nodiscard]] std::span<const MechanismParameter> mechanism_parameters() noexcept;

/// S4's Table 1: 3 linkages, 3 angles phi, 2 places h and 2 lengths l_h of the handle.
[[nodiscard]] Design amniocentesis_design();

/// A list in a text file: one mechanism a line, as `name=value` pairs in mm and rad. Lines that begin with # are
/// comments. `kind=` four-bar (also without it), slider-crank, five-bar or six-bar comes before the parameters. One
/// that a line leaves out is that of S4's first linkage, or of the kind. Error: `file:line:column`, with what is wrong.
[[nodiscard]] Result<Design> parse_design(const std::string& text, const std::string& file);
[[nodiscard]] Result<Design> read_design(const std::filesystem::path& file);

}  // namespace telepalp::study
