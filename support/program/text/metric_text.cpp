#include "support/program/text/metric_text.h"

namespace telepalp::program {

std::string metric_heading(const std::string& name, const std::string& type, const std::string& help) {
  return "# HELP " + name + " " + help + "\n# TYPE " + name + " " + type + "\n";
}

std::string metric_text(const std::string& name, const std::string& type, const std::string& help,
                        std::uint64_t value) {
  return metric_heading(name, type, help) + name + " " + std::to_string(value) + "\n";
}

}  // namespace telepalp::program
