// SPDX-License-Identifier: Apache-2.0
#include "tools/modules/doubts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include "mjcf/text/input_error.hpp"

namespace legwright {
namespace {

constexpr double kMostAngle = 7.0;    // [rad]: a turn either way
constexpr double kMostDensity = 1e4;  // [kg/m3], 5 times the densest of the library; lead: 11340
constexpr double kLitres = 1e3, kGrams = 1e3;

std::string key_of(const std::string& place) {
  std::string out;
  for (std::size_t k = 0; k < place.size(); ++k) {
    if (place[k] == '[')
      k = place.find(']', k);
    else
      out += place[k];
  }
  return out;
}

}  // namespace

std::string figure_text(double value) {
  return std::abs(value) < 100.0 ? fmt::format("{:.3g}", value) : fmt::format("{:.0f}", value);
}

std::string vector_text(const Eigen::Ref<const Eigen::VectorXd>& values) {
  std::vector<std::string> words;
  for (const double value : values) words.push_back(fmt::format("{:.4g}", value + 0.0));
  return fmt::format("[{}]", fmt::join(words, ", "));
}

std::string shorter_vectors(const Eigen::Vector3d& given,
                            const std::function<bool(const Eigen::Vector3d&)>& fits) {
  constexpr std::array<std::pair<double, std::string_view>, 3> kScales{
      {{10.0, "with a digit less"}, {100.0, "in cm"}, {1000.0, "in mm"}}};
  std::vector<std::string> found;
  for (const auto& [scale, words] : kScales)
    if (const Eigen::Vector3d meant = given / scale; fits(meant))
      found.push_back(fmt::format("{} it is {} m", words, vector_text(meant)));
  return fmt::format("{}", fmt::join(found, ", "));
}

void Doubts::add(const std::string& place, const std::string& message) {
  const toml::node* node = toml_.at_path(place).node();
  const int line = node ? static_cast<int>(node->source().begin.line) : 0;
  all_.emplace_back(InputError(file_.string(), line, key_of(place), message).what());
}

void Doubts::check_angles(const std::string& place) {
  const toml::node* node = toml_.at_path(place).node();
  if (!node) return;
  std::vector<double> angles;
  if (const toml::array* array = node->as_array())
    for (const toml::node& entry : *array) angles.push_back(entry.value_or(0.0));
  else
    angles.push_back(node->value_or(0.0));
  const double most = std::abs(*std::max_element(
      angles.begin(), angles.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
  if (most <= kMostAngle) return;
  const Eigen::Map<const Eigen::VectorXd> given(angles.data(),
                                                static_cast<Eigen::Index>(angles.size()));
  const auto text = [&](double scale) {
    return node->is_array() ? vector_text(scale * given)
                            : fmt::format("{:.4g}", scale * angles.front());
  };
  add(place, fmt::format("is {} rad, more than a turn; {} degrees are {} rad", text(1.0), text(1.0),
                         text(std::numbers::pi / 180.0)));
}

void Doubts::check_density(double mass, double volume, double least, const std::string& mass_place,
                           const std::string& size_place) {
  const double density = mass / volume;
  const auto plain = [&](double each) { return each >= least && each <= kMostDensity; };
  if (plain(density)) return;
  const std::string heavy = fmt::format("{:.4g} kg in {} litres, {} kg/m3", mass,
                                        figure_text(kLitres * volume), figure_text(density));
  if (density > kMostDensity)
    return add(mass_place,
               fmt::format("is {}; expected at most {}; {}", heavy, kMostDensity,
                           plain(density / kGrams)
                               ? fmt::format("{:.4g} g are {:.4g} kg", mass, mass / kGrams)
                               : "check it, and the lengths of the shape"));
  const bool cm = plain(1e6 * density), mm = plain(1e9 * density);
  add(size_place,
      fmt::format("makes a shape of {}, less than {}; {}", heavy, least,
                  cm   ? "lengths are in metres, and fit if they are meant in cm: divide by 100"
                  : mm ? "lengths are in metres, and fit if they are meant in mm: divide by 1000"
                       : "check its lengths, and the mass"));
}

}  // namespace legwright
