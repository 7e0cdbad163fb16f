// SPDX-License-Identifier: Apache-2.0
#include "mjcf/capsules.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "mjcf/growth.hpp"
#include "mjcf/mesh_assets.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Capsules side by side touch each other, up to so many: between those of a wide, thin plate a limb, which has a
// thickness itself, does not get through either.
constexpr int kMostOfTrunk = 5, kMostOfLimb = 2;
constexpr double kEdgeRadius = 0.2;  // of the thickness
constexpr double kEven = 1.05;       // width over thickness: as round as a rod
// Of its radius, from the end of a long cylinder to that of its capsule: the rim stands out by an eighth, the end of
// the capsule by two fifths.
constexpr double kCylinderEnd = 0.6;

Matrix3d rotation_of(const mjtNum* q) {
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
}

/// A capsule within a shape: its ends are share ∘ (half sizes − depth) along the shape's axes.
struct Cover {
  Vector3d from, to;  // shares
  Vector3d depth;     // [m]
  double radius;      // [m]
};

/// The axes of a shape by size.
struct Order {
  Eigen::Index longest, middle, shortest;
  explicit Order(const Vector3d& half) {
    std::array<Eigen::Index, 3> k{0, 1, 2};
    std::stable_sort(k.begin(), k.end(), [&](auto a, auto b) { return half[a] > half[b]; });
    longest = k[0];
    middle = k[1];
    shortest = k[2];
  }
};

/// Capsules as thick as the shape, side by side over its width. @param oval the outline, seen along its shortest axis.
std::vector<Cover> row_of(const Vector3d& half, bool oval, int most) {
  const Order axes(half);
  const double thick = half[axes.shortest], wide = half[axes.middle];
  const double wanted = wide < kEven * thick ? 1.0 : 1.0 + std::ceil((wide - thick) / thick);
  const int count = static_cast<int>(std::min<double>(wanted, std::max(most, 1)));
  std::vector<Cover> out;
  for (int k = 0; k < count; ++k) {
    const double across = count == 1 ? 0.0 : 2.0 * k / (count - 1) - 1.0;
    Cover cover{Vector3d::Zero(), Vector3d::Zero(), Vector3d::Constant(thick), thick};
    cover.to[axes.longest] = oval ? std::sqrt(std::max(0.0, 1.0 - across * across)) : 1.0;
    cover.from[axes.longest] = -cover.to[axes.longest];
    cover.from[axes.middle] = cover.to[axes.middle] = across;
    out.push_back(cover);
  }
  return out;
}

void add_edges(const Vector3d& half, std::vector<Cover>& out) {
  const Order axes(half);
  const double radius = kEdgeRadius * half[axes.shortest];
  for (const double across : {-1.0, 1.0})
    for (const double up : {-1.0, 1.0}) {
      Cover cover{Vector3d::Zero(), Vector3d::Zero(), Vector3d::Constant(radius), radius};
      cover.from[axes.longest] = -1.0;
      cover.to[axes.longest] = 1.0;
      cover.from[axes.middle] = cover.to[axes.middle] = across;
      cover.from[axes.shortest] = cover.to[axes.shortest] = up;
      out.push_back(cover);
    }
}

std::vector<Cover> cover_of(int type, const Vector3d& half, double sharp, CoverDetail detail) {
  const int most = detail == CoverDetail::edges ? kMostOfTrunk : kMostOfLimb;
  const Vector3d z = Vector3d::UnitZ();
  switch (type) {
    case mjGEOM_SPHERE:
      return {{Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero(), half.x()}};
    case mjGEOM_CAPSULE:
      return {{-z, z, Vector3d::Zero(), half.x()}};
    case mjGEOM_CYLINDER:
      if (half.z() <= half.x()) return row_of(half, true, most);  // a disc
      return {{-z, z, kCylinderEnd * half.x() * z, half.x()}};
    case mjGEOM_ELLIPSOID:
      return row_of(half, true, most);
    case mjGEOM_MESH:  // its corners need not be there
      return row_of(half, false, most);
    case mjGEOM_BOX: {
      std::vector<Cover> out = row_of(half, false, most);
      if (detail == CoverDetail::edges && half.minCoeff() > sharp) add_edges(half, out);
      return out;
    }
    default:
      return {};
  }
}

/// Where the middle of a geom's shape is and how it lies, and how that follows the design.
struct Shape {
  Vector3d half;
  Matrix3d axes;              // body ← shape
  AffineVector middle;        // in the body
  std::array<bool, 3> moves;  // ends along an axis are points of the body
};

Shape shape_of(const XmlFile& xml, const TreeElements& elements, const mjModel& model, int geom,
               const std::vector<Stretch>& stretches) {
  const int type = model.geom_type[geom];
  Shape out{half_sizes(type, model.geom_size + 3 * geom),
            rotation_of(model.geom_quat + 4 * geom),
            {},
            {}};
  const Vector3d place = Vector3d::Map(model.geom_pos + 3 * geom);
  if (type == mjGEOM_MESH) {
    // MuJoCo's frame is at the mesh's centre of mass, its box about another place.
    const mjtNum* box = model.geom_aabb + 6 * geom;  // centre, half sizes
    out.half = Vector3d::Map(box + 3);
    const Vector3d centre = out.axes * Vector3d::Map(box);
    if (mesh_grows(xml, *elements.geoms[static_cast<std::size_t>(geom)])) {
      out.middle = stretched_point(place + centre, stretches);
      out.moves = {true, true, true};
      return out;
    }
    // The stretch moves the mesh's own origin and leaves its size.
    const int mesh = model.geom_dataid[geom];
    const Vector3d origin = place - out.axes * rotation_of(model.mesh_quat + 4 * mesh).transpose() *
                                        Vector3d::Map(model.mesh_pos + 3 * mesh);
    out.middle = stretched_point(origin, stretches);
    out.middle.constant += place - origin + centre;
    return out;
  }
  const bool from_to = inherited_attribute(xml, *elements.geoms[static_cast<std::size_t>(geom)],
                                           "fromto") != nullptr;
  const auto grows = growing_axes(type, out.half, out.axes, from_to, stretches);
  out.middle = stretched_point(place, stretches);
  for (std::size_t k = 0; k < 3; ++k) out.moves[k] = grows[k] != nullptr || (from_to && k == 2);
  return out;
}

}  // namespace

std::vector<Capsule> capsules_of(const XmlFile& xml, const TreeElements& elements,
                                 const mjModel& model, int geom,
                                 const std::vector<Stretch>& stretches, double sharp,
                                 CoverDetail detail) {
  const Shape shape = shape_of(xml, elements, model, geom, stretches);
  std::vector<Capsule> out;
  for (const Cover& cover : cover_of(model.geom_type[geom], shape.half, sharp, detail)) {
    const auto place = [&](const Vector3d& share) {
      AffineVector end = shape.middle;
      end.constant -= shape.axes * share.cwiseProduct(cover.depth);
      for (Eigen::Index k = 0; k < 3; ++k) {
        const Vector3d arm = share[k] * shape.half[k] * shape.axes.col(k);
        if (shape.moves[static_cast<std::size_t>(k)])
          end = sum(end, stretched_point(arm, stretches));
        else
          end.constant += arm;
      }
      return end;
    };
    out.push_back({0, 0, place(cover.from), place(cover.to), cover.radius});
  }
  return out;
}

}  // namespace legwright
