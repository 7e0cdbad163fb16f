// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <string>

#include "mjcf/text/input_error.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {

/// The value of a key that must be there. Throws InputError.
template <class T>
T needed(const Json& body, const char* key) {
  if (!body.is_object() || !body.contains(key))
    throw InputError(std::string("the body has no '") + key + "', which is needed");
  try {
    return body.at(key).get<T>();
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
