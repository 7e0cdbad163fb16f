// SPDX-License-Identifier: Apache-2.0
#include "tools/run/checkpoint_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <system_error>
#include <utility>

#include "tools/files/atomic_file.hpp"
#include "tools/files/checksum.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBegin = "begin.json";
constexpr const char* kStates = "states.bin";
constexpr std::size_t kSumBytes = 8;                            // CRC-32 of what follows, in hex
constexpr std::size_t kMostFileBytes = std::size_t{4} << 30;    // of a file
constexpr std::size_t kSpareBytes = std::size_t{64} << 20;      // that superseded states may take
constexpr std::uint64_t kMostNumbers = std::uint64_t{1} << 28;  // of a state

/// Length of the name and count of the numbers, before both.
struct Head {
  std::uint64_t name = 0, numbers = 0;
};

std::string sum_of(std::string_view bytes) { return crc32_hex(bytes); }

std::string bytes_of(const std::string& name, const std::vector<double>& state) {
  const Head head{name.size(), state.size()};
  std::string body(reinterpret_cast<const char*>(&head), sizeof head);
  body += name;
  body.append(reinterpret_cast<const char*>(state.data()), state.size() * sizeof(double));
  return sum_of(body) + body;
}

/// Takes a state off the front. @return false where there is no whole one
bool take_state(std::string_view& rest, CheckpointStates& states) {
  constexpr std::size_t kFixed = kSumBytes + sizeof(Head);
  if (rest.size() < kFixed) return false;
  Head head;
  std::memcpy(&head, rest.data() + kSumBytes, sizeof head);
  if (head.name > rest.size() || head.numbers > kMostNumbers) return false;
  const std::size_t whole = kFixed + head.name + head.numbers * sizeof(double);
  if (whole > rest.size()) return false;
  if (rest.substr(0, kSumBytes) != sum_of(rest.substr(kSumBytes, whole - kSumBytes))) return false;
  std::vector<double> state(head.numbers);
  if (!state.empty())
    std::memcpy(state.data(), rest.data() + kFixed + head.name, head.numbers * sizeof(double));
  states[std::string(rest.substr(kFixed, head.name))] = std::move(state);
  rest.remove_prefix(whole);
  return true;
}

[[noreturn]] void fail(const fs::path& path) {
  throw std::system_error(errno, std::generic_category(), "cannot write " + path.string());
}

}  // namespace

void fields(Fields& f, CheckpointBegin& begin) {
  f("folder", begin.folder, "in which the process worked: paths in the options start there");
  f("options", begin.options, "of the verb, each as JSON");
  f("versions", begin.versions, "of the program that searched");
  f("factor", begin.factor, "how Hessians are factored: last bits depend on it");
  f("inputs", begin.inputs, "CRC-32 of the files of task and robot");
}

ByName<std::string> sums_of_inputs(const fs::path& run) {
  ByName<std::string> sums;
  std::error_code ignored;
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(run / "inputs"))
    if (entry.is_regular_file(ignored)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files)
    sums.of(file.lexically_relative(run).generic_string()) =
        crc32_hex(read_file(file, kMostFileBytes));
  return sums;
}

fs::path checkpoint_folder(const fs::path& run) { return run / "checkpoint"; }

bool has_checkpoint(const fs::path& run) {
  std::error_code error;
  return fs::exists(checkpoint_folder(run) / kBegin, error);
}

fs::file_time_type last_kept(const fs::path& run) {
  return fs::last_write_time(checkpoint_folder(run) / kStates);
}

std::optional<ReadCheckpoint> read_checkpoint(const fs::path& run) {
  if (!has_checkpoint(run)) return std::nullopt;
  const fs::path folder = checkpoint_folder(run);
  ReadCheckpoint out;
  out.begin = read_record_file<CheckpointBegin>(folder / kBegin);
  if (!fs::exists(folder / kStates)) return out;
  const std::string bytes = read_file(folder / kStates, kMostFileBytes);
  std::string_view rest = bytes;
  while (take_state(rest, out.states)) {
  }
  return out;
}

CheckpointFile::CheckpointFile(const fs::path& run, const CheckpointBegin& begin,
                               CheckpointStates earlier)
    : folder_(checkpoint_folder(run)), earlier_(std::move(earlier)), latest_(earlier_) {
  fs::create_directories(folder_);
  write_anew();
  write_file(folder_ / kBegin, json_of(begin).dump(2) + "\n", Durability::process);
}

CheckpointFile::~CheckpointFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::vector<double> CheckpointFile::find(const std::string& name) {
  const auto found = earlier_.find(name);
  return found == earlier_.end() ? std::vector<double>() : found->second;
}

void CheckpointFile::keep(const std::string& name, const std::vector<double>& state) {
  const std::string bytes = bytes_of(name, state);
  const std::lock_guard lock(mutex_);
  auto& latest = latest_[name];
  latest_bytes_ += state.size() * sizeof(double);
  latest_bytes_ -= latest.size() * sizeof(double);
  latest = state;
  if (file_bytes_ > kSpareBytes + 2 * latest_bytes_) return write_anew();
  append(bytes);
}

void CheckpointFile::remove() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void CheckpointFile::write_anew() {
  std::string bytes;
  latest_bytes_ = 0;
  for (const auto& [name, state] : latest_) {
    bytes += bytes_of(name, state);
    latest_bytes_ += state.size() * sizeof(double);
  }
  write_file(folder_ / kStates, bytes, Durability::process);
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = ::open((folder_ / kStates).c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (descriptor_ < 0) fail(folder_ / kStates);
  file_bytes_ = bytes.size();
}

void CheckpointFile::append(const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t written = ::write(descriptor_, bytes.data() + done, bytes.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(folder_ / kStates);
    done += static_cast<std::size_t>(written);
  }
  file_bytes_ += bytes.size();
}

}  // namespace legwright
