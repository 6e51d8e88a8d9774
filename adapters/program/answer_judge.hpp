// Was a program's answer to the question what it is an answer at all?
#pragma once

#include "adapters/process/question.hpp"

#include <optional>
#include <string>

namespace crossgrain::adapters {

/// Why it is none, e.g. "was killed by signal 11", or "does not run: " and the loader's own words;
/// nothing if the program ended by itself. Then its exit status says little: LIGGGHTS exits with 1
/// from its own help.
[[nodiscard]] std::optional<std::string> why_no_answer(const process::Answer& answer);

/// " (exit status 1: 'first line that it printed')", for an answer that means nothing to us;
/// empty if the program ended well.
[[nodiscard]] std::string last_words(const process::Answer& answer);

}  // namespace crossgrain::adapters
