// SPDX-License-Identifier: Apache-2.0
// Inputs that libFuzzer kept or found: each keeps the promises of its reader.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "tests/fuzz/promises.hpp"
#include "tests/fuzz/targets.hpp"
#include "tests/support/paths.hpp"
#include "tools/files/atomic_file.hpp"

namespace legwright {
namespace {

struct CorpusOf {
  const char* name;
  bool (*target)(std::string_view);
};

class Corpus : public testing::TestWithParam<CorpusOf> {};

TEST_P(Corpus, KeepsThePromisesOfItsReader) {
  const std::filesystem::path folder =
      std::filesystem::path(test::source_dir()) / "tests/fuzz/corpus" / GetParam().name;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  int counts[2] = {0, 0};
  for (const auto& file : files)
    EXPECT_NO_THROW(++counts[GetParam().target(read_file(file))]) << file.string();
  // A corpus of nothing but refusals would prove little.
  EXPECT_GT(counts[false], 2);
  EXPECT_GT(counts[true], 2);
}

INSTANTIATE_TEST_SUITE_P(
    Fuzz, Corpus,
    testing::Values(CorpusOf{"numbers", test::fuzz_numbers}, CorpusOf{"toml", test::fuzz_toml},
                    CorpusOf{"json", test::fuzz_json}, CorpusOf{"journal", test::fuzz_journal},
                    CorpusOf{"trajectory", test::fuzz_trajectory},
                    CorpusOf{"robot", test::fuzz_robot}, CorpusOf{"collada", test::fuzz_collada},
                    CorpusOf{"urdf", test::fuzz_urdf}),
    [](const auto& of) { return std::string(of.param.name); });

/// A target that is blind would find nothing.
TEST(CorpusPromises, ThatAreBrokenAreFindings) {
  const auto refuse = [](const char* file, const char* why) {
    test::accepted("robot.xml", [&] { throw InputError(file, 3, "body", why); });
  };
  EXPECT_NO_THROW(refuse("robot.xml", "has no mass; give it one"));
  EXPECT_THROW(refuse("other.xml", "has no mass; give it one"), test::Finding);
  EXPECT_THROW(refuse("robot.xml", ""), test::Finding);
  EXPECT_THROW(test::accepted("robot.xml", [] { throw std::out_of_range("map::at"); }),
               std::out_of_range);
}

}  // namespace
}  // namespace legwright
