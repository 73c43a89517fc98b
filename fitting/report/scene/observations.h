// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a report's 3D view and pictures show beside the cloth: observations, handles, the mesh.
#pragma once

#include <string>
#include <vector>

#include "fitting/report/page/blobs.h"
#include "fitting/report/scene/scene.h"

namespace clothfit {

ReportBlobs::Json MeshAsJson(const ClothMesh& mesh, ReportBlobs* blobs);

// "points" of the cloth, "markers" and "tracks", which name points by index. Of very many tracks
// every n-th point is kept, and a note says so.
ReportBlobs::Json ObservationsAsJson(const Scene& scene, ReportBlobs* blobs,
                                     std::vector<std::string>* notes);

// Where each handle holds the fitted cloth, frame by frame.
ReportBlobs::Json HandlesAsJson(const ReportScene& report, ReportBlobs* blobs);

}  // namespace clothfit
