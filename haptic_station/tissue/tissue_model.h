#pragma once

#include "haptic_station/tissue/force_bound.h"
#include "haptic_station/tissue/mesh/triangle_tree.h"
#include "haptic_station/tissue/net/stiffness_map.h"
#include "haptic_station/tissue/tissue_settings.h"

namespace telepalp::tissue {

struct TissueModel {
  TissueModel(const TissueSettings& given, SurfaceMesh surface)
      : settings(given),
        mesh(std::move(surface)),
        tree(mesh),
        stiffness(mesh, given.net),
        most_N(most_force_N(settings, stiffness.range())) {}
  TissueModel(const TissueModel&) = delete;
  TissueModel& operator=(const TissueModel&) = delete;

  TissueSettings settings;
  SurfaceMesh mesh;
  TriangleTree tree;
  StiffnessMap stiffness;
  double most_N = 0.0;  ///< greatest force on a needle
};

}  // namespace telepalp::tissue
