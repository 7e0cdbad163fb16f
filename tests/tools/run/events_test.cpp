// SPDX-License-Identifier: Apache-2.0
#include "tools/run/events.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <system_error>

#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/checksum.hpp"

namespace legwright {
namespace {

using test::TemporaryFolder;

Json event(int index) { return {{"event", "iteration"}, {"index", index}, {"F", 0.1 * index}}; }

void overwrite(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << text;
}

TEST(EventLine, CarriesTheCrcOfTheLineWithoutIt) {
  const std::string body = "{\"event\":\"start\",\"n\":3}";
  const std::string line = event_line({{"event", "start"}, {"n", 3}});
  EXPECT_EQ(line, body.substr(0, body.size() - 1) + ",\"crc\":\"" + crc32_hex(body) + "\"}");
  EXPECT_TRUE(Json::accept(line));
}

TEST(EventLog, GivesBackWhatWasAppended) {
  const TemporaryFolder folder;
  {
    EventLog log(folder.path() / "events.jsonl");
    for (int i = 0; i < 3; ++i) log.append(event(i));
    log.sync();
  }
  const std::vector<Json> events = read_events(folder.path() / "events.jsonl");
  ASSERT_EQ(events.size(), 3u);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(events[i], event(i));
}

TEST(EventLog, NeverWritesOverAnExistingLog) {
  const TemporaryFolder folder;
  overwrite(folder.path() / "events.jsonl", "old\n");
  EXPECT_THROW(EventLog(folder.path() / "events.jsonl"), std::system_error);
  EXPECT_EQ(read_file(folder.path() / "events.jsonl"), "old\n");
}

TEST(ReadEvents, CutsATornTailAtEveryByte) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "events.jsonl";
  const std::string whole = event_line(event(0)) + "\n" + event_line(event(1)) + "\n";
  const std::size_t first = event_line(event(0)).size() + 1;
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    overwrite(path, whole.substr(0, size));
    EXPECT_EQ(read_events(path).size(), size < first ? 0u : size < whole.size() ? 1u : 2u) << size;
  }
}

TEST(ReadEvents, StopsAtADamagedLine) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "events.jsonl";
  std::string text =
      event_line(event(0)) + "\n" + event_line(event(1)) + "\n" + event_line(event(2)) + "\n";
  text[event_line(event(0)).size() + 12] ^= 1;  // in the second line
  overwrite(path, text);
  EXPECT_EQ(read_events(path).size(), 1u);
}

}  // namespace
}  // namespace legwright
