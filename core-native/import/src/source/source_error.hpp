#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "echoway/import/report.hpp"
#include "echoway/result.hpp"

namespace echoway::import {

/// A plan that cannot become a building. Thrown inside the importer only; its facade returns the Error.
class SourceError : public std::runtime_error {
 public:
  explicit SourceError(Error error) : std::runtime_error(error.to_string()), error_(std::move(error)) {}
  SourceError(const Source& source, const std::string& what)
      : SourceError(Error{source.id.empty() ? what : "feature " + source.id + ": " + what, source.file, 0}) {}

  [[nodiscard]] const Error& error() const noexcept { return error_; }

 private:
  Error error_;
};

}  // namespace echoway::import
