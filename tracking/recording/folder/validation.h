// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The parts of CheckRecording. Each throws InputError, naming the file and the key or line at which
// the value stands on disk.
#pragma once

#include <string>

#include "tracking/recording/folder/tables.h"
#include "tracking/recording/recording.h"

namespace clothfit {

// All of the parts below; the lines are those that the observations were read from.
void CheckValues(const Recording& recording, const ObservationLines& lines);

// Throws unless there are images, videos, masks, depth pictures, clouds, tracks or markers.
void CheckHasObservation(const Recording& recording);

void CheckScene(const Recording& recording);  // frame rate and count, gravity, ground
void CheckCloth(const Recording& recording);  // with its initial placement
void CheckHandles(const Recording& recording);
void CheckObstacles(const Recording& recording);
void CheckNoiseAndSplits(const Recording& recording);
void CheckCameras(const Recording& recording);
void CheckObservations(const Recording& recording, const ObservationLines& lines);

// "FOLDER/recording.yaml: key".
std::string PlaceInRecording(const Recording& recording, const std::string& file,
                             const std::string& key);

// Throws unless (u, v) lies on the cloth, to within rounding of the file.
void CheckOnCloth(const Recording& recording, const Eigen::Vector2d& uv, const std::string& place);

void CheckFrame(const Recording& recording, int frame, const std::string& place);

// Throws unless the place (m, world) is finite and within kFarthest.
void CheckPosition(const Eigen::Vector3d& position, const std::string& place);

// Throws unless the name can be shown as it is, and is short.
void CheckShown(const std::string& name, const std::string& place);

}  // namespace clothfit
