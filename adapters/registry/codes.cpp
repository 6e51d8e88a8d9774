#include "adapters/registry/codes.hpp"

#include "adapters/lammps/lammps_code.hpp"
#include "adapters/liggghts/liggghts_code.hpp"
#include "adapters/native/native_dem_code.hpp"
#include "adapters/native/native_gas_code.hpp"
#include "adapters/native/native_hopper_code.hpp"
#include "adapters/registry/program_version.hpp"
#include "adapters/synthetic/signal_code.hpp"
#include "adapters/yade/yade_code.hpp"
#include "cases/toml/toml_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace crossgrain::adapters {

const std::vector<std::unique_ptr<Code>>& codes() {
    static const auto all = [] {
        std::vector<std::unique_ptr<Code>> list;
        list.push_back(std::make_unique<NativeDemCode>(program_version()));
        list.push_back(std::make_unique<NativeGasCode>(program_version()));
        list.push_back(std::make_unique<NativeHopperCode>(program_version()));
        list.push_back(std::make_unique<SyntheticSignalCode>(program_version()));
        list.push_back(std::make_unique<LammpsCode>());
        list.push_back(std::make_unique<LiggghtsCode>());
        list.push_back(std::make_unique<YadeCode>());
        // tools/new.sh code: codes go above this line
        return list;
    }();
    return all;
}

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

std::vector<const Code*> select_codes(const std::vector<std::string>& names) {
    for (const auto& name : names)
        require_code(name, {});
    std::vector<const Code*> selected;
    for (const auto& code : codes()) {
        if (names.empty() || std::find(names.begin(), names.end(), code->name()) != names.end()) {
            selected.push_back(code.get());
        }
    }
    return selected;
}

}  // namespace crossgrain::adapters
