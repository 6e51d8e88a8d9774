#include "reference/judge/case_runs.hpp"

#include <algorithm>

namespace crossgrain::judge {
namespace {

/// Tests of single runs (steady, a line through the shifts) refuse one run in a hundred or so by
/// chance: among many replicas one must not cost the measurement. Below this number all must have
/// it.
constexpr std::int64_t replicas_for_one_without = 10;

compare::Outcome outcome_of(store::RunStatus status) {
    if (status == store::RunStatus::not_installed) return compare::Outcome::not_installed;
    if (status == store::RunStatus::not_expressible) return compare::Outcome::not_expressible;
    return store::has_failed(status) ? compare::Outcome::run_failed : compare::Outcome::undecided;
}

}  // namespace

CaseRuns::CaseRuns(const catalog::Case& the_case, std::vector<store::RunRecord> records)
    : case_(&the_case), records_(std::move(records)) {
    for (const auto& record : records_) {
        if (std::find(codes_.begin(), codes_.end(), record.code) == codes_.end()) {
            codes_.push_back(record.code);
        }
    }
}

const store::RunRecord* CaseRuns::find(const std::string& code, std::size_t variant,
                                       std::size_t rung, std::int64_t replica) const {
    const std::string& name = case_->variants[variant].name;
    const auto found =
        std::find_if(records_.begin(), records_.end(), [&](const store::RunRecord& r) {
            return r.code == code && r.variant == name && r.rung == rung && r.replica == replica &&
                   r.status == store::RunStatus::ok;
        });
    return found == records_.end() ? nullptr : &*found;
}

std::optional<Absence> CaseRuns::absence(const std::string& code, std::size_t variant) const {
    const std::string& name = case_->variants[variant].name;
    for (const auto& record : records_) {
        if (record.code != code || record.variant != name || record.status == store::RunStatus::ok)
            continue;
        const bool pending = record.status == store::RunStatus::not_run ||
                             record.status == store::RunStatus::planned;
        return Absence{.outcome = outcome_of(record.status),
                       .reason = pending ? "no run in the store" : record.reason,
                       .code = {}};
    }
    return std::nullopt;
}

std::int64_t CaseRuns::replicas(const std::string& code, std::size_t variant,
                                std::size_t rung) const {
    return std::count_if(records_.begin(), records_.end(), [&](const store::RunRecord& r) {
        return r.code == code && r.variant == case_->variants[variant].name && r.rung == rung;
    });
}

std::optional<compare::Combined> CaseRuns::combined(const std::string& code, std::size_t variant,
                                                    std::size_t rung,
                                                    const std::string& observable) const {
    std::vector<measure::Measurement> found;
    const std::int64_t count = replicas(code, variant, rung);
    for (std::int64_t replica = 0; replica < count; ++replica) {
        const auto* record = find(code, variant, rung, replica);
        if (record == nullptr) return std::nullopt;
        for (const auto& measurement : record->results.measurements) {
            if (measurement.observable == observable) found.push_back(measurement);
        }
    }
    const std::int64_t without = count - static_cast<std::int64_t>(found.size());
    if (found.empty() || without * replicas_for_one_without > count) return std::nullopt;
    auto all = compare::combine(found);
    if (without > 0) all.measurement.settings["replicas_without"] = static_cast<double>(without);
    return all;
}

bool CaseRuns::known_not_expressible(const std::string& code, std::size_t variant) const {
    const auto& known = case_->variants[variant].not_expressible_in;
    return std::find(known.begin(), known.end(), code) != known.end();
}

}  // namespace crossgrain::judge
