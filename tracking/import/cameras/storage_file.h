// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What cv::FileStorage writes, read without it: its parsers (OpenCV 4.6) read beyond the text, run
// out of stack or go on without end where a file is damaged.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

namespace clothfit {

// The file's documents, each a map: one of XML or JSON, several of YAML that was appended to. An
// element of XML is a text, a map of its elements, or a list of those that are named "_". Throws
// InputError with line and column where the file is none of the three.
std::vector<YAML::Node> ReadStorageFile(const std::filesystem::path& file);

// The numbers, all finite, of a matrix (row by row, its channels beside each other), of a list or
// of a list of lists; of one number, too. Throws InputError, of the place, on all else and beyond
// 1000.
std::vector<double> StorageNumbers(const YAML::Node& node, const std::string& place);

}  // namespace clothfit
