// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/runs/recording_list.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "tracking/files/output_folder.h"
#include "tracking/files/whole_file.h"
#include "tracking/recording/limits.h"
#include "tracking/text/text.h"
#include "tracking/text/yaml_reader.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

constexpr const char* kList = "recordings.yaml";
constexpr const char* kListFormat = "clothfit-recordings/1";

bool HasName(const std::vector<ListedRecording>& listed, const std::string& name) {
  return std::any_of(listed.begin(), listed.end(),
                     [&](const ListedRecording& one) { return one.name == name; });
}

// One that is not there is told when it is read.
bool AreSame(const fs::path& a, const fs::path& b) {
  std::error_code unknown;
  return a == b || fs::equivalent(a, b, unknown);
}

void Add(const std::string& folder, bool is_held_out, std::vector<ListedRecording>* listed) {
  fs::path path = fs::absolute(folder).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  for (const ListedRecording& one : *listed) {
    if (AreSame(one.path, path))
      throw InputError(folder, "is named twice; expected each recording once");
  }
  std::string base = AsFolderName(path.filename().string());
  for (char& c : base)
    if (std::iscntrl(static_cast<unsigned char>(c)) != 0) c = '_';
  std::string name = base;
  for (int number = 2; HasName(*listed, name); ++number) name = fmt::format("{}-{}", base, number);
  listed->push_back({name, path, is_held_out});
}

void CheckNumber(std::size_t count, const std::string& place) {
  if (count > static_cast<std::size_t>(kMostThings))
    throw InputError(place, fmt::format("more than {} recordings", kMostThings));
}

}  // namespace

std::vector<ListedRecording> ListRecordings(const std::vector<std::string>& fitted,
                                            const std::vector<std::string>& held_out) {
  std::vector<ListedRecording> listed;
  for (const std::string& folder : fitted) Add(folder, false, &listed);
  std::vector<ListedRecording> out;
  for (const std::string& folder : held_out) Add(folder, true, &out);
  for (const ListedRecording& one : out) {
    const auto same = std::find_if(listed.begin(), listed.end(), [&](const ListedRecording& other) {
      return AreSame(other.path, one.path);
    });
    if (same == listed.end()) {
      Add(one.path.string(), true, &listed);
    } else {
      same->is_held_out = true;
    }
  }
  const auto is_fitted = [](const ListedRecording& one) { return !one.is_held_out; };
  if (std::none_of(listed.begin(), listed.end(), is_fitted))
    throw InputError("--hold-out", "all recordings are held out; expected one to fit");
  CheckNumber(listed.size(), held_out.empty() ? "RECORDING" : "--hold-out");
  return listed;
}

void WriteRecordingList(const std::vector<ListedRecording>& recordings, const fs::path& folder) {
  std::string text = fmt::format("format: {}\nrecordings:\n", kListFormat);
  for (const auto& [name, path, is_held_out] : recordings)
    text += fmt::format("  - {{name: {}, path: {}, hold_out: {}}}\n", YamlText(name),
                        YamlText(path.string()), is_held_out);
  WriteWholeFile(folder / kList, text);
}

std::vector<ListedRecording> ReadRecordingList(const fs::path& folder) {
  if (KindOfFolder(folder) != FolderKind::kJointRun)
    throw InputError(folder.string(), "is not the folder of a fit of several recordings");
  const YamlValue top = YamlValue::Load(folder / kList);
  top.AllowKeys({"format", "recordings"});
  const YamlValue format = top.Require("format");
  if (format.Text() != kListFormat) format.Fail(fmt::format("expected {}", kListFormat));
  std::vector<ListedRecording> listed;
  for (const YamlValue& item : top.Require("recordings").Items()) {
    item.AllowKeys({"name", "path", "hold_out"});
    const YamlValue name = item.Require("name"), held_out = item.Require("hold_out");
    if (AsFolderName(name.Text()) != name.Text() || HasName(listed, name.Text()))
      name.Fail("'" + name.Text() + "': expected the name of one folder, each once");
    if (held_out.Text() != "true" && held_out.Text() != "false")
      held_out.Fail("'" + held_out.Text() + "': expected true or false");
    listed.push_back({name.Text(), item.Require("path").Text(), held_out.Text() == "true"});
    CheckNumber(listed.size(), (folder / kList).string());
  }
  return listed;
}

}  // namespace clothfit
