// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/splice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <string_view>

#include "mjcf/text/safe_path.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 100;
constexpr std::size_t kLongestChain = 8;

class Splicer {
 public:
  Splicer(const fs::path& file, const FileReach& reach) : file_(file), reach_(reach) {}

  SplicedText run(std::string text) {
    out_.parts.push_back({{}, std::move(text)});
    auto xml = load_xml(out_.parts.front().text, file_);
    if (is_tag(xml->root(), "robot"))
      throw xml->error(
          xml->root(),
          "is a URDF, expected MJCF; `legwright init FILE.urdf -o robot.xml` makes MJCF "
          "of it");
    if (!is_tag(xml->root(), "mujoco"))
      throw xml->error(xml->root(),
                       "the root element of a robot is <mujoco>; is this an MJCF file?");
    bytes_ = xml->text.size();
    first_.emplace(fs::weakly_canonical(file_), Chosen{0, ""});
    chain_.push_back(0);
    splice(0, *xml, 0, xml->text.size());
    if (out_.parts.size() == 1) out_.main = std::move(xml);
    return std::move(out_);
  }

 private:
  struct Chosen {
    std::size_t part;
    std::string where;  // the place that includes it
  };

  std::string name_of(std::size_t part) const {
    return (part == 0 ? file_.filename() : out_.parts[part].path).string();
  }

  /// Copies bytes [begin, end) of a file, with what it includes in place.
  void splice(std::size_t part, const XmlFile& xml, std::size_t begin, std::size_t end) {
    std::size_t at = begin;
    for_each_element(xml.root(), [&](const XmlElement& element) {
      if (!is_include(element)) return;
      const TagSpan& tag = xml.tag(element);
      copy(part, xml, at, tag.begin);
      include(part, xml, element);
      at = tag.close_end;
    });
    copy(part, xml, at, end);
  }

  void copy(std::size_t part, const XmlFile& xml, std::size_t begin, std::size_t end) {
    if (!out_.segments.empty()) out_.text += '\n';
    out_.segments.push_back({out_.text.size(), end - begin, part, begin});
    out_.text.append(xml.text, begin, end - begin);
  }

  void include(std::size_t part, const XmlFile& xml, const XmlElement& element) {
    for (const tinyxml2::XMLAttribute* a = element.FirstAttribute(); a; a = a->Next())
      if (a->Name() != std::string_view("file"))
        throw xml.error(
            element,
            fmt::format("attribute {}: <include> has no attribute but file; remove it", a->Name()));
    if (element.FirstChildElement())
      throw xml.error(element, "holds elements; an <include> names a file and holds nothing");
    const std::string reference = slashed(std::string(attribute(element, "file")));
    const FoundFile found = look_up(part, reference);
    if (!found.fault.empty())
      throw xml.error(element, fmt::format("'{}' {}", reference, found.fault));
    out_.gathered = out_.gathered && path_below(reference) == found.path;
    check_chain(xml, element, reference, found);
    bytes_ += found.bytes;
    if (bytes_ > XmlLimits{}.bytes || out_.parts.size() > kMostFiles)
      throw xml.error(element,
                      fmt::format("'{}': the files of a robot are at most {} with {} bytes "
                                  "together; remove what does not belong to it",
                                  reference, kMostFiles, XmlLimits{}.bytes));
    add(xml, element, found);
  }

  /// Newer releases of MuJoCo look beside the including file, too, older ones for some spellings of
  /// the main file's path.
  FoundFile look_up(std::size_t part, const std::string& reference) const {
    const fs::path home = file_.parent_path();
    FoundFile found = find_file(home, reference, XmlLimits{}.bytes, reach_);
    const fs::path beside = out_.parts[part].path.parent_path();
    if (!found.missing || beside.empty() || fs::path(reference).is_absolute()) return found;
    const FoundFile other =
        find_file(home, (beside / reference).string(), XmlLimits{}.bytes, reach_);
    return other.missing ? found : other;
  }

  void check_chain(const XmlFile& xml, const XmlElement& element, const std::string& reference,
                   const FoundFile& found) const {
    const auto known = first_.find(fs::canonical(found.source));
    if (known != first_.end()) {
      const auto own = std::find(chain_.begin(), chain_.end(), known->second.part);
      if (own == chain_.end())
        throw xml.error(element, fmt::format("'{}' is included a second time, first by {}; each "
                                             "file may be included once, remove one of them",
                                             reference, known->second.where));
      std::string chain;
      for (auto part = own; part != chain_.end(); ++part) chain += name_of(*part) + " > ";
      throw xml.error(element, fmt::format("the file includes itself: {}{}; remove this <include>",
                                           chain, name_of(*own)));
    }
    if (chain_.size() > kLongestChain)
      throw xml.error(element, fmt::format("'{}': files include each other more than {} deep; "
                                           "include it from the main file",
                                           reference, kLongestChain));
  }

  void add(const XmlFile& xml, const XmlElement& element, const FoundFile& found) {
    const std::size_t part = out_.parts.size();
    const InputError place = xml.error(element, "");
    out_.mentions.push_back({found.path, found.source, place.file(), place.line(), place.where()});
    first_.emplace(fs::canonical(found.source),
                   Chosen{part, fmt::format("{}:{}", place.file(), place.line())});
    out_.parts.push_back({found.path, read_regular_file(found.source, XmlLimits{}.bytes)});
    const auto own = load_xml(out_.parts.back().text, found.source);
    const XmlElement& root = own->root();
    // MuJoCo takes the elements out of a root of any name.
    if (is_tag(root, "robot") && root.FirstChildElement("link"))
      throw own->error(root,
                       "an included URDF; what is included are elements of MJCF: convert the file "
                       "first (MuJoCo's `compile` does)");
    if (!root.FirstChildElement())
      throw own->error(root,
                       "an included file without elements; write them, or remove the <include>");
    const TagSpan& tag = own->tag(root);
    chain_.push_back(part);
    splice(part, *own, tag.end, tag.close_begin);
    chain_.pop_back();
  }

  const fs::path& file_;
  const FileReach& reach_;
  SplicedText out_;
  std::size_t bytes_ = 0;
  std::map<fs::path, Chosen> first_;
  std::vector<std::size_t> chain_;
};

}  // namespace

bool is_include(const XmlElement& element) {
  const std::string_view name = element.Name();
  constexpr std::string_view kInclude = "include";
  return std::equal(name.begin(), name.end(), kInclude.begin(), kInclude.end(), [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == b;
  });
}

std::string read_main_file(const fs::path& file) {
  return read_regular_file(file, XmlLimits{}.bytes);
}

SplicedText splice_includes(std::string text, const fs::path& file, const FileReach& reach) {
  return Splicer(file, reach).run(std::move(text));
}

}  // namespace legwright
