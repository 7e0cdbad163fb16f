// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/connectors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "mjcf/read/feet.hpp"
#include "mjcf/read/moving_parts.hpp"
#include "mjcf/read/stretch.hpp"
#include "mjcf/shape/polyhedron.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/elements.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "mjcf/text/numbers.hpp"
#include "mjcf/text/refusals.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kSamePoint = 1e-6;   // [m]; files have six digits
constexpr double kSameWeight = 1e-6;  // of mass and moments
constexpr std::size_t kMostPoints = 500;
constexpr const char* kForm =
    "expected \"DENSITY kg/m3 | joint NAME: x y z … | body NAME: x y z … | geom NAME: x y z …\"";
constexpr const char* kCure =
    "change lengths by `legwright export`, which makes it anew, or remove the declaration: then it "
    "stays as it is";

/// One declaration, read against the compiled model.
class ConnectorReader {
 public:
  ConnectorReader(const XmlFile& xml, const mjModel& model, const TreeElements& elements,
                  const Structure& structure, const StretchMap& stretches,
                  const std::vector<TurningPart>& turning, const VectorXd& initial,
                  const MeshElements& meshes, const XmlElement& text)
      : xml_(xml),
        model_(model),
        elements_(elements),
        structure_(structure),
        stretches_(stretches),
        turning_(turning),
        initial_(initial),
        meshes_(meshes),
        text_(text) {}

  Connector run() {
    out_.mesh = attribute(text_, "name").substr(kConnectorPrefix.size());
    const int geom = find_geom();
    body_ = model_.geom_bodyid[geom];
    out_.body = name_of(model_, mjOBJ_BODY, body_);
    check_body(geom);
    out_.ends = read_text();
    for (Connector::End& end : out_.ends) {
      const AffineVector place = place_of(end);
      for (const Vector3d& point : end.points) out_.points.push_back(sum(place, {point, {}}));
    }
    const std::vector<Vector3d> now = points_at(out_.points, initial_);
    out_.facets = convex_hull(now);
    if (out_.facets.empty())
      throw xml_.error(text_,
                       "its points lie in one plane and hold no volume; give some beside it");
    check_mesh(now);
    check_weight(now);
    return std::move(out_);
  }

 private:
  int find_geom() {
    const auto named = meshes_.find(out_.mesh);
    mesh_ = named == meshes_.end() ? nullptr : named->second;
    if (!mesh_ || !has_attribute(*mesh_, "vertex"))
      throw xml_.error(text_, fmt::format("declares the mesh '{}', of which there is no <mesh> "
                                          "with vertices in the file; correct the name",
                                          out_.mesh));
    for (const char* const name : {"scale", "refpos", "refquat", "face"})
      if (has_attribute(*mesh_, name))
        throw xml_.error(*mesh_, fmt::format("is a connector, whose vertices are rewritten as they "
                                             "are; remove {}",
                                             name));
    int found = -1;
    const int asset = mj_name2id(&model_, mjOBJ_MESH, out_.mesh.c_str());
    for (int g = 0; g < static_cast<int>(model_.ngeom); ++g) {
      if (model_.geom_type[g] != mjGEOM_MESH || model_.geom_dataid[g] != asset) continue;
      if (found >= 0)
        throw xml_.error(
            *elements_.geoms[static_cast<std::size_t>(g)],
            fmt::format("is a second geom of the connector '{}'; give it a mesh of its "
                        "own",
                        out_.mesh));
      found = g;
    }
    if (found < 0)
      throw xml_.error(text_, fmt::format("declares the mesh '{}', which no geom shows; add one, "
                                          "or remove the declaration",
                                          out_.mesh));
    return found;
  }

  void check_body(int geom) const {
    const XmlElement& element = *elements_.geoms[static_cast<std::size_t>(geom)];
    const XmlElement* const body = elements_.bodies[static_cast<std::size_t>(body_)];
    const bool is_plain = body_ > structure_.trunk && !out_.body.empty() &&
                          model_.body_jntnum[body_] == 0 && body->FirstChildElement("inertial") &&
                          is_at_origin(geom, *body);
    if (!is_plain)
      throw xml_.error(element,
                       "is a connector, which stands at the origin of a body of its own that has a "
                       "name, an <inertial> and no joint, and is fixed to a link; put it into one");
    if (find_turning_part(turning_, out_.body))
      throw xml_.error(element,
                       "is a connector in a body that is declared to turn with a joint; "
                       "put it into one of its own, beside that");
  }

  /// MuJoCo adds the mesh's own centre and axes to a geom's place.
  bool is_at_origin(int geom, const XmlElement& body) const {
    const int mesh = model_.geom_dataid[geom];
    return elements_.geoms[static_cast<std::size_t>(geom)]->Parent() == &body &&
           (vector_at(model_.geom_pos, geom) - vector_at(model_.mesh_pos, mesh)).norm() < 1e-9 &&
           rotation_at(model_.geom_quat, geom).isApprox(rotation_at(model_.mesh_quat, mesh), 1e-9);
  }

  std::vector<Connector::End> read_text() {
    const std::string_view data = attribute(text_, "data");
    std::vector<std::string_view> parts;
    for (std::size_t at = 0; at <= data.size();) {
      const std::size_t bar = std::min(data.find('|', at), data.size());
      parts.push_back(trimmed(data.substr(at, bar - at)));
      at = bar + 1;
    }
    const auto words = split_words(parts.front());
    const auto density = words.empty() ? std::nullopt : parse_number(words.front());
    if (words.size() != 2 || words[1] != "kg/m3" || !density || !(*density > 0.0))
      throw xml_.error(text_,
                       fmt::format("attribute data: '{}' is no density; {}", parts.front(), kForm));
    out_.density = *density;
    std::vector<Connector::End> ends;
    std::size_t count = 0;
    for (std::size_t k = 1; k < parts.size(); ++k) {
      ends.push_back(read_end(parts[k]));
      count += ends.back().points.size();
    }
    if (count > kMostPoints)
      throw xml_.error(text_, fmt::format("has {} points, at most {} are taken; leave out those "
                                          "that are within the hull",
                                          count, kMostPoints));
    return ends;
  }

  Connector::End read_end(std::string_view part) const {
    const std::size_t colon = part.rfind(':');
    const std::string_view head = trimmed(part.substr(0, colon));
    Connector::End out;
    const auto numbers =
        colon == std::string_view::npos ? std::nullopt : parse_numbers(part.substr(colon + 1));
    const auto sort = sort_of(head);
    if ((sort != "geom" && sort != "body" && sort != "joint") || !numbers || numbers->empty() ||
        numbers->size() % 3 != 0)
      throw xml_.error(text_,
                       fmt::format("attribute data: '{}' is no end with points; {}", part, kForm));
    out.what = fmt::format("{} {}", sort, trimmed(head.substr(sort.size())));
    for (std::size_t k = 0; k < numbers->size(); k += 3)
      out.points.emplace_back(Vector3d::Map(numbers->data() + k));
    return out;
  }

  const std::vector<Stretch>& stretches() const {
    static const std::vector<Stretch> none;
    const auto found = stretches_.find(name_of(model_, mjOBJ_BODY, model_.body_parentid[body_]));
    return found == stretches_.end() ? none : found->second;
  }

  /// The origin of a body that stands beside the connector's, or of that itself, in the frame of
  /// the body that holds both.
  AffineVector origin_of(int body) const {
    const Vector3d carried = carried_point(model_, structure_, body);
    AffineVector out = stretched_point(carried, stretches());
    out.constant += vector_at(model_.body_pos, body) - carried;
    return out;
  }

  AffineVector origin_of_geom(int geom) const {
    const XmlElement& element = *elements_.geoms[static_cast<std::size_t>(geom)];
    AffineVector out = stretched_point(pose_in_body(xml_, element).translation(), stretches());
    for (const FootContact& foot : structure_.feet)
      if (is_of_foot(foot, geom))
        out = sum(out, foot_shift(xml_, elements_, model_, foot, stretches()));
    return out;
  }

  static std::string_view sort_of(std::string_view what) { return what.substr(0, what.find(' ')); }

  /// The origin of what an end goes with, in the connector's frame; the end is told with whose axis
  /// it turns.
  AffineVector place_of(Connector::End& end) const {
    const std::string_view sort = sort_of(end.what);
    const bool is_geom = sort == "geom", is_joint = sort == "joint";
    const mjtObj kind = is_geom ? mjOBJ_GEOM : is_joint ? mjOBJ_JOINT : mjOBJ_BODY;
    const std::string name = end.what.substr(sort.size() + 1);
    const int id = mj_name2id(&model_, kind, name.c_str()), above = model_.body_parentid[body_];
    const bool is_beside =
        id >= 0 && (is_geom    ? model_.geom_bodyid[id] == above
                    : is_joint ? model_.jnt_bodyid[id] == above
                               : id == body_ || (id > 0 && model_.body_parentid[id] == above));
    if (!is_beside)
      throw xml_.error(text_,
                       fmt::format("names the {} '{}', which does not stand in the body that "
                                   "holds '{}'; name one that does, or '{}' itself",
                                   sort, name, out_.body, out_.body));
    const Matrix3d back = rotation_at(model_.body_quat, body_).transpose();
    const auto from_own = [&](const AffineVector& place) {
      return rotated(back, sum(place, negative(origin_of(body_))));
    };
    if (is_geom) return from_own(origin_of_geom(id));
    if (is_joint) {
      end.joint = name;
      end.frame = back;
      return from_own(stretched_point(vector_at(model_.jnt_pos, id), stretches()));
    }
    if (id == body_) return {};
    if (const TurningPart* const part = find_turning_part(turning_, name)) {
      end.joint = part->joint;
      end.frame = back * part->frame;
    }
    return from_own(origin_of(id));
  }

  /// Its corners are declared points; whether they are all of them is told by what the hull weighs.
  void check_mesh(const std::vector<Vector3d>& now) const {
    const auto numbers = parse_numbers(attribute(*mesh_, "vertex"));
    bool is_same = numbers && !numbers->empty() && numbers->size() % 3 == 0;
    for (std::size_t k = 0; is_same && k < numbers->size(); k += 3) {
      const Vector3d corner = Vector3d::Map(numbers->data() + k);
      is_same = std::any_of(now.begin(), now.end(), [&](const Vector3d& point) {
        return (point - corner).norm() <= kSamePoint;
      });
    }
    if (!is_same)
      throw xml_.error(*mesh_, fmt::format("is no longer the hull of the points that 'text {}{}' "
                                           "declares; {}",
                                           kConnectorPrefix, out_.mesh, kCure));
  }

  void check_weight(const std::vector<Vector3d>& now) const {
    const XmlElement& inertial =
        *elements_.bodies[static_cast<std::size_t>(body_)]->FirstChildElement("inertial");
    const SolidMoments hull = moments_of_solid(out_.facets, now);
    const BodyInertia said = legwright::inertia_of(inertial, model_, body_);
    const double mass = out_.density * hull.volume;
    const Matrix3d inertia = out_.density * hull.inertia();
    if (!(std::abs(model_.body_mass[body_] - mass) <= kSameWeight * mass) ||
        !((said.centre - hull.centre).norm() <= kSamePoint) ||
        !((said.inertia - inertia).norm() <= kSameWeight * inertia.norm()))
      throw xml_.error(inertial,
                       fmt::format("is of the connector '{}', whose hull weighs {:.6g} kg at {} "
                                   "kg/m3, with its centre at {}; {}",
                                   out_.mesh, mass, out_.density,
                                   format_numbers(rounded(VectorXd(hull.centre))), kCure));
  }

  const XmlFile& xml_;
  const mjModel& model_;
  const TreeElements& elements_;
  const Structure& structure_;
  const StretchMap& stretches_;
  const std::vector<TurningPart>& turning_;
  const VectorXd& initial_;
  const MeshElements& meshes_;
  const XmlElement& text_;
  const XmlElement* mesh_ = nullptr;
  int body_ = 0;
  Connector out_;
};

}  // namespace

MeshElements find_mesh_elements(const XmlFile& xml) {
  MeshElements out;
  for (const XmlElement* section = xml.root().FirstChildElement("asset"); section;
       section = section->NextSiblingElement("asset"))
    for (const XmlElement* mesh = section->FirstChildElement("mesh"); mesh;
         mesh = mesh->NextSiblingElement("mesh"))
      if (has_attribute(*mesh, "name")) out.emplace(attribute(*mesh, "name"), mesh);
  return out;
}

std::vector<Vector3d> points_at(const std::vector<AffineVector>& points, const VectorXd& s) {
  std::vector<Vector3d> out;
  out.reserve(points.size());
  for (const AffineVector& point : points) out.push_back(point.at(s));
  return out;
}

std::vector<Facet> facets_at(const Connector& connector, const std::vector<Vector3d>& points) {
  return is_convex_hull(connector.facets, points) ? connector.facets : convex_hull(points);
}

std::vector<Connector> read_connectors(const XmlFile& xml, const mjModel& model,
                                       const Structure& structure, const StretchMap& stretches,
                                       const std::vector<TurningPart>& turning,
                                       const VectorXd& initial, Refusals& reasons) {
  const std::vector<const XmlElement*> texts = custom_elements(xml, "text", kConnectorPrefix);
  std::vector<Connector> out;
  if (texts.empty()) return out;
  const TreeElements elements = find_elements(xml, model);
  const MeshElements meshes = find_mesh_elements(xml);
  for (const XmlElement* text : texts)
    reasons.collect([&] {
      out.push_back(ConnectorReader(xml, model, elements, structure, stretches, turning, initial,
                                    meshes, *text)
                        .run());
    });
  return out;
}

void add_connector_masses(const std::vector<Connector>& connectors, const VectorXd& initial,
                          PrintedMap& printed) {
  for (const Connector& connector : connectors)
    printed.emplace(connector.body, masses_of_solid(connector.facets, connector.points,
                                                    connector.density, initial));
}

bool turns(const RobotModel& robot, const Connector& connector, const VectorXd& s) {
  const VectorXd initial = robot.space.initial();
  return std::any_of(connector.ends.begin(), connector.ends.end(), [&](const Connector::End& end) {
    return !end.joint.empty() &&
           axis_turn(robot.morphology, end.joint, initial, s) != Matrix3d::Identity();
  });
}

std::vector<Vector3d> turned_end(const RobotModel& robot, const Connector::End& end,
                                 const VectorXd& s) {
  std::vector<Vector3d> out = end.points;
  if (end.joint.empty()) return out;
  const Matrix3d turn = axis_turn(robot.morphology, end.joint, robot.space.initial(), s);
  if (turn == Matrix3d::Identity()) return out;
  for (Vector3d& point : out) point = end.frame * (turn * (end.frame.transpose() * point));
  return out;
}

std::vector<AffineVector> turned_points(const RobotModel& robot, const Connector& connector,
                                        const VectorXd& s) {
  std::vector<AffineVector> out = connector.points;
  auto at = out.begin();
  for (const Connector::End& end : connector.ends) {
    const std::vector<Vector3d> turned = turned_end(robot, end, s);
    for (std::size_t k = 0; k < turned.size(); ++k) at++->constant += turned[k] - end.points[k];
  }
  return out;
}

Morphology with_hulls_at(const RobotModel& robot, const VectorXd& s) {
  Morphology out = robot.morphology;
  for (const Connector& connector : robot.connectors) {
    const std::vector<AffineVector> own = turned_points(robot, connector, s);
    const std::vector<Facet> facets = facets_at(connector, points_at(own, s));
    if (facets == connector.facets && !turns(robot, connector, s)) continue;
    // As many as on reading: of the same points, in the same frame.
    auto to =
        out.links[static_cast<std::size_t>(connector.link)].masses.begin() + connector.first_mass;
    for (PointMass& point :
         masses_of_solid(facets, own, connector.density, robot.space.initial())) {
      point.position = sum(connector.origin, rotated(connector.link_from_body, point.position));
      *to++ = std::move(point);
    }
  }
  return out;
}

}  // namespace legwright
