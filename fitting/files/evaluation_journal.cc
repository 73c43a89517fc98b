// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/files/evaluation_journal.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <system_error>
#include <utility>

#include <zlib.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/input_file.h"
#include "fitting/files/version.h"
#include "tracking/files/whole_file.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

// Of an entry, before the key and the numbers.
struct Head {
  std::uint32_t key_bytes = 0, num_numbers = 0, sum = 0;
};
static_assert(sizeof(Head) == 12, "written as it is");

std::string FirstLine() { return "clothfit-checkpoint/2 " + Version() + "\n"; }

std::string Bytes(const Eigen::VectorXd& numbers) {
  std::string bytes(static_cast<std::size_t>(numbers.size()) * sizeof(double), '\0');
  if (numbers.size() > 0) std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

std::string KeyOf(const std::string& name, const Eigen::VectorXd& at) {
  return name + '\0' + Bytes(at);
}

std::uint32_t SumOf(const std::string& key, const std::string& numbers) {
  const auto add = [](uLong sum, const std::string& bytes) {
    return crc32(sum, reinterpret_cast<const Bytef*>(bytes.data()),
                 static_cast<uInt>(bytes.size()));
  };
  return static_cast<std::uint32_t>(add(add(0, key), numbers));
}

}  // namespace

EvaluationJournal::EvaluationJournal(fs::path file) : file_(std::move(file)) {
  if (IsThere(file_)) Read();
  if (size_ > 0) return;
  WriteWholeFile(file_, FirstLine());
  size_ = FirstLine().size();
}

void EvaluationJournal::Read() {
  const std::string bytes = ReadInputFile(file_);
  const std::string first = FirstLine();
  if (!StartsWith(bytes, first)) return;
  size_ = first.size();
  Head head;
  while (bytes.size() - size_ >= sizeof(head)) {
    std::memcpy(&head, &bytes[size_], sizeof(head));
    const std::size_t num_bytes = std::size_t{head.num_numbers} * sizeof(double);
    const std::size_t begin = size_ + sizeof(head);
    if (bytes.size() - begin < head.key_bytes + num_bytes) break;
    const std::string key = bytes.substr(begin, head.key_bytes);
    const std::string values = bytes.substr(begin + head.key_bytes, num_bytes);
    if (SumOf(key, values) != head.sum) break;
    Eigen::VectorXd numbers(head.num_numbers);
    if (num_bytes > 0) std::memcpy(numbers.data(), values.data(), num_bytes);
    known_[key].push_back(std::move(numbers));
    size_ = begin + head.key_bytes + num_bytes;
  }
  for (auto& [key, numbers] : known_) std::reverse(numbers.begin(), numbers.end());
  if (size_ == bytes.size()) return;
  std::error_code error;
  fs::resize_file(file_, size_, error);
  if (error) throw InputError(file_.string(), "cannot be written: " + error.message());
}

std::optional<Eigen::VectorXd> EvaluationJournal::Recall(const std::string& name,
                                                         const Eigen::VectorXd& at) {
  const auto found = known_.find(KeyOf(name, at));
  if (found == known_.end()) return std::nullopt;
  Eigen::VectorXd numbers = std::move(found->second.back());
  found->second.pop_back();
  if (found->second.empty()) known_.erase(found);
  ++num_recalled_;
  return numbers;
}

void EvaluationJournal::Add(const std::string& name, const Eigen::VectorXd& at,
                            const Eigen::VectorXd& numbers) {
  constexpr std::uintmax_t kMostOnDisk = 500'000'000;
  constexpr Eigen::Index kShort = 1000;  // numbers
  if (numbers.size() > kShort && size_ > kMostOnDisk) return;
  const std::string key = KeyOf(name, at), values = Bytes(numbers);
  const Head head{static_cast<std::uint32_t>(key.size()),
                  static_cast<std::uint32_t>(numbers.size()), SumOf(key, values)};
  std::string entry(sizeof(head), '\0');
  std::memcpy(entry.data(), &head, sizeof(head));
  entry += key + values;
  Append(file_, entry);
  size_ += entry.size();
}

}  // namespace clothfit
