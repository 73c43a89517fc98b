// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/verdict/sentences.h"

#include <cmath>

#include <fmt/format.h>

#include "tracking/text/text.h"

namespace clothfit {
namespace {

// ": 76 % less than at the start (11 mm)"
std::string ComparedWithStart(const ErrorChange& error) {
  if (!error.before || *error.before <= 0.0) return "";
  const double change = 100.0 * (*error.after / *error.before - 1.0);
  const std::string start = QuantityInWords(*error.before, error.unit);
  if (std::abs(change) < 1.0) return fmt::format(", as at the start ({})", start);
  return fmt::format(", {:.0f} % {} than at the start ({})", std::abs(change),
                     change < 0.0 ? "less" : "more", start);
}

}  // namespace

std::string FittedSentence(const ErrorChange& error) {
  const std::string amount = QuantityInWords(*error.after, error.unit);
  if (error.kind == "silhouettes") {
    return fmt::format("Simulated and measured silhouettes differ by {} in a picture{}.", amount,
                       ComparedWithStart(error));
  }
  return fmt::format("The {} are off by {} (root mean square){}.", error.kind, amount,
                     ComparedWithStart(error));
}

std::string HeldOutSentence(const ErrorChange& error, double ratio) {
  const char* const meaning = ratio <= 1.2            ? "it predicts as well as it fits"
                              : ratio <= kGoodHeldOut ? "it predicts nearly as well as it fits"
                                                      : "it predicts worse than it fits";
  return fmt::format("On what was held out the error is {}{}: {}.",
                     QuantityInWords(*error.after, error.unit), ComparedWithStart(error), meaning);
}

std::string NoiseSentence(double factor) {
  if (factor <= 1.05) return "What is left is no larger than the stated noise of the measurement.";
  return fmt::format(
      "What is left is {:.2g} times the stated noise: {}; the intervals are widened by as much.",
      factor,
      factor <= kGoodNoise ? "the noise is understated, or a little physics is missing"
                           : "physics is missing, or the noise is understated");
}

std::string MisfitSentence(const Misfit& misfit) {
  const std::string left =
      fmt::format("The residuals' chi-square is {:.3g} (1 is expected, noise leaves up to {:.3g})",
                  misfit.chi_square, misfit.limit);
  if (misfit.IsNoise()) return left + ": no more than the stated noise.";
  if (misfit.IsNoiseAndMesh()) {
    return fmt::format("{}, {:.3g} without what mesh and step leave: no more than both.", left,
                       *misfit.without_discretisation);
  }
  return left +
         ": physics is missing, the noise is understated, or there is a lower minimum. The "
         "intervals are widened by what is left.";
}

std::string MeshSentence(const Misfit& misfit) {
  constexpr double kSmall = 0.5;  // of the noise
  if (!misfit.discretisation) return "What mesh and step do to the fit is not known.";
  return fmt::format("Mesh and step err by {:.2g} times the noise{}; the intervals contain it.",
                     *misfit.discretisation,
                     *misfit.discretisation <= kSmall
                         ? ""
                         : ": a finer mesh (--resolution) may change what was found");
}

std::string ParameterSentence(const VerdictFacts& facts) {
  if (facts.num_free == 0) return "No physical parameter was free.";
  const auto open = facts.undetermined.size();
  if (open == 0) {
    return facts.num_free == 1
               ? "The one free parameter is determined by the data."
               : fmt::format("All {} free parameters are determined by the data.", facts.num_free);
  }
  return fmt::format("{} of {} free parameters {} left to {} prior: {}.", open, facts.num_free,
                     open == 1 ? "is" : "are", open == 1 ? "its" : "their",
                     JoinNames(facts.undetermined));
}

}  // namespace clothfit
