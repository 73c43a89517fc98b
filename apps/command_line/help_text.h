// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What --help prints.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace clothfit {

// Description, usage, arguments, options by groups with their defaults, commands by groups, footer;
// no line longer than 80 characters where words can be broken. `name` is the command as it was
// called: "clothfit import markers".
std::string HelpText(const CLI::App* command, const std::string& name, CLI::AppFormatMode mode);

// "-o, --output RUN"; of an argument "RECORDING" or "FILE ...".
std::string OptionLabel(const CLI::Option& option);

}  // namespace clothfit
