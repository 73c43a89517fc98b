// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What may be wrong with an observation rather than with the physics, to first order: poses, clocks
// and scales of cameras, the place, scale and clock of markers, where on the cloth they sit, all or
// one of them, fat masks. These compete with physics in one list.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "fitting/residuals/observation_residuals.h"
#include "fitting/scene/scene.h"

namespace clothfit {

struct Fault {
  enum class Kind {
    kCameraShift,   // of its centre, m, along the world's axes
    kCameraTurn,    // about its centre, rad, about the world's axes
    kCameraClock,   // s, by which its pictures were taken later than said
    kCameraScale,   // share by which its focal length is longer
    kMaskBias,      // px by which its masks are too fat
    kMarkerShift,   // m, of all markers together, world
    kMarkerScale,   // share by which markers are farther from their middle than said
    kMarkerClock,   // s, by which markers were seen later than said
    kMarkerLayout,  // m, of all markers together on the cloth, along u or v
    kMarkerOffset,  // m, of one marker on the cloth, along u or v
  };
  Kind kind;
  std::string group;  // what it is called as a candidate: "camera 2: pose"
  std::string name, unit;
  int source = -1;  // camera, or marker's id
  int axis = 0;
  double tolerated = 0.0;  // one sigma that goes unremarked as long as physics is looked for
  double typical = 0.0;    // one sigma of a well-made recording
};

// Whether it is of the markers rather than of a camera.
bool IsOfMarkers(Fault::Kind kind);

// Whether it moves what its camera tracks.
bool ShowsInTracks(const Fault& fault);

// One sigma of its amount where it is not as it should be.
double LargestSigma(const Fault& fault);

std::vector<Fault> ListFaults(const Scene& scene, const FitConfig& config);

// Where each residual of a frame comes from, in the order of ObservationResiduals.
struct ResidualSource {
  enum class Kind { kMarker, kTrack, kOutline, kParticle };
  Kind kind;
  int source;          // marker's id, or camera
  SurfacePoint point;  // markers and tracks
};
std::vector<ResidualSource> SourcesOfFrame(const Scene& scene, int frame);

// d residuals of a frame / d faults, rows x faults, where the faults are part of the prediction: a
// residual that they explain is minus these columns times their amounts. `state` is the simulated
// one.
RowMajorMatrix FaultColumns(const Scene& scene, const FitConfig& config,
                            const ObservationResiduals& observations,
                            const std::vector<Fault>& faults, int frame, const State& state);

// The recording as it would have been without these faults: `amounts` are in the faults' units, one
// a fault. Masks are put right where they are loaded (LoadMask).
Recording WithoutFaults(const Recording& recording, const std::vector<Fault>& faults,
                        const Eigen::VectorXd& amounts);

}  // namespace clothfit
