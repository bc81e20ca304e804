#include "clients/record/selection/topic_filter.h"

#include <fnmatch.h>

#include <algorithm>
#include <boost/algorithm/string.hpp>

namespace telepalp::record {
namespace {

bool any_matches(const std::vector<std::string>& patterns, const std::string& topic) {
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](const std::string& pattern) { return ::fnmatch(pattern.c_str(), topic.c_str(), 0) == 0; });
}

}  // namespace

TopicFilter::TopicFilter(const std::string& comma_separated) {
  std::vector<std::string> words;
  boost::split(words, comma_separated, boost::is_any_of(", "), boost::token_compress_on);
  for (const std::string& word : words) {
    if (word.starts_with('!'))
      excluded_.push_back(word.substr(1));
    else if (!word.empty())
      included_.push_back(word);
  }
  if (included_.empty()) included_.emplace_back("*");
}

bool TopicFilter::matches(std::string_view topic) const {
  const std::string name(topic);
  return any_matches(included_, name) && !any_matches(excluded_, name);
}

std::vector<std::string> TopicFilter::subscription() const {
  std::vector<std::string> topics;
  for (const std::string& pattern : included_) {
    const std::size_t wildcard = pattern.find_first_of("*?[\\");
    topics.push_back(wildcard == std::string::npos ? pattern : pattern.substr(0, wildcard) + "*");
  }
  return topics;
}

}  // namespace telepalp::record
