#include "server/capture/oni/stream_property.h"

#include "proto/words/little_endian.h"

namespace telepalp::capture {
namespace {

/// Reads fields in order; after a missing field, all later ones count as missing.
class Fields {
 public:
  explicit Fields(std::string_view left) : left_(left) {}
  std::optional<std::string_view> bytes(std::size_t count) {
    if (missing_ || count > left_.size()) {
      missing_ = true;
      return std::nullopt;
    }
    const std::string_view taken = left_.substr(0, count);
    left_.remove_prefix(count);
    return taken;
  }
  std::optional<std::uint32_t> number() {
    const auto four = bytes(4);
    if (!four) return std::nullopt;
    return get_little_endian<std::uint32_t>(four->data());
  }
  std::optional<std::string_view> counted() {
    const auto count = number();
    return count ? bytes(*count) : std::nullopt;
  }

 private:
  std::string_view left_;
  bool missing_ = false;
};

}  // namespace

std::optional<OniProperty> property_in(const OniRecord& record) {
  Fields fields(record.fields);
  const auto name = fields.counted();
  const auto value = fields.counted();
  if (!value || !name->ends_with('\0')) return std::nullopt;
  return OniProperty{name->substr(0, name->size() - 1), *value};
}

std::optional<OniNode> node_in(const OniRecord& record) {
  Fields fields(record.fields);
  (void)fields.counted();  // the node's name
  const auto type = fields.number();
  const auto codec = fields.bytes(4);
  if (!codec) return std::nullopt;
  OniNode node{.type = *type, .codec = *codec};
  if (record.kind != OniRecordKind::NodeAdded4) node.frames = fields.number();
  return node;
}

}  // namespace telepalp::capture
