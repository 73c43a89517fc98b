// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/records/record_file.h"

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "fitting/files/version.h"
#include "tracking/text/json_text.h"

namespace clothfit {

namespace fs = std::filesystem;

fs::path RequireFile(const fs::path& file, const std::string& expected) {
  if (fs::exists(file)) return file;
  throw InputError(file.string(), "is missing; expected " + expected);
}

nlohmann::ordered_json ReadRecordFile(const fs::path& file, const std::string& remedy) {
  nlohmann::ordered_json record = nlohmann::ordered_json::parse(ReadJsonText(file), nullptr, false);
  if (!record.is_object()) throw InputError(file.string(), "is damaged; expected a JSON object");
  const auto found = record.find("clothfit");
  const std::string version =
      found != record.end() && found->is_string() ? found->get<std::string>() : "";
  if (version == Version()) return record;
  throw InputError(file.string(), fmt::format("was written by clothfit {}; expected {}, {}",
                                              version.empty() ? "of no known version" : version,
                                              Version(), remedy));
}

}  // namespace clothfit
