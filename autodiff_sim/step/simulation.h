// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A cloth that moves by implicit steps, each solved to convergence and differentiated exactly.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/step/cloth_model.h"
#include "autodiff_sim/step/state.h"
#include "autodiff_sim/term/step_inputs.h"

namespace clothfit {

struct SimulationOptions {
  Integrator integrator = Integrator::kBdf2;
  // A step has converged when the estimated error of its positions is below this times the mean
  // edge.
  double tolerance = 1e-9;
  int max_newton_iterations = 40;
  // A step that fails is tried afresh, without what is kept from earlier steps, and then as 2, 4,
  // ... 2^max_halvings shorter ones.
  int max_halvings = 8;
  // Of the linear solves of the derivatives, relative to each right-hand side.
  double sensitivity_tolerance = 1e-9;
  // Whether the cloth collides with itself. Then it never passes through itself or the ground,
  // neither at the end of a step nor on its way there; what the layers do to one another is the
  // term `contact`. With the world's obstacles it collides always (the term `obstacle`).
  bool self_contact = false;
  // Counts after every step how often the cloth passes through itself, an obstacle or the ground.
  bool check_intersections = false;
  // Of the derivatives; 0: as many as the machine runs at once. The numbers are the same for any.
  int num_threads = 1;
  // Terms that are off and remember do so in steps with derivatives by their parameters; this makes
  // them in every step, so that such derivatives may begin later and know what was before.
  bool remember_when_off = false;
};

enum class StepStatus {
  kConverged,
  kDiverged,           // no step length that was tried converges; the state is the last that did
  kSensitivityFailed,  // the state is good, its derivatives could not be solved for and are
                       // unusable
};

// What it took. Counts add up over the parts of a step that was halved.
struct StepReport {
  StepStatus status = StepStatus::kConverged;
  int newton_iterations = 0;
  int linear_iterations = 0;       // of the forward solves
  int sensitivity_iterations = 0;  // of the derivatives' solves, the slowest lanes of each step
  int jacobians = 0;               // evaluated
  int factorizations = 0;
  int halvings = 0;
  int contact_pairs = 0;      // of features of the cloth, at the end of the step
  int obstacle_contacts = 0;  // of the cloth and obstacles or the ground, likewise
  // The most of both at the end of any step that was added up.
  int most_contact_pairs = 0, most_obstacle_contacts = 0;
  int limited_iterates = 0;  // that would have passed through something and were shortened
  int pattern_rebuilds = 0;  // of the matrices, to make room for new contacts
  int blocked_steps = 0;     // tried in vain, since the handles' own motion met something
  int intersections = 0;     // of all steps, where they are checked
  // J, that the handles did: each step's length times their power at its end. Backward Euler and
  // BDF2 then gain no energy beyond it where the forces' energy is convex, BDF2 but for terms that
  // fall with the step.
  double handle_work = 0.0;
  double error = 0.0;  // m, the largest estimated error of a position

  StepReport& operator+=(const StepReport& other);
};

// Gives the inputs at a time (s). With directions it also fills StepInputs::directions.
using Drive = std::function<StepInputs(double time, bool with_directions)>;

class Simulation {
 public:
  // A simulation with clothfit's own terms. `handles` are all points that a drive may ever hold.
  Simulation(ClothMesh mesh, const World& world, const std::vector<SurfacePoint>& handles,
             const SimulationOptions& options = {});

  // The same with another list of terms, e.g. Simulation::WithTerms(TypeList<Gravity, Mine>{},
  // ...).
  template <class... List>
  static Simulation WithTerms(TypeList<List...>, ClothMesh mesh, const World& world,
                              const std::vector<SurfacePoint>& handles,
                              const SimulationOptions& options = {}) {
    return Simulation(std::make_unique<ClothModel>(
                          std::move(mesh), world,
                          [](const TermContext& context) {
                            return MakeForceBatches(TypeList<List...>{}, context);
                          },
                          handles),
                      options);
  }

  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  const ClothModel& model() const { return *model_; }
  const SimulationOptions& options() const { return options_; }

  // All parameters in the order of model().parameters().
  const Eigen::VectorXd& parameters() const { return parameters_; }
  void SetParameters(const Eigen::VectorXd& values);

  // The cloth at rest at these positions (3N, m).
  State MakeState(const Eigen::VectorXd& x) const;
  // Throws InputError where contact cannot begin with this state and the present parameters: it
  // passes through itself or an obstacle, or the thickness is too large for the mesh.
  void CheckStart(const State& state) const;
  // How many edges meet a triangle with which they have no vertex in common, at x (3N, m). Exact.
  int CountIntersections(const Eigen::VectorXd& x) const;
  // How much of the cloth at x is in an obstacle where that is at the time (s), and with
  // self_contact not above the ground: see ObstacleContacts. `names` gets those that are concerned.
  int CountObstacleIntersections(const Eigen::VectorXd& x, double time,
                                 std::vector<std::string>* names = nullptr) const;

  // Moves the state on by h seconds, and its derivatives where `sensitivity` is given. There is no
  // way to get a derivative of a step that did not converge. `known`: the velocities (3N, m/s) with
  // which the same step in one part has ended before; they are not solved for again, unless there
  // is contact.
  StepReport Advance(double h, const Drive& drive, State* state, Sensitivity* sensitivity = nullptr,
                     const Eigen::VectorXd* known = nullptr);

  // The force (N, 3N) that a handle exerts on the cloth to hold it: the last step's residual at the
  // held particles over gamma; zero elsewhere.
  const Eigen::VectorXd& handle_forces() const { return handle_forces_; }

  // Where the state's energy is: kinetic, and of each term that has one. Drag, damping and friction
  // have none and only take.
  std::vector<NamedEnergy> Energies(const State& state);

  // Forgets the factor kept from earlier steps, so that what follows does not depend on them.
  void Reset();

 private:
  struct Solver;
  Simulation(std::unique_ptr<ClothModel> model, const SimulationOptions& options);
  StepReport TryStep(double h, bool fresh, const Drive& drive, State* state,
                     Sensitivity* sensitivity, const Eigen::VectorXd* known);

  bool StartsClear(const State& state);

  std::unique_ptr<ClothModel> model_;
  SimulationOptions options_;
  Eigen::VectorXd parameters_;
  Eigen::VectorXd handle_forces_;
  std::unique_ptr<Solver> solver_;
};

}  // namespace clothfit
