// What the command line decides about a call.
#pragma once

#include "cases/catalog/case.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace crossgrain::app {

struct Settings {
    std::filesystem::path results = "crossgrain-results";
    bool json = false;
    bool quiet = false;
    catalog::Suite suite = catalog::Suite::full;
    std::vector<std::string> map_axes;     ///< keys of a failure map's sweep; empty: all
    std::vector<std::string> cases;        ///< empty: all of the suite
    std::vector<std::string> codes;        ///< empty: all
    std::optional<std::int64_t> replicas;  ///< overrides the case
    std::uint64_t seed = 1;                ///< of the first replica
    unsigned jobs = 0;                     ///< runs side by side; 0: one per processor
    bool fresh = false;                    ///< compute again what the store already has
    std::optional<double> time_limit;      ///< wall seconds per run, overrides the case
    bool keep_dumps = false;               ///< write trajectories to <results>/runs/...
    std::string command;                   ///< command_text(), for the report
};

/// "crossgrain" with the arguments, for people to read and to copy: what a shell would not take as
/// one word is quoted, what cannot be shown is escaped (printable.hpp), long arguments are cut.
[[nodiscard]] std::string command_text(const std::vector<std::string>& arguments);

/// Directory with catalog/, published/ and web/: $CROSSGRAIN_SHARE, or share/crossgrain next to the
/// executable, or ../share/crossgrain. Throws CaseError if there is none.
[[nodiscard]] std::filesystem::path share_directory();

/// e.g. "0.1.0 (source 1a2b3c4d)": the digest covers every source that decides a number.
[[nodiscard]] std::string program_version();

struct Machine {
    std::string cpu, os;
    unsigned cores = 0;
};
[[nodiscard]] Machine this_machine();

}  // namespace crossgrain::app
