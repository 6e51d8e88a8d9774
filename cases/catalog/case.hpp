// A case: a scene in one or several variants, what is looked at, and what it is checked against.
#pragma once

#include "cases/scene/scene.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace crossgrain::catalog {

/// Which part of the catalogue runs, and at which size. `quick` applies a case's [quick] table.
enum class Suite { quick, full };

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

/// What an exact check looks at: the value of each run, its limit for dt -> 0 over the rungs of
/// time steps, or the order at which its error falls with dt.
enum class Aspect { value, limit, order };

/// One question of a case. Limits carry their reason.
struct Check {
    CheckKind kind = CheckKind::exact;
    std::string observable;  ///< measurement, series or "trajectory"
    Aspect aspect = Aspect::value;
    std::string against;                      ///< "analytic:..." or "published:..."
    double order = 0;                         ///< theoretical order of convergence, Aspect::order
    std::vector<std::string> variants;        ///< empty: all
    std::vector<std::string> codes;           ///< empty: all
    double limit = 0;                         ///< tolerance or equivalence margin, > 0
    std::map<std::string, double> limit_for;  ///< by code; a pair takes its largest
    std::string reason;                       ///< why this limit
    std::optional<double> at_contact_times;   ///< time of a trajectory comparison
    std::optional<double> from, to;           ///< time window of a series comparison
    std::string column;                       ///< column of a series that is compared
    std::string expect = "agree";
    std::map<std::string, std::string> expect_for;  ///< by code
    std::string expect_reason;  ///< required if anything but `agree` is expected
    int line = 0;               ///< of the check in its file
};

struct Variant {
    std::string name;                             ///< empty if the case has one variant only
    std::size_t rungs = 1;                        ///< time steps of its ladder
    std::vector<std::string> not_expressible_in;  ///< codes of which the catalogue knows it
};

/// How many independent runs of a case each code does.
struct Replicas {
    std::int64_t standard = 1;
    std::map<std::string, std::int64_t> by_code;
    [[nodiscard]] std::int64_t of(const std::string& code) const;
};

class Case {
  public:
    std::string name, title, source, text;
    std::string file;
    std::vector<std::string> suites;  ///< "quick", "full"
    std::vector<Variant> variants;    ///< at least one
    std::vector<ObservableRequest> observables;
    std::vector<Check> checks;
    Replicas replicas;
    double time_limit = 0;  ///< wall seconds per run

    /// The scene of one run. Throws CaseError.
    [[nodiscard]] scene::Scene scene(std::size_t variant, std::size_t rung,
                                     std::uint64_t seed) const;

    struct Source;  ///< the parsed file, for scene()
    std::shared_ptr<const Source> parsed;
};

/// Reads a case file and checks all of it, including every variant's scene. Throws CaseError.
[[nodiscard]] Case load_case(const std::string& file, Suite suite);

/// Names of the cases in a catalogue directory, sorted.
[[nodiscard]] std::vector<std::string> case_names(const std::string& directory);

/// A case by its name in the catalogue or by the path of a case file (anything with a '/' or that
/// ends in ".toml"). Throws CaseError with the nearest name.
[[nodiscard]] Case find_case(const std::string& directory, const std::string& name, Suite suite);

}  // namespace crossgrain::catalog
