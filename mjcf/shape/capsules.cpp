// SPDX-License-Identifier: Apache-2.0
#include "mjcf/shape/capsules.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "mjcf/shape/growing_axes.hpp"
#include "mjcf/shape/hull_cover.hpp"
#include "mjcf/shape/mesh_assets.hpp"
#include "mjcf/text/model_arrays.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Capsules side by side touch each other, up to so many: between those of a wide, thin plate a
// limb, which has a thickness itself, does not get through either.
constexpr int kMostOfTrunk = 5, kMostOfLimb = 2;
// A hull has corners and rims.
constexpr int kMostOfTrunkMesh = 8, kMostOfLimbMesh = 4, kMostOfRoughMesh = 2;
constexpr double kLeastRoom =
    0.05;  // beside a ball that fills a mesh, along an axis, share of its half size
constexpr double kEdgeRadius = 0.2;  // of the thickness
constexpr double kEven = 1.05;       // width over thickness: as round as a rod
// Of its radius, from the end of a long cylinder to that of its capsule: the rim stands out by an
// eighth, the end of the capsule by two fifths.
constexpr double kCylinderEnd = 0.6;

/// A capsule within a shape: its ends are share ∘ half sizes − depth along the shape's axes.
struct Cover {
  std::array<Vector3d, 2> share, depth;  // of each end; depth in [m]
  double radius;                         // [m]

  Cover(const Vector3d& from, const Vector3d& to, const Vector3d& inwards, double thick)
      : share{from, to},
        depth{from.cwiseProduct(inwards), to.cwiseProduct(inwards)},
        radius(thick) {}
  Cover(const std::array<Vector3d, 2>& shares, const std::array<Vector3d, 2>& depths, double thick)
      : share(shares), depth(depths), radius(thick) {}
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

/// Capsules as thick as the shape, side by side over its width. @param oval the outline, seen along
/// its shortest axis.
std::vector<Cover> row_of(const Vector3d& half, bool oval, int most) {
  const Order axes(half);
  const double thick = half[axes.shortest], wide = half[axes.middle];
  const double wanted = wide < kEven * thick ? 1.0 : 1.0 + std::ceil((wide - thick) / thick);
  const int count = static_cast<int>(std::min<double>(wanted, std::max(most, 1)));
  std::vector<Cover> out;
  for (int k = 0; k < count; ++k) {
    const double across = count == 1 ? 0.0 : 2.0 * k / (count - 1) - 1.0;
    Vector3d from = Vector3d::Zero(), to = Vector3d::Zero();
    to[axes.longest] = oval ? std::sqrt(std::max(0.0, 1.0 - across * across)) : 1.0;
    from[axes.longest] = -to[axes.longest];
    from[axes.middle] = to[axes.middle] = across;
    out.emplace_back(from, to, Vector3d::Constant(thick), thick);
  }
  return out;
}

void add_edges(const Vector3d& half, std::vector<Cover>& out) {
  const Order axes(half);
  const double radius = kEdgeRadius * half[axes.shortest];
  for (const double across : {-1.0, 1.0})
    for (const double up : {-1.0, 1.0}) {
      Vector3d from = Vector3d::Zero(), to = Vector3d::Zero();
      from[axes.longest] = -1.0;
      to[axes.longest] = 1.0;
      from[axes.middle] = to[axes.middle] = across;
      from[axes.shortest] = to[axes.shortest] = up;
      out.emplace_back(from, to, Vector3d::Constant(radius), radius);
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
    case mjGEOM_BOX: {
      std::vector<Cover> out = row_of(half, false, most);
      if (detail == CoverDetail::edges && half.minCoeff() > sharp) add_edges(half, out);
      return out;
    }
    default:
      return {};
  }
}

/// Within the hull; the surface of a ball at an end stretches as far as the end is off the middle.
std::vector<Cover> cover_of_mesh(const mjModel& model, int geom, const Vector3d& half,
                                 double enough, CoverDetail detail) {
  const int most = detail == CoverDetail::edges    ? kMostOfTrunkMesh
                   : detail == CoverDetail::coarse ? kMostOfLimbMesh
                                                   : kMostOfRoughMesh;
  const Vector3d middle = Vector3d::Map(model.geom_aabb + std::ptrdiff_t{6} * geom);
  std::vector<Cover> out;
  for (const HullCapsule& capsule : cover_hull(model, model.geom_dataid[geom], most, enough)) {
    const auto share = [&](const Vector3d& end) -> Vector3d {
      return (end - middle)
          .cwiseQuotient((half.array() - capsule.radius).max(kLeastRoom * half.array()).matrix());
    };
    const std::array<Vector3d, 2> shares{share(capsule.from), share(capsule.to)};
    out.emplace_back(shares,
                     std::array<Vector3d, 2>{shares[0].cwiseProduct(half) + middle - capsule.from,
                                             shares[1].cwiseProduct(half) + middle - capsule.to},
                     capsule.radius);
  }
  if (out.empty()) return row_of(half, false, most);  // no hull
  return out;
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
  Shape out{half_sizes(type, model.geom_size + std::ptrdiff_t{3} * geom),
            rotation_at(model.geom_quat, geom),
            {},
            {}};
  const Vector3d place = vector_at(model.geom_pos, geom);
  if (type == mjGEOM_MESH) {
    // MuJoCo's frame is at the mesh's centre of mass, its box about another place.
    const mjtNum* box = model.geom_aabb + std::ptrdiff_t{6} * geom;  // centre, half sizes
    out.half = Vector3d::Map(box + 3);
    const Vector3d centre = out.axes * Vector3d::Map(box);
    if (mesh_grows(xml, *elements.geoms[static_cast<std::size_t>(geom)])) {
      out.middle = stretched_point(place + centre, stretches);
      out.moves = {true, true, true};
      return out;
    }
    // The stretch moves the mesh's own origin and leaves its size.
    const int mesh = model.geom_dataid[geom];
    const Vector3d origin = place - out.axes * rotation_at(model.mesh_quat, mesh).transpose() *
                                        vector_at(model.mesh_pos, mesh);
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
  const auto place = [&](const Vector3d& share, const Vector3d& depth) {
    AffineVector end = shape.middle;
    end.constant -= shape.axes * depth;
    for (Eigen::Index k = 0; k < 3; ++k) {
      const Vector3d arm = share[k] * shape.half[k] * shape.axes.col(k);
      if (shape.moves[static_cast<std::size_t>(k)])
        end = sum(end, stretched_arm(arm, stretches));
      else
        end.constant += arm;
    }
    return end;
  };
  const bool is_mesh = model.geom_type[geom] == mjGEOM_MESH;
  std::vector<Capsule> out;
  for (const Cover& cover : is_mesh ? cover_of_mesh(model, geom, shape.half, 0.5 * sharp, detail)
                                    : cover_of(model.geom_type[geom], shape.half, sharp, detail))
    out.push_back({0, 0, place(cover.share[0], cover.depth[0]),
                   place(cover.share[1], cover.depth[1]), cover.radius});
  return out;
}

}  // namespace legwright
