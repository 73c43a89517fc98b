// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/batch/list.h"

#include <algorithm>
#include <cctype>

#include "tracking/text/text.h"
#include "tracking/text/yaml_reader.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

bool IsFileName(const std::string& name) {
  return !name.empty() && name.front() != '.' &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) {
           return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.';
         });
}

fs::path PathFrom(const fs::path& list, const YamlValue& value) {
  return fs::absolute(list.parent_path() / value.Text()).lexically_normal();
}

std::vector<std::string> Texts(const YamlValue& map, const std::string& key) {
  std::vector<std::string> texts;
  if (const auto list = map.Find(key)) {
    for (const YamlValue& item : list->Items()) texts.push_back(item.Text());
  }
  return texts;
}

std::string NameOf(const fs::path& recording) {
  return recording.filename().empty() ? recording.parent_path().filename().string()
                                      : recording.filename().string();
}

BatchFit ReadFit(const fs::path& list, const YamlValue& item) {
  item.AllowKeys({"recording", "name", "config", "set", "free", "fix"});
  BatchFit fit;
  fit.recording = PathFrom(list, item.Require("recording"));
  const auto name = item.Find("name");
  fit.name = name ? name->Text() : NameOf(fit.recording);
  if (!IsFileName(fit.name)) {
    (name ? *name : item)
        .Fail("'" + fit.name + "': expected a name of letters, digits, '-', '_' and '.'");
  }
  if (const auto config = item.Find("config")) fit.configs.push_back(PathFrom(list, *config));
  if (const auto set = item.Find("set")) {
    for (const auto& [parameter, value] : set->Entries())
      fit.set.push_back(parameter + "=" + FormatNumber(value.Number()));
  }
  fit.free = Texts(item, "free");
  fit.fix = Texts(item, "fix");
  return fit;
}

}  // namespace

std::vector<BatchFit> ReadBatchList(const fs::path& file) {
  const YamlValue top = YamlValue::Load(file);
  top.AllowKeys({"config", "fits"});
  std::vector<BatchFit> fits;
  for (const YamlValue& item : top.Require("fits").Items()) {
    BatchFit fit = ReadFit(file, item);
    if (const auto common = top.Find("config"))
      fit.configs.insert(fit.configs.begin(), PathFrom(file, *common));
    for (const BatchFit& other : fits) {
      if (other.name == fit.name) item.Fail("another fit is called '" + fit.name + "', too");
    }
    BatchConfig(fit, ReadRecording(fit.recording));
    fits.push_back(std::move(fit));
  }
  if (fits.empty()) top.Require("fits").Fail("expected one or more");
  return fits;
}

FitConfig BatchConfig(const BatchFit& fit, const Recording& recording) {
  FitConfig config = DefaultConfig(recording);
  for (const fs::path& file : fit.configs) ReadConfig(file, &config);
  ForgetChosenMesh(&config);
  config.recording = fs::absolute(recording.path).lexically_normal().string();
  for (const std::string& assignment : fit.set)
    SetParameter(fit.name + ": set", assignment, &config);
  for (const std::string& name : fit.fix) SetFree(fit.name + ": fix", name, false, &config);
  for (const std::string& name : fit.free) SetFree(fit.name + ": free", name, true, &config);
  config.Check(fit.name);
  return config;
}

}  // namespace clothfit
