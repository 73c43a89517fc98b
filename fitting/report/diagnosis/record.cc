// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/diagnosis/record.h"

#include <utility>

#include "autodiff_sim/base/error.h"
#include "fitting/files/npy_file.h"
#include "fitting/report/page/markdown_blocks.h"
#include "fitting/report/records/record_file.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFormat = "clothfit-diagnosis/1";
constexpr const char* kWholeDiagnosis = "a diagnosis that has ended, by this version of clothfit";

// With signs that a plain text has no letters for.
std::string Typeset(std::string text) {
  for (const auto& [plain, sign] : {std::pair{"^2", "²"}, std::pair{"+-", "±"}}) {
    for (std::size_t at = text.find(plain); at != std::string::npos; at = text.find(plain, at))
      text.replace(at, 2, sign);
  }
  return text;
}

void CheckFiles(const DiagnosisRecord& record) {
  RequireFile(record.folder / "baseline.npy", kWholeDiagnosis);
  if (!record.effects.empty()) RequireFile(record.folder / "model.npy", kWholeDiagnosis);
}

}  // namespace

DiagnosisRecord ReadDiagnosisRecord(const fs::path& folder) {
  const fs::path file = RequireFile(folder / "diagnosis.json", kWholeDiagnosis);
  DiagnosisRecord record;
  record.folder = folder;
  record.json = ReadRecordFile(file, "so diagnose again");
  try {
    if (record.json.at("format") != kFormat)
      throw InputError(file.string(), std::string("has another format; expected ") + kFormat);
    record.verdict = record.json.at("verdict").get<std::string>();
    record.words = Typeset(record.json.at("words").get<std::string>());
    // Diagnoses of 0.1.0 have none.
    record.headline = Typeset(record.json.value("headline", FirstSentence(record.words).first));
    record.effects = record.json.at("effects").get<std::vector<std::string>>();
    record.confidence_sets.push_back(record.json.at("ambiguity").get<std::vector<std::string>>());
    // Diagnoses of 0.1.0 have none.
    const std::vector<std::vector<std::string>> none;
    for (const auto& set : record.json.value("ambiguity_beside", none))
      record.confidence_sets.push_back(set);
    CheckFiles(record);
    record.resolution = record.json.at("resolution").get<std::array<int, 2>>();
    const auto& held_out = record.json.at("held_out_frames");
    if (!held_out.is_null())
      record.held_out = {held_out.at(0).get<int>(), held_out.at(1).get<int>()};
    for (const char* key : {"mismatch", "class"}) {
      nlohmann::ordered_json& part = record.json.at(key);
      if (part.is_object()) part["words"] = Typeset(part.at("words").get<std::string>());
    }
    for (const char* key : {"gate", "ranking", "models", "seconds"}) record.json.at(key);
  } catch (const nlohmann::json::exception& error) {
    throw InputError(file.string(),
                     std::string("is no diagnosis that can be shown: ") + error.what());
  }
  record.config = ReadTextFile(RequireFile(folder / "config.yaml", kWholeDiagnosis));
  record.log = ReadTextFile(RequireFile(folder / "log.txt", kWholeDiagnosis));
  const fs::path force = folder / "missing-force.npy";
  if (fs::exists(force)) record.force = ReadPointsNpy(force);
  return record;
}

}  // namespace clothfit
