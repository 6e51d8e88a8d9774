#include "tests/selftest/selftest_trials.hpp"

#include "adapters/registry/codes.hpp"

#include "native/base/errors.hpp"
#include "reference/published/published.hpp"

#include <fmt/format.h>

namespace crossgrain::selftest {
namespace {

/// Seeds of two samples never meet: this is more than any case has replicas.
constexpr std::uint64_t seed_stride = 10000;

bool installed(const std::string& code) {
    return adapters::select_codes({code}).front()->probe().installed;
}

/// Plans what a defect needs. An error of a reader that is to refuse the defect is its result.
PlantedDefect plant(SelftestBench& bench, const catalog::Case& the_case, const DefectGroup& group,
                    const Defect& defect) {
    PlantedDefect planted{.defect = &defect};
    for (const auto& needed : {defect.code, defect.lender}) {
        if (needed.empty() || needed == "published" || installed(needed)) continue;
        planted.skipped = fmt::format("{} is not installed", needed);
        return planted;
    }
    try {
        if (defect.kind == DefectKind::reference) {
            planted.references = bench.edited_references(defect.file, defect.edit, defect.place);
            if (defect.refused) (void)published::PublishedValues(planted.references);
            return planted;
        }
        const catalog::Case* changed = &the_case;
        if (defect.kind == DefectKind::scene) {
            changed = &bench.edited_case(group.case_name, defect.edit, defect.place);
        } else if (defect.kind == DefectKind::reading) {
            changed =
                &bench.case_with_reading(group.case_name, defect.file, defect.edit, defect.place);
        }
        planted.runs = bench.plan_defective(
            the_case, *adapters::select_codes({defect.code}).front(), defect, *changed);
    } catch (const CaseError& error) {
        const bool about_the_file =
            !error.details().file.empty() && error.details().file != defect.place;
        if (!defect.refused || !about_the_file) throw;
        planted.refusal = error.what();
    }
    return planted;
}

}  // namespace

GroupTrial plan_group(SelftestBench& bench, const DefectGroup& group) {
    GroupTrial trial{.group = &group, .the_case = &bench.find_case(group.case_name)};
    for (const auto* code : adapters::select_codes(group.codes)) {
        if (!installed(code->name())) continue;
        trial.honest.push_back(
            bench.plan_runs(*trial.the_case, *code, SelftestBench::first_seed, code->name()));
        for (int peer = 1; peer <= group.peers; ++peer) {
            const auto seed = SelftestBench::first_seed + seed_stride * static_cast<unsigned>(peer);
            trial.honest.push_back(bench.plan_runs(*trial.the_case, *code, seed,
                                                   fmt::format("{}-peer{}", code->name(), peer)));
        }
    }
    for (const auto& defect : group.defects)
        trial.planted.push_back(plant(bench, *trial.the_case, group, defect));
    return trial;
}

std::vector<NullTrial> plan_null(SelftestBench& bench, const NullComparison& null,
                                 std::uint64_t& seed) {
    std::vector<NullTrial> trials;
    if (!installed(null.code) || !installed(null.against)) return trials;
    const catalog::Case& the_case = bench.find_case(null.case_name);
    const catalog::Case& other =
        null.edit ? bench.edited_case(null.case_name, *null.edit, null.place) : the_case;
    const auto next = [&] { return seed += seed_stride; };
    for (int round = 0; round < null.rounds; ++round) {
        NullTrial trial{.comparison = &null, .the_case = &the_case};
        trial.a = bench.plan_runs(the_case, *adapters::select_codes({null.code}).front(), next(),
                                  null.code);
        trial.b = bench.plan_runs(other, *adapters::select_codes({null.against}).front(), next(),
                                  null.against + ", other seeds");
        trials.push_back(std::move(trial));
    }
    return trials;
}

std::uint64_t first_null_seed() {
    constexpr std::uint64_t samples = 100;  // more than any group has
    return seed_stride * samples;
}

}  // namespace crossgrain::selftest
