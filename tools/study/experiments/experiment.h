#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/study/figures/t_test.h"
#include "tools/study/person/parameter.h"

namespace telepalp::study {

/// What one observer did in one trial.
struct Row {
  std::size_t observer = 0;
  std::size_t condition = 0;   ///< index in Experiment::conditions
  int trial = 0;               ///< from 0, in this condition
  std::vector<double> values;  ///< in the order of Experiment::columns
};

/// A figure of an experiment in its first two conditions, one value for each observer. In a study within subjects, both
/// lists are in the order of the observers.
struct Measure {
  std::string name;
  std::string unit;
  std::vector<double> first;
  std::vector<double> second;
  std::optional<std::pair<Sample, Sample>> paper = {};  ///< what the paper printed for the same conditions
  std::string paper_says = {};                          ///< the paper's own test, as printed
};

/// A chart for the page: several curves on the same axes.
struct Curves {
  std::string title;
  std::string x_label;
  std::string y_label;
  struct Curve {
    std::string name;
    std::vector<double> x;
    std::vector<double> y;
  };
  std::vector<Curve> curves;
};

/// A parameter of the observers or of the task, with its source, as words for the page.
struct RangeWords {
  std::string name;
  std::string range;
  std::string source;
};

enum class Subjects {
  Between,  ///< each observer takes part in one condition
  Within,   ///< each observer takes part in all conditions
};

/// A study with simulated observers. Pure: the rows of an observer depend on seed and number alone.
struct Experiment {
  std::string name;   ///< as on the command line
  std::string title;  ///< heading of the page
  std::string task;   ///< what an observer does, and by which rule
  std::vector<std::string> conditions;
  Subjects subjects = Subjects::Within;
  std::string columns;  ///< of a row as CSV: observer,condition,trial, then the names of the values
  std::string variant;  ///< a further setting on which the rows depend; empty: none
  std::vector<RangeWords> ranges;
  std::vector<std::string> limits;  ///< what simulated observers cannot show
  std::function<std::vector<Row>(std::uint64_t seed, std::size_t observer)> run;
  std::function<std::vector<Measure>(const std::vector<Row>&)> measures;
  std::function<std::vector<std::string>(const std::vector<Row>&)> findings;  ///< sentences besides those of the tests
  std::function<std::vector<Curves>(const std::vector<Row>&)> curves;
};

/// The ranges as words for the page.
template <class Owner>
[[nodiscard]] std::vector<RangeWords> in_words(std::span<const Drawn<Owner>> ranges) {
  std::vector<RangeWords> words;
  for (const Drawn<Owner>& one : ranges)
    words.push_back({std::string(one.name),
                     number_text(one.least) + " to " + number_text(one.most) + " " + std::string(one.unit),
                     std::string(one.source)});
  return words;
}

/// The order in which an observer takes part in the conditions. The first n! observers have the n! orders of n
/// conditions once each, shuffled by the seed; so do the next n! observers, and so on.
[[nodiscard]] std::vector<std::size_t> order_of(std::uint64_t seed, std::size_t observer, std::size_t conditions);

/// Parts of the experiments, for seed_of(). The needle's study has the numbers below 100.
enum ExperimentPart : std::uint64_t { kObserver = 101, kOrders, kTask };

}  // namespace telepalp::study
