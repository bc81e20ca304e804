#pragma once

#include <cstdint>
#include <string>

namespace telepalp::program {

/// The lines that precede the values of a metric in Prometheus' text format. `type`: "counter" or "gauge".
[[nodiscard]] std::string metric_heading(const std::string& name, const std::string& type, const std::string& help);

/// A metric with one value, with its heading.
[[nodiscard]] std::string metric_text(const std::string& name, const std::string& type, const std::string& help,
                                      std::uint64_t value);

}  // namespace telepalp::program
