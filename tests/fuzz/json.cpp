// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/promises.hpp"
#include "tests/fuzz/targets.hpp"
#include "tools/files/parse_json.hpp"

namespace legwright::test {

bool fuzz_json(std::string_view text) {
  const Json document = parse_json(text);
  if (document.is_discarded()) return false;
  promise(parse_json(to_text(document)) == document, "a document is another when read again");
  promise(parse_json(to_line(document)) == document, "a line is another when read again");
  promise(to_line(document).find('\n') == std::string::npos, "a line has several");
  return true;
}

}  // namespace legwright::test
