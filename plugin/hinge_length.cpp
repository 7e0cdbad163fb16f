// SPDX-License-Identifier: Apache-2.0
#include "plugin/hinge_length.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace legwright {
namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& u, const Vector& v) { return mju_dot3(u.data(), v.data()); }

Vector cross(const Vector& u, const Vector& v) {
  Vector out;
  mju_cross(out.data(), u.data(), v.data());
  return out;
}

Vector minus(const Vector& u, const Vector& v) { return {u[0] - v[0], u[1] - v[1], u[2] - v[2]}; }

Vector vector_at(const mjtNum* array, int index) {
  return {array[3 * index], array[3 * index + 1], array[3 * index + 2]};
}

/// A point of a body in the frame of the body above it.
Vector in_parent(const mjModel* m, int body, const Vector& p) {
  Vector out;
  mju_rotVecQuat(out.data(), p.data(), m->body_quat + 4 * body);
  mju_addTo3(out.data(), m->body_pos + 3 * body);
  return out;
}

/// Where a site is on the rigid part it belongs to: the body with joints that carries it (or the
/// world), and the point in its frame.
struct Carried {
  int body;
  Vector point;
};

Carried carried(const mjModel* m, int body, Vector point) {
  while (body > 0 && m->body_jntnum[body] == 0) {
    point = in_parent(m, body, point);
    body = m->body_parentid[body];
  }
  return {body, point};
}

bool hangs_by_one_hinge(const mjModel* m, const Carried& lower, const Carried& upper) {
  const int body = lower.body;
  return body > 0 && m->body_jntnum[body] == 1 &&
         m->jnt_type[m->body_jntadr[body]] == mjJNT_HINGE &&
         carried(m, m->body_parentid[body], {}).body == upper.body;
}

}  // namespace

double HingeLength::length(double q) const noexcept {
  return std::sqrt(std::max(0.0, a + b * std::cos(q) + c * std::sin(q)));
}

double HingeLength::arm(double q) const noexcept {
  const double l = length(q);
  return l > 0.0 ? (c * std::cos(q) - b * std::sin(q)) / (2.0 * l) : 0.0;
}

HingeLength hinge_length(const mjModel* m, int tendon) {
  const int first = m->tendon_adr[tendon];
  if (m->tendon_num[tendon] != 2 || m->wrap_type[first] != mjWRAP_SITE ||
      m->wrap_type[first + 1] != mjWRAP_SITE) {
    throw std::invalid_argument("is no <spatial> between two sites");
  }
  const auto end = [&](int k) {
    const int site = m->wrap_objid[first + k];
    return carried(m, m->site_bodyid[site], vector_at(m->site_pos, site));
  };
  Carried upper = end(0), lower = end(1);
  if (hangs_by_one_hinge(m, upper, lower)) std::swap(upper, lower);
  if (!hangs_by_one_hinge(m, lower, upper))
    throw std::invalid_argument("does not span exactly one hinge");

  // w from the upper end to the hinge, l from the hinge to the lower end; the link's frame in the
  // file's pose.
  const int joint = m->body_jntadr[lower.body];
  const Vector anchor = vector_at(m->jnt_pos, joint), axis = vector_at(m->jnt_axis, joint);
  const Vector hinge =
      carried(m, m->body_parentid[lower.body], in_parent(m, lower.body, anchor)).point;
  // Turned back through every body between the two links.
  Vector w = minus(hinge, upper.point);
  std::array<double, 4> turn = {1.0, 0.0, 0.0, 0.0};
  int body = lower.body;
  do {
    std::array<double, 4> product;
    mju_mulQuat(product.data(), m->body_quat + 4 * body, turn.data());
    turn = product;
    body = m->body_parentid[body];
  } while (body > 0 && m->body_jntnum[body] == 0);
  std::array<double, 4> back;
  mju_negQuat(back.data(), turn.data());
  Vector rotated;
  mju_rotVecQuat(rotated.data(), w.data(), back.data());
  w = rotated;
  const Vector l = minus(lower.point, anchor);
  const double along = 2.0 * dot(w, axis) * dot(l, axis);
  const double b = 2.0 * dot(w, l) - along, c = 2.0 * dot(w, cross(axis, l));
  // The file's pose is at q = qpos0 (the joint's `ref`): turn (b, c) so that q itself counts.
  const double ref = m->qpos0[m->jnt_qposadr[joint]];
  return {joint, dot(w, w) + dot(l, l) + along, b * std::cos(ref) - c * std::sin(ref),
          b * std::sin(ref) + c * std::cos(ref)};
}

}  // namespace legwright
