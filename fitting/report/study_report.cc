// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The page of any folder of tables and pictures: what the .md files say, the pictures, the .csv
// files as tables, the conditions.
#include <algorithm>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "fitting/report/kinds.h"
#include "fitting/report/page/markdown_blocks.h"
#include "fitting/report/scene_page.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostRows = 1000;         // of one table
constexpr std::size_t kMostSentences = 6;       // of the verdict
constexpr std::uintmax_t kMostBytes = 4000000;  // of one picture

std::vector<fs::path> FilesEndingIn(const fs::path& folder, const std::string& extension) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file() && entry.path().extension() == extension)
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// Names of sections: letters and digits only.
std::string IdOf(const std::string& prefix, const fs::path& file) {
  std::string id = prefix + "-" + file.stem().string();
  for (char& c : id) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '-';
  }
  return id;
}

struct Study {
  std::vector<MarkdownPage> pages;
  std::vector<ReportJson> sections;
  std::vector<std::string> notes;
  ReportBlobs blobs;
};

void AddTexts(const std::vector<fs::path>& files, Study* study) {
  for (const fs::path& file : files) {
    const std::string text = ReadTextFile(file);
    study->pages.push_back(ParseMarkdown(text));
    const MarkdownPage& page = study->pages.back();
    if (page.blocks.empty()) {
      throw InputError(file.string(), "is empty; expected a study that has ended");
    }
    study->sections.push_back(
        SectionOf(IdOf("text", file),
                  page.title.empty() ? "What was measured: " + file.stem().string() : page.title,
                  page.blocks));
  }
}

void AddPictureFiles(const fs::path& folder, Study* study) {
  ReportJson blocks = ReportJson::array();
  for (const char* extension : {".svg", ".png"}) {
    for (const fs::path& file : FilesEndingIn(folder, extension)) {
      if (fs::file_size(file) > kMostBytes) {
        study->notes.push_back(file.filename().string() + " is too large for this page.");
        continue;
      }
      blocks.push_back(PictureBlock(file, file.filename().string(), &study->blobs));
    }
  }
  if (!blocks.empty()) study->sections.push_back(SectionOf("pictures", "Pictures", blocks));
}

void AddTables(const std::vector<fs::path>& files, Study* study) {
  ReportJson blocks = ReportJson::array();
  for (const fs::path& file : files) {
    std::size_t rows = 0;
    const std::string name = file.filename().string();
    const ReportJson table = CsvTable(ReadTextFile(file), name, kMostRows, &rows);
    if (table.is_null()) {
      throw InputError(file.string(), "is empty; expected a study that has ended");
    }
    if (rows > kMostRows) {
      study->notes.push_back(
          fmt::format("Of {} the first {} of {} rows are shown.", name, kMostRows, rows));
    }
    blocks.push_back(table);
  }
  if (blocks.empty()) return;
  ReportJson section = SectionOf("tables", "Tables", blocks);
  section["lead"] = "A click on the head of a column sorts by it.";
  study->sections.push_back(section);
}

void AddConditions(const fs::path& folder, Study* study) {
  ReportJson blocks = ReportJson::array();
  blocks.push_back(TextBlock({"Folder: " + fs::absolute(folder).lexically_normal().string()}));
  for (const char* extension : {".yaml", ".txt", ".json"}) {
    for (const fs::path& file : FilesEndingIn(folder, extension)) {
      if (fs::file_size(file) > kMostBytes) continue;
      blocks.push_back({{"kind", "code"},
                        {"title", file.filename().string()},
                        {"folded", true},
                        {"text", ReadTextFile(file)}});
    }
  }
  study->sections.push_back(SectionOf("configuration", "Conditions", blocks));
}

// In a study's text tables come first and what they come to after them: that is the verdict, and
// what stands before them tells what was measured.
PageVerdict VerdictOf(const std::vector<MarkdownPage>& pages) {
  PageVerdict verdict;
  verdict.grade = PageVerdict::Grade::kGood;
  for (const MarkdownPage& page : pages) {
    std::vector<std::string> prose = page.paragraphs;
    const bool has_result = page.paragraphs_before_table < static_cast<int>(prose.size());
    if (verdict.headline.empty() && !prose.empty()) {
      const std::size_t at =
          has_result ? static_cast<std::size_t>(page.paragraphs_before_table) : 0;
      const auto [first, rest] = FirstSentence(prose[at]);
      verdict.headline = first;
      prose[at] = rest;
    }
    for (const std::string& paragraph : prose) {
      if (!paragraph.empty() && verdict.sentences.size() < kMostSentences)
        verdict.sentences.push_back(paragraph);
    }
  }
  return verdict;
}

}  // namespace

ReportPage MakeStudyReport(const fs::path& folder, const ReportAssets& assets) {
  const std::vector<fs::path> texts = FilesEndingIn(folder, ".md");
  if (texts.empty()) {
    throw InputError(folder.string(),
                     "holds tables but no .md file; expected a study that has ended");
  }
  Study study;
  AddTexts(texts, &study);
  AddPictureFiles(folder, &study);
  AddTables(FilesEndingIn(folder, ".csv"), &study);
  AddConditions(folder, &study);
  PageVerdict verdict = VerdictOf(study.pages);
  if (verdict.headline.empty()) verdict.headline = texts.front().stem().string();
  ReportJson json;
  json["title"] = "Study: " + texts.front().stem().string();
  json["sections"] = study.sections;
  json["notes"] = study.notes;
  return AsReportPage(std::move(json), verdict, study.blobs, assets);
}

}  // namespace clothfit
