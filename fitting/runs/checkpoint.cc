// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Where a fit stands, as checkpoint.json. Numbers are written so that the same doubles come back.
#include <nlohmann/json.hpp>

#include "autodiff_sim/base/error.h"
#include "fitting/runs/run_folder.h"
#include "tracking/files/whole_file.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kCheckpointFormat = "clothfit-checkpoint/1";

Json ToJson(const Eigen::VectorXd& vector) {
  return std::vector<double>(vector.begin(), vector.end());
}

Eigen::VectorXd ToVector(const Json& json) {
  const std::vector<double> numbers = json.get<std::vector<double>>();
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(),
                                           static_cast<Eigen::Index>(numbers.size()));
}

}  // namespace

void RunFolder::WriteCheckpoint(const FitCheckpoint& checkpoint) const {
  Json json;
  json["format"] = kCheckpointFormat;
  json["coarse"] = checkpoint.coarse;
  json["next_window"] = checkpoint.next_window;
  json["theta"] = ToJson(checkpoint.theta);
  WriteWholeFile(path_ / "checkpoint.json", json.dump() + "\n");
}

FitCheckpoint RunFolder::ReadCheckpoint() const {
  const std::filesystem::path file = path_ / "checkpoint.json";
  const std::string text = ReadTextFile(file);
  FitCheckpoint checkpoint;
  try {
    const Json json = Json::parse(text);
    if (json.at("format") != kCheckpointFormat) throw std::invalid_argument("another format");
    checkpoint.coarse = json.value("coarse", false);
    json.at("next_window").get_to(checkpoint.next_window);
    checkpoint.theta = ToVector(json.at("theta"));
  } catch (const std::exception&) {
    throw InputError(file.string(), std::string("damaged; expected a ") + kCheckpointFormat);
  }
  return checkpoint;
}

}  // namespace clothfit
