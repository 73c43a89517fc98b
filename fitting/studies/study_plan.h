// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A study as a list of jobs in a folder: first the recordings that it uses, then its own.
#pragma once

#include <filesystem>
#include <optional>

#include "fitting/jobs/folder.h"
#include "fitting/jobs/plan.h"
#include "fitting/studies/study.h"

namespace clothfit {

// Makes the folder of the study, with study.json (what decides the numbers) and the list, and that
// of its recordings (empty: recordings/ in it), which others may share. Returns the lock of the
// study's. Throws InputError as PrepareJobFolder.
FolderLock PrepareStudy(const Study& study, const StudyOptions& options,
                        const std::filesystem::path& folder,
                        const std::filesystem::path& recordings, Existing existing);

// What was prepared there. Its report writes NAME.csv, NAME.md and pictures, without the jobs that
// failed.
JobPlan StudyPlan(const Study& study, JobList list, const std::filesystem::path& folder);

// The study of a list; nothing where another command made it.
std::optional<Study> StudyOf(const JobList& list);

}  // namespace clothfit
