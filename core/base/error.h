// Errors as values. A message names the thing, its value and what was expected.
// Stability: stable since 0.1
#pragma once

#include <string>
#include <utility>

#include <tl/expected.hpp>

#include "core/base/message.h"

namespace fyd {

struct Error {
  Message message;

  [[nodiscard]] std::string text() const { return message.text(); }  ///< in English
};

template <class T>
using Result = tl::expected<T, Error>;

/// Makes the failed side of a Result from a format string: `return fail("{}: …", name);`
template <class... Args>
[[nodiscard]] tl::unexpected<Error> fail(MessageFormat<Args...> format, Args&&... args) {
  return tl::unexpected<Error>(Error{say<Args...>(format, std::forward<Args>(args)...)});
}
[[nodiscard]] inline tl::unexpected<Error> fail(Message message) {
  return tl::unexpected<Error>(Error{std::move(message)});
}

}  // namespace fyd
