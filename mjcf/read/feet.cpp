// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/feet.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "mjcf/shape/growing_axes.hpp"
#include "mjcf/shape/mesh_assets.hpp"
#include "mjcf/text/model_arrays.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kFlat = 0.3;      // sine of the angle up to which a face lies flat on the ground
constexpr double kLevel = 0.035;   // the same for what lies on its side: else its lower end touches
constexpr double kNearEnd = 0.25;  // of the far end's distance: so near to the hinge a link begins
constexpr double kAsLow = 1e-4;    // [m]: balls that touch together
constexpr double kTwinsAsLow = 5e-4;  // [m]: geoms of one shape, of which the first counts
constexpr double kTurnedAlike = 1e-9;
constexpr double kApart = 1e-6;      // [m]: geoms that stand in the file twice are one plate
constexpr double kSoleShare = 0.02;  // of a mesh's height: what is no higher belongs to the sole
constexpr double kBallFirst = 0.5;   // of its radius: a ball may be so much higher than other geoms

/// Vertices of a geom's mesh in its frame.
Eigen::Map<const Eigen::Matrix<float, 3, Eigen::Dynamic>> vertices_of(const mjModel& model,
                                                                      int geom) {
  const int mesh = model.geom_dataid[geom];
  return {model.mesh_vert + std::ptrdiff_t{3} * model.mesh_vertadr[mesh], 3,
          model.mesh_vertnum[mesh]};
}

bool is_mesh(const mjModel& model, int geom) {
  return model.geom_type[geom] == mjGEOM_MESH && model.geom_dataid[geom] >= 0;
}

/// Whether two geoms are of one shape, as the two plates of a fork are: which of them is lower is a
/// matter of rounding, and another one in each leg.
bool are_twins(const mjModel& model, int a, int b) {
  return model.geom_type[a] == model.geom_type[b] && model.geom_bodyid[a] == model.geom_bodyid[b] &&
         model.geom_dataid[a] == model.geom_dataid[b] &&
         std::equal(model.geom_size + std::ptrdiff_t{3} * a,
                    model.geom_size + std::ptrdiff_t{3} * a + 3,
                    model.geom_size + std::ptrdiff_t{3} * b);
}

/// Whether a geom is a ball as a given one of the same body is.
bool is_ball_of_sole(const mjModel& model, int geom, int ball) {
  return model.geom_type[geom] == mjGEOM_SPHERE &&
         model.geom_bodyid[geom] == model.geom_bodyid[ball] &&
         model.geom_size[std::ptrdiff_t{3} * geom] == model.geom_size[std::ptrdiff_t{3} * ball];
}

/// Whether the plates of a fork touch together, turned alike.
bool is_fork(const mjModel& model, const mjData& data, int a, int b) {
  const double turn = Eigen::Vector4d::Map(model.geom_quat + std::ptrdiff_t{4} * a)
                          .dot(Eigen::Vector4d::Map(model.geom_quat + std::ptrdiff_t{4} * b));
  const double apart = (vector_at(model.geom_pos, a) - vector_at(model.geom_pos, b)).norm();
  return are_twins(model, a, b) && apart > kApart && std::abs(turn) > 1.0 - kTurnedAlike &&
         std::abs(lowest_point(model, data, a) - lowest_point(model, data, b)) <= kTwinsAsLow;
}

/// Down in the frame of a geom.
Vector3d down(const mjData& data, int geom) {
  return -matrix_at(data.geom_xmat, geom).row(2).transpose();
}

/// From the middle of a mesh to that of its sole, in the world's axes.
Vector3d arm_to_sole(const mjModel& model, const mjData& data, int geom) {
  const Eigen::Matrix3Xd points =
      matrix_at(data.geom_xmat, geom) * vertices_of(model, geom).cast<double>();
  const double low = points.row(2).minCoeff(), high = points.row(2).maxCoeff();
  Vector3d least = Vector3d::Constant(std::numeric_limits<double>::infinity()), most = -least;
  for (const auto& point : points.colwise()) {
    if (point.z() > low + kSoleShare * (high - low)) continue;
    least = least.cwiseMin(point);
    most = most.cwiseMax(point);
  }
  Vector3d middle = (least + most) / 2;
  middle.z() = low;
  return middle;
}

/// Middle of a mesh's sole, in the frame of its asset.
Vector3d sole_of_mesh(const mjModel& model, const mjData& data, int geom) {
  const int mesh = model.geom_dataid[geom];
  return vector_at(model.mesh_pos, mesh) +
         rotation_at(model.mesh_quat, mesh) *
             (matrix_at(data.geom_xmat, geom).transpose() * arm_to_sole(model, data, geom));
}

/// −1, 0 or 1: to which side along an axis a shape touches the ground.
double side(double along, double level = kFlat) {
  return std::abs(along) > level ? std::copysign(1.0, along) : 0.0;
}

/// The end of a capsule or cylinder that touches: the lower one; of a level one the middle, but of
/// one that is the link itself, from the hinge on, the far end.
double end_of_rod(const mjModel& model, const mjData& data, int geom, const Vector3d& hinge) {
  const Matrix3d axes = matrix_at(data.geom_xmat, geom);
  const double lower = side(-axes(2, 2), kLevel);
  if (lower != 0.0) return lower;
  const Vector3d end = model.geom_size[3 * geom + 1] * axes.col(2),
                 centre = Vector3d::Map(data.geom_xpos + std::ptrdiff_t{3} * geom) - hinge;
  const double ahead = (centre + end).norm(), behind = (centre - end).norm();
  if (std::min(ahead, behind) > kNearEnd * std::max(ahead, behind)) return 0.0;
  return ahead > behind ? 1.0 : -1.0;
}

FootContact contact_of(const mjModel& model, const mjData& data, int geom, const Vector3d& hinge) {
  FootContact out;
  out.geom = geom;
  out.geom_type = model.geom_type[geom];
  const Vector3d d = down(data, geom),
                 half =
                     half_sizes(model.geom_type[geom], model.geom_size + std::ptrdiff_t{3} * geom);
  switch (model.geom_type[geom]) {
    case mjGEOM_SPHERE:
      out.radius = half.x();
      break;
    case mjGEOM_CAPSULE:
      out.radius = half.x();
      out.share.z() = end_of_rod(model, data, geom, hinge);
      break;
    case mjGEOM_CYLINDER:
      out.share.z() = end_of_rod(model, data, geom, hinge);
      if (side(d.z()) == 0.0)
        out.radius = half.x();  // lies and rolls like a ball
      else if (const double across = d.head<2>().norm(); across > kFlat)
        out.share.head<2>() = d.head<2>() / across;
      break;
    case mjGEOM_BOX:
      out.share = d.unaryExpr([](double along) { return side(along); });
      break;
    case mjGEOM_ELLIPSOID:
      out.share = half.cwiseProduct(d).normalized();
      break;
    case mjGEOM_MESH:
      out.share = sole_of_mesh(model, data, geom);
      break;
    default:
      break;
  }
  return out;
}

/// From the middle of a plain geom to where it touches, in its body's frame.
struct Arms {
  Vector3d growing = Vector3d::Zero();  // as far as it follows the stretches with the geom's size
  Vector3d rigid = Vector3d::Zero();
};

Arms arms_of(const XmlFile& xml, const TreeElements& elements, const mjModel& model,
             const FootContact& foot, const std::vector<Stretch>& stretches) {
  const int g = foot.geom;
  const Matrix3d axes = rotation_at(model.geom_quat, g);
  const Vector3d half = half_sizes(model.geom_type[g], model.geom_size + std::ptrdiff_t{3} * g);
  const bool from_to =
      inherited_attribute(xml, *elements.geoms[static_cast<std::size_t>(g)], "fromto") != nullptr;
  const auto grows = growing_axes(model.geom_type[g], half, axes, from_to, stretches);
  Arms out;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Vector3d arm = foot.share[k] * half[k] * axes.col(k);
    // The ends of what is placed by fromto are points of the body, in whatever direction they lie.
    const bool with_body = grows[static_cast<std::size_t>(k)] != nullptr || (from_to && k == 2);
    (with_body ? out.growing : out.rigid) += arm;
  }
  return out;
}

bool is_across(const Vector3d& arm, const std::vector<Stretch>& stretches) {
  return std::all_of(stretches.begin(), stretches.end(), [&](const Stretch& stretch) {
    return std::abs(stretch.direction.dot(arm)) <= 1e-12;
  });
}

}  // namespace

bool collides(const mjModel& model, int geom) {
  return model.geom_contype[geom] != 0 || model.geom_conaffinity[geom] != 0;
}

double lowest_point(const mjModel& model, const mjData& data, int geom) {
  const double height = data.geom_xpos[3 * geom + 2];
  const Vector3d d = down(data, geom),
                 half =
                     half_sizes(model.geom_type[geom], model.geom_size + std::ptrdiff_t{3} * geom);
  switch (model.geom_type[geom]) {
    case mjGEOM_SPHERE:
      return height - half.x();
    case mjGEOM_CAPSULE:
      return height - half.z() * std::abs(d.z()) - half.x();
    case mjGEOM_CYLINDER:
      return height - half.z() * std::abs(d.z()) - half.x() * d.head<2>().norm();
    case mjGEOM_BOX:
      return height - half.dot(d.cwiseAbs());
    case mjGEOM_ELLIPSOID:
      return height - half.cwiseProduct(d).norm();
    case mjGEOM_MESH:
      if (is_mesh(model, geom) && vertices_of(model, geom).cols() > 0)
        return height - (d.transpose() * vertices_of(model, geom).cast<double>()).maxCoeff();
      return height;
    default:
      return height;
  }
}

Vector3d lowest_place(const mjModel& model, const mjData& data, int geom) {
  Vector3d at = vector_at(data.geom_xpos, geom);
  const Matrix3d axes = matrix_at(data.geom_xmat, geom);
  const Vector3d half =
      half_sizes(model.geom_type[geom], model.geom_size + std::ptrdiff_t{3} * geom);
  switch (model.geom_type[geom]) {
    case mjGEOM_CAPSULE:
    case mjGEOM_CYLINDER:
      at -= std::copysign(model.geom_size[3 * geom + 1], axes(2, 2)) * axes.col(2);
      break;
    case mjGEOM_ELLIPSOID: {
      const Vector3d d = down(data, geom);
      at += axes * half.cwiseAbs2().cwiseProduct(d) / half.cwiseProduct(d).norm();
      break;
    }
    case mjGEOM_BOX:
      for (Eigen::Index k = 0; k < 3; ++k) at -= side(axes(2, k)) * half[k] * axes.col(k);
      break;
    case mjGEOM_MESH:
      if (is_mesh(model, geom) && vertices_of(model, geom).cols() > 0)
        at += arm_to_sole(model, data, geom);
      break;
    default:
      break;
  }
  at.z() = lowest_point(model, data, geom);
  return at;
}

bool choose_foot(const XmlFile& xml, const mjModel& model, const mjData& data,
                 const std::vector<int>& bodies, FootContact& foot) {
  const auto among = [&](int body) {
    return std::find(bodies.begin(), bodies.end(), body) != bodies.end();
  };
  int geom = -1, ball = -1;
  const auto low = [&](int g) { return lowest_point(model, data, g); };
  for (int g = 0; g < model.ngeom; ++g) {
    const int type = model.geom_type[g];
    const bool known = (type >= mjGEOM_SPHERE && type <= mjGEOM_BOX) || is_mesh(model, g);
    if (!known || !collides(model, g) || !among(model.geom_bodyid[g])) continue;
    const double least = geom >= 0 && are_twins(model, geom, g) ? kTwinsAsLow : 0.0;
    if (geom < 0 || low(g) < low(geom) - least) geom = g;
    if (type == mjGEOM_SPHERE && (ball < 0 || low(g) < low(ball))) ball = g;
  }
  if (ball >= 0 && low(ball) - low(geom) <= kBallFirst * model.geom_size[std::ptrdiff_t{3} * ball])
    geom = ball;
  if (geom >= 0) {
    // The balls of one sole that touch together are one foot, and so are the plates of a fork.
    std::vector<int> others;
    for (int g = 0; g < model.ngeom; ++g)
      if (g != geom && collides(model, g) &&
          (geom == ball ? is_ball_of_sole(model, g, ball) && low(g) - low(ball) <= kAsLow
                        : is_fork(model, data, g, geom)))
        others.push_back(g);
    const int last = model.body_jntadr[bodies.front()] + model.body_jntnum[bodies.front()] - 1;
    foot = contact_of(model, data, geom, Vector3d::Map(data.xanchor + std::ptrdiff_t{3} * last));
    foot.others = std::move(others);
    if (is_mesh(model, geom)) {
      const TreeElements elements = find_elements(xml, model);
      const MeshAsset asset = mesh_of(xml, *elements.geoms[static_cast<std::size_t>(geom)]);
      if (asset.scale.cwiseAbs().minCoeff() == 0.0)
        throw xml.error(*asset.element,
                        "attribute scale: is zero along an axis, and a foot shows it; give all "
                        "three numbers another value, like 0.001");
      foot.share = asset.turn * foot.share.cwiseQuotient(asset.scale);
    }
    return true;
  }
  int site = -1;
  for (int s = 0; s < model.nsite; ++s)
    if (among(model.site_bodyid[s]) &&
        (site < 0 || data.site_xpos[3 * s + 2] < data.site_xpos[3 * site + 2]))
      site = s;
  if (site < 0) return false;
  foot = FootContact{};
  foot.site = site;
  foot.radius = model.site_size[std::ptrdiff_t{3} * site];
  return true;
}

bool is_of_foot(const FootContact& foot, int geom) {
  return geom >= 0 && (geom == foot.geom || std::find(foot.others.begin(), foot.others.end(),
                                                      geom) != foot.others.end());
}

int foot_body(const mjModel& model, const FootContact& foot) {
  return foot.geom >= 0 ? model.geom_bodyid[foot.geom] : model.site_bodyid[foot.site];
}

AffineVector foot_point(const XmlFile& xml, const TreeElements& elements, const mjModel& model,
                        const FootContact& foot, const std::vector<Stretch>& stretches) {
  if (foot.geom < 0) return stretched_point(vector_at(model.site_pos, foot.site), stretches);
  if (foot.middle) return stretched_point(*foot.middle, stretches);
  const int g = foot.geom;
  Vector3d centre = vector_at(model.geom_pos, g);
  for (const int other : foot.others) centre += vector_at(model.geom_pos, other);
  centre /= static_cast<double>(1 + foot.others.size());
  if (model.geom_type[g] == mjGEOM_SPHERE) return stretched_point(centre, stretches);
  Matrix3d axes = rotation_at(model.geom_quat, g);
  if (is_mesh(model, g)) {
    // From MuJoCo's frame of the geom, at the mesh's centre, to the one that the file places.
    const int mesh = model.geom_dataid[g];
    axes = (axes * rotation_at(model.mesh_quat, mesh).transpose()).eval();
    centre -= axes * vector_at(model.mesh_pos, mesh);
    const XmlElement& element = *elements.geoms[static_cast<std::size_t>(g)];
    const Vector3d arm = axes * (mesh_of(xml, element).shown() * foot.share);
    if (mesh_grows(xml, element)) return stretched_point(centre + arm, stretches);
    AffineVector out = stretched_point(centre, stretches);
    out.constant += arm;
    return out;
  }
  const Arms arms = arms_of(xml, elements, model, foot, stretches);
  const Vector3d point = centre + arms.growing;
  if (is_across(arms.rigid, stretches)) {
    AffineVector out = stretched_point(point, stretches);
    out.constant += arms.rigid;
    return out;
  }
  return stretched_point(point + arms.rigid, stretches);
}

AffineVector foot_shift(const XmlFile& xml, const TreeElements& elements, const mjModel& model,
                        const FootContact& foot, const std::vector<Stretch>& stretches) {
  if (foot.geom < 0 || foot.middle || is_mesh(model, foot.geom)) return {};
  const Vector3d arm = arms_of(xml, elements, model, foot, stretches).rigid;
  if (is_across(arm, stretches)) return {};
  AffineVector out = stretched_arm(arm, stretches);
  out.constant -= arm;
  return out;
}

}  // namespace legwright
