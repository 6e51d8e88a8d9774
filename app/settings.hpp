// What the command line decides about a call.
#pragma once

#include "adapters/run/settings.hpp"

#include <string>
#include <vector>

namespace crossgrain::app {

struct Printing {
    bool json = false;
    bool quiet = false;
};

struct Settings : run::Settings, Printing {};

/// "crossgrain" with the arguments, for people to read and to copy: what a shell would not take as
/// one word is quoted, what cannot be shown is escaped (printable.hpp), long arguments are cut.
[[nodiscard]] std::string command_text(const std::vector<std::string>& arguments);

}  // namespace crossgrain::app
