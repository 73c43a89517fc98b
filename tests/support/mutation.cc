// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/mutation.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <regex>
#include <utility>
#include <vector>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace clothfit {
namespace {

namespace fs = std::filesystem;

std::size_t Below(std::size_t count, std::mt19937* random) {
  return count == 0 ? 0 : std::uniform_int_distribution<std::size_t>(0, count - 1)(*random);
}

template <class Value>
const Value& OneOf(const std::vector<Value>& values, std::mt19937* random) {
  return values[Below(values.size(), random)];
}

std::vector<std::string> LinesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1);
    lines.push_back(text.substr(begin, end + 1 - begin));
    begin = end + 1;
  }
  return lines;
}

std::string Joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line;
  return text;
}

std::string Repeated(const std::string& text, std::size_t times) {
  std::string all;
  all.reserve(text.size() * times);
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

using Mutation = std::string (*)(std::string, std::mt19937*);
struct Way {
  const char* name;
  Mutation mutate;
};

// Of whole lines.
std::string WithLines(const std::string& text,
                      const std::function<void(std::vector<std::string>*)>& change) {
  std::vector<std::string> lines = LinesOf(text);
  if (!lines.empty()) change(&lines);
  return Joined(lines);
}

std::string ReplaceNumber(const std::string& text, const std::string& with, std::mt19937* random) {
  static const std::regex kNumber(R"([-+]?[0-9]+\.?[0-9]*([eE][-+]?[0-9]+)?)");
  // Not in what is too large for std::regex.
  const std::string part = text.substr(0, 20'000);
  std::vector<std::pair<std::size_t, std::size_t>> places;
  for (std::sregex_iterator match(part.begin(), part.end(), kNumber), end; match != end; ++match)
    places.emplace_back(match->position(), match->length());
  if (places.empty()) return text + with;
  const auto [at, length] = OneOf(places, random);
  return std::string(text).replace(at, length, with);
}

std::string InsertAnywhere(const std::string& text, const std::string& what, std::mt19937* random) {
  return std::string(text).insert(Below(text.size() + 1, random), what);
}

const std::vector<Way>& Ways() {
  static const std::vector<Way> ways = {
      {"line gone",
       [](std::string text, std::mt19937* random) {
         return WithLines(text, [&](auto* lines) {
           lines->erase(lines->begin() + static_cast<std::ptrdiff_t>(Below(lines->size(), random)));
         });
       }},
      {"line twice",
       [](std::string text, std::mt19937* random) {
         return WithLines(text, [&](auto* lines) {
           const std::string line = OneOf(*lines, random);
           lines->insert(lines->begin() + static_cast<std::ptrdiff_t>(Below(lines->size(), random)),
                         line);
         });
       }},
      {"lines exchanged",
       [](std::string text, std::mt19937* random) {
         return WithLines(text, [&](auto* lines) {
           std::swap((*lines)[Below(lines->size(), random)],
                     (*lines)[Below(lines->size(), random)]);
         });
       }},
      {"line a hundred thousand times",
       [](std::string text, std::mt19937* random) {
         return WithLines(text, [&](auto* lines) {
           std::string& line = (*lines)[Below(lines->size(), random)];
           line = Repeated(line.substr(0, 100), 100'000);
         });
       }},
      {"extreme number",
       [](std::string text, std::mt19937* random) {
         static const std::vector<std::string> kExtremes = {"0",
                                                            "-1",
                                                            "1e308",
                                                            "-1e308",
                                                            "1e-320",
                                                            "1e19",
                                                            "1e10",
                                                            "1e5",
                                                            "100000",
                                                            "10000000",
                                                            "2147483647",
                                                            "2147483648",
                                                            "-0.0",
                                                            "4294967296",
                                                            "1e400",
                                                            "0.001",
                                                            "99999999999999999999"};
         return ReplaceNumber(text, OneOf(kExtremes, random), random);
       }},
      {"number times a power of ten",
       [](std::string text, std::mt19937* random) {
         static const std::vector<std::string> kPowers = {"e3", "e-3", "e6", "0000", "e-9"};
         static const std::regex kNumber(R"([0-9]+\.?[0-9]*)");
         std::smatch match;
         const std::string rest =
             text.substr(std::min(text.size(), Below(text.size(), random)), 5000);
         if (!std::regex_search(rest, match, kNumber)) return text;
         const std::size_t at = text.find(match.str());
         return text.insert(at + match.length(), OneOf(kPowers, random));
       }},
      {"no number",
       [](std::string text, std::mt19937* random) {
         static const std::vector<std::string> kNone = {"nan", "inf", "-inf", "null", "true", "[]",
                                                        "{}",  "''",  "0x10", "1,5",  "~",    "*a"};
         return ReplaceNumber(text, OneOf(kNone, random), random);
       }},
      {"cut off",
       [](std::string text, std::mt19937* random) {
         text.resize(Below(text.size(), random));
         return text;
       }},
      {"bytes flipped",
       [](std::string text, std::mt19937* random) {
         for (std::size_t i = 0; i < 1 + text.size() / 200 && !text.empty(); ++i)
           text[Below(text.size(), random)] ^= static_cast<char>(1U << Below(8, random));
         return text;
       }},
      {"bytes put in",
       [](std::string text, std::mt19937* random) {
         std::string bytes;
         for (std::size_t i = 0; i < 1 + Below(40, random); ++i)
           bytes += static_cast<char>(Below(256, random));
         return InsertAnywhere(text, bytes, random);
       }},
      {"control characters",
       [](std::string text, std::mt19937* random) {
         static const std::vector<std::string> kControls = {
             "\x1b[2J", "\r", "\x07", "\x7f", "\xc2\x9b", "\xe2\x80\xae", std::string(1, '\0')};
         return InsertAnywhere(text, OneOf(kControls, random), random);
       }},
      {"carriage returns",
       [](std::string text, std::mt19937* random) {
         const bool both = Below(2, random) == 0;
         std::string other;
         for (const char c : text) other += c == '\n' ? (both ? "\r\n" : "\r") : std::string(1, c);
         return other;
       }},
      {"UTF-16",
       [](std::string text, std::mt19937*) {
         std::string wide = "\xff\xfe";
         for (const char c : text) wide += c, wide += '\0';
         return wide;
       }},
      {"byte order mark", [](std::string text, std::mt19937*) { return "\xef\xbb\xbf" + text; }},
      {"long field",
       [](std::string text, std::mt19937* random) {
         return InsertAnywhere(text, std::string(2'000'000, 'x'), random);
       }},
      {"long number",
       [](std::string text, std::mt19937* random) {
         return ReplaceNumber(text, std::string(500'000, '7'), random);
       }},
      {"brackets",
       [](std::string text, std::mt19937* random) {
         static const std::vector<std::string> kBrackets = {"[", "{a: ", "{\"a\":", "[[", "- "};
         return InsertAnywhere(text, Repeated(OneOf(kBrackets, random), 60'000), random);
       }},
      {"lists in lists",
       [](std::string text, std::mt19937* random) {
         static const std::vector<std::pair<std::string, std::string>> kPairs = {
             {"[", "]"}, {"{\"a\":", "}"}, {"[{\"a\":", "}]"}};
         const auto& [open, close] = OneOf(kPairs, random);
         const std::size_t levels = OneOf(std::vector<std::size_t>{50, 60'000}, random);
         return ReplaceNumber(text, Repeated(open, levels) + "1" + Repeated(close, levels), random);
       }},
      {"elements",
       [](std::string text, std::mt19937* random) {
         return InsertAnywhere(text, Repeated("<a>", 100'000), random);
       }},
      {"indentation",
       [](std::string text, std::mt19937* random) {
         std::string deep = "\n";
         for (std::size_t i = 0; i < 1500; ++i) deep += std::string(i, ' ') + "a:\n";
         return InsertAnywhere(text, deep, random);
       }},
      {"aliases",
       [](std::string text, std::mt19937*) {
         std::string bomb = "a0: &a0 [x, x]\n";
         for (int i = 1; i < 30; ++i)
           bomb += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [*a" +
                   std::to_string(i - 1) + ", *a" + std::to_string(i - 1) + "]\n";
         return bomb + text;
       }},
      {"comma gone",
       [](std::string text, std::mt19937* random) {
         const std::size_t at = text.find(',', Below(text.size(), random));
         return at == std::string::npos ? text + "," : text.erase(at, 1);
       }},
      {"another path",
       [](std::string text, std::mt19937* random) {
         static const std::vector<std::string> kPaths = {
             "../../etc/passwd", "/etc/passwd", "truth/a", "a/../../b", ".", "", "/dev/zero"};
         const std::size_t at = text.find(".csv");
         if (at == std::string::npos) return text + OneOf(kPaths, random);
         const std::size_t begin = text.find_last_of(" '\"", at) + 1;
         return text.replace(begin, at + 4 - begin, OneOf(kPaths, random));
       }},
  };
  return ways;
}

void MakeSocket(const fs::path& file) {
  const int made = socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  file.string().copy(address.sun_path, sizeof(address.sun_path) - 1);
  if (bind(made, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0)
    mkfifo(file.c_str(), 0600);
  close(made);
}

struct Replacement {
  const char* name;
  void (*make)(const fs::path& file);
};

const std::vector<Replacement>& Replacements() {
  static const std::vector<Replacement> replacements = {
      {"empty", [](const fs::path& file) { std::ofstream{file}; }},
      {"gone", [](const fs::path&) {}},
      {"a folder", [](const fs::path& file) { fs::create_directory(file); }},
      {"a pipe", [](const fs::path& file) { mkfifo(file.c_str(), 0600); }},
      {"a socket", MakeSocket},
      {"a link to /dev/zero", [](const fs::path& file) { fs::create_symlink("/dev/zero", file); }},
      {"a link to a file outside",
       [](const fs::path& file) { fs::create_symlink("/etc/passwd", file); }},
      {"a link in a circle",
       [](const fs::path& file) { fs::create_symlink(file.filename(), file); }},
      {"a link to nothing", [](const fs::path& file) { fs::create_symlink("nothing", file); }},
      {"a hundred gigabytes",
       [](const fs::path& file) {
         std::ofstream{file};
         fs::resize_file(file, 100'000'000'000);
       }},
  };
  return replacements;
}

}  // namespace

std::string MutateText(std::string text, std::mt19937* random, std::string* how) {
  const Way& way = OneOf(Ways(), random);
  *how = way.name;
  return way.mutate(std::move(text), random);
}

void ReplaceFile(const fs::path& file, std::mt19937* random, std::string* how) {
  const Replacement& replacement = OneOf(Replacements(), random);
  *how = replacement.name;
  fs::remove_all(file);
  replacement.make(file);
}

}  // namespace clothfit
