// SPDX-License-Identifier: Apache-2.0
#include "tools/modules/module_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "mjcf/text/nearest_word.hpp"
#include "tools/modules/doubtful_module.hpp"
#include "tools/modules/figure_check.hpp"
#include "tools/modules/module_figures.hpp"
#include "tools/modules/slide_table.hpp"
#include "tools/modules/table_values.hpp"
#include "tools/task/task_table.hpp"
#include "tools/task/toml_text.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr double kInThePlaneOfHoles = 1e-5;  // [m]

/// Evenly about the middle of an attachment; with no turn the first lies along the module's x, or
/// y where the normal is along x.
/// @param circle its diameter [m]. @param turn of all about the normal [rad]
std::vector<Vector3d> holes_on_circle(const Attachment& at, double circle, int count, double turn) {
  const Vector3d wanted = std::abs(at.normal.x()) < 0.9 ? Vector3d::UnitX() : Vector3d::UnitY();
  const Vector3d side = (wanted - at.normal.dot(wanted) * at.normal).normalized(),
                 other = at.normal.cross(side);
  std::vector<Vector3d> out;
  for (int k = 0; k < count; ++k) {
    const double angle = turn + 2.0 * std::numbers::pi * k / count;
    out.emplace_back(at.position +
                     0.5 * circle * (std::cos(angle) * side + std::sin(angle) * other));
  }
  return out;
}

class ModuleReader {
 public:
  ModuleReader(const std::string& text, const std::filesystem::path& file)
      : toml_(parse_toml(text, file)),
        problems_(file.string(), "docs/module_file.md has all keys"),
        root_(table(&toml_, "")) {
    out_.file = file;
  }

  ModuleFile run() {
    read_name_and_kind();
    read_outline();
    read_joint();
    read_slide();
    read_foot();
    for (const toml::table* at : root_.tables("attachment")) read_attachment(at);
    read_cable();
    for (const toml::table* source : root_.tables("source")) read_source(source);
    for (const toml::table* assumption : root_.tables("assumption")) read_assumption(assumption);
    out_.unknown = figures(root_, "unknown");
    root_.finish();
    check_figures(out_, given_, kind_known_, lines_, problems_);
    problems_.throw_if_any();
    out_.doubts = doubts_on_module(out_.module, toml_, out_.file);
    return std::move(out_);
  }

 private:
  TaskTable table(const toml::table* toml, const std::string& path) {
    return {toml, path, problems_, lines_, module_keys()};
  }

  std::string needed_text(TaskTable& in, std::string_view key, const std::string& example) {
    const auto value = in.text(key);
    in.require(value.has_value(), key, fmt::format("{} = \"{}\"", key, example));
    return value.value_or("");
  }

  /// One of these words; `words[0]` where it is another.
  template <std::size_t N>
  std::size_t choice(TaskTable& in, std::string_view key, const std::string& word,
                     const std::array<std::string_view, N>& words) {
    const auto found = std::find(words.begin(), words.end(), word);
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    if (!word.empty())
      problems_.add(in.line_of(key), in.full(key),
                    fmt::format("is \"{}\"; expected one of {}", word, fmt::join(words, ", ")));
    return 0;
  }

  std::vector<std::string> figures(TaskTable& in, std::string_view key) {
    std::vector<std::string> words = in.names(key).value_or(std::vector<std::string>{});
    const std::vector<std::string> known(module_figures().begin(), module_figures().end());
    for (const std::string& word : words) {
      if (std::find(known.begin(), known.end(), word) != known.end()) continue;
      const std::string guess = nearest(word, known);
      problems_.add(in.line_of(key), in.full(key),
                    fmt::format("names \"{}\", which is no figure of a module; {}", word,
                                guess.empty() ? fmt::format("there are {}", fmt::join(known, ", "))
                                              : fmt::format("did you mean \"{}\"?", guess)));
    }
    return words;
  }

  void read_name_and_kind() {
    Module& module = out_.module;
    module.name = needed_text(root_, "name", "XL430-W250");
    if (!module.name.empty() && !is_plain_name(module.name, "."))
      problems_.add(
          root_.line_of("name"), "name",
          fmt::format("is \"{}\"; expected letters, digits, '_', '-' and '.'", module.name));
    const std::string kind = needed_text(root_, "kind", "servo");
    module.kind = static_cast<ModuleKind>(choice(root_, "kind", kind, kModuleKinds));
    kind_known_ = module.kind_name() == kind;
    module.maker = needed_text(root_, "maker", "ROBOTIS");
    module.about = root_.text("about").value_or("");
    const auto mass = root_.number("mass");
    root_.require(mass.has_value(), "mass", "mass = 0.057");
    module.mass = mass.value_or(1.0);
    module.voltage = root_.number("voltage");
    module.price = root_.number("price");
    note("mass", root_.has("mass"));
    note("voltage", root_.has("voltage"));
  }

  bool is_a(ModuleKind kind) const { return kind_known_ && out_.module.kind == kind; }
  bool is_servo() const { return is_a(ModuleKind::servo); }

  void read_outline() {
    const std::vector<const toml::table*> tables = root_.tables("outline");
    root_.require(!tables.empty(), "outline",
                  "[[outline]] with shape = \"box\" and size = [0.028, 0.046, 0.034]");
    for (const toml::table* toml : tables) {
      TaskTable in = table(toml, "outline");
      OutlineShape shape;
      constexpr std::array<std::string_view, 3> kShapes{"box", "cylinder", "sphere"};
      constexpr std::array<std::size_t, 3> kCounts{3, 2, 1};
      const std::size_t type = choice(in, "shape", needed_text(in, "shape", "box"), kShapes);
      shape.type = static_cast<OutlineShape::Type>(type);
      const auto size = in.numbers("size");
      in.require(size.has_value(), "size", "size = [0.028, 0.046, 0.034]");
      if (size && size->size() != kCounts[type])
        problems_.add(in.line_of("size"), "outline.size",
                      fmt::format("has {} numbers; a {} has {}: {}", size->size(), kShapes[type],
                                  kCounts[type],
                                  type == 0   ? "widths along x, y and z"
                                  : type == 1 ? "radius and length"
                                              : "its radius"));
      else if (size)
        for (std::size_t k = 0; k < size->size(); ++k)
          shape.size[static_cast<Eigen::Index>(k)] = (*size)[k];
      if (const auto place = in.numbers("position")) shape.position = vector_of(*place);
      shape.axis = direction_in(in, "axis", problems_).value_or(Vector3d::UnitZ());
      shape.on_rod = read_on(in, {"body", "rod"}) == 1;
      in.finish();
      out_.module.outline.push_back(shape);
    }
    note("outline", root_.has("outline"));
  }

  void read_joint() {
    const toml::table* toml = root_.table("joint");
    const bool servo = is_servo();
    root_.require(toml != nullptr || !servo, "joint",
                  "[joint] with position = [0.0, 0.012, 0.017] and stall_torque = 1.4");
    if (!toml) return;
    if (!servo && kind_known_)
      problems_.add(
          root_.line_of("joint"), "joint",
          fmt::format("is for servos, and this is a {}; take it out", out_.module.kind_name()));
    TaskTable in = table(toml, "joint");
    ModuleJoint joint;
    const auto position = in.numbers("position");
    in.require(position || !servo, "position", "position = [0.0, 0.012, 0.017]");
    if (position) joint.position = vector_of(*position);
    joint.axis = direction_in(in, "axis", problems_).value_or(Vector3d::UnitZ());
    const auto stall = in.number("stall_torque");
    in.require(stall || !servo, "stall_torque", "stall_torque = 1.4");
    joint.stall_torque = stall.value_or(1.0);
    joint.continuous_torque = in.number("continuous_torque");
    joint.no_load_speed = in.number("no_load_speed");
    joint.gear_ratio = in.number("gear_ratio");
    joint.reflected_inertia = in.number("reflected_inertia");
    joint.friction = in.number("friction");
    joint.damping = in.number("damping");
    joint.kp = in.number("kp");
    joint.kd = in.number("kd");
    joint.range = angle_range_in(in, "range", problems_);
    if (joint.range && ((*joint.range)[0] > 0.0 || (*joint.range)[1] < 0.0))
      problems_.add(in.line_of("range"), "joint.range",
                    fmt::format("is [{}, {}], without zero, from which its angles count; expected "
                                "a range about the middle, as [{:.4g}, {:.4g}]",
                                (*joint.range)[0], (*joint.range)[1],
                                -0.5 * ((*joint.range)[1] - (*joint.range)[0]),
                                0.5 * ((*joint.range)[1] - (*joint.range)[0])));
    if (stall && joint.continuous_torque && *joint.continuous_torque > *stall)
      problems_.add(in.line_of("continuous_torque"), "joint.continuous_torque",
                    fmt::format("is {}, above the stall torque of {}; expected no more",
                                *joint.continuous_torque, *stall));
    in.finish();
    for (const std::string_view figure : module_figures())
      if (figure.starts_with("joint.")) note(figure, toml->contains(figure.substr(6)));
    out_.module.joint = joint;
  }

  /// On which part of a module something is: the body, or one that moves, which its kind must have.
  std::size_t read_on(TaskTable& in, const std::vector<std::string_view>& parts) {
    const std::string word = in.text("on").value_or("body");
    const auto found = std::find(parts.begin(), parts.end(), word);
    if (found == parts.end())
      problems_.add(in.line_of("on"), in.full("on"),
                    fmt::format("is \"{}\"; expected one of {}", word, fmt::join(parts, ", ")));
    const ModuleKind kind = word == "rod" ? ModuleKind::linear : ModuleKind::servo;
    if (word != "body" && found != parts.end() && kind_known_ && !is_a(kind))
      problems_.add(
          in.line_of("on"), in.full("on"),
          fmt::format("is \"{}\", and a {} has none; take it out", word, out_.module.kind_name()));
    return found == parts.end() ? 0 : static_cast<std::size_t>(found - parts.begin());
  }

  void read_slide() {
    const toml::table* toml = root_.table("slide");
    const bool linear = is_a(ModuleKind::linear);
    root_.require(toml != nullptr || !linear, "slide",
                  "[slide] with position, retracted_length = 0.118, stroke = 0.05 and max_force = "
                  "50.0");
    if (!toml) return;
    if (!linear && kind_known_)
      problems_.add(root_.line_of("slide"), "slide",
                    fmt::format("is for linear actuators, and this is a {}; take it out",
                                out_.module.kind_name()));
    TaskTable in = table(toml, "slide");
    out_.module.slide = read_slide_table(in, problems_, linear);
    for (const std::string_view figure : module_figures())
      if (figure.starts_with("slide.")) note(figure, toml->contains(figure.substr(6)));
    const auto& outline = out_.module.outline;
    if (std::all_of(outline.begin(), outline.end(), [](const auto& each) { return each.on_rod; }) &&
        !outline.empty())
      problems_.add(root_.line_of("outline"), "outline.on",
                    "puts all of its shape on the rod; expected one shape on the body at least");
  }

  void read_foot() {
    const toml::table* toml = root_.table("foot");
    if (!toml) return;
    if (kind_known_ && out_.module.kind != ModuleKind::foot)
      problems_.add(
          root_.line_of("foot"), "foot",
          fmt::format("is for feet, and this is a {}; take it out", out_.module.kind_name()));
    TaskTable in = table(toml, "foot");
    out_.module.friction = in.number("friction");
    note("foot.friction", in.has("friction"));
    in.finish();
  }

  void read_attachment(const toml::table* toml) {
    TaskTable in = table(toml, "attachment");
    Attachment at;
    at.name = needed_text(in, "name", "back");
    if (!at.name.empty() && !is_plain_name(at.name, "."))
      problems_.add(in.line_of("name"), "attachment.name",
                    fmt::format("is \"{}\"; expected letters, digits, '_', '-' and '.'", at.name));
    if (std::any_of(out_.module.attachments.begin(), out_.module.attachments.end(),
                    [&](const Attachment& other) { return other.name == at.name; }) &&
        !at.name.empty())
      problems_.add(
          in.line_of("name"), "attachment.name",
          fmt::format("is \"{}\" a second time; give each attachment its own name", at.name));
    at.on_horn = read_on(in, {"body", "horn", "rod"}) > 0;
    const auto position = in.numbers("position");
    in.require(position.has_value(), "position", "position = [0.0, 0.0, -0.017]");
    if (position) at.position = vector_of(*position);
    in.require(in.has("normal"), "normal", "normal = [0, 0, -1]");
    at.normal = direction_in(in, "normal", problems_).value_or(Vector3d::UnitZ());
    at.screws = in.text("screws").value_or("");
    if (in.has("screws")) note("attachment.screws", true);
    if (!at.screws.empty()) choice(in, "screws", at.screws, kScrewSizes);
    read_holes(in, at);
    in.finish();
    out_.module.attachments.push_back(at);
  }

  void read_cable() {
    Module& module = out_.module;
    module.cable = root_.names("cable").value_or(std::vector<std::string>{});
    note("cable", root_.has("cable"));
    std::vector<std::string> sides;
    for (const Attachment& at : module.attachments)
      if (!at.on_horn) sides.push_back(at.name);
    const std::string told = fmt::format("{}", fmt::join(sides, ", "));
    for (const std::string& side : module.cable)
      if (std::find(sides.begin(), sides.end(), side) == sides.end())
        problems_.add(root_.line_of("cable"), "cable",
                      fmt::format("names \"{}\", which is no attachment on the body; there are {}",
                                  side, sides.empty() ? "none" : told));
  }

  /// Screws on a circle about the middle of an attachment, and places one by one.
  void read_holes(TaskTable& in, Attachment& at) {
    const auto circle = in.number("circle");
    const auto count = in.integer("count");
    const double turn = in.number("turn").value_or(0.0);
    const std::vector<double> holes = in.numbers("holes").value_or(std::vector<double>{});
    if (circle && count) at.holes = holes_on_circle(at, *circle, *count, turn);
    if (holes.size() % 3 != 0)
      problems_.add(in.line_of("holes"), "attachment.holes",
                    fmt::format("has {} numbers; expected three for each hole", holes.size()));
    for (std::size_t k = 0; k + 2 < holes.size(); k += 3) {
      at.holes.emplace_back(Vector3d::Map(holes.data() + k));
      const double off = at.normal.dot(at.holes.back() - at.position);
      if (std::abs(off) > kInThePlaneOfHoles)
        problems_.add(in.line_of("holes"), "attachment.holes",
                      fmt::format("hole {} is {:.3g} mm off the plane of its attachment; expected "
                                  "a place in it",
                                  k / 3 + 1, 1e3 * off));
    }
    if (circle.has_value() != count.has_value() || at.screws.empty() != at.holes.empty())
      problems_.add(in.line_of("screws"), "attachment.screws",
                    "stands with where they are, and that with it: screws = \"M2\", circle = "
                    "0.016, count = 4; or holes = [0.008, 0.0, 0.017]");
  }

  void read_source(const toml::table* toml) {
    TaskTable in = table(toml, "source");
    FigureSource source;
    source.title = needed_text(in, "title", "data sheet");
    source.address = needed_text(in, "address", "https://maker.example/datasheet.pdf");
    source.note = in.text("note").value_or("");
    in.require(in.has("figures"), "figures", "figures = [\"mass\"]");
    source.figures = figures(in, "figures");
    in.finish();
    out_.sources.push_back(source);
  }

  void read_assumption(const toml::table* toml) {
    TaskTable in = table(toml, "assumption");
    FigureAssumption assumption;
    assumption.why = needed_text(in, "why", "half the width from the end");
    in.require(in.has("figures"), "figures", "figures = [\"joint.position\"]");
    assumption.figures = figures(in, "figures");
    in.finish();
    out_.assumptions.push_back(assumption);
  }

  void note(std::string_view figure, bool given) {
    if (given) given_.insert(std::string(figure));
  }

  toml::table toml_;
  Problems problems_;
  std::map<std::string, int> lines_;
  ModuleFile out_;
  std::set<std::string> given_;
  bool kind_known_ = false;  // else what belongs to a kind is not asked for
  TaskTable root_;
};

}  // namespace

std::size_t ModuleFile::source_count(const std::string& figure) const {
  return static_cast<std::size_t>(
      std::count_if(sources.begin(), sources.end(), [&](const FigureSource& source) {
        return std::find(source.figures.begin(), source.figures.end(), figure) !=
               source.figures.end();
      }));
}

ModuleFile parse_module(const std::string& text, const std::filesystem::path& file) {
  return ModuleReader(text, file).run();
}

}  // namespace legwright
