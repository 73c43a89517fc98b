// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit report: a recording, a run, two runs, a diagnosis, a comparison or a study as one page
// to open in a browser.
#include "fitting/report/report.h"

#include <filesystem>
#include <memory>

#include "apps/commands/commands.h"
#include "apps/options/value_checks.h"
#include "apps/report/assets.h"
#include "apps/terminal/next_step.h"
#include "apps/terminal/terminal.h"
#include "autodiff_sim/base/printable.h"
#include "fitting/jobs/shell.h"
#include "fitting/report/page/file.h"
#include "fitting/runs/recording_list.h"
#include "tracking/files/manifest.h"

namespace clothfit {
namespace {

struct ReportCommandOptions {
  std::string folder, other, output;  // output empty: FOLDER/report.html
  ReportOptions report;
  bool force = false;
};

std::string NameOf(const std::filesystem::path& folder) {
  const std::filesystem::path whole = std::filesystem::absolute(folder).lexically_normal();
  return (whole.has_filename() ? whole.filename() : whole.parent_path().filename()).string();
}

// A recording is somebody's own: its page comes to where the command is run. So does that of two
// runs, which is neither's.
std::filesystem::path PageOf(const ReportCommandOptions& options) {
  const std::filesystem::path folder = options.folder;
  if (!options.other.empty()) return NameOf(folder) + "-" + NameOf(options.other) + ".html";
  if (!IsRecordingFolder(folder)) return folder / "report.html";
  return NameOf(folder) + ".html";
}

// Of a fit of several recordings each run's page, in the run: the whole one leads there.
std::vector<std::filesystem::path> PagesOfRecordings(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> runs;
  if (KindOfFolder(folder) == FolderKind::kJointRun)
    for (const ListedRecording& one : ReadRecordingList(folder))
      runs.push_back(folder / RunFolder::PlaceOf(one.name) / "report.html");
  return runs;
}

int RunReportCommand(const ReportCommandOptions& options) {
  const std::filesystem::path folder = options.folder;
  const bool is_pair = !options.other.empty();
  const std::filesystem::path file =
      options.output.empty() ? PageOf(options) : std::filesystem::path(options.output);
  const Overwrite overwrite = OverwriteIf(options.force);
  PageFile whole_page(file, overwrite);
  std::vector<PageFile> of_recordings;
  if (!is_pair)
    for (const std::filesystem::path& one : PagesOfRecordings(folder))
      of_recordings.emplace_back(one, overwrite);
  ReportOptions whole = options.report;
  whole.page = file;
  const ReportPage page = is_pair ? MakePairReport(folder, options.other, PageAssets(), whole)
                                  : MakeReport(folder, PageAssets(), whole);
  for (PageFile& one : of_recordings)
    one.Write(MakeReport(one.path().parent_path(), PageAssets(), options.report).html);
  whole_page.Write(page.html);
  Print("{}\n", page.verdict.headline);
  for (const std::string& sentence : page.verdict.sentences) Print("  {}\n", Printable(sentence));
  for (const std::string& note : page.notes) Print("  {}\n", Printable(note));
  Print("report: {} ({:.1f} MB)\n", file.string(), 1e-6 * static_cast<double>(page.html.size()));
  if (!of_recordings.empty())
    Print("and of each recording: {}\n",
          (folder / RunFolder::PlaceOf("NAME") / "report.html").string());
  PrintNext("open " + ShellWord(file.string()) + " in a browser");
  return kExitSuccess;
}

}  // namespace

void AddReportCommand(CLI::App* app, Action* action) {
  CLI::App* const command = app->add_subcommand(
      "report",
      "a recording, run, diagnosis, comparison or study as a page to open in a browser, "
      "or two runs side by side");
  const auto options = std::make_shared<ReportCommandOptions>();
  command
      ->add_option("FOLDER", options->folder,
                   "a recording, or what fit, diagnose, compare, study or trials wrote")
      ->required();
  command
      ->add_option(
          "OTHER", options->other,
          "a run to compare with FOLDER, which is a run too: of fit, or what diagnose wrote")
      ->check(CLI::Validator(
          [](const std::string& name) { return name.empty() ? "is empty" : std::string(); }, ""));
  command
      ->add_option(
          "-o,--output", options->output,
          "page to write; if left out FOLDER/report.html, of a recording NAME.html, of two "
          "runs FOLDER-OTHER.html where you are")
      ->type_name("FILE.html");
  command
      ->add_option("--pictures", options->report.pictures,
                   "recording with the pictures; where the run found them if left out")
      ->type_name("RECORDING");
  command
      ->add_option("--picture-width", options->report.picture.width,
                   "width of the pictures at most, px; 16 to 4096")
      ->type_name("PX")
      ->check(WholeNumber(16, 4096))
      ->capture_default_str();
  command
      ->add_option("--max-size", options->report.max_megabytes,
                   "size of the page at most, MB; pictures are left out until it holds")
      ->type_name("MB")
      ->check(NumberAboveZero())
      ->capture_default_str();
  command->add_flag("--force", options->force,
                    "replace the page that is there; in folders of clothfit none but its own");
  command->footer(
      "The page holds everything it shows and asks no network: it can be sent as it is.\n\n"
      "Examples:\n"
      "  clothfit report runs/demo -o demo.html\n"
      "  clothfit report runs/demo runs/finer -o both.html");
  command->callback(
      [options, action] { *action = [options] { return RunReportCommand(*options); }; });
}

}  // namespace clothfit
