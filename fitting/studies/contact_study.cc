// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether contact holds where it is hard: does every step converge, does nothing pass through
// anything, and does no energy come from nowhere? And what it costs.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "autodiff_sim/scenes/hard_scenes.h"
#include "fitting/pictures/line_chart.h"
#include "fitting/pictures/picture.h"
#include "fitting/studies/study.h"
#include "tracking/files/whole_file.h"

namespace clothfit {
namespace {

constexpr int kReducedParticles = 11, kFullParticles = 21;  // a side

// How a scene is simulated: as clothfit does, by shorter and shorter steps, and by backward Euler
// without losses, where energy must not rise in any step.
struct Way {
  int rate;  // steps a second
  bool strict;
};
constexpr std::array<Way, 4> kWays = {{{120, false}, {240, false}, {480, false}, {120, true}}};

std::vector<Job> ContactJobs(const StudyOptions& options) {
  std::vector<Job> jobs;
  for (const HardScene& scene : HardScenes()) {
    for (const Way& way : kWays) {
      jobs.push_back({fmt::format("{}-{}{}", scene.name, way.rate, way.strict ? "-strict" : ""),
                      {{"scene", scene.name},
                       {"steps_per_second", way.rate},
                       {"strict", way.strict},
                       {"particles", options.full ? kFullParticles : kReducedParticles}}});
    }
  }
  return jobs;
}

// One of the rows of a scene's table, each frame a row.
nlohmann::json FrameRow(const SceneFrame& frame) {
  nlohmann::json row = {frame.time};
  for (const NamedEnergy& part : frame.energies) row.push_back(part.energy);
  const StepReport& report = frame.report;
  for (const double number : {frame.handle_work, frame.balance}) row.push_back(number);
  for (const int number :
       {report.most_contact_pairs, report.most_obstacle_contacts, report.newton_iterations,
        report.factorizations, report.halvings, report.intersections})
    row.push_back(number);
  for (const double number : {frame.seconds, frame.detection, frame.response})
    row.push_back(number);
  return row;
}

nlohmann::json Columns(const SceneFrame& frame) {
  nlohmann::json columns = {"time"};
  for (const NamedEnergy& part : frame.energies) columns.push_back(part.name);
  for (const char* name :
       {"handle_work", "balance", "pairs", "obstacle_contacts", "newton_iterations",
        "factorizations", "halvings", "intersections", "seconds", "detection", "response"})
    columns.push_back(name);
  return columns;
}

// Places over the cloth's side, so that all scenes are drawn to one scale.
std::vector<double> ScaledPlaces(const SceneFrame& frame, double side) {
  const Eigen::VectorXd x = frame.x / side;
  return {x.begin(), x.end()};
}

nlohmann::json RunContactJob(const StudyOptions&, const Job& job, const JobContext&) {
  const HardScene scene = FindHardScene(job.input.at("scene"));
  SceneOptions how;
  how.particles = job.input.at("particles");
  how.step = 1.0 / job.input.at("steps_per_second").get<double>();
  how.lossless = job.input.at("strict");
  if (how.lossless) how.integrator = Integrator::kBackwardEuler;
  const SceneRun run = RunHardScene(scene, how);
  nlohmann::json rows = nlohmann::json::array();
  for (const SceneFrame& frame : run.frames) rows.push_back(FrameRow(frame));
  const std::size_t last = run.frames.size() - 1;
  return {{"complete", run.complete},
          {"scale", run.scale},
          {"largest_gain", run.largest_gain},
          {"largest_rise", run.largest_rise},
          {"columns", Columns(run.frames[0])},
          {"rows", rows},
          {"middle", ScaledPlaces(run.frames[last / 2], scene.side)},
          {"end", ScaledPlaces(run.frames[last], scene.side)}};
}

// A scene by one step, with what came of it.
struct Done {
  nlohmann::json input, output;
  int Column(const std::string& name) const {
    const nlohmann::json& columns = output.at("columns");
    return static_cast<int>(std::find(columns.begin(), columns.end(), name) - columns.begin());
  }
  double Sum(const std::string& name) const {
    const int column = Column(name);
    double sum = 0.0;
    for (const nlohmann::json& row : output.at("rows")) sum += row[column].get<double>();
    return sum;
  }
  double Most(const std::string& name) const {
    const int column = Column(name);
    double most = 0.0;
    for (const nlohmann::json& row : output.at("rows"))
      most = std::max(most, row[column].get<double>());
    return most;
  }
  std::string Scene() const { return input.at("scene"); }
  int Rate() const { return input.at("steps_per_second"); }
  bool IsStrict() const { return input.at("strict"); }
  const char* Integrator() const { return IsStrict() ? "backward Euler, lossless" : "BDF2"; }
  const char* IntegratorInTables() const { return IsStrict() ? "euler_lossless" : "bdf2"; }
};

std::vector<Done> AllDone(const std::vector<Job>& jobs, const std::vector<JobResult>& results) {
  std::vector<Done> done;
  for (const JobResult& result : results) {
    const auto job = std::find_if(jobs.begin(), jobs.end(),
                                  [&](const Job& one) { return one.name == result.name; });
    done.push_back({job->input, result.output});
  }
  return done;
}

// The frames of a scene, by all steps.
std::string FrameTable(const std::vector<Done>& done, const std::string& scene) {
  std::string text;
  for (const Done& one : done) {
    if (one.Scene() != scene) continue;
    if (text.empty()) {
      text = "integrator,steps_per_second";
      for (const nlohmann::json& name : one.output.at("columns"))
        text += "," + name.get<std::string>();
      text += "\n";
    }
    for (const nlohmann::json& row : one.output.at("rows")) {
      text += fmt::format("{},{}", one.IntegratorInTables(), one.Rate());
      for (const nlohmann::json& number : row) text += fmt::format(",{:.6g}", number.get<double>());
      text += "\n";
    }
  }
  return text;
}

std::string ContactRows(const std::vector<Done>& done, bool markdown) {
  std::string text;
  for (const Done& one : done) {
    const double seconds = one.Sum("seconds"), scale = one.output.at("scale");
    const double steps =
        one.output.at("rows").back()[one.Column("time")].get<double>() * one.Rate();
    text += fmt::format(
        markdown
            ? "| {} | {} | {} | {} | {} | {} | {:.1e} | {:.1e} | {} | {} | {:.1f} | {:.2f} | {} | "
              "{:.1f} | {:.2f} | {:.2f} |\n"
            : "{},{},{},{},{},{},{:.3e},{:.3e},{},{},{:.2f},{:.3f},{},{:.3f},{:.3f},{:.3f}\n",
        one.Scene(), markdown ? one.Integrator() : one.IntegratorInTables(), one.Rate(),
        one.output.at("rows").size() - 1, one.output.at("complete").get<bool>() ? "yes" : "no",
        one.Sum("intersections"), one.output.at("largest_gain").get<double>() / scale,
        one.output.at("largest_rise").get<double>() / scale, one.Most("pairs"),
        one.Most("obstacle_contacts"), one.Sum("newton_iterations") / steps,
        one.Sum("factorizations") / steps, one.Sum("halvings"), 1e3 * seconds / steps,
        one.Sum("detection") / seconds, one.Sum("response") / seconds);
  }
  return text;
}

Chart BalanceChart(const std::vector<Done>& done, const Way& way) {
  Chart chart{way.strict ? "Backward Euler, lossless" : "BDF2",
              "time, of the whole scene",
              "energy gained, of weight times side",
              false,
              false,
              {}};
  for (const Done& one : done) {
    if (one.Rate() != way.rate || one.IsStrict() != way.strict) continue;
    ChartLine line{one.Scene(), {}, false, false};
    const nlohmann::json& rows = one.output.at("rows");
    const double end = rows.back()[0], scale = one.output.at("scale");
    for (const nlohmann::json& row : rows) {
      const double time = row[0], balance = row[one.Column("balance")];
      line.points.emplace_back(time / end, balance / scale);
    }
    chart.lines.push_back(line);
  }
  return chart;
}

void Draw(const std::vector<Done>& done, const std::string& file) {
  std::vector<std::vector<ClothPanel>> rows(2);
  int particles = 0;
  for (const Done& one : done) {
    if (one.Rate() != kWays.front().rate || one.IsStrict()) continue;
    particles = one.input.at("particles");
    int row = 0;
    for (const char* when : {"middle", "end"}) {
      const std::vector<double> places = one.output.at(when);
      const Eigen::Map<const Eigen::VectorXd> x(places.data(),
                                                static_cast<Eigen::Index>(places.size()));
      const Eigen::Map<const Eigen::Matrix3Xd> points(x.data(), 3, x.size() / 3);
      rows[row++].push_back({fmt::format("{}, {}", one.Scene(), when), x, points.rowwise().mean()});
    }
  }
  DrawCloths(MakeGrid({1.0, 1.0}, {particles, particles}), rows, 1.6, {}, file);
}

std::string ContactStudyReport(const StudyOptions&, const std::vector<Job>& jobs,
                               const std::vector<JobResult>& results, const StudyPlace& place) {
  const std::vector<Done> done = AllDone(jobs, results);
  for (const HardScene& scene : HardScenes()) {
    const std::string table = FrameTable(done, scene.name);
    if (!table.empty()) WriteWholeFile(place.folder / ("contact-" + scene.name + ".csv"), table);
  }
  WriteWholeFile(
      place.folder / "contact.csv",
      "scene,integrator,steps_per_second,frames,complete,intersections,largest_gain,largest_rise,"
      "most_pairs,most_obstacle_contacts,newton_iterations,factorizations,halvings,"
      "step_ms,detection_share,response_share\n" +
          ContactRows(done, false));
  WriteWholeFile(place.folder / "contact.svg", ChartsAsSvg({BalanceChart(done, kWays.front()),
                                                            BalanceChart(done, kWays.back())}));
  Draw(done, (place.folder / "contact.png").string());
  return "| scene | integrator | steps a second | frames | all converged | intersections | most "
         "gained | largest "
         "rise | most pairs | with the obstacle or ground | Newton iterations a step | "
         "factorisations a step | halved steps | a step, ms | finding, share | response, share |\n"
         "|---|---|---:|---:|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n" +
         ContactRows(done, true);
}

}  // namespace

Study ContactStudy() {
  Study study;
  study.name = "contact";
  study.doc = "hard scenes of contact: convergence, intersections, energy and cost";
  study.uses_recordings = false;
  for (const HardScene& scene : HardScenes())
    study.files.push_back("contact-" + std::string(scene.name) + ".csv");
  study.jobs = ContactJobs;
  study.work = RunContactJob;
  study.report = ContactStudyReport;
  return study;
}

}  // namespace clothfit
