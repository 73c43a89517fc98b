// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Command lines that cannot be understood, and the line that answers each.
#include <sstream>

#include "tests/apps/command.h"

namespace clothfit {
namespace {

using testing::HasSubstr;
using testing::Not;

struct WrongLine {
  const char* words;
  const char* answer;  // the beginning, up to "; 'clothfit help ...' tells more"
};

const WrongLine kWrongLines[] = {
    {"diagnose r -o x --max-effects 99", "--max-effects: 99; expected a whole number from 1 to 10"},
    {"diagnose r -o x --max-effects abc",
     "--max-effects: abc; expected a whole number from 1 to 10"},
    {"diagnose r -o x --max-effects 1.5",
     "--max-effects: 1.5; expected a whole number from 1 to 10"},
    {"diagnose r -o x --max-effects", "--max-effects: no value; expected a whole number"},
    {"diagnose r -o x --max-models 0", "--max-models: 0; expected a whole number from 1 to 40"},
    {"diagnose r", "--output: is missing (folder of the answer)"},
    {"diagnose r -o x --resume --force", "--force, --resume: both are given; expected one of them"},
    {"fit r --frames a b", "--frames: a b; expected 2 whole numbers"},
    {"fit r --frames 1", "--frames: 1; expected 2 whole numbers"},
    {"fit r --frames 1 2.5", "--frames: 1 2.5; expected 2 whole numbers"},
    {"fit r --window abc", "--window: abc; expected a number"},
    {"fit r --window 1e999", "--window: 1e999; expected a finite number"},
    {"fit r --window -inf", "--window: -inf; expected a finite number"},
    {"fit r --alpha nan", "--alpha: nan; expected a finite number"},
    {"fit r --max-simulations infinity", "--max-simulations: infinity; expected a whole number"},
    {"compare r -o x --spread inf", "--spread: inf; expected a finite number"},
    {"draw r -o x --azimuth 1e400", "--azimuth: 1e400; expected a finite number"},
    {"import markers t -o x --size 1 nan", "--size: nan; expected a finite number"},
    {"import markers t -o x --density inf", "--density: inf; expected a finite number"},
    {"import markers t -o x --rate inf", "--rate: inf; expected a finite number"},
    {"import markers t -o x --sigma inf", "--sigma: inf; expected a finite number"},
    {"import markers t -o x --held-out inf", "--held-out: inf; expected a finite number"},
    {"import colmap m -o x --scale nan", "--scale: nan; expected a finite number"},
    {"import colmap m -o x --origin 0 inf 0", "--origin: inf; expected a finite number"},
    {"study chaos -o x --duration inf", "--duration: inf; expected a finite number"},
    {"study cameras -o x --values 1,inf", "--values: inf; expected a finite number"},
    {"fit r --max-iterations 99999999999",
     "--max-iterations: 99999999999; expected a whole number"},
    {"fit r --loss hubr", "--loss: hubr; did you mean 'huber'?"},
    {"fit r --loss square", "--loss: square; expected one of none, huber, cauchy"},
    {"fit r -o", "-o: no value; expected a value"},
    {"fit r -o a --output b", "-o: a b; expected one value"},
    {"check", "RECORDING: is missing (folder of the recording)"},
    {"import markers", "FILE: is missing (of motion capture; read by what is in it, whatever its "},
    {"import video -o x", "CAMERA=FILE: is missing (one a camera"},
    {"import markers t -o x --unit inch", "--unit: inch; expected one of m, cm, mm"},
    {"import markers t -o x --every 1.5", "--every: 1.5; expected a whole number"},
    {"import colmap m -o x --names stm", "--names: stm; did you mean 'stem'?"},
    {"import colmap m -o x --corner a 1 2", "--corner: a 1 2; expected 5 values"},
    {"import colmap m -o x --corner a 1 2 x 3", "--corner: a 1 2 x 3; expected CAMERA U V X Y"},
    {"import colmap m -o x --corner a 1 2 3 4 --origin 0 0 0", "--corner, --origin: both are"},
    {"import opencv f -o x --transform 1 2 3", "--transform: 1 2 3; expected 16 values"},
    {"report f --picture-width 3", "--picture-width: 3; expected a whole number from 16 to 4096"},
    {"report f --max-size -1", "--max-size: -1; expected a number above 0"},
    {"batch l -o x --array-size 4", "--array-size: expected --slurm too"},
    {"batch l -o x --prepare --slurm", "--slurm, --prepare: both are given"},
    {"trials clean --list --effects", "--list, --effects: both are given"},
    {"track r -o x --reidentify look", "--reidentify: look; expected one of reference, tracking"},
    {"track r -o x --marker-place", "--marker-place: no value; expected a value"},
    {"draw r -o x --frames 3 foo", "--frames: foo; expected a whole number"},
    {"draw r -o x --azimuth north", "--azimuth: north; expected a number"},
    {"synthesize -o x --size 1", "--size: 1; expected 2 values"},
    {"study mesh -o x --particles 9 a", "--particles: a; expected a whole number"},
    {"study cameras -o x --values a", "--values: a; expected a number"},
    {"evaluate r", "--truth: is missing (recording with truth/)"}};

CommandResult RunLine(const std::string& line) {
  const TestFolder folder;
  std::vector<std::string> words;
  std::istringstream stream(line);
  for (std::string word; stream >> word;) words.push_back(word);
  return RunCommand(words, folder.path());
}

TEST(OptionErrors, SayWhatWasTypedAndWhatWasExpected) {
  for (const WrongLine& wrong : kWrongLines) {
    const std::string line = BadInputLine(RunLine(wrong.words));
    EXPECT_THAT(line, HasSubstr("error: " + std::string(wrong.answer))) << wrong.words;
    EXPECT_THAT(line, HasSubstr("; 'clothfit help ")) << wrong.words;
    for (const char* of_parser : {"excludes", "required", "REQUIRED", "requires", " INT", ":INT",
                                  "[", "{", "At least", "At Most", "not in", "Value "})
      EXPECT_THAT(line, Not(HasSubstr(of_parser))) << wrong.words;
  }
}

TEST(OptionErrors, FlagsTakeNoValue) {
  EXPECT_THAT(BadInputLine(RunLine("fit r --quiet=7x")),
              HasSubstr("error: --quiet: 7x; expected no value"));
  EXPECT_THAT(BadInputLine(RunLine("synthesize -o x --images=maybe")),
              HasSubstr("error: --images: maybe; expected no value"));
  EXPECT_THAT(BadInputLine(RunLine("check r --help=3")), HasSubstr("--help: 3"));
}

}  // namespace
}  // namespace clothfit
