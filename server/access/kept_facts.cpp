#include "server/access/kept_facts.h"

#include <fstream>
#include <utility>

#include "proto/keys/key_file.h"

namespace telepalp::access {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 20;

/// True if `text` fits in one line. The values do, because names of persons have no control characters.
bool is_plain(const std::string& text) { return text.find('\n') == std::string::npos; }

}  // namespace

Result<KeptFacts> KeptFacts::open(fs::path file) {
  KeptFacts kept(std::move(file));
  std::error_code failed;
  if (!fs::exists(kept.file_, failed)) return kept;
  std::ifstream stream(kept.file_, std::ios::binary);
  if (!stream || fs::file_size(kept.file_, failed) > kMostBytes || failed)
    return Error{
        .what = "the file in which this server keeps who used which token cannot be read",
        .where = kept.file_.string(),
        .fix = "check that this program may read it; or remove it: then an older list of revoked keys is taken"};
  for (std::string line; std::getline(stream, line);)
    if (const std::size_t equals = line.find('='); equals != std::string::npos)
      kept.facts_[line.substr(0, equals)] = line.substr(equals + 1);
  return kept;
}

std::optional<std::string> KeptFacts::get(const std::string& name) const {
  const auto found = facts_.find(name);
  return found == facts_.end() ? std::nullopt : std::optional(found->second);
}

bool KeptFacts::set(const std::string& name, const std::optional<std::string>& value) {
  if (get(name) == value) return true;
  if (value && is_plain(*value))
    facts_[name] = *value;
  else
    facts_.erase(name);
  std::string text;
  for (const auto& [fact, known] : facts_) text += fact + "=" + known + "\n";
  return keys::replace_file(file_, text);
}

}  // namespace telepalp::access
