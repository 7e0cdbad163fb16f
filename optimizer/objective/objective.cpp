// SPDX-License-Identifier: Apache-2.0
#include "optimizer/objective/objective.hpp"

#include <map>
#include <stdexcept>
#include <string>

#include "optimizer/design/inertia.hpp"
#include "optimizer/motion/initial_guess.hpp"
#include "optimizer/objective/parts.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

bool has_second(Order order) { return order == Order::hessian || order == Order::design; }
bool has_design(Order order) { return order == Order::gradients || order == Order::design; }

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

const Clique& clique_of(const WeightedTerm& entry, int index) {
  return *entry.plans[static_cast<std::size_t>(index)].plan->clique;
}

}  // namespace

Objective::Workspace::Workspace() : parts_(std::make_unique<EvaluationScratch>()) {}
Objective::Workspace::~Workspace() = default;

void ObjectiveParts::build() {
  const StyleTargets style = style_targets(morphology, space.initial(), task);
  const double mass = morphology.total_mass();
  const TermContext context{layout,
                            morphology,
                            space,
                            task,
                            path,
                            morphology.leg_length,
                            mass,
                            mass * kGravity,
                            style.com_height,
                            style.footprint,
                            style.footprint_slopes};
  units = layout.motion_units(context.length, context.weight);
  const std::vector<double> weights = term_weights(task);
  std::vector<char> wanted(layout.extended_size(), 0);
  for (std::size_t k = 0; k < term_registry().size(); ++k) {
    const TermEntry& entry = term_registry()[k];
    terms.push_back({&entry, weights[k], entry.make(context), {}, {}});
    if (weights[k] == 0.0) continue;
    for (const Element& element : terms.back().term->elements())
      for (int slot : element.slots) wanted[slot] = 1;
  }
  derived = DerivedQuantities(morphology, layout, task, path, wanted);
  plan();
}

void ObjectiveParts::plan() {
  ElementPlanner planner(derived.blocks(), layout.extended_size(), layout.design_size(),
                         layout.parameter_count());
  for (WeightedTerm& entry : terms) {
    const int count = entry.weight == 0.0 ? 0 : static_cast<int>(entry.term->elements().size());
    entry.plans.reserve(static_cast<std::size_t>(count));
    for (int e = 0; e < count; ++e) entry.plans.push_back(planner.plan(*entry.term, e));
    entry.linear = linear_rows(*entry.term, entry.plans);
  }
  for (const auto& block : derived.blocks()) block_cliques.push_back(planner.clique_of(*block));
  motion_blocks.plan(layout, derived.blocks(), planner);
  pattern = Sparsity::build(layout.design_size(), layout.motion_size(), planner.cliques());
  motion_blocks.locate();
  ElementWorkspace scratch;
  const HessianTarget target{pattern.valuePtr(), nullptr, nullptr, layout.design_size()};
  for (const WeightedTerm& entry : terms)
    for (std::size_t e = 0; e < entry.plans.size(); ++e) {
      if (!entry.plans[e].constant) continue;
      const Eigen::MatrixXd& J = *entry.term->constant_jacobian(static_cast<int>(e));
      const Clique& clique = *entry.plans[e].plan->clique;
      expand_jacobian(entry.plans[e], J, {}, clique.motion_count, scratch);
      scatter_rank(clique, scratch.expanded, VectorXd::Constant(J.rows(), entry.weight), target);
    }
}

void ObjectiveParts::residual(const WeightedTerm& entry, int index,
                              EvaluationScratch& workspace) const {
  const Element& element = entry.term->elements()[index];
  ElementWorkspace& local = workspace.element;
  local.residual.resize(element.rows);
  if (!entry.linear.empty()) {
    const int first = entry.linear.first_row(index);
    for (int row = 0; row < element.rows; ++row)
      local.residual[row] = entry.linear.residual(first + row, workspace.extended.data());
    return;
  }
  const int size = static_cast<int>(element.slots.size());
  local.z.resize(size);
  for (int k = 0; k < size; ++k) local.z[k] = workspace.extended[element.slots[k]];
  entry.term->residual(index, local.z, local.residual);
}

double ObjectiveParts::add_linear(const WeightedTerm& entry, int index, Order order,
                                  EvaluationScratch& workspace, const HessianTarget& target) const {
  const LinearRows& rows = entry.linear;
  const double* x = workspace.extended.data();
  double* gradient = workspace.gradient.data();
  const Penalty penalty = entry.term->penalty();
  const bool constant = rows.constant[static_cast<std::size_t>(index)] != 0;
  double value = 0.0;
  for (int row = rows.first_row(index); row < rows.last_rows[static_cast<std::size_t>(index)];
       ++row) {
    const double r = rows.residual(row, x);
    double multiplier = entry.weight * r;
    const LinearRows::Entry* first = rows.begin(row);
    if (constant) {
      value += 0.5 * r * r;
    } else {
      const PenaltyValue p = legwright::evaluate(penalty, r, task.barrier_edge);
      value += entry.weight * p.value;
      multiplier = entry.weight * p.first;
      if (has_second(order))
        target.mm[clique_of(entry, index).positions[0]] +=
            first->coefficient * first->coefficient * (entry.weight * p.second);
    }
    if (order == Order::value || multiplier == 0.0) continue;
    for (const LinearRows::Entry* e = first; e != rows.end(row); ++e)
      gradient[e->slot] += e->coefficient * multiplier;
  }
  return constant ? entry.weight * value : value;
}

double ObjectiveParts::add_element(const WeightedTerm& entry, int index, Order order,
                                   EvaluationScratch& workspace,
                                   const HessianTarget& target) const {
  const Term& term = *entry.term;
  const bool linear = !entry.linear.empty();
  if (linear && (!has_second(order) || entry.linear.constant[static_cast<std::size_t>(index)] ||
                 entry.linear.lone[static_cast<std::size_t>(index)]))
    return add_linear(entry, index, order, workspace, target);
  ElementWorkspace& local = workspace.element;
  residual(entry, index, workspace);
  const int rows = static_cast<int>(local.residual.size());
  local.multiplier.resize(rows);
  local.second.resize(rows);
  double value = 0.0;
  bool idle = true;
  for (int k = 0; k < rows; ++k) {
    const PenaltyValue p =
        legwright::evaluate(term.penalty(), local.residual[k], task.barrier_edge);
    value += entry.weight * p.value;
    local.multiplier[k] = entry.weight * p.first;
    local.second[k] = entry.weight * p.second;
    idle = idle && p.first == 0.0 && p.second == 0.0;
  }
  if (order == Order::value || idle) return value;
  if (linear) {
    const int first = entry.linear.first_row(index);
    for (int row = 0; row < rows; ++row)
      for (const auto* e = entry.linear.begin(first + row); e != entry.linear.end(first + row); ++e)
        workspace.gradient[e->slot] += e->coefficient * local.multiplier[row];
  } else {
    const Element& element = term.elements()[index];
    local.jacobian.setZero(rows, local.z.size());
    term.jacobian(index, local.z, local.jacobian);
    for (int k = 0; k < local.z.size(); ++k)
      workspace.gradient[element.slots[k]] += local.jacobian.col(k).dot(local.multiplier);
  }
  if (!has_second(order)) return value;
  add_second(entry, index, order, workspace, target);
  return value;
}

void ObjectiveParts::add_second(const WeightedTerm& entry, int index, Order order,
                                EvaluationScratch& workspace, const HessianTarget& target) const {
  const Term& term = *entry.term;
  const PlannedElement& plan = entry.plans[index];
  const Clique& clique = *plan.plan->clique;
  ElementWorkspace& local = workspace.element;
  const int columns =
      order == Order::design ? static_cast<int>(clique.slots.size()) : clique.motion_count;
  if (columns == 0) return;
  for (const int block : plan.blocks)
    derived.jacobian(morphology, block, workspace.extended, workspace.derived);
  const Eigen::MatrixXd* constant = term.constant_jacobian(index);
  expand_jacobian(plan, constant != nullptr ? *constant : local.jacobian,
                  workspace.derived.jacobians, columns, local);
  if (!term.curved()) {
    scatter_rank(clique, local.expanded, local.second, target);
    return;
  }
  local.curvature.setZero(local.z.size(), local.z.size());
  term.add_curvature(index, local.z, local.multiplier, local.curvature);
  rank_hessian(local);
  expand_curvature(plan, workspace.derived.jacobians, columns, local);
  scatter(clique, local.hessian, target);
}

double ObjectiveParts::add_term(const WeightedTerm& entry, Order order,
                                EvaluationScratch& workspace, const HessianTarget& target) const {
  double value = 0.0;
  if (entry.plans.empty()) return value;
  workspace.active.clear();
  if (entry.term->select_active(workspace.extended, workspace.active)) {
    for (int e : workspace.active) value += add_element(entry, e, order, workspace, target);
  } else {
    for (std::size_t e = 0; e < entry.plans.size(); ++e)
      value += add_element(entry, static_cast<int>(e), order, workspace, target);
  }
  return value;
}

void ObjectiveParts::add_derived(Order order, EvaluationScratch& workspace,
                                 const HessianTarget& target) const {
  // Chain rule: what terms want of y is handed on to m and s, and y's own curvature comes in.
  if (order == Order::hessian) derived.clear_loads(workspace.derived);
  for (std::size_t b = 0; b < derived.blocks().size(); ++b) {
    const DerivedQuantities::Extent at = derived.extents()[b];
    const auto multiplier = workspace.gradient.segment(at.slot, at.size);
    const DerivedQuantity& block = *derived.blocks()[b];
    const int columns =
        has_design(order) ? static_cast<int>(block.slots().size()) : block.motion_columns();
    if (columns == 0 || multiplier.isZero(0.0)) continue;
    const int index = static_cast<int>(b);
    if (order == Order::gradient &&
        derived.add_motion_gradient(morphology, index, multiplier.data(), workspace.extended,
                                    workspace.derived, workspace.gradient.data()))
      continue;
    const Eigen::MatrixXd& jacobian =
        derived.jacobian(morphology, index, workspace.extended, workspace.derived);
    for (int d = 0; d < block.size(); ++d)
      for (int k = 0; k < columns; ++k)
        workspace.gradient[block.slots()[k]] += jacobian(k, d) * multiplier[d];
    if (!has_second(order)) continue;
    if (order == Order::hessian && derived.add_loads(morphology, index, multiplier.data(),
                                                     workspace.extended, workspace.derived))
      continue;
    derived.curvature(index, multiplier.data(), workspace.derived);
    scatter(*block_cliques[b], workspace.derived.curvature, target);
  }
  if (order == Order::hessian)
    motion_blocks.add(morphology, workspace.derived.robot, workspace.derived.loads, target.mm);
}

void ObjectiveParts::prepare(const VectorXd& s, const VectorXd& m, Order order,
                             EvaluationScratch& workspace) const {
  if (s.size() != layout.design_size() || m.size() != layout.motion_size())
    throw std::invalid_argument("F: s has " + std::to_string(s.size()) + " and m " +
                                std::to_string(m.size()) + " entries");
  if (workspace.owner != this) workspace.derived = {};  // of another robot
  workspace.owner = this;
  workspace.extended.resize(layout.extended_size());
  workspace.extended.head(s.size()) = s;
  workspace.extended.segment(s.size(), m.size()) = m;
  workspace.extended.tail(layout.extended_size() - layout.parameter_count()).setZero();
  const PoseDetail detail = order == Order::value      ? PoseDetail::place
                            : order == Order::gradient ? PoseDetail::rates
                            : has_design(order)        ? PoseDetail::design
                                                       : PoseDetail::motion;
  derived.evaluate(morphology, layout, detail, workspace.extended, workspace.derived);
  workspace.gradient.setZero(layout.extended_size());
}

Objective::Objective(Morphology morphology, DesignSpace space, Task task)
    : impl_(std::make_unique<ObjectiveParts>()) {
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
  for (const WeightedTerm& term : impl_->terms) names.push_back(term.entry->name);
  return names;
}

ResidualUnit Objective::unit_of(std::string_view term) const {
  for (const WeightedTerm& each : impl_->terms)
    if (each.entry->name == term && !each.term->elements().empty()) return each.term->unit(0, 0);
  return {};
}

std::unique_ptr<Objective::Workspace> Objective::make_workspace() const {
  return std::make_unique<Workspace>();
}

void Objective::evaluate(const VectorXd& s, const VectorXd& m, Order order, Workspace& scratch,
                         Evaluation& out) const {
  EvaluationScratch& workspace = *scratch.parts_;
  const Layout& layout = impl_->layout;
  impl_->prepare(s, m, order, workspace);
  HessianTarget target{nullptr, nullptr, nullptr, layout.design_size()};
  if (has_second(order)) {
    if (out.pattern == impl_->pattern_key &&
        out.hessian_mm.nonZeros() == impl_->pattern.nonZeros()) {
      std::copy_n(impl_->pattern.valuePtr(), impl_->pattern.nonZeros(), out.hessian_mm.valuePtr());
    } else {
      out.hessian_mm = impl_->pattern;
      out.pattern = impl_->pattern_key;
    }
    target.mm = out.hessian_mm.valuePtr();
  }
  if (order == Order::design) {
    out.hessian_ms.setZero(layout.motion_size(), layout.design_size());
    out.hessian_ss.setZero(layout.design_size(), layout.design_size());
    target.ms = &out.hessian_ms;
    target.ss = &out.hessian_ss;
  }
  out.value = 0.0;
  out.term_values.assign(impl_->terms.size(), 0.0);
  for (std::size_t k = 0; k < impl_->terms.size(); ++k) {
    out.term_values[k] = impl_->add_term(impl_->terms[k], order, workspace, target);
    out.value += out.term_values[k];
  }
  if (order == Order::value) return;
  impl_->add_derived(order, workspace, target);
  if (order == Order::design)
    out.hessian_ss.triangularView<Eigen::StrictlyUpper>() = out.hessian_ss.transpose();
  out.stationarity = workspace.gradient.segment(layout.design_size(), layout.motion_size());
  if (has_design(order)) out.partial_s = workspace.gradient.head(layout.design_size());
}

TermShares Objective::shares(const VectorXd& s, const VectorXd& m, bool with_stationarity) const {
  const Layout& layout = impl_->layout;
  const Eigen::Index count = static_cast<Eigen::Index>(impl_->terms.size());
  const HessianTarget none{nullptr, nullptr, nullptr, layout.design_size()};
  EvaluationScratch workspace;
  TermShares out{term_names(), Eigen::MatrixXd::Zero(count, layout.design_size()), {}};
  if (with_stationarity) out.stationarity.setZero(count, layout.motion_size());
  impl_->prepare(s, m, Order::gradients, workspace);
  for (Eigen::Index k = 0; k < count; ++k) {
    workspace.gradient.setZero();
    impl_->add_term(impl_->terms[static_cast<std::size_t>(k)], Order::gradients, workspace, none);
    impl_->add_derived(Order::gradients, workspace, none);
    out.partial_s.row(k) = workspace.gradient.head(layout.design_size());
    if (with_stationarity)
      out.stationarity.row(k) =
          workspace.gradient.segment(layout.design_size(), layout.motion_size());
  }
  return out;
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
    values.push_back({impl_->terms[k].entry->name, at.term_values[k]});
  return values;
}

VectorXd initial_guess(const Objective& objective, const VectorXd& s) {
  const VectorXd initial = objective.space().initial();
  const StyleTargets style = style_targets(objective.morphology(), initial, objective.task());
  return initial_guess(objective.morphology(), objective.layout(), objective.task(),
                       objective.path(), at_design(style, s - initial), s);
}

}  // namespace legwright
