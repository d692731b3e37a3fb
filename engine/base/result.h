// SPDX-License-Identifier: MIT
// Errors are values: what went wrong, where, and what the user can do about it.
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace svoscope {

/// The kind decides the exit code of the program (docs/commands.md).
enum class ErrorKind { internal = 1, usage = 2, input = 3, output = 4 };

struct Error {
  ErrorKind kind = ErrorKind::internal;
  std::string what;    ///< what is wrong: "rgb.txt is missing"
  std::string where;   ///< the file, line, option or stage it concerns
  std::string remedy;  ///< what to do: "a TUM folder needs rgb.txt, rgb/ and camera.yaml"

  int exitCode() const { return static_cast<int>(kind); }

  /// One line for logs and toasts: "where: what (remedy)".
  std::string message() const {
    std::string text = where.empty() ? what : where + ": " + what;
    if (!remedy.empty()) text += " (" + remedy + ")";
    return text;
  }
};

inline Error inputError(std::string what, std::string where, std::string remedy) {
  return {ErrorKind::input, std::move(what), std::move(where), std::move(remedy)};
}
inline Error outputError(std::string what, std::string where, std::string remedy) {
  return {ErrorKind::output, std::move(what), std::move(where), std::move(remedy)};
}
inline Error usageError(std::string what, std::string where, std::string remedy) {
  return {ErrorKind::usage, std::move(what), std::move(where), std::move(remedy)};
}

/// A value or the error that kept it from being made. Reading the wrong side throws
/// std::bad_variant_access: check with ok() first.
template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : data_(std::move(value)) {}      // NOLINT: implicit by design
  Result(Error error) : data_(std::move(error)) {}  // NOLINT: implicit by design

  bool ok() const { return std::holds_alternative<T>(data_); }
  explicit operator bool() const { return ok(); }

  const T& value() const& { return std::get<T>(data_); }
  T& value() & { return std::get<T>(data_); }
  T&& value() && { return std::get<T>(std::move(data_)); }
  const Error& error() const { return std::get<Error>(data_); }

 private:
  std::variant<T, Error> data_;
};

/// Result of an action that yields nothing on success.
struct Done {};
using Status = Result<Done>;

}  // namespace svoscope
