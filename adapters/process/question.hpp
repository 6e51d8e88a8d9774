// What does a program say about itself?
#pragma once

#include "adapters/process/process.hpp"

#include <stop_token>
#include <string>
#include <vector>

namespace crossgrain::adapters::process {

struct Question {
    std::vector<std::string> argv;  ///< e.g. {"lmp", "-h"}
    std::vector<std::string> extra_environment;
    double time_limit = 0;  ///< wall seconds, > 0
    std::stop_token stop;
};

struct Answer {
    Ending ending = Ending::exited;
    int status = 0;        ///< exit status or signal number
    std::string ended;     ///< "exit status 1", "killed by signal 11", ...
    std::string out, err;  ///< what it printed, at most longest_answer bytes each
};

inline constexpr std::size_t longest_answer = std::size_t{1} << 20;

/// Runs a short command in a directory of its own that is removed afterwards. Whether its exit
/// status is a good one is not judged: some programs exit with 1 from their own help. Throws
/// std::system_error if it cannot be started, CaseError if there is no place for the directory.
[[nodiscard]] Answer ask(const Question& question);

}  // namespace crossgrain::adapters::process
