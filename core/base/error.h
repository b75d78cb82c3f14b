// Errors as values. A message names the thing, its value and what was expected.
#pragma once

#include <string>
#include <utility>

#include <fmt/format.h>
#include <tl/expected.hpp>

namespace fyd {

struct Error {
  std::string message;
};

template <class T>
using Result = tl::expected<T, Error>;

/// Makes the failed side of a Result from a format string: `return fail("{}: …", name);`
template <class... Args>
[[nodiscard]] tl::unexpected<Error> fail(fmt::format_string<Args...> format, Args&&... args) {
  return tl::unexpected<Error>(Error{fmt::format(format, std::forward<Args>(args)...)});
}

}  // namespace fyd
