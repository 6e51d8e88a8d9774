// A case: a scene in one or several variants, what is looked at, and what it is checked against.
#pragma once

#include "cases/catalog/reference.hpp"
#include "cases/scene/any_scene.hpp"
#include "native/base/enum_words.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace crossgrain::catalog {

/// Which part of the catalogue runs, and at which size. `quick` applies a case's [quick] table,
/// `chart` its [chart] table: the ladder that is charted for cost and error.
enum class Suite { quick, full, chart };
constexpr auto words(Suite /*of*/) {
    return std::array{"quick", "full", "chart"};
}

/// Most runs that one case may ask of one code: variants x time steps x replicas.
inline constexpr std::int64_t most_runs = 100'000;

/// An option of an observable as the case file gives it.
struct Option {
    std::vector<double> numbers;  ///< empty for a text option
    std::string text;
    int line = 0;
    int column = 0;
};

struct ObservableRequest {
    std::string name;
    std::map<std::string, Option> options;
    int line = 0;
    int column = 0;
};

enum class CheckKind { exact, parity, agree, published };
constexpr auto words(CheckKind /*of*/) {
    return std::array{"exact", "parity", "agree", "published"};
}

/// What a check looks at. Exact: the value of each run, its limit for dt -> 0 over the rungs of
/// time steps, or the order at which its error falls with dt. Published: the value, or its trend
/// along a key of the sweep.
enum class Aspect { value, limit, order, constant, increasing, decreasing };
constexpr auto words(Aspect /*of*/) {
    return std::array{"value", "limit", "order", "constant", "increasing", "decreasing"};
}

[[nodiscard]] constexpr bool is_trend(Aspect aspect) noexcept {
    return aspect == Aspect::constant || aspect == Aspect::increasing ||
           aspect == Aspect::decreasing;
}

/// One question of a case. Limits carry their reason.
struct Check {
    CheckKind kind = CheckKind::exact;
    std::string observable;  ///< measurement, series or "trajectory"
    Aspect aspect = Aspect::value;
    Reference against;                  ///< of `exact` a closed form, of `published` a value
    double order = 0;                   ///< theoretical order of convergence, Aspect::order
    std::string along;                  ///< key of the sweep a trend is judged over
    std::vector<std::string> variants;  ///< names or globs ("P/*"); empty: all
    std::vector<std::string> between;   ///< two variants that must agree in each code; or empty
    std::string with;                   ///< the same code's observable to agree with; or empty
    std::vector<std::string> codes;     ///< empty: all
    double limit = 0;                   ///< tolerance or equivalence margin, > 0
    std::map<std::string, double> limit_for;  ///< by code; a pair takes its largest
    std::string reason;                       ///< why this limit
    std::optional<double> at_contact_times;   ///< time of a trajectory comparison
    std::optional<double> from, to;           ///< time window of a series comparison
    std::string column;                       ///< column of a series that is compared
    std::string expect = "agree";
    std::map<std::string, std::string> expect_for;  ///< by code
    std::map<std::string, std::string> expect_in;   ///< by variant (glob)
    std::string expect_reason;  ///< required if anything but `agree` is expected
    int line = 0;               ///< of the check in its file
};

/// What the error of a charted observable is measured from.
struct ChartedError {
    std::string observable;
    Reference against;   ///< a closed form or a converged variant
    double margin = 0;   ///< beyond it a result is inaccurate, > 0
    std::string reason;  ///< why this margin
    int line = 0;
};

/// What is fitted over the variants of a case: the exponent a of y ~ x^a or of 1/y ~ x^a;
/// Beverloo's law y = C (x - k)^(3/2), or its exponent; the slope dy/dx at every inner variant.
enum class FitLaw { exponent, inverse_exponent, outlet, outlet_exponent, local_slope };
constexpr auto words(FitLaw /*of*/) {
    return std::array{"exponent", "inverse-exponent", "outlet", "outlet-exponent", "local-slope"};
}

/// One measurement over the variants of a case.
struct Fit {
    std::string name;  ///< of the measurement
    FitLaw law = FitLaw::exponent;
    std::string observable;  ///< y
    std::string along;       ///< x: a key of the sweep, a setting of y, or another measurement
    bool tangent = false;    ///< x is the tangent of that, which is in degrees
    std::optional<double> from, to;     ///< range of x, before any tangent
    std::vector<std::string> variants;  ///< names or globs; empty: all
};

struct Variant {
    std::string name;       ///< empty if the case has one variant only
    std::string drops;      ///< physics that this variant leaves out, e.g. "spins"; usually empty
    std::size_t rungs = 1;  ///< time steps of its ladder
    double bytes = 0;       ///< of its scenes in memory, all rungs of one replica
    std::vector<std::string> not_expressible_in;  ///< codes of which the catalogue knows it
    /// Keys of the sweep with this variant's values, in the sweep's order; empty without a sweep.
    std::vector<std::pair<std::string, std::string>> parameters;
    /// Values of the sweep's keys at which alone this variant is made; empty: at all points.
    std::map<std::string, std::vector<std::string>> only;
    std::size_t point = 0, written = 0;  ///< of the sweep and of the file's tables it is made from

    [[nodiscard]] std::optional<std::string> parameter(const std::string& key) const;
};

/// Whether a variant's name matches a pattern in which * stands for any text.
[[nodiscard]] bool matches(const std::string& pattern, const std::string& name);

/// How many independent runs of a case each code does.
struct Replicas {
    std::int64_t standard = 1;
    std::map<std::string, std::int64_t> by_code;
    /// By variant (name or glob): how many times as many, where single runs scatter more.
    std::map<std::string, std::int64_t> times_in;
    /// At most most_runs + 1: a larger number is not told apart.
    [[nodiscard]] std::int64_t of(const std::string& code, const std::string& variant = "") const;
};

class Case {
  public:
    std::string name, title, source, text;
    std::string model =
        "grains";  ///< "grains", "lattice-gas", "hopper-automaton", "synthetic-signal"
    std::string file;
    std::string failure_map;  ///< case whose sweep maps where this one's model fails; may be empty
    std::vector<std::string> suites;  ///< "quick", "full", and "chart" if there is a [chart]
    std::vector<Variant> variants;    ///< at least one
    std::vector<ObservableRequest> observables;
    std::vector<Check> checks;          ///< of the quick and the full suite
    std::vector<ChartedError> charted;  ///< in the chart suite only
    std::vector<Fit> fits;
    Replicas replicas;
    double time_limit = 0;  ///< wall seconds per run

    /// The scene of one run. Throws CaseError.
    [[nodiscard]] scene::AnyScene scene(std::size_t variant, std::size_t rung,
                                        std::uint64_t seed) const;
    /// The same for a case of grains.
    [[nodiscard]] scene::Scene grain_scene(std::size_t variant, std::size_t rung,
                                           std::uint64_t seed) const;

    struct Source;  ///< the parsed file, for scene()
    std::shared_ptr<const Source> parsed;
};

/// Throws CaseError when the runs of a case are too many, or their scenes too large to be in memory
/// together. `replicas` overrides those of the case.
void check_runs(const Case& the_case, std::optional<std::int64_t> replicas);

/// Reads a case file and checks all of it, including every variant's scene. `readings` is the
/// directory of the shipped readings of the models' rules. Throws CaseError.
/// `axes`: keys of the sweep of which all numbers are taken; empty for all.
/// `stop` is heard while the file, if it is a pipe, waits for its writer: Interrupted.
[[nodiscard]] Case load_case(const std::string& file, Suite suite, const std::string& readings = "",
                             const std::vector<std::string>& axes = {}, std::stop_token stop = {});

/// Names of the cases in a catalogue directory, sorted.
[[nodiscard]] std::vector<std::string> case_names(const std::string& directory);

/// A case by its name in the catalogue or by the path of a case file (anything with a '/' or that
/// ends in ".toml"). Throws CaseError with the nearest name. Readings are in directory/readings.
[[nodiscard]] Case find_case(const std::string& directory, const std::string& name, Suite suite,
                             const std::vector<std::string>& axes = {}, std::stop_token stop = {});

}  // namespace crossgrain::catalog
