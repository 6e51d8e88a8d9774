#include "app/catalogue/catalogue.hpp"
#include "app/settings.hpp"

#include "adapters/lammps/lammps_code.hpp"
#include "adapters/liggghts/liggghts_code.hpp"
#include "adapters/native/native_dem_code.hpp"
#include "adapters/native/native_gas_code.hpp"
#include "adapters/native/native_hopper_code.hpp"
#include "adapters/synthetic/signal_code.hpp"
#include "adapters/yade/yade_code.hpp"
#include "cases/toml/toml_table.hpp"
#include "native/base/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace crossgrain::app {

const std::vector<std::unique_ptr<adapters::Code>>& codes() {
    static const auto all = [] {
        std::vector<std::unique_ptr<adapters::Code>> list;
        list.push_back(std::make_unique<adapters::NativeDemCode>(program_version()));
        list.push_back(std::make_unique<adapters::NativeGasCode>(program_version()));
        list.push_back(std::make_unique<adapters::NativeHopperCode>(program_version()));
        list.push_back(std::make_unique<adapters::SyntheticSignalCode>(program_version()));
        list.push_back(std::make_unique<adapters::LammpsCode>());
        list.push_back(std::make_unique<adapters::LiggghtsCode>());
        list.push_back(std::make_unique<adapters::YadeCode>());
        // tools/new.sh code: codes go above this line
        return list;
    }();
    return all;
}

namespace {

/// Throws CaseError unless the code exists. `where` says which file and key named it, if any.
void require_code(const std::string& name, CaseErrorDetails where) {
    std::vector<std::string> known;
    for (const auto& code : codes())
        known.push_back(code->name());
    if (std::find(known.begin(), known.end(), name) != known.end()) return;
    const auto near = toml_input::nearest(name, known);
    where.problem = where.key.empty() ? "unknown code" : "names an unknown code";
    where.got = fmt::format("'{}'", name);
    where.expected = fmt::format("one of {}", fmt::join(known, ", "));
    where.hint = near ? fmt::format("did you mean '{}'?", *near) : "";
    throw CaseError(where);
}

}  // namespace

void check_names(const catalog::Case& the_case) {
    check_observables(the_case);
    const auto require = [&](const std::string& name, int line, const char* key) {
        require_code(name, {.file = the_case.file, .line = line, .key = key});
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

std::vector<const adapters::Code*> select_codes(const std::vector<std::string>& names) {
    for (const auto& name : names)
        require_code(name, {});
    std::vector<const adapters::Code*> selected;
    for (const auto& code : codes()) {
        if (names.empty() || std::find(names.begin(), names.end(), code->name()) != names.end()) {
            selected.push_back(code.get());
        }
    }
    return selected;
}

}  // namespace crossgrain::app
