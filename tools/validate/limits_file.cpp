// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/limits_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "mjcf/text/input_error.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/io_error.hpp"
#include "tools/task/toml_reader.hpp"
#include "tools/task/toml_text.hpp"
#include "tools/validate/robustness_limits.hpp"

namespace legwright {
namespace {

constexpr std::uintmax_t kMostBytes = 1 << 20;

/// What may be asked for of each quantity.
struct Askable {
  std::string name;  // without "margin."
  std::string unit;
  double low = -1e9, high = 1e9;
  bool below = false;  // the upper bound itself does not pass
  std::optional<double> nominal =
      {};  // of a margin: what is played without it, where that is known
};

std::vector<Askable> askable_quantities() {
  std::vector<Askable> out;
  for (const auto& quantity : limited_quantities())
    out.push_back(
        {quantity.name, quantity.unit, quantity.least, quantity.most, quantity.below, {}});
  out.push_back({.name = "numerics", .unit = "1", .low = 0.0});
  out.push_back({.name = "survival", .unit = "1", .low = 0.0, .high = 1.0});
  return out;
}

constexpr const char* kFriction = "floor_friction";

// What cannot be played has no margin: a floor of no friction at all, masses below nothing. The
// friction that is planned for is the task's.
std::vector<Askable> askable_margins() {
  std::vector<Askable> out;
  for (const auto& factor : disturbance_factors({})) {
    out.push_back({factor.name, factor.unit, factor.valid.first, factor.valid.second});
    if (factor.name != kFriction) out.back().nominal = Disturbance{}.*factor.value;
  }
  return out;
}

/// Why a margin is on the wrong side of what is played without it: empty where it is not.
std::string wrong_side(const Bounds& bounds, bool low, double nominal, const std::string& unit) {
  const std::optional<double>& asked = low ? bounds.low : bounds.high;
  if (!asked || (low ? *asked <= nominal : *asked >= nominal)) return "";
  return fmt::format(
      "is {}, {} what is planned ({}{}): {} is a value {} to which the robot must walk; give one "
      "{} {}, or call it {}",
      *asked, low ? "above" : "below", nominal, unit.empty() || unit == "1" ? "" : " " + unit,
      low ? "low" : "high", low ? "down" : "up", low ? "of at most" : "from", nominal,
      low ? "high" : "low");
}

class Reader {
 public:
  Reader(const toml::table& root, Problems& problems, Limits& limits)
      : problems_(problems), limits_(limits), in_(&root, "", problems, lines_) {}

  void read(const std::vector<Askable>& all, bool margins) {
    TableReader* from = &in_;
    std::optional<TableReader> within;
    if (margins) from = &within.emplace(in_.table("margin"), "margin", problems_, lines_);
    for (const Askable& one : all) bounds(*from, one, margins ? std::string(kMarginPrefix) : "");
    if (margins) within->finish();
  }
  void finish() { in_.finish(); }

 private:
  void bounds(TableReader& from, const Askable& one, const std::string& prefix) {
    const toml::table* table = from.table(one.name);
    if (table == nullptr) return;
    const std::string full = prefix + one.name;
    TableReader in(table, full, problems_, lines_);
    // A view of the name itself: a conditional with "" would make a string that dies here.
    const std::string_view unit = one.unit == "1" ? std::string_view() : std::string_view(one.unit);
    const Range range{one.low, one.high, false, false, unit};
    const Bounds read{in.number("low", range), in.number("high", range)};
    if (!read.any() && !in.has("low") && !in.has("high"))
      problems_.add(static_cast<int>(table->source().begin.line), full,
                    "has neither low nor high; give one of them, or both");
    in.finish();
    Bounds& own = limits_[full];
    own.by_file = true;
    if (read.low) {
      own.low = read.low;
      own.low_line = in.line_of("low");
    }
    if (read.high) {
      own.high = read.high;
      own.high_line = in.line_of("high");
    }
    if (one.below && read.high && *read.high <= one.low)
      problems_.add(own.high_line, full + ".high",
                    fmt::format("nothing would pass: it must stay below {}; expected more than {}",
                                *read.high, one.low));
    if (one.nominal) {
      for (const bool low : {true, false})
        if (const std::string why = wrong_side(read, low, *one.nominal, one.unit); !why.empty())
          problems_.add(low ? own.low_line : own.high_line, full + (low ? ".low" : ".high"), why);
      return;
    }
    if (!own.low || !own.high || *own.low < *own.high) return;
    if (*own.low == *own.high && !one.below) return;
    // Whichever end the file does not give holds by default.
    const char* key = read.high ? "high" : "low";
    const auto held = [](bool by_file) { return by_file ? "" : ", which holds by default"; };
    if (read.low || read.high)
      problems_.add(in.line_of(key), full + "." + key,
                    fmt::format("nothing would pass: low is {}{}, high {}{}; {}", *own.low,
                                held(read.low.has_value()), *own.high, held(read.high.has_value()),
                                read.low && read.high ? "swap them, or take another"
                                                      : "give both, low below high"));
  }

  Problems& problems_;
  Limits& limits_;
  std::map<std::string, int> lines_;
  TableReader in_;
};

}  // namespace

Limits parse_limits(const std::string& text, const std::filesystem::path& file) {
  const toml::table root = parse_toml(text, file);
  Limits limits = default_limits();
  Problems problems(file.string());
  Reader reader(root, problems, limits);
  reader.read(askable_quantities(), false);
  reader.read(askable_margins(), true);
  reader.finish();
  problems.throw_if_any();
  return limits;
}

void check_friction_margin(const Limits& limits, const std::filesystem::path& file,
                           double planned) {
  const std::string name = std::string(kMarginPrefix) + kFriction;
  const auto found = limits.find(name);
  if (found == limits.end()) return;
  for (const bool low : {true, false})
    if (const std::string why = wrong_side(found->second, low, planned, "1"); !why.empty())
      throw InputError(file.string(), low ? found->second.low_line : found->second.high_line,
                       name + (low ? ".low" : ".high"), why);
}

Limits read_limits(const std::filesystem::path& file) {
  std::string text;
  try {
    text = read_file(file, kMostBytes);
  } catch (const std::system_error& error) {
    throw InputError(file.string(), 0, "",
                     error.code().message() + "; give the path of a limits file, for instance " +
                         "examples/limits.toml");
  } catch (const IoError&) {
    throw InputError(file.string(), 0, "",
                     std::filesystem::is_regular_file(file)
                         ? "larger than 1 MiB; this is no limits file"
                         : "is a pipe, a socket or a device; expected a regular file");
  }
  return parse_limits(text, file);
}

bool ask_for_numerics(const Limits& limits) {
  const auto found = limits.find("numerics");
  return found != limits.end() && found->second.by_file && found->second.any();
}

bool need_robustness(const Limits& limits) {
  return std::any_of(limits.begin(), limits.end(), [](const auto& entry) {
    return entry.second.any() &&
           (entry.first == "survival" || entry.first.starts_with(kMarginPrefix));
  });
}

}  // namespace legwright
