#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "haptic_station/solids/polish.h"
#include "haptic_station/solids/solid_tree.h"

namespace telepalp::solids {

/// The solid of `text` in Polish notation, which must be valid.
inline std::shared_ptr<const SolidTree> tree_of(const std::string& text) {
  const Result<Solid> solid = parse_polish(text, "test");
  EXPECT_TRUE(solid.ok()) << (solid.ok() ? "" : to_string(solid.error()));
  const auto tree = build_tree(*solid);
  EXPECT_TRUE(tree.ok()) << (tree.ok() ? "" : to_string(tree.error()));
  return *tree;
}

}  // namespace telepalp::solids
