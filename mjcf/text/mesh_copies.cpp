// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/mesh_copies.hpp"

#include <set>

#include "mjcf/text/text_scan.hpp"

namespace legwright {
namespace {

/// The value of `name` as it is written; empty where there is none.
std::string_view name_in(std::string_view text, const TagSpan& tag) {
  for (const AttributeSpan& span : tag.attributes)
    if (span.name == "name")
      return text.substr(span.value_begin, span.value_end - span.value_begin);
  return {};
}

}  // namespace

std::vector<TextRange> find_added_meshes(std::string_view before, std::string_view after) {
  std::set<std::string_view> known;
  const TagScan old = scan_tags(before), now = scan_tags(after);
  for (const TagSpan& tag : old.tags)
    if (tag.name == "mesh") known.insert(name_in(before, tag));
  std::vector<TextRange> out;
  for (const TagSpan& tag : now.tags) {
    if (tag.name != "mesh" || name_in(after, tag).empty() || known.count(name_in(after, tag)))
      continue;
    const std::size_t last = after.substr(0, tag.begin).find_last_not_of(" \t\r\n");
    out.push_back({last == std::string_view::npos ? 0 : last + 1, tag.close_end});
  }
  return out;
}

std::string without(const std::string& text, const std::vector<TextRange>& ranges) {
  std::string out;
  std::size_t copied = 0;
  for (const TextRange& range : ranges) {
    out.append(text, copied, range.begin - copied);
    copied = range.end;
  }
  return out.append(text, copied, std::string::npos);
}

void put_back(const std::vector<TextRange>& ranges, const std::string& text,
              std::vector<IncludedFile>& parts, std::vector<TextSegment>& segments) {
  // In order: when a range's turn comes, the text before it is whole again, so its place holds.
  for (const TextRange& range : ranges) {
    const std::size_t size = range.end - range.begin;
    for (std::size_t k = 0; k < segments.size(); ++k) {
      TextSegment& own = segments[k];
      if (!(own.begin < range.begin && range.begin <= own.begin + own.size)) continue;
      const std::size_t at = own.source + (range.begin - own.begin);
      parts[own.part].text.insert(at, text, range.begin, size);
      for (std::size_t other = 0; other < segments.size(); ++other) {
        if (other == k) continue;
        if (segments[other].begin >= range.begin) segments[other].begin += size;
        if (segments[other].part == own.part && segments[other].source >= at)
          segments[other].source += size;
      }
      own.size += size;
      break;
    }
  }
}

}  // namespace legwright
