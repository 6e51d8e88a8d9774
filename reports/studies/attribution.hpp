// What the codes' conventions of friction do to the answer: the native engine in all combinations
// of them, every difference between two codes' conventions split into what each single one makes of
// it.
#pragma once

#include "reference/compare/attribution.hpp"
#include "reports/session/session.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace crossgrain::studies {

/// One convention in which two codes differ, by its key in a case file: velocity_lever,
/// torque_lever, rotation, limit.
struct ConventionSwitch {
    std::string key, from, to;
};

struct AttributedObservable {
    std::string observable, unit;
    compare::Attribution attribution;  ///< contributions parallel to the pair's switches
};

/// Two codes' conventions (scene::conventions_named).
struct AttributedPair {
    std::string case_name, a, b;
    std::vector<ConventionSwitch> switches;
    std::vector<AttributedObservable> observables;
};

/// Every pair of named conventions that differ, for a case whose sweep has the four keys above;
/// nothing for other cases. Of granular_temperature, mean_square_spin and mean_speed those that at
/// least four replicas of native-dem have in every combination between the two.
[[nodiscard]] std::vector<AttributedPair> attribute_conventions(const judge::CaseRuns& runs);

/// A table in percent of the mean of both codes and a sentence for each difference that is
/// significant; a line for a case of conventions that lacks runs; empty without such a case.
[[nodiscard]] std::string attribution_table(const session::SessionReport& report);

/// One element per pair: {case, a, b, code, switches: [{switch, from, to}], observables:
/// [{observable, unit, replicas, a, b, difference, significant, contributions: [{switch, average,
/// first, last, significant}], interaction}]}, every number as {value, stderr} in its unit.
[[nodiscard]] nlohmann::json attribution_document(const session::SessionReport& report);

}  // namespace crossgrain::studies
