// SPDX-License-Identifier: Apache-2.0
// Whether other step sizes, integrators and contact models come to the same verdict.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/report/judged_words.hpp"
#include "tools/report/number_words.hpp"
#include "tools/report/page_template.hpp"
#include "tools/report/sections.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

constexpr std::size_t kMostRuns = 24;
constexpr double kSame = 5e-3;  // of a value: smaller differences are not worth telling

struct NumericsColumn {
  std::optional<double> NumericsNumbers::*value;
  const char *head, *unit;
};
constexpr NumericsColumn kColumns[] = {{&NumericsNumbers::speed_ratio, "of planned speed", "%"},
                                       {&NumericsNumbers::turn_ratio, "of planned turn", "%"},
                                       {&NumericsNumbers::tilt_max, "largest tilt", "rad"},
                                       {&NumericsNumbers::heading_drift, "heading drift", "rad"},
                                       {&NumericsNumbers::torque_rms, "torque, RMS", "N m"}};

/// "+0.3 %", "−1.2°"; empty without a difference.
std::string difference_words(std::optional<double> difference, std::optional<double> value,
                             const char* unit) {
  if (!difference) return "";
  const bool ratio = std::string_view(unit) == "%";  // of which a tenth of a per cent is told
  if (value && std::abs(*difference) < (ratio ? 5e-4 : kSame * std::abs(*value))) return "same";
  const std::string text = percent_or_amount(difference, unit);
  if (text.front() == '0' && text.find_first_of("123456789") == std::string::npos) return "same";
  return fmt::format("{}{}", *difference > 0.0 ? "+" : "", text);
}

/// The columns of which any run has a number.
std::vector<NumericsColumn> columns_of(const std::vector<NumericsRun>& runs) {
  std::vector<NumericsColumn> out;
  for (const NumericsColumn& column : kColumns)
    if (std::any_of(runs.begin(), runs.end(), [&](const NumericsRun& run) {
          return (run.numbers.*column.value).has_value();
        }))
      out.push_back(column);
  return out;
}

std::string cell_html(const NumericsRun& run, const NumericsColumn& column) {
  const auto value = run.numbers.*column.value;
  const std::string by = difference_words(
      run.difference ? (*run.difference).*column.value : std::nullopt, value, column.unit);
  return fill(R"(<td class="n" data-label="{head}">{value}{difference}</td>)",
              {{"head", column.head},
               {"value", percent_or_amount(value, column.unit)},
               Hole::markup("difference", small_html(by))});
}

std::string run_html(const NumericsRun& run, const std::vector<NumericsColumn>& columns) {
  return fill(R"(<tr><td class="mark {mark}">{tick}</td><td class="head"><b>{label}</b></td>
{cells}</tr>
)",
              {{"mark", run.pass ? "good" : "bad"},
               {"tick", run.pass ? "✓" : "✗"},
               {"label", label_of(run) + (run.gains.empty() ? "" : ", " + run.gains + " gains")},
               Hole::markup("cells", each(columns, [&](const NumericsColumn& column) {
                              return cell_html(run, column);
                            }))});
}

/// The second engine's roll-outs as rows of the same table, against MuJoCo's at the same gains.
std::vector<NumericsRun> engine_runs(const RunData& data) {
  std::vector<NumericsRun> out;
  if (!data.second_engine) return out;
  for (const auto& [gains, measured] : data.second_engine->result) {
    NumericsRun run;
    run.label = engine_name(*data.second_engine);
    run.gains = gains;
    const bool* const pass = data.second_engine->passes.find(gains);
    run.pass = pass != nullptr && *pass;
    run.numbers = numbers_of(measured);
    if (const GainMetrics* in_mujoco = data.gains_of(Design::result).find(gains))
      run.difference = numbers_of(measured) - numbers_of(*in_mujoco);
    out.push_back(std::move(run));
  }
  return out;
}

void add_runs(Html& page, const std::vector<NumericsRun>& runs, const std::string& note) {
  const auto columns = columns_of(runs);
  page.raw(fill(
      R"(<table class="limits stack"><thead><tr><th></th><th></th>{heads}</tr></thead><tbody>
{rows}</tbody></table>
<p class="note">{note}</p>
)",
      {{"note", note},
       Hole::markup("heads", each(columns,
                                  [](const NumericsColumn& column) {
                                    return number_head_html(column.head);
                                  })),
       Hole::markup("rows",
                    each(runs, [&](const NumericsRun& run) { return run_html(run, columns); }))}));
}

void add_second_engine(Html& page, const RunData& data) {
  if (!data.second_engine) return;
  page.element("p", "A second physics engine, of another contact model and solver: " +
                        engine_words(*data.second_engine));
  add_runs(page, engine_runs(data),
           "Below each number: its difference from MuJoCo’s, at the same "
           "gains.");
}

}  // namespace

void add_numerics(Html& page, const RunData& data) {
  page.open("section").element("h2", "Second opinion");
  if (!data.numerics || data.numerics->runs.empty()) {
    add_hint(page, "The gait has not been played with other numerics yet.", "validate", data);
  } else {
    auto runs = data.numerics->runs;
    if (runs.size() > kMostRuns) runs.resize(kMostRuns);
    page.element("p",
                 "The same gait with finer time steps, another integrator and another model of "
                 "friction. " +
                     numerics_words(*data.numerics));
    add_runs(page, runs,
             "Below each number: its difference from the scene as it is, at the same gains.");
  }
  add_second_engine(page, data);
  page.close();
}

}  // namespace legwright
