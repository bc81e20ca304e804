#pragma once

#include <string>

#include "haptic_station/scenes/field_check.h"
#include "haptic_station/tissue/tissue_settings.h"

namespace telepalp::scenes {

[[nodiscard]] inline Range within(const tissue::Limit& limit) { return {limit.least, limit.most, limit.unit}; }

/// Reads the numbers of one message. A number that is missing keeps its value. `prefix`: of the fields' names in
/// errors. TELEPALP_READ cannot read these fields: Protobuf's accessors write the units in their names in lower case.
struct NumberReader {
  FieldCheck& check;
  const google::protobuf::Message& given;
  std::string prefix;

  void operator()(bool has, const char* field, double value, const tissue::Limit& limit, double& into) const {
    if (has) check.in(given).number(prefix + field, value, within(limit), into);
  }
  void operator()(bool has, const char* field, double value, const tissue::Limit& limit, int& into) const {
    double number = into;
    (*this)(has, field, value, limit, number);
    into = static_cast<int>(number);
  }
};

}  // namespace telepalp::scenes
