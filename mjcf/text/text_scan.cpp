// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/text_scan.hpp"

#include <algorithm>

namespace legwright {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";
constexpr std::string_view kNameEnd = " \t\r\n/>=<\"'";

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  TagScan run() {
    while (step()) {
    }
    return std::move(scan_);
  }

 private:
  /// One piece of markup; false at the end.
  bool step() {
    at_ = text_.find('<', at_);
    if (at_ == std::string_view::npos) return false;
    if (starts("<!--")) return skip_past("-->");
    if (starts("<![CDATA[")) return skip_past("]]>");
    if (starts("<?")) return skip_past("?>");
    if (starts("<!")) {
      if (scan_.doctype_line == 0) scan_.doctype_line = line();
      return skip_past(">");
    }
    const std::size_t markup = at_++;
    skip_blanks();
    if (at_ < text_.size() && text_[at_] == '/') return end_tag(markup);
    return start_tag(markup);
  }

  bool end_tag(std::size_t markup) {
    --depth_;
    if (!skip_past(">")) return false;
    if (open_.empty()) return true;  // one too many: the parser will say so
    scan_.tags[open_.back()].close_begin = markup;
    scan_.tags[open_.back()].close_end = at_;
    open_.pop_back();
    return true;
  }

  bool start_tag(std::size_t markup) {
    const std::size_t begin = at_;
    at_ = std::min(text_.find_first_of(kNameEnd, at_), text_.size());
    if (at_ == begin) return stop();
    TagSpan tag{text_.substr(begin, at_ - begin), at_, line(), depth_ + 1, {}, markup};
    while (true) {
      const std::size_t before = at_;
      skip_blanks();
      if (at_ >= text_.size()) return stop();
      if (text_[at_] == '>' || text_[at_] == '/') break;
      if (!attribute(before, tag)) return stop();
    }
    const bool is_open = text_[at_] == '>';
    if (!is_open && text_.compare(at_, 2, "/>") != 0) return stop();
    at_ += is_open ? 1 : 2;
    tag.end = tag.close_begin = tag.close_end = at_;
    if (is_open) {
      ++depth_;
      open_.push_back(scan_.tags.size());
    }
    scan_.tags.push_back(std::move(tag));
    return true;
  }

  bool attribute(std::size_t before, TagSpan& tag) {
    const std::size_t name = at_;
    at_ = std::min(text_.find_first_of(kNameEnd, at_), text_.size());
    const std::size_t name_end = at_;
    skip_blanks();
    if (name == name_end || at_ >= text_.size() || text_[at_] != '=') return false;
    ++at_;
    skip_blanks();
    if (at_ >= text_.size() || (text_[at_] != '"' && text_[at_] != '\'')) return false;
    const char quote = text_[at_];
    const std::size_t close = text_.find(quote, at_ + 1);
    if (close == std::string_view::npos) return false;
    tag.attributes.push_back(
        {text_.substr(name, name_end - name), before, close + 1, at_ + 1, close, quote});
    at_ = close + 1;
    return true;
  }

  bool starts(std::string_view mark) const { return text_.compare(at_, mark.size(), mark) == 0; }
  void skip_blanks() { at_ = std::min(text_.find_first_not_of(kBlanks, at_), text_.size()); }

  bool skip_past(std::string_view mark) {
    const std::size_t found = text_.find(mark, at_);
    if (found == std::string_view::npos) return stop();
    at_ = found + mark.size();
    return true;
  }

  bool stop() {
    scan_.stopped_line = line();
    return false;
  }

  /// Line of the current place; counts on from the last call, which was never further on.
  int line() {
    const std::size_t end = std::min(at_, text_.size());
    line_ += static_cast<int>(std::count(text_.begin() + counted_, text_.begin() + end, '\n'));
    counted_ = end;
    return line_;
  }

  std::string_view text_;
  std::size_t at_ = 0, counted_ = 0;
  int line_ = 1, depth_ = 0;
  std::vector<std::size_t> open_;  // elements whose end tag is to come
  TagScan scan_;
};

}  // namespace

TagScan scan_tags(std::string_view text) { return Scanner(text).run(); }

}  // namespace legwright
