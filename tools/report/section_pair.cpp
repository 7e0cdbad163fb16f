// SPDX-License-Identifier: Apache-2.0
// Two runs side by side: verdicts, pictures, main numbers, bodies.
#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "tools/files/atomic_file.hpp"
#include "tools/files/json_file.hpp"
#include "tools/report/number_words.hpp"
#include "tools/report/pair_report.hpp"
#include "tools/report/parameter_view.hpp"
#include "tools/report/sections.hpp"
#include "tools/report/svg_bars.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// A number of a run and how it reads.
struct PairNumber {
  const char* head;
  std::function<std::optional<double>(const RunData&)> value;
  const char* unit;  // "%" for shares
};

constexpr std::size_t kMostSettings = 200;

std::string long_setting(double value) { return fmt::format("{:.6g}", value); }

const std::vector<PairNumber>& numbers() {
  const auto played = [](auto key) {
    return [key](const RunData& run) {
      const GainMetrics* measured = run.gains_of(Design::result).find("default");
      return measured == nullptr ? std::nullopt : finite(measured->*key);
    };
  };
  const auto told = [](auto member) {
    return [member](const RunData& run) -> std::optional<double> { return run.run.*member; };
  };
  const auto sound = [](double InverseDynamics::*key) {
    return [key](const RunData& run) {
      const Comparison* compared = run.comparison_of(Design::result);
      return compared == nullptr ? std::nullopt : finite(compared->inverse_dynamics.*key);
    };
  };
  static const std::vector<PairNumber> list = {
      {"cost F of the gait alone", told(&RunRecord::motion_only_F), ""},
      {"cost F at the end", told(&RunRecord::final_F), ""},
      {"of the planned speed", played(&GainMetrics::speed_ratio), "%"},
      {"of the planned turn", played(&GainMetrics::turn_ratio), "%"},
      {"largest tilt", played(&GainMetrics::tilt_max), "rad"},
      {"heading drift", played(&GainMetrics::heading_drift), "rad"},
      {"servo torque, RMS", played(&GainMetrics::torque_rms), "N m"},
      {"servos at their limit", played(&GainMetrics::saturated_share), "%"},
      {"mean power", played(&GainMetrics::power_mean), "W"},
      {"cost of transport", played(&GainMetrics::cost_of_transport), ""},
      {"plan out of balance, of the weight", sound(&InverseDynamics::force_max), "%"},
      {"friction that the plan uses", sound(&InverseDynamics::friction_max), ""},
      {"least load of a bearing foot", sound(&InverseDynamics::normal_min), "N"},
      {"random draws that walk",
       [](const RunData& run) {
         return run.robustness ? finite(run.robustness->monte_carlo.share) : std::nullopt;
       },
       "%"},
      {"design iterations", told(&RunRecord::design_iterations), ""},
      {"Newton steps of the motion", told(&RunRecord::newton_iterations), ""},
  };
  return list;
}

/// "+2.5 mm"; "same" where it is too small to see.
std::string difference(std::optional<double> a, std::optional<double> b, const std::string& unit) {
  if (!a || !b) return "–";
  const double by = *b - *a;
  if (percent_or_amount(*a, unit) == percent_or_amount(*b, unit)) return "same";
  return fmt::format("{}{}", by > 0.0 ? "+" : "", percent_or_amount(by, unit));
}

void add_cells(Html& page, const std::string& a, const std::string& b, const std::string& by) {
  page.number(a, "A");
  page.number(b, "B");
  page.number(by, "B less A");
}

/// Width of a PNG from its head; 0 where it is none.
unsigned png_width(const std::string& bytes) {
  if (bytes.size() < 24 || bytes.compare(1, 3, "PNG") != 0) return 0;
  unsigned width = 0;
  for (std::size_t k = 16; k < 20; ++k) width = width << 8 | static_cast<unsigned char>(bytes[k]);
  return width;
}

void add_parameter(Html& page, const ParameterView* a, const ParameterView* b) {
  ParameterView both = a != nullptr ? *a : *b;
  both.initial = a != nullptr ? a->final : NAN;
  both.final = b != nullptr ? b->final : NAN;
  const bool comparable = a != nullptr && b != nullptr && a->angle == b->angle;
  page.open("tr").open("td", {{"class", "head"}}).element("b", spaced(both.name)).close();
  const auto value = [](const ParameterView* p) {
    return p == nullptr ? std::string("not free") : p->with_unit(p->final);
  };
  add_cells(page, value(a), value(b),
            !comparable            ? "–"
            : both.change() == "0" ? "same"
                                   : both.change());
  page.open("td", {{"class", "bar"}});
  if (comparable) page.raw(bounds_bar(both.lower, both.upper, both.initial, both.final));
  page.close().close();
}

void add_pair_head(Html& page, bool bar = false) {
  std::vector<TableColumn> columns{{""}, {"A", "n"}, {"B", "n"}, {"B less A", "n"}};
  if (bar) columns.push_back({"within the bounds of A"});
  page.open_table("stack pair", columns);
}

/// A JSON value's parts by their paths: "task velocity 0".
void flatten(const Json& json, const std::string& path,
             std::vector<std::pair<std::string, std::string>>& out) {
  if (out.size() >= kMostSettings) return;
  if (!json.is_structured()) {
    const bool number = json.is_number();
    out.emplace_back(path, number             ? long_setting(json.get<double>())
                           : json.is_string() ? json.get<std::string>()
                                              : to_text(json));
    return;
  }
  for (const auto& [key, value] : json.items())
    flatten(value, path.empty() ? key : fmt::format("{} {}", path, key), out);
}

/// What the runs were asked for and how, where they differ.
void add_settings(Html& page, const RunPair& pair) {
  std::vector<std::pair<std::string, std::string>> a, b;
  for (const auto& [run, out] : {std::pair{&pair.a.run, &a}, {&pair.b.run, &b}}) {
    if (run->task) flatten(json_of(*run->task), "task", *out);
    if (run->outer) flatten(json_of(*run->outer), "outer", *out);
    out->emplace_back("motion_only", run->motion_only ? "true" : "false");
  }
  const auto find = [](const auto& list, const std::string& path) {
    const auto at =
        std::find_if(list.begin(), list.end(), [&](const auto& one) { return one.first == path; });
    return at == list.end() ? std::string("–") : at->second;
  };
  std::vector<std::string> paths;
  for (const auto* list : {&a, &b})
    for (const auto& [path, value] : *list)
      if (find(a, path) != find(b, path) &&
          std::find(paths.begin(), paths.end(), path) == paths.end())
        paths.push_back(path);
  page.element("h3", "What was asked for");
  if (paths.empty()) {
    page.element("p", "run.json tells of the same task and the same settings for both.");
    return;
  }
  page.open_table("stack pair", {{""}, {"A"}, {"B"}});
  for (const std::string& path : paths) {
    page.open("tr").element("td", spaced(path), {{"class", "head"}});
    page.element("td", find(a, path), {{"data-label", "A"}});
    page.element("td", find(b, path), {{"data-label", "B"}}).close();
  }
  page.close().close();
}

}  // namespace

void add_pair_verdicts(Html& page, const RunPair& pair) {
  page.open("section", {{"class", "cards"}});
  for (const auto& [name, run] : {std::pair{"A", &pair.a}, {"B", &pair.b}}) {
    add_card(page, run->verdict_of(Design::result), fmt::format("{} · {}", name, run->title),
             task_words(run->run) + (motion_only(*run) ? "; gait alone" : "; body and gait"));
  }
  for (const auto& [name, run] : {std::pair{"A", &pair.a}, {"B", &pair.b}})
    if (!run->verdict)
      add_hint(page, fmt::format("{} has no verdict yet.", name), "validate", *run);
  page.close();
}

void add_pair_pictures(Html& page, const RunPair& pair) {
  page.open("section").element("h2", "Pictures");
  PictureBudget budget;
  unsigned widest = 1;
  std::vector<std::pair<fs::path, unsigned>> strips;
  for (const auto& [name, run] : {std::pair{"A", &pair.a}, {"B", &pair.b}}) {
    fs::path file;
    for (const char* picture : {"result/strip_physics.png", "result/strip_before_after.png"})
      if (file.empty() && !add_of_another(page, *run, picture, fmt::format("{}:", name)) &&
          fs::exists(run->root / picture))
        file = run->root / picture;
    strips.emplace_back(file, file.empty() ? 0 : png_width(read_head(file, 24)));
    widest = std::max(widest, strips.back().second);
  }
  const char* name = "A";
  for (const RunData* run : {&pair.a, &pair.b}) {
    const auto& [file, width] = strips[run == &pair.a ? 0 : 1];
    if (width == 0) {
      add_hint(page, fmt::format("No film strip of {}.", name), "render", *run);
    } else if (budget.take(file)) {
      add_strip(page, file, fmt::format("{} · {}.", name, run->title),
                motion_only(*run) ? "" : "Above, the initial body; below, the result.",
                static_cast<double>(width) / static_cast<double>(widest));
    }
    name = "B";
  }
  page.close();
}

void add_pair_numbers(Html& page, const RunPair& pair) {
  page.open("section").element("h2", "Main numbers");
  add_pair_head(page);
  for (const PairNumber& number : numbers()) {
    const auto a = number.value(pair.a), b = number.value(pair.b);
    if (!a && !b) continue;
    page.open("tr").element("td", number.head, {{"class", "head"}});
    add_cells(page, percent_or_amount(a, number.unit), percent_or_amount(b, number.unit),
              difference(a, b, number.unit));
    page.close();
  }
  page.close().close();
  page.note("Measured at default servo gains.");
  for (const auto& [name, run] : {std::pair{"A", &pair.a}, {"B", &pair.b}})
    add_gap_note(page, run->run, fmt::format("{}: F is", name));
  add_settings(page, pair);
  page.open("div", {{"class", "charts single"}});
  page.raw(cost_plot({by_iteration(pair.a, &IterationEvent::F, "A"),
                      by_iteration(pair.b, &IterationEvent::F, "B", 2)},
                     "Cost F by design iteration", "design iteration (0: gait alone)"));
  page.close().close();
}

void add_pair_bodies(Html& page, const RunPair& pair) {
  const auto a = parameters_of(pair.a.run), b = parameters_of(pair.b.run);
  page.open("section").element("h2", "The bodies");
  if (a.empty() && b.empty()) {
    page.note("Neither run.json lists design parameters.").close();
    return;
  }
  page.note("Each body as its run ended; in the bar, the hollow mark is A, the full one B.");
  add_pair_head(page, true);
  for (const auto& [in_a, in_b] : joined_by_name(a, b)) add_parameter(page, in_a, in_b);
  page.close().close().close();
}

void add_pair_terms(Html& page, const RunPair& pair) {
  const auto terms = [](const RunData& run) {
    return run.iterations.empty() ? ByName<double>() : run.iterations.back().terms;
  };
  const ByName<double> a = terms(pair.a), b = terms(pair.b);
  const auto value = [](const ByName<double>& list, const std::string& name) {
    const double* const found = list.find(name);
    return found != nullptr ? std::optional(*found) : std::nullopt;
  };
  std::vector<std::pair<std::string, double>> names;
  for (const auto* list : {&a, &b}) {
    for (const auto& [name, own] : *list) {
      const double most = std::max(value(a, name).value_or(0.0), value(b, name).value_or(0.0));
      const bool known = std::any_of(names.begin(), names.end(),
                                     [&, &key = name](const auto& n) { return n.first == key; });
      if (most > 0.0 && !known) names.emplace_back(name, most);
    }
  }
  if (names.empty()) return;
  std::stable_sort(names.begin(), names.end(),
                   [](const auto& x, const auto& y) { return x.second > y.second; });
  page.open("section").element("h2", "What the cost is made of");
  page.note("Each term of F at the end of the run, weighted; the largest first.");
  const double all = std::max(pair.a.run.final_F.value_or(0.0), pair.b.run.final_F.value_or(0.0));
  const auto small = std::find_if(names.begin(), names.end(),
                                  [&](const auto& name) { return name.second < kSmallTerm * all; });
  const auto add_rows = [&](auto from, auto to) {
    add_pair_head(page);
    for (; from != to; ++from) {
      const std::string& name = from->first;
      const auto in_a = value(a, name), in_b = value(b, name);
      page.open("tr").open("td", {{"class", "head"}}).element("b", term_words(name)).close();
      add_cells(page, short_number(in_a), short_number(in_b), difference(in_a, in_b, ""));
      page.close();
    }
    page.close().close();
  };
  add_rows(names.begin(), small);
  if (small != names.end()) {
    page.open("details").element(
        "summary", fmt::format("{} more terms, each below 1 % of F", names.end() - small));
    add_rows(small, names.end());
    page.close();
  }
  page.close();
}

}  // namespace legwright
