// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The XML of cv::FileStorage: elements with text. Attributes are passed over and entities left as
// they stand, for no number has any.
#pragma once

#include <string>
#include <string_view>

#include <yaml-cpp/yaml.h>

namespace clothfit {

// The outermost element: a map of its elements. See ReadStorageFile.
YAML::Node ReadStorageXml(std::string_view text, const std::string& file);

}  // namespace clothfit
