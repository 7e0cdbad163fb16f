// SPDX-License-Identifier: Apache-2.0
#include "tools/run/record.hpp"

#include <fmt/format.h>

#include <limits>

#include "tools/files/io_error.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {
namespace {

class Writer final : public Fields {
 public:
  explicit Writer(Json& root) : at_{&root} {}
  using Fields::visit;
  void visit(bool& value) override { *at_.back() = value; }
  void visit(int& value) override { *at_.back() = value; }
  void visit(std::size_t& value) override { *at_.back() = value; }
  void visit(double& value) override { *at_.back() = value; }
  void visit(std::string& value) override { *at_.back() = value; }
  void visit(Json& value) override { *at_.back() = value; }

 protected:
  bool enter(const char* key, bool present, bool, const char*) override {
    if (present) named(key);
    return present;
  }
  void leave() override { at_.pop_back(); }
  void begin_object() override {
    if (at_.back()->is_null()) *at_.back() = Json::object();
  }
  void end_object() override {}
  bool null(bool absent) override { return absent; }
  void word(std::string& value, std::initializer_list<const char*>) override { visit(value); }
  std::size_t list(std::size_t count) override {
    *at_.back() = Json(Json::array_t(count));
    return count;
  }
  void fixed_list(std::size_t count) override { list(count); }
  void item(std::size_t index) override { at_.push_back(&(*at_.back())[index]); }
  std::vector<std::string> names(const std::vector<std::string>& present) override {
    *at_.back() = Json::object();
    return present;
  }
  void named(const std::string& name) override { at_.push_back(&(*at_.back())[name]); }

 private:
  std::vector<Json*> at_;
};

/// What mends a damaged file.
std::string remedy_of(RecordKind kind) {
  return *kind.verb ? fmt::format("run `legwright {}`, which writes it again", kind.verb)
                    : kWriteAgain;
}

/// A value as an error quotes it.
std::string quoted(const Json& value) {
  const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.size() <= 60 ? text : text.substr(0, 57) + "...";
}

class Reader final : public Fields {
 public:
  Reader(const Json& root, std::string_view file, RecordKind kind)
      : at_{&root}, file_(file), remedy_(remedy_of(kind)) {}
  using Fields::visit;
  bool reads() const override { return true; }
  void visit(bool& value) override {
    value = expect(here().is_boolean(), "true or false").get<bool>();
  }
  void visit(int& value) override {
    const Json& json = expect(here().is_number_integer(), "a whole number");
    const auto number = json.get<std::int64_t>();
    expect(std::in_range<int>(number), "a whole number of 32 bits");
    value = static_cast<int>(number);
  }
  void visit(std::size_t& value) override {
    value = expect(here().is_number_unsigned(), "a whole number of at least 0").get<std::size_t>();
  }
  void visit(double& value) override {
    value = here().is_null() ? std::numeric_limits<double>::quiet_NaN()
                             : expect(here().is_number(), "a number").get<double>();
  }
  void visit(std::string& value) override {
    value = expect(here().is_string(), "a string").get<std::string>();
  }
  void visit(Json& value) override { value = here(); }

  [[noreturn]] void fail(const std::string& expected, const std::string& found) const {
    throw IoError(
        fmt::format("{}: {}: expected {}, found {}; the file is damaged or of another "
                    "version of legwright, {}",
                    file_, path_.empty() ? "the file" : path_, expected, found, remedy_));
  }

 protected:
  bool enter(const char* key, bool, bool required, const char*) override {
    known_.back().push_back(key);
    const auto found = here().find(key);
    const bool there = found != here().end();
    if (!there && required) {
      named_path(key);
      fail("a value", "no such key");
    }
    if (!there || (!required && found->is_null())) return false;
    named(key);
    return true;
  }
  void leave() override {
    at_.pop_back();
    path_.resize(lengths_.back());
    lengths_.pop_back();
  }
  void begin_object() override {
    expect(here().is_object(), "an object");
    known_.emplace_back();
  }
  void end_object() override {
    for (const auto& [key, value] : here().items()) {
      bool known = false;
      for (const std::string& name : known_.back()) known = known || name == key;
      if (known) continue;
      named_path(key);
      fail("no such key", quoted(value));
    }
    known_.pop_back();
  }
  bool null(bool) override { return here().is_null(); }
  void word(std::string& value, std::initializer_list<const char*> words) override {
    visit(value);
    std::string list;
    for (const char* one : words) {
      if (value == one) return;
      list += fmt::format("{}\"{}\"", list.empty() ? "" : " or ", one);
    }
    fail(list, quoted(here()));
  }
  std::size_t list(std::size_t) override { return expect(here().is_array(), "a list").size(); }
  void fixed_list(std::size_t count) override {
    if (!here().is_array() || here().size() != count)
      fail(fmt::format("a list of {}", count), quoted(here()));
  }
  void item(std::size_t index) override {
    push(here()[index]);
    path_ += fmt::format("[{}]", index);
  }
  std::vector<std::string> names(const std::vector<std::string>&) override {
    std::vector<std::string> keys;
    expect(here().is_object(), "an object");
    for (const auto& [key, value] : here().items()) keys.push_back(key);
    return keys;
  }
  void named(const std::string& name) override {
    push(here()[name]);
    named_path(name);
  }

 private:
  const Json& here() const { return *at_.back(); }
  const Json& expect(bool fits, const char* expected) const {
    if (!fits) fail(expected, quoted(here()));
    return here();
  }
  void push(const Json& value) {
    lengths_.push_back(path_.size());
    at_.push_back(&value);
  }
  void named_path(const std::string& name) { path_ += (path_.empty() ? "" : ".") + name; }

  std::vector<const Json*> at_;
  std::string file_, remedy_, path_;
  std::vector<std::size_t> lengths_;             // of path_ before each step
  std::vector<std::vector<std::string>> known_;  // keys of each object entered
};

class SchemaWriter final : public Fields {
 public:
  explicit SchemaWriter(Json& root) : at_{&root} {}
  using Fields::visit;
  void visit(bool&) override { type("boolean"); }
  void visit(int&) override { type("integer"); }
  void visit(std::size_t&) override {
    type("integer");
    (*at_.back())["minimum"] = 0;
  }
  void visit(double&) override { type(Json::array({"number", "null"})); }
  void visit(std::string&) override { type("string"); }
  void visit(Json&) override {}

 protected:
  bool enter(const char* key, bool, bool required, const char* what) override {
    if (required) (*at_.back())["required"].push_back(key);
    at_.push_back(&(*at_.back())["properties"][key]);
    *at_.back() = Json::object();
    if (*what) (*at_.back())["description"] = what;
    optional_.push_back(!required);
    return true;
  }
  void leave() override {
    Json& schema = *at_.back();
    if (optional_.back() && schema.contains("type") && schema["type"].is_string())
      schema["type"] = Json::array({schema["type"], "null"});
    if (optional_.back() && schema.contains("enum")) schema["enum"].push_back(nullptr);
    optional_.pop_back();
    at_.pop_back();
  }
  void begin_object() override {
    type("object");
    (*at_.back())["required"] = Json::array();
    (*at_.back())["properties"] = Json::object();
  }
  void end_object() override { (*at_.back())["additionalProperties"] = false; }
  bool null(bool) override {
    optional_.back() = true;
    return false;
  }
  void word(std::string&, std::initializer_list<const char*> words) override {
    type("string");
    for (const char* one : words) (*at_.back())["enum"].push_back(one);
  }
  bool describes() const override { return true; }
  std::size_t list(std::size_t) override {
    type("array");
    return 1;
  }
  void fixed_list(std::size_t count) override {
    type("array");
    (*at_.back())["minItems"] = (*at_.back())["maxItems"] = count;
  }
  void item(std::size_t) override { push("items"); }
  std::vector<std::string> names(const std::vector<std::string>&) override {
    type("object");
    return {"NAME"};
  }
  void named(const std::string&) override { push("additionalProperties"); }

 private:
  void type(Json name) { (*at_.back())["type"] = std::move(name); }
  void push(const char* key) {
    at_.push_back(&(*at_.back())[key]);
    *at_.back() = Json::object();
    optional_.push_back(false);
  }
  std::vector<Json*> at_;
  std::vector<bool> optional_;
};

}  // namespace

Json write_record(RecordKind kind, RecordVisit visit, void* record) {
  Json json;
  if (*kind.schema) json = {{"schema", kind.schema}, {"version", kind.version}};
  Writer writer(json);
  visit(writer, record);
  return json;
}

void read_record(RecordKind kind, RecordVisit visit, void* record, const Json& json,
                 std::string_view file) {
  if (!*kind.schema) {
    Reader reader(json, file, kind);
    return visit(reader, record);
  }
  if (!json.is_object()) Reader(json, file, kind).fail("an object", quoted(json));
  Json body = json;
  for (const auto& [key, expected] :
       {std::pair{"schema", Json(kind.schema)}, std::pair{"version", Json(kind.version)}}) {
    const auto found = body.find(key);
    if (found == body.end() || *found != expected)
      Reader(json, file, kind)
          .fail(fmt::format("\"{}\": {}", key, expected.dump()),
                found == body.end() ? "no such key" : quoted(*found));
    body.erase(found);
  }
  Reader reader(body, file, kind);
  visit(reader, record);
}

Json schema_of_record(RecordKind kind, RecordVisit visit, void* record) {
  Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"}};
  if (*kind.schema) schema["title"] = fmt::format("{} version {}", kind.schema, kind.version);
  SchemaWriter writer(schema);
  visit(writer, record);
  if (!*kind.schema) return schema;
  Json properties{{"schema", {{"const", kind.schema}}}, {"version", {{"const", kind.version}}}};
  properties.update(schema["properties"]);
  Json required = Json::array({"schema", "version"});
  for (const Json& key : schema["required"]) required.push_back(key);
  schema["properties"] = std::move(properties);
  schema["required"] = std::move(required);
  return schema;
}

bool is_kind(const Json& json, RecordKind kind) {
  if (!json.is_object()) return false;
  const auto found = json.find("schema");
  return found != json.end() && *found == kind.schema;
}

Json load_json(const std::filesystem::path& file, RecordKind kind) {
  return read_json(file, remedy_of(kind));
}

}  // namespace legwright
