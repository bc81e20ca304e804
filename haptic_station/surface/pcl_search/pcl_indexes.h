#pragma once

namespace telepalp::surface {

/// From now on, a setting that names an index of PCL uses it. Without this call it uses nanoflann's, which finds the
/// same neighbours, so that only a program that calls this needs PCL. Call it in main(), before any other thread
/// begins.
void use_pcl_indexes() noexcept;

}  // namespace telepalp::surface
