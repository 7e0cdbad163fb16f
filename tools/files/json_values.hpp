// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <limits>
#include <string>
#include <type_traits>

#include "mjcf/text/input_error.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {

/// The value of a key that must be there, whole where T is. Throws InputError.
template <class T>
T needed(const Json& body, const char* key) {
  if (!body.is_object() || !body.contains(key))
    throw InputError(std::string("the body has no '") + key + "', which is needed");
  const Json& found = body.at(key);
  if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>) {
    using Limits = std::numeric_limits<T>;
    if (!found.is_number_integer() || found < Limits::min() || found > Limits::max())
      throw InputError(std::string("'") + key + "' is " + to_line(found) +
                       "; expected a whole number");
  }
  try {
    return found.get<T>();
  } catch (const std::exception& error) {
    throw InputError(std::string("'") + key + "': " + error.what());
  }
}

/// The value of a key, or another where there is none or null. Throws InputError.
template <class T>
T given_or(const Json& body, const char* key, T otherwise) {
  if (!body.is_object() || !body.contains(key) || body.at(key).is_null()) return otherwise;
  return needed<T>(body, key);
}

}  // namespace legwright
