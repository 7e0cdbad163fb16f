// SPDX-License-Identifier: Apache-2.0
#include "plugin/gait_view.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "plugin/model_feet.hpp"

namespace legwright {
namespace {

// Sizes of decoration in mean sizes of a body.
constexpr double kPathRadius = 0.03, kComRadius = 0.45, kHoldRadius = 0.2, kHoldHeight = 0.015;
constexpr double kForceWidth = 1.3;  // in widths of MuJoCo's own arrows

/// Pieces of a path in each cycle: enough to look smooth, few enough for a scene of six legs.
int piece_count(const Trajectory& trajectory) {
  return std::clamp(2 * trajectory.knot_count, 32, 64);
}

double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Visits the ends of the pieces of a path, from a cycle before the present one to its end and a
/// cycle on, at fixed moments of the plan: so the pieces stand still while the robot goes by.
template <typename Visit>
void along_path(const Trajectory& t, const SplinePhase& now, const Visit& visit) {
  const int pieces = piece_count(t);
  const double share = (now.knot[1] + now.fraction) / t.knot_count;
  const int nearest = static_cast<int>(std::floor(share * pieces));
  for (int piece = nearest - pieces; piece <= nearest + pieces; ++piece) {
    const int cycle = piece >= 0 ? piece / pieces : -1 - (-1 - piece) / pieces;
    SplinePhase phase = phase_at(t, (piece - cycle * pieces) * t.period / pieces);
    phase.cycle += now.cycle + cycle;
    visit(phase);
  }
}

}  // namespace

GaitView::GaitView(const mjModel* m, const PdPlayback& playback)
    : playback_(playback),
      plan_(playback.trajectory()),
      robot_(robot_of(m, playback)),
      size_(m->stat.meansize),
      foot_of_geom_(static_cast<std::size_t>(m->ngeom), -1) {
  for (const std::string& name : playback.trajectory().foot_names) {
    int geom = -1;
    try {
      const ModelFoot foot = find_foot(m, playback.names().in_scene(name));
      geom = foot.geoms.front();
      for (const int g : foot.geoms)
        foot_of_geom_[static_cast<std::size_t>(g)] = static_cast<int>(geom_of_foot_.size());
    } catch (const ConfigError&) {  // drawn at its place in the plan
    }
    geom_of_foot_.push_back(geom);
  }
}

void GaitView::draw(const mjModel* m, const mjData* d, const mjvOption* option, mjvScene* scene) {
  Pen pen(scene);
  const SplinePhase now = playback_.phase(d->time);
  if (option->flags[mjVIS_COM] != 0) draw_com(pen, now);
  if (option->flags[mjVIS_CONTACTPOINT] != 0) draw_feet(pen, now);
  if (option->flags[mjVIS_CONTACTFORCE] != 0) draw_forces(m, d, pen);
  if (option->geomgroup[playback_.ghost_group()] == 0) return;
  if (!ghost_) ghost_ = std::make_unique<Ghost>(m, robot_);
  ghost_->draw(playback_, d->time, option, scene);
}

void GaitView::draw_com(Pen& pen, const SplinePhase& now) const noexcept {
  pen.ball(plan_.com(now), kComRadius * size_, kComBallColour);
  bool started = false;
  Point last{};
  along_path(playback_.trajectory(), now, [&](const SplinePhase& phase) {
    const Point point = plan_.com(phase);
    if (started) pen.rod(last, point, kPathRadius * size_, kComColour);
    last = point;
    started = true;
  });
}

void GaitView::draw_feet(Pen& pen, const SplinePhase& now) const noexcept {
  for (int foot = 0; foot < playback_.trajectory().foot_count(); ++foot) {
    bool started = false, held = true;
    Point last{};
    along_path(playback_.trajectory(), now, [&](const SplinePhase& phase) {
      const Point point = plan_.foot(phase, foot);
      const bool holds = plan_.contact(phase, foot);
      if (started && distance(last, point) > 0.2 * kPathRadius * size_)
        pen.rod(last, point, kPathRadius * size_, kFootColour);
      if (started && holds && !held)
        pen.disc(point, kHoldRadius * size_, kHoldHeight * size_, kFootholdColour);
      last = point;
      held = holds;
      started = true;
    });
  }
}

/// Where the foot touches; else where it is; else where it is planned.
Point GaitView::point_of_force(const mjModel* m, const mjData* d, int foot) const noexcept {
  for (int contact = 0; contact < d->ncon; ++contact) {
    int touching = -1;
    if (foot_contact_force(m, d, contact, foot_of_geom_, touching) > 0.0 && touching == foot) {
      const mjtNum* const p = d->contact[contact].pos;
      return {p[0], p[1], p[2]};
    }
  }
  const int geom = geom_of_foot_[static_cast<std::size_t>(foot)];
  if (geom < 0) return plan_.foot(playback_.phase(d->time), foot);
  const mjtNum* const p = d->geom_xpos + std::ptrdiff_t{3} * geom;
  return {p[0], p[1], p[2]};
}

void GaitView::draw_forces(const mjModel* m, const mjData* d, Pen& pen) const noexcept {
  const SplinePhase now = playback_.phase(d->time);
  const double metres = m->vis.map.force / m->stat.meanmass;  // per newton, as MuJoCo's arrows
  const double radius = kForceWidth * m->vis.scale.forcewidth * m->stat.meansize;
  for (int foot = 0; foot < playback_.trajectory().foot_count(); ++foot) {
    const Point force = plan_.force(now, foot), from = point_of_force(m, d, foot);
    const Point to = {from[0] + metres * force[0], from[1] + metres * force[1],
                      from[2] + metres * force[2]};
    if (distance(from, to) > radius) pen.arrow(from, to, radius, kForceColour);
  }
}

}  // namespace legwright
