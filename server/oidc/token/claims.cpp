#include "server/oidc/token/claims.h"

#include <algorithm>

#include "support/program/message_json.h"

namespace telepalp::oidc {

using google::protobuf::Value;

Result<Claims> read_claims(const std::string& json, const std::string& whose) {
  Claims claims;
  if (const Result<void> read = program::read_json(json, claims, whose, "ask who runs the provider"); !read)
    return read.error();
  return claims;
}

const Value* find(const Claims& claims, std::string_view name) {
  if (const auto found = claims.fields().find(std::string(name)); found != claims.fields().end()) return &found->second;
  const std::size_t dot = name.find('.');
  if (dot == std::string_view::npos) return nullptr;
  const auto outer = claims.fields().find(std::string(name.substr(0, dot)));
  if (outer == claims.fields().end() || !outer->second.has_struct_value()) return nullptr;
  return find(outer->second.struct_value(), name.substr(dot + 1));
}

std::string text_of(const Claims& claims, std::string_view name) {
  const Value* const value = find(claims, name);
  return value != nullptr && value->has_string_value() ? value->string_value() : "";
}

std::optional<double> number_of(const Claims& claims, std::string_view name) {
  const Value* const value = find(claims, name);
  return value != nullptr && value->has_number_value() ? std::optional(value->number_value()) : std::nullopt;
}

bool states(const Claims& claims, std::string_view name, std::string_view wanted) {
  const Value* const value = find(claims, name);
  if (value == nullptr) return false;
  const auto is_wanted = [wanted](const Value& one) { return one.has_string_value() && one.string_value() == wanted; };
  return is_wanted(*value) || (value->has_list_value() && std::ranges::any_of(value->list_value().values(), is_wanted));
}

}  // namespace telepalp::oidc
