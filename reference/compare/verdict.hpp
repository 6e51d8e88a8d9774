// The four kinds of check and what they may answer. Only `agree` is green.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

namespace crossgrain::compare {

enum class Kind {
    exact,     ///< against a closed form
    parity,    ///< the same scene in two codes, while chaos allows
    agree,     ///< equivalence of an observable between codes, by replicas or resampling
    published  ///< against a number or a trend in the literature
};

enum class Outcome {
    agree,
    disagree,
    undecided,        ///< not enough data to say
    not_expressible,  ///< a code cannot run this scene exactly
    not_installed,
    run_failed,
    no_reference  ///< the reference is missing or empty
};

/// One answered question. `expected` tells whether the outcome is the one the catalogue records.
struct Verdict {
    std::string code;  ///< "lammps"; for pairs "native-dem" with `against` = "lammps"
    std::string observable;
    Kind kind = Kind::exact;
    std::string against;  ///< "analytic:restitution", "published:...", or a code's name
    std::string setting;  ///< variant and time, e.g. "clip-all, dt = t_col/100"; may be empty
    /// Signed where a sign makes sense; not a number while nothing was compared.
    double difference = std::numeric_limits<double>::quiet_NaN();
    double uncertainty = 0;  ///< half-width of the 95 % interval of `difference`
    double limit = 0;        ///< tolerance or equivalence margin
    std::string limit_reason;
    Outcome outcome = Outcome::undecided;
    bool expected = true;
    /// What was compared with: `difference` is the measured value minus this. Not a number for
    /// pairs of codes, trends, orders, and while nothing was compared.
    double reference = std::numeric_limits<double>::quiet_NaN();
    double reference_error = 0;  ///< standard error of it
    /// Against non-equivalence and against equivalence (equivalence_power.hpp); not numbers for
    /// what is no equivalence test.
    double p_equivalent = std::numeric_limits<double>::quiet_NaN();
    double p_different = std::numeric_limits<double>::quiet_NaN();
    /// Of an undecided one: how many more replicas, of each code, would decide if all else stays.
    std::optional<std::int64_t> more_replicas;
    /// The outcome when all verdicts of a report are one family (Holm); nothing for verdicts that
    /// are no claims of statistics.
    std::optional<Outcome> corrected;
    std::string reason;  ///< one line: why not `agree`, or why a disagreement is expected
};

[[nodiscard]] std::string to_string(Kind kind);
[[nodiscard]] std::string to_string(Outcome outcome);

}  // namespace crossgrain::compare
