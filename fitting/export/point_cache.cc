// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/export/point_cache.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace clothfit {
namespace {

enum class Order { kLittle, kBig };

template <class T>
void Append(T value, Order order, std::string* bytes) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (order == Order::kBig) std::reverse(raw, raw + sizeof(T));
  bytes->append(raw, sizeof(T));
}

void AppendPlaces(const RunMotion& motion, Order order, std::string* bytes) {
  for (const Eigen::VectorXd& frame : motion.frames) {
    for (const double coordinate : frame) Append(static_cast<float>(coordinate), order, bytes);
  }
}

}  // namespace

std::string MotionAsPc2(const RunMotion& motion) {
  std::string bytes("POINTCACHE2\0", 12);
  Append<std::int32_t>(1, Order::kLittle, &bytes);  // version
  Append<std::int32_t>(motion.mesh.num_particles(), Order::kLittle, &bytes);
  Append<float>(0.0F, Order::kLittle, &bytes);  // first frame
  Append<float>(1.0F, Order::kLittle, &bytes);  // frames a sample
  Append(static_cast<std::int32_t>(motion.frames.size()), Order::kLittle, &bytes);
  AppendPlaces(motion, Order::kLittle, &bytes);
  return bytes;
}

std::string MotionAsMdd(const RunMotion& motion) {
  std::string bytes;
  Append(static_cast<std::int32_t>(motion.frames.size()), Order::kBig, &bytes);
  Append<std::int32_t>(motion.mesh.num_particles(), Order::kBig, &bytes);
  for (std::size_t f = 0; f < motion.frames.size(); ++f) {
    Append(static_cast<float>(static_cast<double>(f) / motion.frame_rate), Order::kBig, &bytes);
  }
  AppendPlaces(motion, Order::kBig, &bytes);
  return bytes;
}

}  // namespace clothfit
