// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/fitted/kept_fit.h"

#include <type_traits>
#include <vector>

#include <nlohmann/json.hpp>

#include "tracking/text/json_text.h"

namespace clothfit {
namespace {

using Json = nlohmann::json;

constexpr const char* kFormat = "clothfit-fit/2";

// The members of what is kept, once for both ways.
template <class Visitor>
void VisitMembers(Visitor& visit, Evaluation& e) {
  visit("complete", e.complete);
  visit("frames", e.frames);
  visit("marker_rms", e.marker_rms);
  visit("held_out_marker_rms", e.held_out_marker_rms);
  visit("track_rms", e.track_rms);
  visit("held_out_track_rms", e.held_out_track_rms);
  visit("silhouette_error", e.silhouette_error);
  visit("held_out_silhouette_error", e.held_out_silhouette_error);
}

template <class Visitor>
void VisitMembers(Visitor& visit, ParameterEstimate& e) {
  visit("name", e.name);
  visit("unit", e.unit);
  visit("value", e.value);
  visit("start", e.start);
  visit("free", e.free);
  visit("lower95", e.lower95);
  visit("upper95", e.upper95);
  visit("determined", e.determined);
  visit("at_bound", e.at_bound);
}

template <class Visitor>
void VisitMembers(Visitor& visit, StepReport& s) {
  visit("status", s.status);
  visit("newton_iterations", s.newton_iterations);
  visit("linear_iterations", s.linear_iterations);
  visit("sensitivity_iterations", s.sensitivity_iterations);
  visit("jacobians", s.jacobians);
  visit("factorizations", s.factorizations);
  visit("halvings", s.halvings);
  visit("contact_pairs", s.contact_pairs);
  visit("obstacle_contacts", s.obstacle_contacts);
  visit("most_contact_pairs", s.most_contact_pairs);
  visit("most_obstacle_contacts", s.most_obstacle_contacts);
  visit("limited_iterates", s.limited_iterates);
  visit("pattern_rebuilds", s.pattern_rebuilds);
  visit("blocked_steps", s.blocked_steps);
  visit("intersections", s.intersections);
  visit("handle_work", s.handle_work);
  visit("error", s.error);
}

template <class Visitor>
void VisitMembers(Visitor& visit, Misfit& m) {
  visit("observed", m.observed);
  visit("chi_square", m.chi_square);
  visit("limit", m.limit);
  visit("correlation", m.correlation);
  visit("discretisation", m.discretisation);
  visit("amplitude", m.amplitude);
  visit("without_discretisation", m.without_discretisation);
}

template <class Visitor>
void VisitMembers(Visitor& visit, FitResult& r) {
  visit("status", r.status);
  visit("theta", r.theta);
  visit("parameters", r.parameters);
  visit("iterations", r.iterations);
  visit("simulations", r.simulations);
  visit("simulated_frames", r.simulated_frames);
  visit("differentiated_frames", r.differentiated_frames);
  visit("seconds", r.seconds);
  visit("cost_before", r.cost_before);
  visit("cost_after", r.cost_after);
  visit("before", r.before);
  visit("after", r.after);
  visit("estimates", r.estimates);
  visit("statements", r.statements);
  visit("noise_factor", r.noise_factor);
  visit("misfit", r.misfit);
  visit("steps", r.steps);
}

template <class T>
constexpr bool kIsPlain = std::is_arithmetic_v<T> || std::is_same_v<T, std::string>;

class Writer {
 public:
  template <class T>
  void operator()(const char* name, T& value) {
    json_[name] = Encode(value);
  }
  template <class T>
  static Json Encode(T& value) {
    if constexpr (kIsPlain<T>) {
      return value;
    } else if constexpr (std::is_enum_v<T>) {
      return static_cast<int>(value);
    } else {
      Writer members;
      VisitMembers(members, value);
      return members.json_;
    }
  }
  static Json Encode(Eigen::VectorXd& vector) {
    return std::vector<double>(vector.begin(), vector.end());
  }
  template <class T>
  static Json Encode(std::optional<T>& value) {
    return value ? Encode(*value) : Json();
  }
  template <class T>
  static Json Encode(std::vector<T>& values) {
    Json json = Json::array();
    for (T& value : values) json.push_back(Encode(value));
    return json;
  }

 private:
  Json json_;
};

class Reader {
 public:
  explicit Reader(const Json& json) : json_(json) {}
  template <class T>
  void operator()(const char* name, T& value) {
    Decode(json_.at(name), &value);
  }
  template <class T>
  static void Decode(const Json& json, T* value) {
    if constexpr (kIsPlain<T>) {
      json.get_to(*value);
    } else if constexpr (std::is_enum_v<T>) {
      *value = static_cast<T>(json.get<int>());
    } else {
      Reader members(json);
      VisitMembers(members, *value);
    }
  }
  static void Decode(const Json& json, Eigen::VectorXd* vector) {
    const auto numbers = json.get<std::vector<double>>();
    *vector = Eigen::Map<const Eigen::VectorXd>(numbers.data(),
                                                static_cast<Eigen::Index>(numbers.size()));
  }
  template <class T>
  static void Decode(const Json& json, std::optional<T>* value) {
    if (!json.is_null()) Decode(json, &value->emplace());
  }
  template <class T>
  static void Decode(const Json& json, std::vector<T>* values) {
    for (const Json& one : json) Decode(one, &values->emplace_back());
  }

 private:
  const Json& json_;
};

}  // namespace

std::string FitAsBytes(FitResult result) {
  Json json = Writer::Encode(result);
  json["format"] = kFormat;
  std::string bytes;
  Json::to_cbor(json, bytes);
  return bytes;
}

std::optional<FitResult> FitFromBytes(std::string_view bytes) {
  if (!IsShallowCbor(bytes)) return std::nullopt;
  try {
    const Json json = Json::from_cbor(bytes);
    if (json.at("format") != kFormat) return std::nullopt;
    FitResult result;
    Reader::Decode(json, &result);
    return result;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace clothfit
