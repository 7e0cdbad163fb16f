// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/module_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <optional>

namespace legwright {
namespace {

constexpr double kMillimetres = 1000.0, kGrams = 1000.0;
constexpr double kTurnsPerMinute = 60.0 / (2.0 * std::numbers::pi);

/// "28.5 x 46.5 x 34 mm", around all of its outline.
std::string size_text(const Module& module) {
  const Eigen::Vector3d size = 2.0 * kMillimetres * extent_of(module).half;
  return fmt::format("{:.4g} x {:.4g} x {:.4g}", size.x(), size.y(), size.z());
}

std::string number_or_dash(const std::optional<double>& value, double scale = 1.0) {
  return value ? fmt::format("{:.3g}", scale * *value) : "-";
}

std::string servo_row(const ModuleFile& file) {
  const Module& module = file.module;
  const ModuleJoint& joint = *module.joint;
  return fmt::format("  {:<13} {:<9} {:>6.4g}  {:<20} {:>5.4g} {:>6.3g} {:>6} {:>7} {:>6} {:>8}\n",
                     module.name, module.maker, kGrams * module.mass, size_text(module),
                     module.voltage.value_or(0.0), joint.stall_torque,
                     number_or_dash(joint.continuous_torque), number_or_dash(joint.no_load_speed),
                     number_or_dash(joint.gear_ratio), number_or_dash(joint.reflected_inertia));
}

std::string linear_row(const ModuleFile& file) {
  const Module& module = file.module;
  const ModuleSlide& slide = *module.slide;
  return fmt::format("  {:<13} {:<9} {:>6.4g}  {:<20} {:>5.4g} {:>6.3g} {:>6} {:>7} {:>6} {:>8}\n",
                     module.name, module.maker, kGrams * module.mass, size_text(module),
                     module.voltage.value_or(0.0), slide.most_force,
                     number_or_dash(slide.continuous_force),
                     number_or_dash(slide.no_load_speed, kMillimetres),
                     number_or_dash(slide.gear_ratio), number_or_dash(kMillimetres * slide.stroke));
}

std::string other_row(const ModuleFile& file) {
  const Module& module = file.module;
  return fmt::format("  {:<17} {:<9} {:>6.4g}  {:<20} {}\n", module.name, module.maker,
                     kGrams * module.mass, size_text(module), module.about);
}

/// A figure with its unit, and how it is known.
std::string figure_line(const ModuleFile& file, const std::string& key, const std::string& value) {
  const std::size_t sources = file.source_count(key);
  return fmt::format("  {:<24} {:<34} {}\n", key, value,
                     sources == 0   ? "assumed"
                     : sources == 1 ? "one source"
                                    : fmt::format("{} sources", sources));
}

std::string joint_lines(const ModuleFile& file) {
  const ModuleJoint& joint = *file.module.joint;
  std::string out;
  const auto add = [&](const char* key, const std::optional<double>& value, const char* unit) {
    if (value) out += figure_line(file, key, fmt::format("{:.5g}{}", *value, unit));
  };
  const Eigen::Vector3d at = kMillimetres * joint.position;
  out += figure_line(file, "joint.position",
                     fmt::format("{:.4g} {:.4g} {:.4g} mm", at.x(), at.y(), at.z()));
  add("joint.stall_torque", joint.stall_torque, " N m");
  add("joint.continuous_torque", joint.continuous_torque, " N m");
  if (joint.no_load_speed)
    out += figure_line(file, "joint.no_load_speed",
                       fmt::format("{:.4g} rad/s, {:.4g} rev/min", *joint.no_load_speed,
                                   kTurnsPerMinute * *joint.no_load_speed));
  add("joint.gear_ratio", joint.gear_ratio, "");
  add("joint.reflected_inertia", joint.reflected_inertia, " kg m2");
  add("joint.friction", joint.friction, " N m");
  add("joint.damping", joint.damping, " N m s/rad");
  if (joint.range)
    out += figure_line(file, "joint.range",
                       fmt::format("{:.4g} to {:.4g} rad", (*joint.range)[0], (*joint.range)[1]));
  add("joint.kp", joint.kp, " N m/rad");
  add("joint.kd", joint.kd, " N m s/rad");
  return out;
}

std::string slide_lines(const ModuleFile& file) {
  const ModuleSlide& slide = *file.module.slide;
  std::string out;
  const auto add = [&](const char* key, const std::optional<double>& value, const char* unit) {
    if (value) out += figure_line(file, key, fmt::format("{:.5g}{}", *value, unit));
  };
  const Eigen::Vector3d at = kMillimetres * slide.position;
  out += figure_line(file, "slide.position",
                     fmt::format("{:.4g} {:.4g} {:.4g} mm", at.x(), at.y(), at.z()));
  add("slide.retracted_length", kMillimetres * slide.retracted, " mm");
  add("slide.stroke", kMillimetres * slide.stroke, " mm");
  add("slide.max_force", slide.most_force, " N");
  add("slide.stall_force", slide.stall_force, " N");
  add("slide.continuous_force", slide.continuous_force, " N");
  if (slide.no_load_speed)
    out += figure_line(file, "slide.no_load_speed",
                       fmt::format("{:.4g} mm/s", kMillimetres * *slide.no_load_speed));
  add("slide.backdrive_force", slide.backdrive_force, " N");
  add("slide.gear_ratio", slide.gear_ratio, "");
  add("slide.reflected_mass", slide.reflected_mass, " kg");
  add("slide.kp", slide.kp, " N/m");
  add("slide.kd", slide.kd, " N s/m");
  return out;
}

std::string screw_words(const Attachment& at) {
  return fmt::format("{} x {}", at.holes.size(), at.screws);
}

/// On which part of a module an attachment is.
const char* moving_part(const Module& module, const Attachment& at) {
  return !at.on_horn ? "body" : module.slide ? "rod" : "horn";
}

std::string attachment_lines(const Module& module) {
  std::string out;
  for (const Attachment& at : module.attachments) {
    const Eigen::Vector3d place = kMillimetres * at.position;
    out += fmt::format("  {:<10} {:<5} at {:.4g} {:.4g} {:.4g} mm{}\n", at.name,
                       moving_part(module, at), place.x(), place.y(), place.z(),
                       at.screws.empty() ? "" : ": " + screw_words(at));
  }
  if (!module.cable.empty())
    out += fmt::format("  cables leave at {}\n", fmt::join(module.cable, ", "));
  return out.empty() ? "" : "attachments\n" + out;
}

std::string source_lines(const ModuleFile& file) {
  std::string out;
  if (!file.sources.empty()) out += "sources\n";
  for (const FigureSource& source : file.sources) {
    out += fmt::format("  {}\n    {}\n    gives {}\n", source.title, source.address,
                       fmt::join(source.figures, ", "));
    if (!source.note.empty()) out += fmt::format("    {}\n", source.note);
  }
  if (!file.assumptions.empty()) out += "assumed\n";
  for (const FigureAssumption& assumption : file.assumptions)
    out += fmt::format("  {}: {}\n", fmt::join(assumption.figures, ", "), assumption.why);
  if (!file.unknown.empty()) out += fmt::format("not known\n  {}\n", fmt::join(file.unknown, ", "));
  return out;
}

Json optional_json(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json vector_json(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Json joint_json(const ModuleJoint& joint) {
  return {{"position_m", vector_json(joint.position)},
          {"axis", vector_json(joint.axis)},
          {"stall_torque_nm", joint.stall_torque},
          {"continuous_torque_nm", optional_json(joint.continuous_torque)},
          {"no_load_speed_rad_s", optional_json(joint.no_load_speed)},
          {"gear_ratio", optional_json(joint.gear_ratio)},
          {"reflected_inertia_kgm2", optional_json(joint.reflected_inertia)},
          {"friction_nm", optional_json(joint.friction)},
          {"damping_nms_rad", optional_json(joint.damping)},
          {"range_rad", joint.range ? Json(*joint.range) : Json(nullptr)},
          {"kp_nm_rad", optional_json(joint.kp)},
          {"kd_nms_rad", optional_json(joint.kd)}};
}

Json slide_json(const ModuleSlide& slide) {
  return {{"position_m", vector_json(slide.position)},
          {"axis", vector_json(slide.axis)},
          {"retracted_length_m", slide.retracted},
          {"stroke_m", slide.stroke},
          {"max_force_n", slide.most_force},
          {"stall_force_n", optional_json(slide.stall_force)},
          {"continuous_force_n", optional_json(slide.continuous_force)},
          {"no_load_speed_m_s", optional_json(slide.no_load_speed)},
          {"backdrive_force_n", optional_json(slide.backdrive_force)},
          {"gear_ratio", optional_json(slide.gear_ratio)},
          {"reflected_mass_kg", optional_json(slide.reflected_mass)},
          {"kp_n_m", optional_json(slide.kp)},
          {"kd_ns_m", optional_json(slide.kd)}};
}

}  // namespace

std::string module_table(const std::vector<ModuleFile>& modules) {
  std::string out;
  const auto section = [&](ModuleKind kind) {
    std::string rows;
    for (const ModuleFile& file : modules)
      if (file.module.kind == kind)
        rows += kind == ModuleKind::servo    ? servo_row(file)
                : kind == ModuleKind::linear ? linear_row(file)
                                             : other_row(file);
    if (rows.empty()) return;
    out += out.empty() ? "" : "\n";
    const std::string_view name = kModuleKinds[static_cast<std::size_t>(kind)];
    if (kind == ModuleKind::servo)
      out += fmt::format("  {:<13} {:<9} {:>6}  {:<20} {:>5} {:>6} {:>6} {:>7} {:>6} {:>8}\n", name,
                         "maker", "g", "mm", "V", "N m", "cont.", "rad/s", "ratio", "kg m2");
    else if (kind == ModuleKind::linear)
      out += fmt::format("  {:<13} {:<9} {:>6}  {:<20} {:>5} {:>6} {:>6} {:>7} {:>6} {:>8}\n", name,
                         "maker", "g", "mm", "V", "N", "cont.", "mm/s", "ratio", "stroke");
    else
      out += fmt::format("  {:<17} {:<9} {:>6}  {:<20} what\n", name, "maker", "g", "mm");
    out += rows;
  };
  for (std::size_t kind = 0; kind < kModuleKinds.size(); ++kind)
    section(static_cast<ModuleKind>(kind));
  return out;
}

std::string module_page(const ModuleFile& file) {
  const Module& module = file.module;
  std::string out =
      fmt::format("{}: {} of {}{}\n  {}\n", module.name, module.kind_name(), module.maker,
                  module.about.empty() ? "" : ", " + module.about, file.file.string());
  out += figure_line(file, "mass", fmt::format("{:.4g} g", kGrams * module.mass));
  if (module.voltage) out += figure_line(file, "voltage", fmt::format("{:.4g} V", *module.voltage));
  if (module.price) out += fmt::format("  {:<24} {:.2f}\n", "price", *module.price);
  out += figure_line(file, "outline", size_text(module) + " mm");
  if (module.joint) out += joint_lines(file);
  if (module.slide) out += slide_lines(file);
  if (module.friction)
    out += figure_line(file, "foot.friction", fmt::format("{:.3g}", *module.friction));
  return out + attachment_lines(module) + source_lines(file);
}

Json to_json(const ModuleFile& file) {
  const Module& module = file.module;
  Json outline = Json::array(), attachments = Json::array(), sources = Json::array(),
       assumptions = Json::array();
  constexpr std::array kShapes{"box", "cylinder", "sphere"};
  for (const OutlineShape& shape : module.outline)
    outline.push_back({{"shape", kShapes[static_cast<std::size_t>(shape.type)]},
                       {"size_m", vector_json(shape.size)},
                       {"position_m", vector_json(shape.position)},
                       {"axis", vector_json(shape.axis)},
                       {"on", shape.on_rod ? "rod" : "body"}});
  for (const Attachment& at : module.attachments) {
    Json holes = Json::array();
    for (const Eigen::Vector3d& hole : at.holes) holes.push_back(vector_json(hole));
    attachments.push_back({{"name", at.name},
                           {"on", moving_part(module, at)},
                           {"position_m", vector_json(at.position)},
                           {"normal", vector_json(at.normal)},
                           {"screws", at.screws.empty() ? Json(nullptr) : Json(at.screws)},
                           {"holes_m", holes}});
  }
  for (const FigureSource& source : file.sources)
    sources.push_back({{"title", source.title},
                       {"address", source.address},
                       {"figures", source.figures},
                       {"note", source.note.empty() ? Json(nullptr) : Json(source.note)}});
  for (const FigureAssumption& assumption : file.assumptions)
    assumptions.push_back({{"figures", assumption.figures}, {"why", assumption.why}});
  return {{"name", module.name},
          {"kind", module.kind_name()},
          {"maker", module.maker},
          {"about", module.about},
          {"file", file.file.string()},
          {"mass_kg", module.mass},
          {"voltage_v", optional_json(module.voltage)},
          {"price", optional_json(module.price)},
          {"outline", outline},
          {"joint", module.joint ? joint_json(*module.joint) : Json(nullptr)},
          {"slide", module.slide ? slide_json(*module.slide) : Json(nullptr)},
          {"foot_friction", optional_json(module.friction)},
          {"attachments", attachments},
          {"cable", module.cable},
          {"sources", sources},
          {"assumptions", assumptions},
          {"unknown", file.unknown},
          {"warnings", file.doubts}};
}

}  // namespace legwright
