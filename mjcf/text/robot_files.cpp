// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/robot_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "mjcf/text/assets.hpp"
#include "mjcf/text/gathered_names.hpp"
#include "mjcf/text/mesh_copies.hpp"
#include "mjcf/text/safe_path.hpp"
#include "mjcf/text/splice.hpp"
#include "mjcf/text/text_scan.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// Offset of the first byte of a line, counted from 1.
std::size_t begin_of_line(std::string_view text, int line) {
  std::size_t at = 0;
  for (int k = 1; k < line; ++k) {
    const std::size_t end = text.find('\n', at);
    if (end == std::string_view::npos) break;
    at = end + 1;
  }
  return at;
}

/// The segment to which a byte of the one text belongs.
const TextSegment& segment_at(const std::vector<TextSegment>& segments, std::size_t at) {
  const TextSegment* own = &segments.front();
  for (const TextSegment& segment : segments)
    if (segment.begin <= at) own = &segment;
  return *own;
}

int line_at(std::string_view text, std::size_t at) {
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<long>(at), '\n'));
}

/// Digits behind "line " at `at`; 0 if there are none.
int number_at(std::string_view text, std::size_t at, std::size_t& end) {
  int number = 0;
  for (end = at; end < text.size() && text[end] >= '0' && text[end] <= '9' && number < 100000000;
       ++end)
    number = 10 * number + (text[end] - '0');
  return number;
}

/// Whether two texts have as many start tags and the same bytes before, between and behind them.
bool is_same_between(std::string_view a, const TagScan& in_a, std::string_view b,
                     const TagScan& in_b) {
  if (in_a.tags.size() != in_b.tags.size()) return false;
  std::size_t at_a = 0, at_b = 0;
  for (std::size_t k = 0; k < in_a.tags.size(); ++k) {
    const TagSpan &tag_a = in_a.tags[k], &tag_b = in_b.tags[k];
    if (tag_a.name != tag_b.name ||
        a.substr(at_a, tag_a.begin - at_a) != b.substr(at_b, tag_b.begin - at_b))
      return false;
    at_a = tag_a.end;
    at_b = tag_b.end;
  }
  return a.substr(at_a) == b.substr(at_b);
}

}  // namespace

RobotFiles RobotFiles::read(const fs::path& file, const FileReach& reach) {
  return from_text(read_main_file(file), file, reach);
}

RobotFiles RobotFiles::from_text(std::string text, const fs::path& file, const FileReach& reach) {
  RobotFiles out;
  out.file_ = file;
  out.reach_ = reach;
  SplicedText spliced = splice_includes(std::move(text), file, reach);
  out.gathered_ = spliced.gathered;
  out.parts_ = std::move(spliced.parts);
  out.text_ = std::move(spliced.text);
  out.segments_ = std::move(spliced.segments);
  out.mentions_ = std::move(spliced.mentions);
  if (out.parts_.size() > 1)
    out = out.at_their_lines([&] {
      const auto beside = [&](std::size_t at) {
        return out.parts_[segment_at(out.segments_, at).part].path.parent_path();
      };
      return out.with_attributes(
          named_from_main_folder(*load_xml(out.text_, file), out.folder(), reach, beside));
    });
  out.at_their_lines([&] {
    const auto xml = spliced.main ? std::move(spliced.main) : load_xml(out.text_, file);
    for (FoundAsset& asset : find_assets(*xml, out.folder(), reach)) {
      const InputError place = out.located(xml->error(*asset.element, ""));
      for (std::size_t k = 1; k < out.parts_.size(); ++k)
        if (out.parts_[k].path == asset.file.path)
          throw xml->error(*asset.element,
                           fmt::format("the file '{}' is included as well; a copy of the robot "
                                       "could not change it as MJCF and keep it here",
                                       asset.file.path.string()));
      out.gathered_ = out.gathered_ && asset.gathered;
      out.mentions_.push_back(
          {asset.file.path, asset.file.source, place.file(), place.line(), place.where()});
      out.assets_.push_back(std::move(asset.file));
    }
  });
  for (const FileMention& mention : out.mentions_)
    if (needed_by_runs(mention.path)) out.gathered_ = false;
  out.sort_assets();
  return out;
}

void RobotFiles::sort_assets() {
  std::sort(assets_.begin(), assets_.end(),
            [](const AssetFile& a, const AssetFile& b) { return a.path < b.path; });
  const auto last = std::unique(assets_.begin(), assets_.end(),
                                [](const auto& a, const auto& b) { return a.path == b.path; });
  assets_.erase(last, assets_.end());
}

RobotFiles RobotFiles::with_text(const std::string& text) const {
  const std::vector<TextRange> added = find_added_meshes(text_, text);
  if (added.empty()) return with_attributes(text);
  RobotFiles out = with_attributes(without(text, added));
  put_back(added, text, out.parts_, out.segments_);
  out.text_ = text;
  return out;
}

RobotFiles RobotFiles::with_attributes(const std::string& text) const {
  RobotFiles out = *this;
  out.text_ = text;
  if (parts_.size() == 1) {
    out.parts_.front().text = text;
    out.segments_ = {{0, text.size(), 0, 0}};
    return out;
  }
  const TagScan before = scan_tags(text_), after = scan_tags(text);
  const auto fail = [] {
    return std::logic_error("the changed text has other elements than the robot's files");
  };
  if (!is_same_between(text_, before, text, after)) throw fail();
  // Only start tags change, so the bytes since the last one tell where a segment ends.
  std::size_t tag = 0;
  const auto moved = [&](std::size_t at) {
    while (tag < before.tags.size() && before.tags[tag].end <= at) ++tag;
    return tag == 0 ? at : after.tags[tag - 1].end + (at - before.tags[tag - 1].end);
  };
  std::vector<std::string> texts(parts_.size());
  std::vector<std::size_t> copied(parts_.size(), 0);  // of the old text of each file
  std::string whole;
  for (std::size_t k = 0; k < segments_.size(); ++k) {
    const TextSegment& old = segments_[k];
    TextSegment& own = out.segments_[k];
    own.begin = moved(old.begin);
    const std::size_t end = moved(old.begin + old.size);
    if (end < own.begin || end > text.size()) throw fail();
    own.size = end - own.begin;
    std::string& file = texts[old.part];
    file.append(parts_[old.part].text, copied[old.part], old.source - copied[old.part]);
    copied[old.part] = old.source + old.size;
    own.source = file.size();
    file.append(text, own.begin, own.size);
    whole.append(k == 0 ? "" : "\n").append(text, own.begin, own.size);
  }
  if (whole != text) throw fail();
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    texts[part].append(parts_[part].text, copied[part], std::string::npos);
    out.parts_[part].text = std::move(texts[part]);
  }
  return out;
}

RobotFiles RobotFiles::moved_to(const fs::path& file) const {
  RobotFiles out = gathered();
  out.file_ = file;
  for (AssetFile& asset : out.assets_) {
    asset.source = file.parent_path() / asset.path;
    asset.may_link = true;
  }
  return out;
}

RobotFiles::Place RobotFiles::place_of(int line) const {
  const std::size_t at = begin_of_line(text_, line);
  const TextSegment& own = segment_at(segments_, at);
  const IncludedFile& part = parts_[own.part];
  return {own.part == 0 ? file_ : source_of(folder(), part.path),
          line_at(part.text, std::min(part.text.size(), own.source + (at - own.begin)))};
}

InputError RobotFiles::located(const InputError& error) const {
  if (!error.reasons().empty()) {
    std::vector<InputError> reasons;
    for (const InputError& reason : error.reasons()) reasons.push_back(located(reason));
    return InputError(std::move(reasons));
  }
  if (parts_.size() == 1 || error.line() <= 0 || error.file() != file_.string()) return error;
  const Place place = place_of(error.line());
  // Lines that the message names belong to the same text.
  std::string words;
  const std::string& message = error.message();
  std::size_t copied = 0;
  for (std::size_t at = message.find("line "); at != std::string::npos;
       at = message.find("line ", at + 1)) {
    std::size_t end = 0;
    const int line = number_at(message, at + 5, end);
    if (line == 0) continue;
    const Place other = place_of(line);
    words.append(message, copied, at - copied);
    words += fmt::format("line {}", other.line);
    if (other.file != place.file) words += " of " + other.file.string();
    copied = end;
  }
  words.append(message, copied, std::string::npos);
  return InputError(place.file.string(), place.line, error.where(), words);
}

}  // namespace legwright
