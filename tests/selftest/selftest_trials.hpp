// What a selftest tries: one group of defects, or one comparison of which nothing is wrong, planned
// on the bench.
#pragma once

#include "tests/selftest/selftest_bench.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace crossgrain::selftest {

/// One defect on its way: what was planned for it, or what came out of planning.
struct PlantedDefect {
    const Defect* defect = nullptr;
    std::string skipped, refusal;
    std::optional<RunSlice> runs;      ///< of the code that carries it
    std::filesystem::path references;  ///< edited published values; empty: the shipped ones
};

struct GroupTrial {
    const DefectGroup* group = nullptr;
    const catalog::Case* the_case = nullptr;
    std::vector<RunSlice> honest;  ///< of all codes, then their peers
    std::vector<PlantedDefect> planted;
};

struct NullTrial {
    const NullComparison* comparison = nullptr;
    const catalog::Case* the_case = nullptr;
    RunSlice a, b;
};

/// Plans the honest runs of the group and those with its defects. Throws CaseError for a defect
/// that cannot be planted as it is written.
[[nodiscard]] GroupTrial plan_group(SelftestBench& bench, const DefectGroup& group);

/// One trial per round; none if a code is not installed. `seed` is the last one used.
[[nodiscard]] std::vector<NullTrial> plan_null(SelftestBench& bench, const NullComparison& null,
                                               std::uint64_t& seed);

/// The `seed` of plan_null to begin with: beyond those of all groups.
[[nodiscard]] std::uint64_t first_null_seed();

}  // namespace crossgrain::selftest
