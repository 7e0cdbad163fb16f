// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/recent_models.hpp"

#include <algorithm>

#include "mjcf/text/assets.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

ModelPointer RecentModels::find(const std::string& xml, const std::filesystem::path& file) {
  const std::lock_guard lock(mutex_);
  for (const Kept& each : kept_)
    if (each.xml == xml && each.file == file &&
        std::all_of(each.files.begin(), each.files.end(),
                    [](const auto& named) { return state_of(named.first) == named.second; }))
      return ModelPointer(mj_copyModel(nullptr, each.model.get()));
  return nullptr;
}

void RecentModels::keep(const std::string& xml, const std::filesystem::path& file,
                        const mjModel& model) {
  States files;
  const auto text = load_xml(xml, file);
  for (const AssetReference& reference : asset_references(*text)) {
    const std::string path = (file.parent_path() / reference.path).string();
    files.emplace_back(path, state_of(path));
  }
  ModelPointer copy(mj_copyModel(nullptr, &model));
  if (!copy) return;
  const std::lock_guard lock(mutex_);
  if (kept_.size() == kKept) kept_.pop_front();
  kept_.push_back({xml, file, std::move(files), std::move(copy)});
}

}  // namespace legwright
