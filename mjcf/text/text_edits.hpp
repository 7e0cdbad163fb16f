// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <string_view>

#include "mjcf/text/xml.hpp"

namespace legwright {

/// An attribute's value as XML text: & and < as entities, and each quote that is one of `quotes`.
std::string escape_xml(std::string_view value, std::string_view quotes = "\"'");

/// Changes of attributes, applied to the text itself: every byte outside of them stays.
class TextEdits {
 public:
  explicit TextEdits(const XmlFile& xml) : xml_(xml) {}

  /// Sets an attribute's value; adds the attribute behind the last one where the element has none.
  void set(const XmlElement& element, const char* name, const std::string& value);
  /// Sets a list of numbers to what they are rounded to (numbers.hpp); words whose number rounds to
  /// the same keep their text and blanks.
  void set_numbers(const XmlElement& element, const char* name,
                   const Eigen::Ref<const Eigen::VectorXd>& values);
  /// The same, but writes each number so that it reads back as the same double.
  void set_exactly(const XmlElement& element, const char* name,
                   const Eigen::Ref<const Eigen::VectorXd>& values);
  /// Puts a copy of an element that holds no others behind it, with some attributes set.
  void copy_behind(const XmlElement& element, std::map<std::string, std::string> values);
  /// Removes an attribute and the blank before it; nothing happens where there is none.
  void remove(const XmlElement& element, const char* name);
  /// The edited text.
  std::string apply() const;

 private:
  struct Edit {
    std::size_t end;
    std::string text;
  };
  void set_words(const XmlElement& element, const char* name,
                 const Eigen::Ref<const Eigen::VectorXd>& values, double (*written)(double));
  void replace(std::size_t begin, std::size_t end, std::string text, bool append = false);

  const XmlFile& xml_;
  std::map<std::size_t, Edit> edits_;  // by first byte
};

}  // namespace legwright
