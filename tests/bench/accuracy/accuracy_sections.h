#pragma once

#include <vector>

#include "tests/bench/accuracy/accuracy_page.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// Result of one part of the accuracy benchmark: its figures, and its text for the page.
struct Section {
  std::vector<Row> rows;
  std::vector<PagePart> parts;
  std::vector<PagePicture> pictures;
};

/// The surface's settings and parameters: error, cost, the front of both and its knee; then over noise and density.
[[nodiscard]] Result<Section> surface_section();
/// The error of the settings over the slope of the skin against the camera's ray.
[[nodiscard]] Result<Section> slopes_section();
/// The error of each setting on moving patients.
[[nodiscard]] Result<Section> patients_section();
/// Errors of the models that predict the hand and the surface.
[[nodiscard]] Result<Section> prediction_section();
/// The cell size of an organ: time that a coarser lattice saves, and error that it causes.
[[nodiscard]] Result<Section> organ_section();
/// The proxy of a layer of solids: error and cost over rounds, tolerance, size of the tree, skipping and blends.
[[nodiscard]] Result<Section> solids_section();
/// The needle of `amniocentesis`: error and cost over the net's edge and subdivisions, and over the muscle's laws and
/// steps. A soft prism over its meshes and the rate of its local models. Ways to find a contact.
[[nodiscard]] Result<Section> needle_section();
/// The bill of each library scene, and what each kind of effect costs: processor time, memory, start-up, and the error
/// of the force in motion.
[[nodiscard]] Result<Section> price_section();
/// What further settings cost and gain: JPEG quality, camera, disparity levels, the skin's anchor, the radius of a
/// mark, ultrasound size, the viewer's levels of detail.
[[nodiscard]] Result<Section> settings_section();
/// The stiffest wall that the simulated device can show, over sampling rate and damping, then over loop delay and
/// encoder step.
[[nodiscard]] Result<Section> z_width_section();
/// The depth codec's modes, and the force error that Bounded causes.
[[nodiscard]] Result<Section> depth_section();
/// What it costs to send less over a thin line: depth that is exact in a window, for several sizes of the window and
/// bounds outside it; and colour as VP8, for several rates, beside JPEG.
[[nodiscard]] Result<Section> thin_section();

}  // namespace telepalp::bench
