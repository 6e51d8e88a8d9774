#include "cases/catalog/case.hpp"
#include "native/base/errors.hpp"
#include "native/base/memory_budget.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace crossgrain::catalog {

std::int64_t Replicas::of(const std::string& code, const std::string& variant) const {
    const auto found = by_code.find(code);
    std::int64_t count = found == by_code.end() ? standard : found->second;
    for (const auto& [pattern, times] : times_in) {
        if (matches(pattern, variant)) count = std::min(count * times, most_runs + 1);
    }
    return count;
}

void check_runs(const Case& the_case, std::optional<std::int64_t> replicas) {
    std::vector<std::string> codes{""};
    for (const auto& [code, count] : the_case.replicas.by_code)
        codes.push_back(code);
    std::int64_t runs = 0;
    double bytes = 0;
    for (const Variant& variant : the_case.variants) {
        std::int64_t most = replicas.value_or(0);
        for (const std::string& code : codes) {
            if (!replicas) most = std::max(most, the_case.replicas.of(code, variant.name));
        }
        // Neither factor is above 100'000, by far.
        runs += static_cast<std::int64_t>(variant.rungs) * most;
        bytes += variant.bytes * static_cast<double>(most);
        if (runs > most_runs) break;
    }
    const bool too_many = runs > most_runs;
    if (!too_many && bytes <= memory_budget()) return;
    throw CaseError(
        {.file = the_case.file,
         .key = replicas ? "--replicas" : "replicas",
         .problem = too_many ? "makes too many runs" : "makes runs that do not fit into memory",
         .got = too_many ? fmt::format("{} or more per code", runs)
                         : fmt::format("{} of initial states", shown_bytes(bytes)),
         .expected = too_many
                         ? fmt::format("at most {} (variants x time steps x replicas)", most_runs)
                         : fmt::format("at most {}", shown_bytes(memory_budget())),
         .hint = "ask for fewer replicas, variants or time steps"});
}

}  // namespace crossgrain::catalog
