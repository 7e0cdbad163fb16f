// SPDX-License-Identifier: Apache-2.0
#include "tools/report/parameter_view.hpp"

#include <cmath>

#include "tools/report/number_words.hpp"

namespace legwright {

double ParameterView::shown(double value) const {
  return angle ? value * kDegrees : value * 1000.0;
}

std::string ParameterView::with_unit(double value) const {
  return signed_text(shown(value), 1) + (angle ? "°" : " mm");
}

std::string ParameterView::in_radian(double value) const { return signed_text(value, 3) + " rad"; }

std::string ParameterView::change() const {
  const double by = final - initial;
  const std::string text = with_unit(by);
  if (text.front() == '0' && text.find_first_of("123456789") == std::string::npos) return "0";
  return by > 0 ? "+" + text : text;
}

double ParameterView::share_of_range() const {
  return upper > lower ? std::abs(final - initial) / (upper - lower) : 0.0;
}

std::string ParameterView::at_bound() const { return bound_of(final); }

std::string ParameterView::bound_of(double value) const {
  const double close = 1e-6 * (upper - lower);
  return value <= lower + close ? "lower bound" : value >= upper - close ? "upper bound" : "";
}

std::vector<ParameterView> parameters_of(const RunRecord& run) {
  std::vector<ParameterView> views;
  for (const ParameterRecord& p : run.parameters)
    views.push_back({p.name, p.sentence, p.unit == "rad", p.initial, p.final, p.lower, p.upper});
  return views;
}

}  // namespace legwright
