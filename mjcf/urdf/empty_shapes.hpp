// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mjcf/text/xml.hpp"

namespace legwright {

/// Shapes of size zero, which MuJoCo refuses: exporters write them for what has none. Of what may
/// touch a ball without radius is a point of contact, and becomes one of a millimetre; what else
/// is empty is left out, as is what may only be seen.
class EmptyShapes {
 public:
  /// Mends a <visual> or <collision>. @return whether it has to be left out
  bool mend(XmlElement& shape, const XmlElement& link, bool only_seen);
  /// Adds a sentence for each kind.
  void tell(std::vector<std::string>& notes) const;

 private:
  std::vector<std::string> left_out_, points_;  // links, once each
};

}  // namespace legwright
