// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace legwright {

/// Values by name in the order in which they stand in the file.
template <class T>
struct ByName : std::vector<std::pair<std::string, T>> {
  using std::vector<std::pair<std::string, T>>::vector;
  /// The value of a name; null without.
  const T* find(std::string_view name) const {
    for (const auto& [key, value] : *this)
      if (key == name) return &value;
    return nullptr;
  }
  /// The same to be set; appended where it is not there.
  T& of(std::string_view name) {
    for (auto& [key, value] : *this)
      if (key == name) return value;
    return this->emplace_back(std::string(name), T()).second;
  }
};

/// The first row of that name; null without.
template <class Row>
const Row* find_named(const std::vector<Row>& rows, const std::string& name) {
  for (const Row& row : rows)
    if (row.name == name) return &row;
  return nullptr;
}

/// Visits the members of a record: one list of keys serves writer, reader and JSON Schema. A record
/// is a plain struct with a function beside it
///
///     void fields(Fields& f, Body& body) {
///       f("mass_kg", body.mass, "of the robot without payload");
///       f("printed_volume_m3", body.volume);  // std::optional: absent where there is none
///       f.nullable("name", body.name);        // std::optional: always there, null without
///     }
///
/// Members are bool, int, std::size_t, double, std::string, raw JSON, other records, and
/// std::vector, std::array, ByName, std::map and std::optional of these. A double that is not
/// finite is null in the file, and null is read as NaN; for an optional member null is the same as
/// absent.
class Fields {
 public:
  virtual ~Fields() = default;

  template <class T>
  void operator()(const char* key, T& value, const char* what = "") {
    if (!enter(key, true, true, what)) return;
    visit(value);
    leave();
  }
  template <class T>
  void operator()(const char* key, std::optional<T>& value, const char* what = "") {
    if (!enter(key, value.has_value(), false, what)) return value.reset();
    visit(value);
    leave();
  }
  template <class T>
  void nullable(const char* key, std::optional<T>& value, const char* what = "") {
    if (!enter(key, true, true, what)) return;
    visit(value);
    leave();
  }
  /// A member that must be there where `needed` holds.
  template <class T>
  void required_if(bool needed, const char* key, std::optional<T>& value, const char* what = "") {
    if (!enter(key, value.has_value(), needed && !describes(), what)) return value.reset();
    visit(value);
    leave();
  }
  /// A string that is one of few.
  void one_of(const char* key, std::string& value, std::initializer_list<const char*> words,
              const char* what = "") {
    if (!enter(key, true, true, what)) return;
    word(value, words);
    leave();
  }
  /// Whether members receive what the file has.
  virtual bool reads() const { return false; }
  /// A key of which the value is always the same.
  void constant(const char* key, const char* text) {
    std::string value = text;
    one_of(key, value, {text});
  }

  template <class T>
  void visit(T& record) {
    begin_object();
    fields(*this, record);
    end_object();
  }
  template <class T>
  void visit(std::optional<T>& value) {
    if (null(!value.has_value())) return value.reset();
    if (!value) value.emplace();
    visit(*value);
  }
  template <class T>
  void visit(std::vector<T>& values) {
    values.resize(list(values.size()));
    for (std::size_t k = 0; k < values.size(); ++k) {
      item(k);
      visit(values[k]);
      leave();
    }
  }
  template <class T, std::size_t N>
  void visit(std::array<T, N>& values) {
    fixed_list(N);
    for (std::size_t k = 0; k < N; ++k) {
      item(k);
      visit(values[k]);
      leave();
    }
  }
  template <class T>
  void visit(std::pair<T, T>& values) {
    fixed_list(2);
    item(0);
    visit(values.first);
    leave();
    item(1);
    visit(values.second);
    leave();
  }
  /// A column of Eigen.
  template <class T>
  requires requires { typename T::Scalar; }
  void visit(T& values) {
    if constexpr (T::SizeAtCompileTime > 0)
      fixed_list(T::SizeAtCompileTime);
    else
      values.resize(static_cast<typename T::Index>(list(static_cast<std::size_t>(values.size()))));
    for (std::size_t k = 0; k < static_cast<std::size_t>(values.size()); ++k) {
      item(k);
      visit(values[static_cast<typename T::Index>(k)]);
      leave();
    }
  }
  template <class T>
  void visit(ByName<T>& values) {
    std::vector<std::string> present;
    for (const auto& [name, value] : values) present.push_back(name);
    const std::vector<std::string> found = names(present);
    values.resize(found.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      values[k].first = found[k];
      named(found[k]);
      visit(values[k].second);
      leave();
    }
  }
  template <class T>
  void visit(std::map<std::string, T>& values) {
    std::vector<std::string> present;
    present.reserve(values.size());
    for (const auto& [name, value] : values) present.push_back(name);
    for (const std::string& name : names(present)) {
      named(name);
      visit(values[name]);
      leave();
    }
  }
  virtual void visit(bool& value) = 0;
  virtual void visit(int& value) = 0;
  virtual void visit(std::size_t& value) = 0;
  virtual void visit(double& value) = 0;
  virtual void visit(std::string& value) = 0;
  virtual void visit(nlohmann::ordered_json& value) = 0;

 protected:
  /// Goes to a member. @return whether there is something to visit
  virtual bool enter(const char* key, bool present, bool required, const char* what) = 0;
  virtual void leave() = 0;
  virtual void begin_object() = 0;
  virtual void end_object() = 0;
  /// Whether the record is described as such, not one of its values read or written.
  virtual bool describes() const { return false; }
  /// Whether the value is, or is to be, null.
  virtual bool null(bool absent) = 0;
  virtual void word(std::string& value, std::initializer_list<const char*> words) = 0;
  /// How many items there are, or are to be.
  virtual std::size_t list(std::size_t count) = 0;
  /// A list of always so many.
  virtual void fixed_list(std::size_t count) = 0;
  virtual void item(std::size_t index) = 0;
  /// The keys that there are, or are to be.
  virtual std::vector<std::string> names(const std::vector<std::string>& present) = 0;
  virtual void named(const std::string& name) = 0;
};

/// What a file, or a line of one, says of itself in its first two keys.
struct RecordKind {
  const char* schema;  // "legwright/run"; empty: a part of a file, without the two keys
  int version;
  const char* verb = "";  // that writes the file: "optimize"
};

/// Whether a JSON value says that it is of this schema, whatever its version.
bool is_kind(const nlohmann::ordered_json& json, RecordKind kind);

using RecordVisit = void (*)(Fields& fields, void* record);
/// The three visitors; the templates below are what callers use.
nlohmann::ordered_json write_record(RecordKind kind, RecordVisit visit, void* record);
void read_record(RecordKind kind, RecordVisit visit, void* record,
                 const nlohmann::ordered_json& json, std::string_view file);
nlohmann::ordered_json schema_of_record(RecordKind kind, RecordVisit visit, void* record);
nlohmann::ordered_json load_json(const std::filesystem::path& file, RecordKind kind);

template <class R>
void visit_record(Fields& fields, void* record) {
  fields.visit(*static_cast<R*>(record));
}

/// A record that is a whole file names its kind: `static constexpr RecordKind kKind{...}`.
template <class R>
constexpr RecordKind kind_of() {
  if constexpr (requires { R::kKind; }) return R::kKind;
  return {"", 0, ""};
}

/// The record as JSON, keys in the order of its fields, schema and version first.
template <class R>
nlohmann::ordered_json json_of(const R& record) {
  return write_record(kind_of<R>(), visit_record<R>, const_cast<R*>(&record));  // only read
}

/// The record of a JSON value. Throws IoError with the file and the path of the key where one is
/// missing, unknown or of another type, or where schema or version are of another kind.
/// @param file that the message names
template <class R>
R record_of(const nlohmann::ordered_json& json, std::string_view file) {
  R record;
  read_record(kind_of<R>(), visit_record<R>, &record, json, file);
  return record;
}

/// The record of a file. Throws IoError as above and where it is no JSON, std::system_error where
/// it cannot be read.
template <class R>
R read_record_file(const std::filesystem::path& file) {
  return record_of<R>(load_json(file, kind_of<R>()), file.string());
}

/// The JSON Schema (draft 2020-12) of a record.
template <class R>
nlohmann::ordered_json schema_of() {
  R record;
  return schema_of_record(kind_of<R>(), visit_record<R>, &record);
}

}  // namespace legwright
