#include "adapters/run/case_names.hpp"

#include "adapters/registry/codes.hpp"
#include "cases/observables/observables.hpp"

namespace crossgrain::run {

void check_names(const catalog::Case& the_case) {
    observables::check_observables(the_case);
    const auto require = [&](const std::string& name, int line, const char* key) {
        adapters::require_code(name, {.file = the_case.file, .line = line, .key = key});
    };
    for (const auto& [name, count] : the_case.replicas.by_code)
        require(name, 0, "replicas");
    for (const auto& variant : the_case.variants) {
        for (const auto& name : variant.not_expressible_in) {
            require(name, 0, "variant.not_expressible_in");
        }
    }
    for (const auto& check : the_case.checks) {
        for (const auto& name : check.codes)
            require(name, check.line, "check.codes");
        for (const auto& [name, limit] : check.limit_for) {
            require(name, check.line, "check.limit_for");
        }
        for (const auto& [name, outcome] : check.expect_for) {
            require(name, check.line, "check.expect_for");
        }
    }
}

}  // namespace crossgrain::run
