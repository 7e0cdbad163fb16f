// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace legwright {

/// Where an attribute stands in a text, as byte offsets: [begin, end) from the blank before its
/// name to behind its closing quote, [value_begin, value_end) between the quotes.
struct AttributeSpan {
  std::string_view name;
  std::size_t begin, end, value_begin, value_end;
  char quote;
};

/// Where a start tag stands in a text.
struct TagSpan {
  std::string_view name;
  std::size_t name_end;  // where a new first attribute would go
  int line;              // 1-based
  int depth;             // of the element; the root has 1
  std::vector<AttributeSpan> attributes;
  std::size_t begin = 0, end = 0;  // the start tag, from its < to behind its >
  std::size_t close_begin = 0;     // the end tag's <; `end` for an element without content
  std::size_t close_end = 0;       // behind the end tag's >; `end` for an element without content
};

/// What a scan found: start tags in document order, the order of a depth-first walk of the DOM.
struct TagScan {
  std::vector<TagSpan> tags;
  int doctype_line = 0;  // line of the first <!DOCTYPE or other declaration; 0: none
  int stopped_line = 0;  // where the scan met text that is no XML; 0: it reached the end
};

/// Finds the start tags of an XML text and the byte ranges of their attributes, which a DOM does
/// not keep. It is no parser: it trusts that the text is well formed and stops where that is
/// obviously untrue. The views point into `text`.
TagScan scan_tags(std::string_view text);

}  // namespace legwright
