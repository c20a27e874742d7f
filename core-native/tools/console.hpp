#pragma once

#include <cstdio>
#include <initializer_list>
#include <string>
#include <string_view>

#include "echoway/result.hpp"

namespace echoway::tools {

inline constexpr int kDone = 0;
inline constexpr int kInternalError = 1;
inline constexpr int kBadInput = 2;  // or bad usage

/// Writes a line to standard error, as well as it can be: a tool that cannot complain still ends with its status.
void complain(const std::string& line) noexcept;

/// Complains of `error` and gives the exit status for bad input.
int bad_input(const Error& error) noexcept;

/// Where a command says what it did: on standard output, but on standard error when one of the `files` that it writes
/// is standard output (`--track /dev/stdout`), whose rows its words would spoil.
std::FILE* words_beside(std::initializer_list<std::string_view> files);

/// Whether everything that was printed has left: a full disk behind a redirection is an error like any other.
bool flush_output() noexcept;

}  // namespace echoway::tools
