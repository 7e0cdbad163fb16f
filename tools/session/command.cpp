// SPDX-License-Identifier: Apache-2.0
#include "tools/session/command.hpp"

#include <fmt/format.h>

#include <limits>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "mjcf/text/input_error.hpp"

namespace legwright {
namespace {

using namespace session;

constexpr const char* kKind = "do";
constexpr const char* kFound = "found";  // may be missing

// One list of fields for each command, which writes and reads it.
const char* kind_of(const Edit&) { return "edit"; }
const char* kind_of(const Freeze&) { return "freeze"; }
const char* kind_of(const Bounds&) { return "bounds"; }
const char* kind_of(const Tasks&) { return "tasks"; }
const char* kind_of(const Weights&) { return "weights"; }
const char* kind_of(const Reset&) { return "reset"; }
const char* kind_of(const Undo&) { return "undo"; }
const char* kind_of(const Redo&) { return "redo"; }
const char* kind_of(const Snapshot&) { return "snapshot"; }
const char* kind_of(const Branch&) { return "branch"; }
const char* kind_of(const Step&) { return "step"; }
const char* kind_of(const Settled&) { return "settled"; }
const char* kind_of(const Searched&) { return "searched"; }
const char* kind_of(const WorkedOut&) { return "worked_out"; }
const char* kind_of(const Choose&) { return "choose"; }

template <class F>
void fields(Edit& c, F&& f) {
  f("values", c.values);
  f("goes_on", c.goes_on);
}
template <class F>
void fields(Freeze& c, F&& f) {
  f("names", c.names);
  f("frozen", c.frozen);
}
template <class F>
void fields(Bounds& c, F&& f) {
  f("name", c.name);
  f("lower", c.lower);
  f("upper", c.upper);
}
template <class F>
void fields(Tasks& c, F&& f) {
  f("text", c.text);
  f("file", c.file);
}
template <class F>
void fields(Weights& c, F&& f) {
  f("weights", c.weights);
}
template <class F>
void fields(Reset&, F&&) {}
template <class F>
void fields(Undo&, F&&) {}
template <class F>
void fields(Redo&, F&&) {}
template <class F>
void fields(Snapshot& c, F&& f) {
  f("name", c.name);
}
template <class F>
void fields(Branch& c, F&& f) {
  f("name", c.name);
}
template <class F>
void fields(Step& c, F&& f) {
  f(kFound, c.found);
}
template <class F>
void fields(Settled& c, F&& f) {
  f(kFound, c.found);
}
template <class F>
void fields(Searched& c, F&& f) {
  f("points", c.points);
  f(kFound, c.found);
}
template <class F>
void fields(WorkedOut& c, F&& f) {
  f("what", c.what);
  f(kFound, c.found);
}
template <class F>
void fields(Choose& c, F&& f) {
  f("what", c.what);
  f("design", c.design);
  f("goes_on", c.goes_on);
}

// What was found can be found again: where it cannot be read, it is missing.
void read_field(const char*, const Json& found, std::optional<Found>& value) {
  try {
    value = found_of(found);
  } catch (const std::exception&) {
    value.reset();
  }
}
void read_field(const char*, const Json& found, std::shared_ptr<const Alternatives>& value) {
  try {
    value = std::make_shared<const Alternatives>(alternatives_of(found));
  } catch (const std::exception&) {
    value.reset();
  }
}
void read_field(const char* key, const Json& found, int& value) {
  if (!found.is_number_integer() || found < 0 || found > std::numeric_limits<int>::max())
    throw std::invalid_argument(fmt::format("{} is no whole number that counts", key));
  found.get_to(value);
}
template <class Value>
void read_field(const char*, const Json& found, Value& value) {
  found.get_to(value);
}

void write_field(const char* key, const std::optional<Found>& value, Json& json) {
  if (value) json[key] = json_of(*value);
}
void write_field(const char* key, const std::shared_ptr<const Alternatives>& value, Json& json) {
  if (value) json[key] = json_of(*value);
}
template <class Value>
void write_field(const char* key, const Value& value, Json& json) {
  json[key] = value;
}

/// The command of this kind, with its fields read; nothing where the kind is another.
template <std::size_t I = 0>
std::optional<SessionCommand> read_kind(const std::string& kind, const Json& json) {
  if constexpr (I < std::variant_size_v<SessionCommand>) {
    std::variant_alternative_t<I, SessionCommand> command;
    if (kind != kind_of(command)) return read_kind<I + 1>(kind, json);
    std::size_t read = 1;  // the kind itself
    fields(command, [&](const char* key, auto& value) {
      if (std::string_view(key) == kFound && !json.contains(key)) return;
      read_field(key, json.at(key), value);
      ++read;
    });
    if constexpr (std::is_same_v<decltype(command), Searched>)
      if (command.points < 1) throw std::invalid_argument("points are not 1 or more");
    if (read != json.size()) throw std::invalid_argument("has keys that '" + kind + "' has not");
    return command;
  } else {
    return std::nullopt;
  }
}

}  // namespace

SessionCommand without_found(SessionCommand command) {
  std::visit(
      [](auto& each) {
        if constexpr (requires { each.found.reset(); }) each.found.reset();
      },
      command);
  return command;
}

Json json_of(const SessionCommand& command) {
  return std::visit(
      [](auto each) {
        Json json;
        json[kKind] = kind_of(each);
        fields(each, [&](const char* key, auto& value) { write_field(key, value, json); });
        return json;
      },
      command);
}

SessionCommand command_of(const Json& json, const std::string& file, int line) {
  const auto refuse = [&](const std::string& why) -> void {
    throw InputError(file, line, "", why + "; expected a line as a session writes it");
  };
  if (!json.is_object() || !json.contains(kKind) || !json[kKind].is_string())
    refuse(fmt::format("no command: {}", json.dump()));
  const auto kind = json[kKind].get<std::string>();
  std::optional<SessionCommand> command;
  try {
    command = read_kind(kind, json);
  } catch (const std::exception& error) {  // Json's own and those of read_kind
    refuse(fmt::format("'{}': {}", kind, error.what()));
  }
  if (!command) refuse(fmt::format("'{}' is no command", kind));
  return *std::move(command);
}

}  // namespace legwright
