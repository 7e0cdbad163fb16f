// SPDX-License-Identifier: Apache-2.0
#include "optimizer/objective/objective.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>

#include "optimizer/design/inertia.hpp"
#include "optimizer/design/kinematics.hpp"
#include "optimizer/motion/initial_guess.hpp"
#include "optimizer/motion/path.hpp"
#include "optimizer/objective/assembly.hpp"
#include "optimizer/objective/derived.hpp"
#include "optimizer/terms/registry.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

/// A term of the registry as it stands in this objective.
struct WeightedTerm {
  std::string_view name;
  double weight;
  std::unique_ptr<Term> term;
  std::vector<ElementPlan> plans;  // by element
};

/// The robot standing in its home pose at the initial design: COM and feet under a level trunk.
struct Stance {
  double com_height;
  std::vector<Eigen::Vector2d> footprint;
};

Stance home_stance(const Morphology& morphology, const VectorXd& s) {
  const GeometryAtDesign geometry(morphology, s);
  PoseKinematics pose;
  VectorXd q = VectorXd::Zero(morphology.pose_size());
  q.tail(morphology.joint_count()) = morphology.nominal_joints();
  pose.compute(morphology, geometry, q, false);
  const Columns columns(morphology.pose_size() + s.size(), 0);
  PointDerivatives com, foot;
  com_from_pose(morphology, geometry, pose, columns, com);
  const Ancestry ancestry(morphology);
  Stance stance{0.0, {}};
  double ground = std::numeric_limits<double>::infinity();
  for (int j = 0; j < morphology.foot_count(); ++j) {
    foot_from_pose(morphology, geometry, ancestry, pose, j, columns, foot);
    stance.footprint.push_back((foot.value - com.value).head<2>());
    ground = std::min(ground, foot.value.z() - morphology.feet[j].radius);
  }
  stance.com_height = com.value.z() - ground;
  return stance;
}

bool same_pattern(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& b) {
  return a.cols() == b.cols() && a.nonZeros() == b.nonZeros() &&
         std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1, b.outerIndexPtr()) &&
         std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

std::vector<double> term_weights(const Task& task) {
  std::map<std::string, double> wanted = task.weights;
  std::vector<double> weights;
  for (const TermEntry& entry : term_registry()) {
    const auto found = wanted.find(std::string(entry.name));
    weights.push_back(found == wanted.end() ? entry.default_weight : found->second);
    if (found != wanted.end()) wanted.erase(found);
  }
  if (!wanted.empty())
    throw std::invalid_argument("weights: no term is named " + wanted.begin()->first);
  return weights;
}

}  // namespace

struct Objective::Workspace::Parts {
  const void* owner = nullptr;  // the objective it was last used with
  DerivedQuantities::Workspace derived;
  ElementWorkspace element;
  VectorXd extended, gradient;  // [s; m; y] and ∂F/∂[s; m; y]
};

Objective::Workspace::Workspace() : parts_(std::make_unique<Parts>()) {}
Objective::Workspace::~Workspace() = default;

struct Objective::Impl {
  using Parts = Workspace::Parts;

  Morphology morphology;
  DesignSpace space;
  Task task;
  Layout layout;
  WantedPath path;
  VectorXd units;
  DerivedQuantities derived;
  std::vector<WeightedTerm> terms;
  std::vector<Clique> block_cliques;  // by derived block
  Eigen::SparseMatrix<double> pattern;

  void build();
  void add_element(const WeightedTerm& entry, int index, Order order, Parts& workspace,
                   Evaluation& out, double& term_value) const;
  void scatter(const Clique& clique, const Eigen::MatrixXd& hessian, Order order,
               Evaluation& out) const;
  void add_derived(Order order, Parts& workspace, Evaluation& out) const;
};

void Objective::Impl::build() {
  const VectorXd initial = space.initial();
  const Stance stance = home_stance(morphology, initial);
  const double mass = morphology.total_mass();
  const TermContext context{layout,
                            morphology,
                            space,
                            task,
                            path,
                            morphology.leg_length,
                            mass,
                            mass * kGravity,
                            task.com_height.value_or(stance.com_height),
                            task.footprint.value_or(stance.footprint)};
  units = layout.motion_units(context.length, context.weight);
  derived = DerivedQuantities(morphology, layout, task, path);
  std::vector<int> block_at_slot(layout.extended_size(), -1);
  for (std::size_t b = 0; b < derived.blocks().size(); ++b)
    block_at_slot[derived.blocks()[b].slot] = static_cast<int>(b);
  std::vector<Clique*> cliques;
  const std::vector<double> weights = term_weights(task);
  for (std::size_t k = 0; k < term_registry().size(); ++k) {
    const TermEntry& entry = term_registry()[k];
    terms.push_back({entry.name, weights[k], entry.make(context), {}});
    for (const Element& element : terms.back().term->elements())
      terms.back().plans.push_back(plan_element(element, derived.blocks(), block_at_slot,
                                                layout.design_size(), layout.parameter_count()));
  }
  for (const DerivedBlock& block : derived.blocks())
    block_cliques.push_back({block.slots, block.motion_columns, {}});
  for (WeightedTerm& term : terms)
    for (ElementPlan& plan : term.plans) cliques.push_back(&plan.clique);
  for (Clique& clique : block_cliques) cliques.push_back(&clique);
  pattern = Sparsity::build(layout.design_size(), layout.motion_size(), cliques);
}

void Objective::Impl::scatter(const Clique& clique, const Eigen::MatrixXd& hessian, Order order,
                              Evaluation& out) const {
  double* values = out.hessian_mm.valuePtr();
  const int n = layout.design_size(), motion = clique.motion_count;
  for (int a = 0; a < motion; ++a)
    for (int b = 0; b <= a; ++b) values[clique.position(a, b)] += hessian(a, b);
  if (order != Order::design) return;
  for (std::size_t k = motion; k < clique.slots.size(); ++k) {
    const int column = clique.slots[k], local = static_cast<int>(k);
    for (int a = 0; a < motion; ++a)
      out.hessian_ms(clique.slots[a] - n, column) += hessian(local, a);
    for (std::size_t l = motion; l < clique.slots.size(); ++l)
      out.hessian_ss(column, clique.slots[l]) +=
          hessian(std::max(local, static_cast<int>(l)), std::min(local, static_cast<int>(l)));
  }
}

void Objective::Impl::add_element(const WeightedTerm& entry, int index, Order order,
                                  Parts& workspace, Evaluation& out, double& term_value) const {
  const Term& term = *entry.term;
  const Element& element = term.elements()[index];
  const ElementPlan& plan = entry.plans[index];
  ElementWorkspace& local = workspace.element;
  const int size = static_cast<int>(element.slots.size());
  local.z.resize(size);
  for (int k = 0; k < size; ++k) local.z[k] = workspace.extended[element.slots[k]];
  local.residual.resize(element.rows);
  term.residual(index, local.z, local.residual);
  local.multiplier.resize(element.rows);
  local.second.resize(element.rows);
  for (int k = 0; k < element.rows; ++k) {
    const PenaltyValue p =
        legwright::evaluate(term.penalty(), local.residual[k], task.barrier_edge);
    term_value += entry.weight * p.value;
    local.multiplier[k] = entry.weight * p.first;
    local.second[k] = entry.weight * p.second;
  }
  if (order == Order::value) return;
  local.jacobian.setZero(element.rows, size);
  term.jacobian(index, local.z, local.jacobian);
  for (int k = 0; k < size; ++k)
    workspace.gradient[element.slots[k]] += local.jacobian.col(k).dot(local.multiplier);
  if (order == Order::gradient) return;
  const Clique& clique = plan.clique;
  const int columns =
      order == Order::design ? static_cast<int>(clique.slots.size()) : clique.motion_count;
  if (columns == 0) return;
  expand_jacobian(plan, workspace.derived.jacobians, columns, local);
  local.hessian.setZero(columns, columns);
  for (int k = 0; k < element.rows; ++k)
    local.hessian.selfadjointView<Eigen::Lower>().rankUpdate(local.expanded.row(k).transpose(),
                                                             local.second[k]);
  if (term.curved()) {
    local.curvature.setZero(size, size);
    term.add_curvature(index, local.z, local.multiplier, local.curvature);
    expand_curvature(plan, workspace.derived.jacobians, columns, local);
  }
  scatter(clique, local.hessian, order, out);
}

void Objective::Impl::add_derived(Order order, Parts& workspace, Evaluation& out) const {
  // Chain rule: what terms want of y is handed on to m and s, and y's own curvature comes in.
  for (std::size_t b = 0; b < derived.blocks().size(); ++b) {
    const DerivedBlock& block = derived.blocks()[b];
    const Vector3d multiplier = workspace.gradient.segment<3>(block.slot);
    for (std::size_t k = 0; k < block.slots.size(); ++k)
      workspace.gradient[block.slots[k]] +=
          workspace.derived.jacobians[b].col(static_cast<int>(k)).dot(multiplier);
    if (order == Order::gradient) continue;
    derived.curvature(static_cast<int>(b), multiplier, workspace.derived);
    scatter(block_cliques[b], workspace.derived.curvature, order, out);
  }
}

Objective::Objective(Morphology morphology, DesignSpace space, Task task)
    : impl_(std::make_unique<Impl>()) {
  if (task.gait.foot_count() != morphology.foot_count())
    throw std::invalid_argument("the gait has " + std::to_string(task.gait.foot_count()) +
                                " feet, the robot " + std::to_string(morphology.foot_count()));
  if (task.footprint && static_cast<int>(task.footprint->size()) != morphology.foot_count())
    throw std::invalid_argument("the footprint needs one entry for each foot of the robot");
  if (task.planted_margin < 1)
    throw std::invalid_argument("planted_margin must be at least one knot");
  impl_->layout = Layout(morphology, space.size(), task.gait, task.planted_margin);
  impl_->path = WantedPath(task.velocity, task.turn_rate, task.gait.period());
  impl_->morphology = std::move(morphology);
  impl_->space = std::move(space);
  impl_->task = std::move(task);
  impl_->build();
}

Objective::~Objective() = default;
Objective::Objective(Objective&&) noexcept = default;

const Morphology& Objective::morphology() const { return impl_->morphology; }
const DesignSpace& Objective::space() const { return impl_->space; }
const Task& Objective::task() const { return impl_->task; }
const Layout& Objective::layout() const { return impl_->layout; }
const WantedPath& Objective::path() const { return impl_->path; }
const VectorXd& Objective::motion_units() const { return impl_->units; }

std::vector<std::string_view> Objective::term_names() const {
  std::vector<std::string_view> names;
  for (const WeightedTerm& term : impl_->terms) names.push_back(term.name);
  return names;
}

std::unique_ptr<Objective::Workspace> Objective::make_workspace() const {
  return std::make_unique<Workspace>();
}

void Objective::evaluate(const VectorXd& s, const VectorXd& m, Order order, Workspace& scratch,
                         Evaluation& out) const {
  Workspace::Parts& workspace = *scratch.parts_;
  const Layout& layout = impl_->layout;
  if (s.size() != layout.design_size() || m.size() != layout.motion_size())
    throw std::invalid_argument("F: s has " + std::to_string(s.size()) + " and m " +
                                std::to_string(m.size()) + " entries");
  if (workspace.owner != impl_.get()) workspace.derived = {};  // of another robot
  workspace.owner = impl_.get();
  workspace.extended.resize(layout.extended_size());
  workspace.extended.head(s.size()) = s;
  workspace.extended.segment(s.size(), m.size()) = m;
  workspace.extended.tail(layout.extended_size() - layout.parameter_count()).setZero();
  impl_->derived.evaluate(impl_->morphology, layout, order != Order::value, order == Order::design,
                          workspace.extended, workspace.derived);
  workspace.gradient.setZero(layout.extended_size());
  if (order == Order::hessian || order == Order::design) {
    if (!same_pattern(out.hessian_mm, impl_->pattern)) out.hessian_mm = impl_->pattern;
    std::fill_n(out.hessian_mm.valuePtr(), out.hessian_mm.nonZeros(), 0.0);
  }
  if (order == Order::design) {
    out.hessian_ms.setZero(layout.motion_size(), layout.design_size());
    out.hessian_ss.setZero(layout.design_size(), layout.design_size());
  }
  out.value = 0.0;
  out.term_values.assign(impl_->terms.size(), 0.0);
  for (std::size_t k = 0; k < impl_->terms.size(); ++k) {
    for (std::size_t e = 0; e < impl_->terms[k].plans.size(); ++e)
      impl_->add_element(impl_->terms[k], static_cast<int>(e), order, workspace, out,
                         out.term_values[k]);
    out.value += out.term_values[k];
  }
  if (order == Order::value) return;
  impl_->add_derived(order, workspace, out);
  out.stationarity = workspace.gradient.segment(layout.design_size(), layout.motion_size());
  if (order == Order::design) out.partial_s = workspace.gradient.head(layout.design_size());
}

Evaluation Objective::evaluate(const VectorXd& s, const VectorXd& m, Order order) const {
  Workspace workspace;
  Evaluation out;
  evaluate(s, m, order, workspace, out);
  return out;
}

std::vector<TermValue> Objective::terms(const VectorXd& s, const VectorXd& m) const {
  const Evaluation at = evaluate(s, m, Order::value);
  std::vector<TermValue> values;
  for (std::size_t k = 0; k < impl_->terms.size(); ++k)
    values.push_back({impl_->terms[k].name, at.term_values[k]});
  return values;
}

VectorXd initial_guess(const Objective& objective, const VectorXd& s) {
  return initial_guess(objective.morphology(), objective.layout(), objective.task().gait,
                       objective.path(), s);
}

}  // namespace legwright
