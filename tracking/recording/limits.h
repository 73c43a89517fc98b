// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The largest and smallest that a recording may state. Beyond them lies a slip of the keyboard or
// another unit, and work or memory without bound.
#pragma once

namespace clothfit {

struct Limits {
  double least, most;
};

// An hour at 240 Hz has 864 000.
inline constexpr int kMostFrames = 1'000'000;
// Hz. A frame is simulated in steps of 0.01 s or so: a slower rate is mostly simulation.
inline constexpr Limits kFrameRate{0.01, 100'000.0};
// Particles along a side: the mesh of a thousand each way is ten times finer than cloth is fitted.
inline constexpr int kMostResolution = 1000;
inline constexpr Limits kSide{1e-4, 1000.0};     // m, of the cloth: a thread to a stadium's roof
inline constexpr Limits kDensity{1e-4, 1000.0};  // kg/m^2: far below and above any fabric
inline constexpr double kMostGravity = 1000.0;   // m/s^2, a hundred times that of the Earth
// m, from the origin of the world: rays are traced in single precision, which there is 1 mm.
inline constexpr double kFarthest = 10'000.0;
inline constexpr Limits kLength{1e-6, 10'000.0};  // m, of obstacles
// rad, of an obstacle: a wheel that turns for a day. The squares of larger ones overflow.
inline constexpr double kMostRotation = 1e6;
inline constexpr Limits kSigma{1e-9, 10'000.0};   // m or px
inline constexpr Limits kFocalLength{1e-3, 1e7};  // px
// px, of where a lens points and of tracks: no picture is near that large.
inline constexpr double kFarthestPixel = 1e7;
inline constexpr double kMostDistortion = 1e6;     // of any coefficient; of a lens a few at most
inline constexpr int kMostPictureSide = 20'000;    // px
inline constexpr double kMostPicturePixels = 1e8;  // in colour 300 MB, and several are kept
inline constexpr int kMostThings = 1000;           // cameras, handles, obstacles
// Of one file: a laser scanner's; what a fit takes of it is a thousandth.
inline constexpr int kMostCloudPoints = 10'000'000;
// At which the cloth is at first: a dense system is solved to interpolate them, in seconds.
inline constexpr int kMostPlacedPoints = 3000;
inline constexpr int kLongestName = 100;  // bytes: names become those of files

inline bool IsPictureSize(double width, double height) {
  return width >= 1.0 && height >= 1.0 && width <= kMostPictureSide && height <= kMostPictureSide &&
         width * height <= kMostPicturePixels;
}

}  // namespace clothfit
