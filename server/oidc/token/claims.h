#pragma once

#include <google/protobuf/struct.pb.h>

#include <optional>
#include <string>
#include <string_view>

#include "proto/words/result.h"

namespace telepalp::oidc {

/// A JSON object. Nothing in it is trusted before its signature was checked.
using Claims = google::protobuf::Struct;

/// Error: `json` is not a JSON object, or is nested deeper than 100. `whose`: for the error.
[[nodiscard]] Result<Claims> read_claims(const std::string& json, const std::string& whose);

/// The claim `name`, or else, for a name such as "realm_access.roles", the claim inside an object; null: there is none.
[[nodiscard]] const google::protobuf::Value* find(const Claims& claims, std::string_view name);
/// The claim `name` if it is a text; empty: it is missing or something else.
[[nodiscard]] std::string text_of(const Claims& claims, std::string_view name);
[[nodiscard]] std::optional<double> number_of(const Claims& claims, std::string_view name);
/// True if the claim `name` is the text `wanted`, or a list that has it.
[[nodiscard]] bool states(const Claims& claims, std::string_view name, std::string_view wanted);

}  // namespace telepalp::oidc
