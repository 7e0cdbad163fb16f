// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace legwright {

/// Whether the process has not been told yet of this reason about this subject, which is remembered
/// then. The same sentence with other numbers is the same reason: randomised models come by the
/// thousand. Never true again once a thousand reasons were told. For any thread.
bool first_told(std::string_view subject, std::string_view reason) noexcept;

}  // namespace legwright
