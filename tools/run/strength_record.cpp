// SPDX-License-Identifier: Apache-2.0
#include "tools/run/strength_record.hpp"

namespace legwright {

void fields(Fields& f, PartStrength& part) {
  f("part", part.part);
  f("load", part.load, "\"bears the gait\", \"bears its servo\", \"peg bears the gait\"");
  f.nullable("factor", part.factor, "strength over the largest stress; null: not judged");
  f.nullable("least_factor", part.least_factor, "that passes");
  f("where", part.where, "stressed most, and when; or why it was not judged");
  f("pass", part.pass);
}

void fields(Fields& f, StrengthRecord& strength) {
  f("strength_MPa", strength.strength, "of the printed material across its layers");
  f("parts", strength.parts);
}

}  // namespace legwright
