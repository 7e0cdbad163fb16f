// SPDX-License-Identifier: Apache-2.0
#include "mjcf/write/mesh_scales.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "mjcf/read/feet.hpp"
#include "mjcf/shape/mesh_assets.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "mjcf/text/numbers.hpp"
#include "optimizer/design/rotation.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

// Sine of the angle up to which a stretch runs along an axis of a mesh. A picture may be off by the
// rounding of a hand-written angle; where a foot touches must be what the planner thinks.
constexpr double kAlongDrawn = 5e-5, kAlongColliding = 1e-12;
constexpr double kSame = 1e-12;
constexpr double kLongestFoot = 0.5;  // of the link: a foot that is longer is the link itself
constexpr std::size_t kMostCopied = std::size_t{8}
                                    << 20;  // [bytes] of numbers of meshes in the file
constexpr std::size_t kLongestStem = 150;   // [bytes] of a name that a copy adds to

/// How a geom wants its asset, and how it is then turned itself.
struct ScaleRequest {
  Vector3d scale = Vector3d::Ones();
  Quaterniond turn = Quaterniond::Identity();     // the asset's refquat
  Matrix3d geom_rotation = Matrix3d::Identity();  // old axes of the geom ← new ones
  bool is_scaled = false, is_rotated = false;
};

/// Geoms that want an asset alike.
struct Group {
  ScaleRequest request;  // of the first; geom_rotation is of each its own
  std::vector<std::pair<const XmlElement*, ScaleRequest>> geoms;
};

bool is_same(const ScaleRequest& a, const ScaleRequest& b) {
  return a.is_scaled == b.is_scaled && a.scale.isApprox(b.scale, kSame) &&
         a.turn.toRotationMatrix().isApprox(b.turn.toRotationMatrix(), kSame);
}

/// Axis of a frame that is nearest to a direction.
Eigen::Index nearest_axis(const Vector3d& direction) {
  Eigen::Index axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  return axis;
}

/// The rotation, as small as may be, that brings axes of a frame into perpendicular directions.
Matrix3d rotation_onto(const std::vector<Vector3d>& directions) {
  Matrix3d out = Matrix3d::Identity();
  for (const Vector3d& direction : directions) {
    const Vector3d own = out.transpose() * direction;
    const Eigen::Index axis = nearest_axis(own);
    const Vector3d from = std::copysign(1.0, own[axis]) * Vector3d::Unit(axis);
    out = (out * smallest_rotation(from, own).toRotationMatrix()).eval();
  }
  return out;
}

/// Scale and turns whose product is what the mesh shall look like, R S Qᵀ.
void decompose(const Matrix3d& wanted, ScaleRequest& request) {
  const Eigen::JacobiSVD<Matrix3d> parts(wanted, Eigen::ComputeFullU | Eigen::ComputeFullV);
  if (parts.info() != Eigen::Success) return;  // numbers that are none have no parts
  Matrix3d u = parts.matrixU(), v = parts.matrixV();
  request.scale = parts.singularValues();
  for (Matrix3d* const turn : {&u, &v})
    if (turn->determinant() < 0.0) {
      turn->col(2) *= -1.0;
      request.scale[2] *= -1.0;
    }
  request.geom_rotation = u;
  request.turn = Quaterniond(v);
}

/// What one geom wants of its asset at design s.
class RequestReader {
 public:
  RequestReader(const XmlFile& xml, const mjModel& model, const TreeElements& elements,
                const StretchMap& stretches, const std::map<const XmlElement*, Vector3d>& rigid,
                const Eigen::VectorXd& s)
      : xml_(xml),
        model_(model),
        elements_(elements),
        stretches_(stretches),
        rigid_(rigid),
        s_(s) {}

  ScaleRequest of(int geom, const MeshAsset& asset) const {
    ScaleRequest request{asset.scale, asset.turn, Matrix3d::Identity(), false, false};
    const XmlElement& element = *elements_.geoms[static_cast<std::size_t>(geom)];
    const auto found = stretches_.find(name_of(model_, mjOBJ_BODY, model_.geom_bodyid[geom]));
    if (found == stretches_.end() || !mesh_grows(xml_, element) || rigid_.count(&element) > 0)
      return request;
    const Matrix3d axes = pose_in_body(xml_, element).linear();
    const double along = collides(model_, geom) ? kAlongColliding : kAlongDrawn;
    std::vector<Vector3d> directions;  // of what changes, in the geom's axes
    Vector3d growth = Vector3d::Ones();
    bool is_oblique = false;
    for (const Stretch& stretch : found->second) {
      const double factor = s_[stretch.parameter] / stretch.initial;
      if (factor == 1.0) continue;
      directions.push_back(axes.transpose() * stretch.direction);
      const Eigen::Index axis = nearest_axis(directions.back());
      growth[axis] *= factor;
      Vector3d rest = directions.back();
      rest[axis] = 0.0;
      is_oblique = is_oblique || rest.norm() > along;
    }
    if (directions.empty()) return request;
    request.is_scaled = true;
    request.is_rotated = is_oblique;
    if (!is_oblique)
      request.scale = asset.scale.cwiseProduct(growth);
    else
      turn(asset, directions, axes.transpose() * stretch_matrix(found->second, s_) * axes, request);
    return request;
  }

 private:
  static void turn(const MeshAsset& asset, const std::vector<Vector3d>& directions,
                   const Matrix3d& growth, ScaleRequest& request) {
    const Vector3d size = asset.scale.cwiseAbs();
    if (size.maxCoeff() - size.minCoeff() > kSame * size.maxCoeff())
      return decompose(growth * asset.shown(), request);
    // A mesh of one scale: R D Rᵀ S = R (D S) (S⁻¹ Rᵀ S), where the last is a rotation as well.
    const Vector3d sign = asset.scale / size[0];
    const Matrix3d r = rotation_onto(directions);
    request.geom_rotation = r;
    request.scale = (r.transpose() * growth * r).diagonal().cwiseProduct(asset.scale);
    const Matrix3d mirrored = sign.asDiagonal() * r * sign.asDiagonal();
    request.turn = asset.turn * Quaterniond(mirrored);
  }

  const XmlFile& xml_;
  const mjModel& model_;
  const TreeElements& elements_;
  const StretchMap& stretches_;
  const std::map<const XmlElement*, Vector3d>& rigid_;
  const Eigen::VectorXd& s_;
};

Eigen::Vector4d quat_numbers(const Quaterniond& q) {
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  return sign * Eigen::Vector4d(q.w(), q.x(), q.y(), q.z());
}

/// Turns a geom in its own axes. A class may say its orientation in another way, which would hold
/// before a quat.
void rotate_geom(const XmlFile& xml, const XmlElement& geom, const Matrix3d& turn,
                 TextEdits& edits) {
  const Matrix3d axes = pose_of(xml, geom).linear() * turn;
  constexpr const char* kWays[] = {"euler", "axisangle", "xyaxes", "zaxis", "quat"};
  const bool is_oriented_by_class =
      std::any_of(std::begin(kWays), std::end(kWays) - 1, [&](const char* name) {
        return !has_attribute(geom, name) && inherited_attribute(xml, geom, name);
      });
  const std::string_view own = is_oriented_by_class ? "xyaxes" : "quat";
  for (const char* const name : kWays)
    if (name != own) edits.remove(geom, name);
  if (!is_oriented_by_class)
    return edits.set_numbers(geom, "quat", quat_numbers(Quaterniond(axes)));
  Eigen::VectorXd xy(6);
  xy << axes.col(0), axes.col(1);
  edits.set_numbers(geom, "xyaxes", xy);
}

/// The largest group whose asset stays, else the largest at all, keeps the element.
std::size_t group_of_original(const std::vector<Group>& groups) {
  std::size_t best = 0;
  for (std::size_t k = 1; k < groups.size(); ++k) {
    const Group &one = groups[k], &other = groups[best];
    if (one.request.is_scaled != other.request.is_scaled ? !one.request.is_scaled
                                                         : one.geoms.size() > other.geoms.size())
      best = k;
  }
  return best;
}

class Writer {
 public:
  Writer(const XmlFile& xml, const std::map<std::string, MeshAsset>& meshes, TextEdits& edits)
      : xml_(xml), edits_(edits) {
    for (const auto& [name, mesh] : meshes) names_.insert(name);
  }

  void write(const std::string& name, const MeshAsset& asset, const std::vector<Group>& groups) {
    const std::size_t original = group_of_original(groups);
    for (std::size_t k = 0; k < groups.size(); ++k) {
      const Group& group = groups[k];
      if (k == original) {
        if (!group.request.is_scaled) continue;
        edits_.set_numbers(*asset.element, "scale", group.request.scale);
        if (group.request.is_rotated)
          edits_.set_numbers(*asset.element, "refquat", quat_numbers(group.request.turn));
      } else {
        check_room(*asset.element);
        const std::string own = new_name(name);
        std::map<std::string, std::string> values{
            {"name", own}, {"scale", format_numbers(rounded(group.request.scale))}};
        if (group.request.is_rotated)
          values.emplace("refquat", format_numbers(rounded(quat_numbers(group.request.turn))));
        edits_.copy_behind(*asset.element, values);
        for (const auto& [geom, request] : group.geoms) edits_.set(*geom, "mesh", own);
      }
      for (const auto& [geom, request] : group.geoms)
        if (request.is_rotated) rotate_geom(xml_, *geom, request.geom_rotation, edits_);
    }
  }

 private:
  /// A mesh may have its vertices in the element, and each copy of that repeats them.
  void check_room(const XmlElement& element) {
    for (const char* const list : {"vertex", "normal", "texcoord", "face"})
      copied_ += std::string_view(attribute(element, list)).size();
    if (copied_ > kMostCopied)
      throw xml_.error(element,
                       fmt::format("its numbers stand in the file, and the copies for parts "
                                   "that stretch differently would take more than {} bytes; "
                                   "keep it in a mesh file, or let fewer geoms show it",
                                   kMostCopied));
  }

  std::string new_name(const std::string& name) {
    const std::string stem = name.size() <= kLongestStem ? name : "mesh";
    for (int number = 2;; ++number) {
      std::string found = fmt::format("{}_{}", stem, number);
      if (names_.insert(found).second) return found;
    }
  }

  const XmlFile& xml_;
  TextEdits& edits_;
  std::set<std::string> names_;
  std::size_t copied_ = 0;  // [bytes]
};

/// Length of a mesh along a direction of its geom's body [m].
double extent_along(const mjModel& model, int geom, const Vector3d& direction) {
  const int mesh = model.geom_dataid[geom];
  const Eigen::Map<const Eigen::Matrix<float, 3, Eigen::Dynamic>> corners(
      model.mesh_vert + std::ptrdiff_t{3} * model.mesh_vertadr[mesh], 3, model.mesh_vertnum[mesh]);
  const Eigen::RowVectorXd along =
      (rotation_at(model.geom_quat, geom).transpose() * direction).transpose() *
      corners.cast<double>();
  return along.size() > 0 ? along.maxCoeff() - along.minCoeff() : 0.0;
}

bool is_same_place(const mjModel& model, int a, int b) {
  return model.geom_bodyid[a] == model.geom_bodyid[b] &&
         model.geom_dataid[a] == model.geom_dataid[b] &&
         (vector_at(model.geom_pos, a) - vector_at(model.geom_pos, b)).isZero(1e-9) &&
         rotation_at(model.geom_quat, a).isApprox(rotation_at(model.geom_quat, b), 1e-9);
}

/// Whether a mesh is where one of a foot is.
bool is_part_of(const mjModel& model, int geom, const FootContact& foot) {
  return is_same_place(model, geom, foot.geom) ||
         std::any_of(foot.others.begin(), foot.others.end(),
                     [&](int other) { return is_same_place(model, geom, other); });
}

}  // namespace

std::map<const XmlElement*, Vector3d> rigid_feet(const XmlFile& xml, const mjModel& model,
                                                 const TreeElements& elements,
                                                 const Structure& structure,
                                                 const StretchMap& stretches,
                                                 const Eigen::VectorXd& s) {
  std::map<const XmlElement*, Vector3d> out;
  for (const FootContact& foot : structure.feet) {
    if (foot.geom < 0 || model.geom_type[foot.geom] != mjGEOM_MESH) continue;
    const auto own = stretches.find(name_of(model, mjOBJ_BODY, model.geom_bodyid[foot.geom]));
    if (own == stretches.end()) continue;
    const bool is_short =
        std::all_of(own->second.begin(), own->second.end(), [&](const Stretch& stretch) {
          return extent_along(model, foot.geom, stretch.direction) <=
                 kLongestFoot * stretch.initial;
        });
    if (!is_short) continue;
    const Vector3d point = foot_point(xml, elements, model, foot, {}).constant;
    const Vector3d move =
        stretch_matrix(own->second, s) * point + stretch_shift(own->second, s) - point;
    for (int g = 0; g < model.ngeom; ++g) {
      const XmlElement& element = *elements.geoms[static_cast<std::size_t>(g)];
      if (model.geom_type[g] == mjGEOM_MESH && is_part_of(model, g, foot) &&
          mesh_grows(xml, element))
        out.emplace(&element, move);
    }
  }
  return out;
}

void write_mesh_scales(const XmlFile& xml, const mjModel& model, const TreeElements& elements,
                       const StretchMap& stretches,
                       const std::map<const XmlElement*, Vector3d>& rigid, const Eigen::VectorXd& s,
                       TextEdits& edits) {
  const std::map<std::string, MeshAsset> meshes = find_meshes(xml);
  const RequestReader reader(xml, model, elements, stretches, rigid, s);
  std::map<std::string, std::vector<Group>> groups_by_mesh;  // by asset
  for (int g = 0; g < model.ngeom; ++g) {
    const XmlElement* const element = elements.geoms[static_cast<std::size_t>(g)];
    const char* const mesh = inherited_attribute(xml, *element, "mesh");
    if (mesh == nullptr) continue;
    const auto asset = meshes.find(mesh);
    if (asset == meshes.end()) continue;
    const ScaleRequest request = reader.of(g, asset->second);
    std::vector<Group>& groups = groups_by_mesh[mesh];
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const Group& one) { return is_same(one.request, request); });
    if (group == groups.end()) group = groups.insert(groups.end(), Group{request, {}});
    group->geoms.emplace_back(element, request);
  }
  Writer writer(xml, meshes, edits);
  for (const auto& [name, groups] : groups_by_mesh) writer.write(name, meshes.at(name), groups);
}

}  // namespace legwright
