// The four kinds of check and what they may answer. Only `agree` is green.
#pragma once

#include "native/base/enum_words.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

namespace crossgrain::compare {

using crossgrain::to_string;

enum class Kind {
    exact,     ///< against a closed form
    parity,    ///< the same scene in two codes, while chaos allows
    agree,     ///< equivalence of an observable between codes, by replicas or resampling
    published  ///< against a number or a trend in the literature
};
constexpr auto words(Kind /*of*/) {
    return std::array{"exact", "parity", "agree", "published"};
}

enum class Outcome {
    agree,
    disagree,
    undecided,        ///< not enough data to say
    not_expressible,  ///< a code cannot run this scene exactly
    not_installed,
    run_failed,
    no_reference  ///< the reference is missing or empty
};
constexpr auto words(Outcome /*of*/) {
    return std::array{"agree",         "disagree",   "undecided",   "not_expressible",
                      "not_installed", "run_failed", "no_reference"};
}

/// What a measured value is held against.
struct Against {
    enum class Kind {
        code,            ///< the same in another code
        variant,         ///< the same code in another variant of the case
        own_observable,  ///< another observable of the same run
        closed_form,
        published,  ///< a value of the literature
        trend       ///< a trend of the literature
    };
    Kind kind = Kind::closed_form;
    std::string name;  ///< "lammps", a variant, an observable, "analytic:...", "published:..."

    friend bool operator==(const Against&, const Against&) = default;
};

/// What of an observable is judged: its value, its limit for dt -> 0, the order at which its error
/// falls with dt, or its trend along a key of the sweep.
enum class Aspect { value, limit, order, constant, increasing, decreasing };

/// One answered question. `expected` tells whether the outcome is the one the catalogue records.
struct Verdict {
    std::string code;        ///< "lammps"; of a pair the first one
    std::string observable;  ///< as the catalogue of observables names it
    std::string column;      ///< of a series; may be empty
    Aspect aspect = Aspect::value;
    std::string along;  ///< key of the sweep, of a trend
    Kind kind = Kind::exact;
    Against against;
    std::string variant;  ///< of the case; of a trend what its variants share; may be empty
    std::string place;    ///< where in a run, e.g. "t = 10 t_col"; may be empty
    /// The rule variant of the model, where the case sweeps over those.
    std::string rule_variant;
    /// The code of a pair without a result, if that is what decided.
    std::string absent_code;
    /// Signed where a sign makes sense; not a number while nothing was compared.
    double difference = std::numeric_limits<double>::quiet_NaN();
    double uncertainty = 0;     ///< half-width of the 95 % interval of `difference`
    double standard_error = 0;  ///< of `difference`
    double limit = 0;           ///< tolerance or equivalence margin
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

/// "lammps", "variant mixed", "its own rise", "analytic:restitution".
[[nodiscard]] std::string to_string(const Against& against);
/// "restitution (dt -> 0)", "lid-height.h", "flux (constant along width)".
[[nodiscard]] std::string observable_text(const Verdict& verdict);
/// "clip-all, t = 10 t_col"; may be empty.
[[nodiscard]] std::string setting_text(const Verdict& verdict);
/// Whether two codes are held against each other.
[[nodiscard]] inline bool is_pair(const Verdict& verdict) noexcept {
    return verdict.against.kind == Against::Kind::code;
}

}  // namespace crossgrain::compare
