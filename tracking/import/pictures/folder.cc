// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/pictures/folder.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <tuple>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/input_file.h"
#include "tracking/files/whole_file.h"
#include "tracking/recording/limits.h"
#include "tracking/recording/pictures/bytes.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

bool IsPng(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".png";
}

int NumberOf(const fs::path& file) {
  const std::string stem = file.stem().string();
  const size_t before = stem.find_last_not_of("0123456789");
  const std::string digits = before == std::string::npos ? stem : stem.substr(before + 1);
  if (const std::optional<int> number = ParseInteger(digits)) return *number;
  throw InputError(file.string(), "expected a name that ends in a number, such as 000001.png");
}

}  // namespace

std::array<int, 2> InspectPng(const fs::path& file) {
  const std::optional<std::array<int, 2>> size = SizeOfPng(ReadInputFile(file));
  if (size && IsPictureSize((*size)[0], (*size)[1])) return *size;
  throw InputError(file.string(), "cannot be read as a PNG");
}

PictureFolder InspectPictures(const fs::path& path) {
  CheckInputFolder(path);
  PictureFolder folder;
  for (const fs::path& file : ListInputFolder(path)) {
    if (!IsPng(file)) continue;
    const auto [other, is_new] = folder.pictures.emplace(NumberOf(file), file);
    if (!is_new) {
      throw InputError(file.string(), "has the number of " + other->second.filename().string());
    }
    const auto [width, height] = InspectPng(file);
    if (folder.width == 0) std::tie(folder.width, folder.height) = std::tie(width, height);
    if (width == folder.width && height == folder.height) continue;
    throw InputError(file.string(),
                     fmt::format("expected {} x {} px as the first one, found {} x {}",
                                 folder.width, folder.height, width, height));
  }
  if (folder.pictures.empty()) {
    throw InputError(path.string(), "expected pictures such as 000001.png, found none");
  }
  return folder;
}

std::map<std::string, fs::path> PlacesOfPictures(const PictureFolder& folder,
                                                 const std::string& camera, int first) {
  std::map<std::string, fs::path> places;
  for (const auto& [number, file] : folder.pictures) {
    places[fmt::format("images/{}/{:06}.png", camera, number - first)] = file;
  }
  return places;
}

bool IsSameFile(const fs::path& copy, const fs::path& file) {
  std::error_code ignored;
  if (fs::equivalent(copy, file, ignored)) return true;
  if (!fs::is_regular_file(copy) || fs::file_size(copy) != fs::file_size(file)) return false;
  std::ifstream one(copy, std::ios::binary), other(file, std::ios::binary);
  return std::equal(std::istreambuf_iterator<char>(one), {}, std::istreambuf_iterator<char>(other));
}

void CopyInto(const fs::path& file, const std::string& name, const OutputFolder& recording) {
  const fs::path copy = recording.path() / name;
  PartFile part(copy);
  std::error_code error;
  fs::copy_file(file, part.path(), fs::copy_options::overwrite_existing, error);
  if (error) throw InputError(copy.string(), "cannot be written: " + error.message());
  part.MoveToPlace();
}

void CopyPictures(const std::string& camera, const PictureFolder& folder, int first,
                  OutputFolder* output) {
  const std::map<std::string, fs::path> places = PlacesOfPictures(folder, camera, first);
  const fs::path there = output->path() / "images" / camera;
  std::vector<std::string> added, old;
  for (const auto& [name, file] : places) {
    if (!IsSameFile(output->path() / name, file)) added.push_back(name);
  }
  if (fs::is_directory(there)) {
    for (const fs::path& file : ListInputFolder(there)) {
      const std::string name = "images/" + camera + "/" + file.filename().string();
      if (places.count(name) == 0 && output->Lists(name)) old.push_back(name);
    }
  }
  output->Remove(old);
  output->Add(added);
  for (const std::string& name : added) CopyInto(places.at(name), name, *output);
}

}  // namespace clothfit
