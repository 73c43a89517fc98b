// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The three experiments of Hasler et al. 2007, remade: pictures of a simulated cloth, and what
// tracking finds in them. Nobody tells a fit where the handles went.
#pragma once

#include <filesystem>

#include "fitting/jobs/job.h"
#include "fitting/studies/study_options.h"
#include "tracking/recording/recording.h"

namespace clothfit {

// The job that makes and tracks the recording of an experiment. Its name says all that decides it,
// so that studies of one size can share them.
Job RecordingJob(const StudyOptions& options, const std::string& experiment);

// Does it, in folder/NAME: pictures/ and seen/, both whole or not there.
nlohmann::json MakeStudyRecording(const std::filesystem::path& folder, const Job& job,
                                  const JobContext& context);

// What was made: the tracked recording with its truth, or the one with pictures.
std::filesystem::path SeenFolder(const std::filesystem::path& folder, const StudyOptions& options,
                                 const std::string& experiment);
std::filesystem::path PictureFolder(const std::filesystem::path& folder,
                                    const StudyOptions& options, const std::string& experiment);

}  // namespace clothfit
